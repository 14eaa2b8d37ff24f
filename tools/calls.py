# SPDX-License-Identifier: Apache-2.0
"""What the tools that call other programs share."""
import subprocess


class Mistake(Exception):
    """What the user must be told."""


def output_of(*call, cwd=None):
    """The standard output of a program, without white space at its ends; Mistake when it fails."""
    words = [str(word) for word in call]
    try:
        done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False)
    except OSError as error:
        raise Mistake(f"{words[0]}: {error.strerror}") from error
    if done.returncode != 0:
        raise Mistake(f"{' '.join(words)} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout.strip()
