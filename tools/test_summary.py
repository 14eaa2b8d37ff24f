# SPDX-License-Identifier: Apache-2.0
"""Counts the tests in the file ctest --output-junit wrote, and names those that failed or were skipped.

A skipped test returned 77 (Python) or printed GoogleTest's "[  SKIPPED ]". A test that could not be run at all,
which ctest also notes as skipped, has failed.
"""
import os
import sys
import xml.etree.ElementTree as ElementTree


def reason(output):
    """The line in which a skipped test says why: after GoogleTest's "file:line: Skipped", or the last one."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    for line, following in zip(lines, lines[1:]):
        if line.endswith(": Skipped"):
            return following
    return lines[-1] if lines else "no reason given"


def main(path):
    names = {"passed": [], "failed": [], "skipped": []}
    for case in ElementTree.parse(path).iter("testcase") if os.path.exists(path) else ():
        name, mark = case.get("name"), case.find("skipped")
        output = case.findtext("system-out") or ""
        if case.get("status") == "run":
            names["passed"].append(name)
        elif case.get("status") == "disabled":
            names["skipped"].append(f"{name}: disabled")
        elif mark is not None and mark.get("message", "").startswith("SKIP_"):
            names["skipped"].append(f"{name}: {reason(output)}")
        else:
            names["failed"].append(name)
    print()
    for kind in ("skipped", "failed"):
        for name in names[kind]:
            print(f"{kind.upper()}  {name}")
    if not names["passed"] and not names["failed"]:
        print("no test ran")
    print(", ".join(f"{len(tests)} {kind}" for kind, tests in names.items()))
    return 1 if names["failed"] or not names["passed"] else 0


sys.exit(main(sys.argv[1]))
