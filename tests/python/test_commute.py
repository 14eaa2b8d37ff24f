# SPDX-License-Identifier: Apache-2.0
"""tools/commute and tools/cities: arms, keys, the tuned device and the report by hand; a matrix of a pretended thalweg,
interrupted and taken up again; a small city that comes out the same twice."""
import contextlib
import csv
import gzip
import importlib.machinery
import importlib.util
import io
import os
import re
import subprocess
import sys
from pathlib import Path

import support
from support import PROJECT, write

sys.path.insert(0, str(PROJECT / "tools"))
import commute_report  # noqa: E402
import commute_table as table  # noqa: E402

FAKE = r"""#!/usr/bin/env python3
import json, pathlib, re, sys
words = sys.argv[1:]
if words == ["doctor"]:
    print("thalweg          0.1.0\nlibsumo          SUMO 9.9.9")
    sys.exit()
value = dict(zip(words, words[1:]))
with open(pathlib.Path(__file__).parent / "calls", "a") as calls:
    calls.write(" ".join(words) + "\n")
for arm in re.split(r",(?![\w.]+=)", value["--arms"]):
    bad = arm == "one-shot"
    folder = pathlib.Path(value["-o"]) / re.sub("[:, ]", "_", arm) / value["--seed"]
    folder.mkdir(parents=True)
    part = folder / "part"  # nobody reads half a file: the program writes it so as well
    part.write_text(json.dumps({
        "arm": arm, "seed": int(value["--seed"]), "vehicles": 5, "finished": 5, "running": 0, "waiting": 0,
        "commute_mean": 100.0 + len(arm), "duration_mean": 100.0, "depart_delay_mean": 0.5,
        "teleports": {"jam": 1, "yield": 2, "wrong_lane": 0, "collision": 0}, "reroutes": 3, "router_cpu_s": 0.5,
        "simulation_cpu_s": 1.5, "exit": int(bad), "error": "a gridlock" if bad else None}))
    part.rename(folder / "run.json")
"""


def tool(name):
    """A tool without .py, as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(PROJECT / "tools" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def line(scenario, arm, seed, commute, router="", date="2026-01-01T00:00:00", **more):
    return {"scenario": scenario, "hash": "0", "arm": arm, "options": "", "seed": str(seed), "sumo": "1.28.0",
            "router": router, "vehicles": "10", "finished": "10", "running": "0", "waiting": "0",
            "mean_commute_s": str(commute), "duration_s": "0", "depart_delay_s": "0", "teleports": "0",
            "reroutings": "0", "router_cpu_s": "0", "simulation_cpu_s": "4", "date": date, **more}


def tuning_lines(scenario, best="device:period=120,probability=0.5"):
    """All settings at 200 and 220 s, `best` at 150 and 160."""
    return [line(scenario, arm, seed, value) for arm in table.tuning().arms
            for seed, value in ((1, 150), (2, 160)) if arm == best] + \
           [line(scenario, arm, seed, value) for arm in table.tuning().arms
            for seed, value in ((1, 200), (2, 220)) if arm != best]


def rows(**groups):
    """Of scenarios.csv."""
    return [{"name": name, "group": group, "tuning": ""} for name, group in groups.items()]


class Pure(support.TestCase):
    def test_arms(self):
        self.assertEqual(table.split_arms("static, device:probability=0.5,period=120,device-tuned,device:period=60"),
                         ["static", "device:period=120,probability=0.5", "device-tuned", "device"])
        self.assertEqual(table.split_arms("device:device.rerouting.period=30,threshold.factor=1.1"),
                         ["device:period=30,threshold.factor=1.1"])
        with self.assertRaisesRegex(table.Mistake, "'30'"):
            table.canonical("device:30")

    def test_tuning_arms(self):
        arms = table.tuning().arms
        self.assertEqual((len(arms), len(set(arms))), (15, 15))
        few = table.tuning("few").arms
        self.assertEqual((len(set(few)), set(few) - set(arms)), (6, set()))
        self.assertIn("device", arms)
        self.assertEqual(arms, table.split_arms(",".join(arms)))

    def test_seeds(self):
        self.assertEqual(table.split_seeds("1-3, 7,2"), [1, 2, 3, 7])
        for wrong in ("", "3-1", "x", "1-", "-2"):
            with self.assertRaises(table.Mistake, msg=wrong):
                table.split_seeds(wrong)
        self.assertEqual(commute_report.ranges([7, 1, 2, 3, 9]), "1-3, 7, 9")

    def test_lines(self):
        file = self.folder() / "sub" / "runs.csv"
        self.assertEqual(table.read(file), [])
        lines = [line("a", "device:period=30,probability=0.5", 1, 10.5), line("a", "evolved", 2, 11, router="abc+")]
        for one in lines:
            table.append(file, one)
        self.assertEqual(table.read(file), lines)
        self.assertEqual(table.key(lines[1]), ("a", "0", "evolved", "", "2", "1.28.0", "abc+"))
        self.assertEqual(table.key({**lines[1], "seed": 2}), table.key(lines[1]), "a number and its text are one key")
        file.write_text(file.read_text() + "a,0,cut o")
        with self.assertRaisesRegex(table.Mistake, "runs.csv"):
            table.read(file)

    def test_tuned(self):
        lines = tuning_lines("a")
        self.assertEqual(table.tuned(lines), "device:period=120,probability=0.5")
        better_elsewhere = [line("a", "device", 3, 1)]  # no tuning seed: it does not count
        self.assertEqual(table.tuned(lines + better_elsewhere), "device:period=120,probability=0.5")
        with self.assertRaises(LookupError) as error:
            table.tuned([one for one in lines if (one["arm"], one["seed"]) != ("device", "2")])
        self.assertEqual(error.exception.args[0], ["device"])
        few = [line("a", arm, 1, value) for value, arm in enumerate(table.tuning("few").arms)]
        self.assertEqual(table.tuned(few, "few"), "device")

    def test_current(self):
        old = [line("a", "forecast", 1, 9, router="old"), line("b", "forecast", 1, 9, router="old"),
               line("a", "static", 1, 9, hash="1"), line("a", "evolved", 1, 9, router="old")]
        new = [line("a", "forecast", 1, 8, router="new", date="2026-01-02T00:00:00"),
               line("a", "static", 1, 8, date="2026-01-02T00:00:00")]
        other = line("a", "forecast", 2, 7, router="new", options="--period 30", date="2026-01-03T00:00:00")
        self.assertCountEqual(table.current([*new, other, *old]), [old[1], old[3], *new])
        self.assertEqual(table.current([*new, other, *old], "--period 30"), [other])

    def test_statistics(self):
        self.assertAlmostEqual(commute_report.half_width([100, 110, 120]), 4.303 * 10 / 3**0.5)
        self.assertIsNone(commute_report.half_width([100]))
        self.assertEqual(commute_report.ratio({1: 50, 2: 70, 3: 999}, {1: 100, 2: 140, 4: 1}), 0.5)
        self.assertIsNone(commute_report.ratio({1: 50}, {2: 50}))

    def judged_lines(self):
        """a: forecast 110, tuned 120, static 200; b: forecast 130, tuned 120, static 100. The tuning seeds are there."""
        lines = [*tuning_lines("a"), *tuning_lines("b", "device:threshold.constant=30")]
        for scenario, tuned, static, forecast in (("a", "device:period=120,probability=0.5", 200, (100, 110, 120)),
                                                  ("b", "device:threshold.constant=30", 100, (120, 130, 140))):
            for seed in (3, 4, 5):
                lines += [line(scenario, tuned, seed, 120), line(scenario, "static", seed, static, teleports="2"),
                          line(scenario, "forecast", seed, forecast[seed - 3], router="abc", router_cpu_s="1")]
        return lines

    def test_report_of_arms(self):
        groups = rows(a="population", b="population", absent="city")
        text = commute_report.Report(self.judged_lines(), groups).long()
        self.assertIn("- `forecast`: 2 cities; better than `device-tuned` in 1 of 2 (50 %); geometric mean of the ratio "
                      f"{(110 / 120 * 130 / 120) ** 0.5:.3f}; worst against the best baseline: b, 1.300 of `static`", text)
        self.assertIn("| a | `forecast` | 3-5 | 110.0 | ±24.8 | 0.917 | 0.917 | 0.0 | 0.0 | 20 % |", text)
        # without the seeds that chose its setting, where it had 150 and 160
        self.assertIn("| a | `device-tuned` (device:period=120,probability=0.5) * | 3-5 | 120.0 | ±0.0 | 1.000 |", text)
        self.assertIn("| b | `static` * | 3-5 | 100.0 | ±0.0 | 1.000 | 0.833 | 2.0 | 0.0 | - |", text)
        self.assertIn("\nMade by `tools/commute --report` of [runs.csv](runs.csv). SUMO 1.28.0; `forecast` of src abc; "
                      "2026-01-01 to 2026-01-01.\n", text)
        self.assertNotIn("## city", text)
        with self.assertRaisesRegex(table.Mistake, "no run"):
            commute_report.Report(self.judged_lines(), rows(absent="city"))

    def test_report_names_older_routers(self):
        newer = line("a", "forecast", 3, 90, router="def", date="2026-01-02T00:00:00")
        report = commute_report.Report([*self.judged_lines(), newer], rows(a="population", b="population"), [3, 4, 5])
        self.assertIn("`forecast` of src abc, def; ", report.origin())
        self.assertIn("| a | `forecast` | 3 | 90.0 | - | 0.750 |", report.long())
        self.assertIn("| b | `forecast` of abc | 3-5 | 130.0 |", report.long())

    def test_report_of_scenarios(self):
        lines = [*self.judged_lines(), line("a", "forecast", 9, 1, router="abc"),  # a seed without the tuned device
                 line("c", "forecast", 1, 70, router="abc"), line("c", "static", 1, 100)]  # nothing tuned
        report = commute_report.Report(lines, rows(a="city", b="population", c="sample"))
        shown = report.short().splitlines()
        self.assertIn("| a | 3-5 | - | 200.0 | - | - | 120.0 | device:period=120,probability=0.5 | 110.0 ±24.8 "
                      "| 10.0 ±24.8 | 2 of 3 | 0.917 | 0.917 (device-tuned) | 0.0, 0.0 | 16 % |", shown)
        self.assertIn("| c | 1 | - | 100.0 | - | - | - | - | 70.0 | - | - | - | 0.700 (static) | -, 0.0 | 0 % |", shown)
        self.assertIn("- `forecast`: 2 scenarios; better than `device-tuned` in 1 of 1 (100 %); geometric mean of the "
                      "ratio 0.917; worst against the best baseline: a, 0.917 of `device-tuned`", shown)
        self.assertIn("- `forecast`: 1 generated cities; better than `device-tuned` in 0 of 1 (0 %); geometric mean of "
                      "the ratio 1.083; worst against the best baseline: b, 1.300 of `static`", shown)

    def test_markers(self):
        page = f"before\n{commute_report.BEGIN}\nold\n{commute_report.END}\nafter\n"
        self.assertEqual(commute_report.between_markers(page, "new\n\n"), page.replace("old", "new"))
        for wrong in ("", f"{commute_report.END}{commute_report.BEGIN}", page + page):
            with self.assertRaises(table.Mistake):
                commute_report.between_markers(wrong, "new")

    def test_page_has_the_markers(self):
        commute_report.between_markers((PROJECT / "docs" / "commute.md").read_text(encoding="utf-8"), "")

    def test_scenarios_are_the_population_and_the_samples(self):
        def names(file):
            with open(PROJECT / "scenarios" / file, newline="", encoding="utf-8") as stream:
                return {row["name"]: row for row in csv.DictReader(stream)}
        scenarios, cities = names("commute/scenarios.csv"), names("population/cities.csv")
        self.assertEqual({n for n, s in scenarios.items() if s["group"] == "population"}, cities.keys())
        for sample in (s for s in scenarios.values() if s["group"] == "sample"):
            self.assertTrue((PROJECT / sample["configuration"]).exists(), sample)
        self.assertLessEqual({s["group"] for s in scenarios.values()}, {"population", "sample", "city"})


class Matrix(support.TestCase):
    def setUp(self):
        self.commute, self.work = tool("commute"), self.folder()
        self.commute.RUNS, self.commute.SCENARIOS = self.work / "runs.csv", write(
            self.work / "scenarios.csv", "name,group,configuration,arguments,tuning\nc1,city,c.sumocfg,,\n"
                                         "c2,city,c.sumocfg,-r b.xml,few\np1,population,p1.sumocfg,,\n")
        self.commute.router_version = lambda: "abc"
        write(self.work / "c.sumocfg", '<c><net-file value="n.xml.gz"/><route-files value="a.xml, b.xml"/></c>')
        (self.work / "n.xml.gz").write_bytes(gzip.compress(b"<net/>"))
        write(self.work / "a.xml", "<a/>")
        write(self.work / "b.xml", "<b/>")
        self.fake = write(self.work / "thalweg", FAKE)
        self.fake.chmod(0o755)

    def call(self, *words, code=0):
        """(what was printed, the calls of compare)"""
        said, calls = io.StringIO(), self.work / "calls"
        calls.write_text("")
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            self.assertEqual(self.commute.main(["--thalweg", str(self.fake), "--cities", str(self.work), "--population",
                                                str(self.work / "none"), *words]), code, said.getvalue())
        return said.getvalue(), calls.read_text().splitlines()

    def test_hash(self):
        def hash_of(arguments=""):
            return self.commute.input_hash(self.work / "c.sumocfg", arguments)
        first = hash_of()
        self.assertRegex(first, "^[0-9a-f]{8}$")
        (self.work / "n.xml.gz").write_bytes(gzip.compress(b"<net/>", 1, mtime=7))
        self.assertEqual(hash_of(), first, "packed in another way")
        self.assertNotEqual(hash_of("-r b.xml"), first)
        only_b = hash_of("-r b.xml")
        write(self.work / "a.xml", "<other/>")
        self.assertNotEqual(hash_of(), first)
        self.assertEqual(hash_of("-r b.xml"), only_b)
        closed = self.commute.PROJECT / "scenarios" / "commute" / "bologna-joined-closed.add.xml"
        self.assertNotEqual(hash_of("-a {project}/scenarios/commute/" + closed.name), first)
        self.assertEqual(self.commute.in_project("-a a.xml,{project}/b.xml"),
                         ["-a", f"a.xml,{self.commute.PROJECT}/b.xml"])

    def test_runs_are_not_done_twice(self):
        said, calls = self.call("--arms", "static,device:probability=0.5,forecast", "--seeds", "1,2")
        self.assertIn("p1: left out", said)
        self.assertEqual(len(calls), 4)
        self.assertTrue(all("--arms static,device:probability=0.5,forecast" in call for call in calls))
        self.assertEqual(sum("-r b.xml" in call for call in calls), 2)
        lines = table.read(self.commute.RUNS)
        self.assertEqual(len(lines), 12)
        self.assertEqual({(one["arm"], one["router"]) for one in lines},
                         {("static", ""), ("device:probability=0.5", ""), ("forecast", "abc")})
        self.assertEqual({one["sumo"] for one in lines}, {"9.9.9"})
        self.assertEqual((lines[0]["mean_commute_s"], lines[0]["teleports"]), ("106.000", "3"))
        self.assertEqual(self.call("--arms", "forecast,static", "--seeds", "1-2")[1], [])
        calls = self.call("--arms", "forecast,given", "--seeds", "2-3", "--scenarios", "c1")[1]
        self.assertCountEqual([re.search("--arms (.*?) --seed (.)", call).groups() for call in calls],
                              [("given", "2"), ("forecast,given", "3")])
        calls = self.call("--arms", "static", "--seeds", "1", "--scenarios", "c1", "--", "--period", "30")[1]
        self.assertTrue(calls[0].endswith(" --period 30"), calls)
        self.assertEqual(table.read(self.commute.RUNS)[-1]["options"], "--period 30")

    def test_failed_runs_are_told_and_done_again(self):
        for _ in range(2):
            said, calls = self.call("--arms", "given,one-shot", "--seeds", "1", "--scenarios", "c1", code=1)
            self.assertIn("Error: c1, seed 1, one-shot: a gridlock", said)
            self.assertEqual(len(calls), 1)
        self.assertEqual([one["arm"] for one in table.read(self.commute.RUNS)], ["given"])

    def test_tune(self):
        tuned = ("--arms", "device-tuned", "--seeds", "3", "--scenarios", "c1")
        self.assertRegex(self.call(*tuned, code=1)[0], r"Error: c1: device-tuned is not known yet, 15 of 15 (?s:.*)"
                                                       r"tools/commute --tune --scenarios c1\n")
        self.call("--tune", "--scenarios", "c1,c2")
        self.assertEqual([sum(one["scenario"] == name for one in table.read(self.commute.RUNS)) for name in ("c1", "c2")],
                         [30, 6])
        calls = self.call(*tuned)[1]  # the pretended commute grows with the arm's name: `device` is the least
        self.assertEqual([re.search("--arms (.*?) --seed", call)[1] for call in calls], ["device"])

    def test_wrong(self):
        for words, message in ((["--scenarios", "x*"], "there are only c1, c2, p1"),
                               (["--scenarios", "p1"], "none of these scenarios is there"),
                               (["--seeds", "0x"], "'0x' is no seed"),
                               (["--jobs", "0"], "--jobs must be at least 1")):
            self.assertIn(f"Error: {message}" if words[0] == "--jobs" else message, self.call(*words, code=1)[0])


class Cities(support.TestCase):
    HEADER = ("name,level,kind,size,length,perturb,lanes,speed,signals,where,removed,demand,vehicles_per_hour,seconds,"
              "seed\n")
    FILES = ("small.net.xml.gz", "small.trips.xml", "small.sumocfg")

    def cities(self, text, folder):
        cities = write(self.folder() / "cities.csv", self.HEADER + text)
        return subprocess.run([sys.executable, PROJECT / "tools" / "cities", "--list", cities, folder],
                              capture_output=True, text=True, env={**os.environ, "SUMO_HOME": str(support.sumo_home())})

    def test_the_same_twice(self):
        row = "small,light,grid,6x4,150x200,10,mixed,30-60,mixed,river,0.5,crossing,600,600,5\n"
        first, second = self.folder(), self.folder()
        # 38 streets, 2 of the 4 over the river removed; half of the junctions of three streets or more
        self.assertRegex(self.cities(row, first).stdout, r"^small: 72 roads, (8|9|10) signals, 100 vehicles in 10 min\n$")
        self.cities(row, second)
        for file in self.FILES:
            self.assertEqual((first / "small" / file).read_bytes(), (second / "small" / file).read_bytes(), file)
        self.assertIn("unchanged", self.cities(row, first).stdout)
        Path(first / "small" / self.FILES[1]).write_text("")
        self.assertNotIn("unchanged", self.cities(row, first).stdout)
        self.assertEqual((first / "small" / self.FILES[1]).read_bytes(), (second / "small" / self.FILES[1]).read_bytes())

    def test_wrong(self):
        row = "small,light,{},6x4,150,0,1,50,fixed,anywhere,0,{},600,600,5\n"
        for text, message in ((row.format("hexagon", "uniform"), "there is no kind 'hexagon'"),
                              (row.format("grid", "triangle"), "there is no demand 'triangle'"),
                              ("small,light\n", "'small'")):
            done = self.cities(text, self.folder())
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertRegex(done.stderr, f"^Error: .*{message}")


if __name__ == "__main__":
    support.main()
