# SPDX-License-Identifier: Apache-2.0
"""thalweg lab from outside: its list, parameters from a file and the command line, and what is wrong with them."""
import csv

import support
from support import expand, on_each, sample_net, write

WRONG = {  # name: arguments, what the error must say
    "experiment": (["enumerat"], r"there is no experiment 'enumerat'.*did you mean 'enumerate'"),
    "option": (["enumerate", "--sise", 5], r"sise.*size"),
    "side_0": (["enumerate", "--size", 0], r"side 0.*at least 2"),
    "side_1": (["runtime", "--size", 1], r"side 1.*at least 2"),
    "side_is_a_word": (["greedy", "--size", "five"], r"--size five"),
    "memory": (["runtime", "--size", 1000000], r"would need about [\d.]+ GB; this machine has [\d.]+ GB"),
    "memory_of_states": (["crew", "--horizon", 10**13], r"would need about [\d.]+ GB"),
    "enumeration_without_end": (["enumerate", "--size", 7, "--max-paths", 10000],
                                r"stopped at 10000 paths and \d+ loops, with more to come; --max-paths"),
    "ebogp_without_end": (["enumerate", "--size", 30, "--max-paths", 1000], r"stopped at 1000 paths"),
    "no_repetition": (["polygon", "--repetitions", 0], r"--repetitions"),
    "no_thread": (["polygon", "--threads", 0], r"--threads"),
    "family": (["evolve-rounds", "--family", "grd"], r"family 'grd'.*'grid'"),
    "reading": (["density", "--reading", "tabel"], r"reading 'tabel'.*'table'"),
    "class": (["city-regions", "-n", sample_net("grid"), "--vclass", "passengers"], r"--vclass passengers"),
    "no_network": (["city-regions"], r"--net-file"),
    "network_is_missing": (["city-regions", "-n", "nowhere.net.xml"], r"nowhere.net.xml"),
    "no_recording": (["city-dynamic", "-n", sample_net("grid")], r"--edgedata-file"),
    "half_a_recording": (["score", "-n", sample_net("grid")], r"--net-file and --edgedata-file"),
    "parameter_file_is_missing": (["polygon", "-c", "nowhere.xml"], r"nowhere.xml"),
    "output_folder_is_missing": (["triangle", "--n", 5, "--repetitions", 2, "-o", "nowhere/out.csv"], r"nowhere"),
}


@expand
class Lab(support.TestCase):
    def refused(self, message, *arguments, **how):
        """Ends with 1, an error in words that match, and no table."""
        result = support.thalweg("lab", *arguments, **how)
        self.assertEqual(result.exit, 1, str(result))
        self.assertRegex(result.err, rf"Error: (?s:.*){message}", str(result))

    def test_list(self):
        out = self.succeeds("lab").out
        for name in ("runtime", "enumerate", "city-dynamic", "score", "memory"):
            self.assertRegex(out, rf"(?m)^  {name} +\S")

    @on_each(WRONG)
    def test_wrong(self, name):
        arguments, message = WRONG[name]
        self.refused(message, *arguments, cwd=self.folder())

    def test_wrong_parameter_files(self):
        folder = self.folder()
        broken = write(folder / "broken.xml", "<configuration><experiment>")
        self.refused(r"broken.xml", "polygon", "-c", broken)
        unknown = write(folder / "unknown.xml", '<configuration><experiment><sides value="9"/><sise value="5"/>'
                                                "</experiment></configuration>")
        self.refused(r"unknown.xml: .* has no option 'sise'.*did you mean 'sides'", "polygon", "-c", unknown)

    def test_file_command_line_and_csv(self):
        folder = self.folder()
        file = write(folder / "p.xml", '<configuration><experiment><numbers value="20"/><sides value="19"/>'
                                       '<seed value="7"/></experiment></configuration>')
        self.assertIn("seed 7", self.succeeds("lab", "polygon", "-c", file, "--repetitions", 20).out)
        tables = []
        for threads in (1, 2):
            out = folder / f"{threads}.csv"
            said = self.succeeds("lab", "polygon", "-c", file, "--seed", 8, "--repetitions", 20, "--threads", threads,
                                 "-o", out).out
            self.assertIn("seed 8, 20 repetitions, numbers 20, sides 19", said)
            tables.append(out.read_text())
        self.assertEqual(*tables)
        header = next(csv.reader(tables[0].splitlines()))
        self.assertIn("95 % half width", " ".join(header))
        self.assertTrue(any("[" in name for name in header), "a unit")


if __name__ == "__main__":
    support.main()
