# SPDX-License-Identifier: Apache-2.0
"""`thalweg compare`: the same demand under several arms and seeds, each run in a process of its own."""
import hashlib
import json
import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import support
from support import (PROJECT, expand, make_grid, on_each, random_trips, read_xml, thalweg, without_comments, write,
                     write_routes)

HEAVY = PROJECT / "scenarios" / "grid" / "heavy.sumocfg"
PARTS = ("finished", "running", "waiting", "dropped", "discarded", "not_loaded")
TIMES = ("wall_s", "router_cpu_s", "simulation_cpu_s", "command")


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(v) for key, v in value.items() if key not in TIMES}
    return [without_times(v) for v in value] if isinstance(value, list) else value


def name_of(pid):
    try:
        return Path(f"/proc/{pid}/comm").read_text().strip()
    except (FileNotFoundError, ProcessLookupError):
        return ""


def is_alive(pid):
    """A zombie is not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def hashes(folder):
    return {str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
            for file in sorted(folder.rglob("*")) if file.is_file()}


def make_city(folder):
    """A city as a user has it: outputs wherever one can name them, a trip that leads nowhere, one that never
    gets in, one that comes too late."""
    folder.mkdir()
    net = make_grid(folder)
    trips = random_trips(net, 200, 100) + [
        '<trip id="nowhere" depart="101" from="A0B0" to="Atlantis"/>',
        *(f'<trip id="crowd{i}" depart="102" from="A0B0" to="D4E4"/>' for i in range(40)),
        '<trip id="late" depart="5000" from="A0B0" to="D4E4"/>']
    write_routes(folder / "trips.xml", trips)
    write(folder / "detectors.add.xml", """<additional>
        <e1Detector id="e1" lane="B1B2_0" pos="20" period="60" file="e1.xml"/>
        <e2Detector id="e2" lane="B1B2_1" pos="20" length="50" period="60" file="deep/e2.xml"/>
        <edgeData id="edges" period="60" file="edges.xml"/></additional>""")
    (folder / "deep").mkdir()
    return write(folder / "city.sumocfg", """<configuration>
        <input><net-file value="grid.net.xml"/><route-files value="trips.xml"/>
               <additional-files value="detectors.add.xml"/></input>
        <output><tripinfo-output value="my.trips.xml"/><summary-output value="deep/summary.xml"/>
                <vehroute-output value="routes.xml"/><save-state.period value="100"/>
                <save-state.prefix value="state"/></output>
        <time><end value="250"/></time>
        <processing><max-depart-delay value="60"/></processing>
        <report><log value="log.txt"/><error-log value="errors.txt"/></report></configuration>""")


class Compare(support.TestCase):
    @classmethod
    def setUpClass(cls):
        place = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="thalweg-compare-")))
        cls.configuration = make_city(place / "city")
        cls.before = hashes(place / "city")
        cls.results, cls.jsons, cls.folders = {}, {}, {}
        for jobs in (1, 2):
            # the same name of the folder for both: paths in the outputs must not differ either
            out = cls.folders[jobs] = place / f"jobs{jobs}" / "out"
            cls.results[jobs] = thalweg("compare", "-c", cls.configuration, "-o", out, "--arms", "static,device,evolved",
                                        "--seeds", "3,9", "--jobs", jobs, cwd=place)
            cls.jsons[jobs] = json.loads((out / "comparison.json").read_text())
        cls.comparison = cls.jsons[1]

    def runs(self):
        return [(arm["name"], run) for arm in self.comparison["arms"] for run in arm["runs"]]

    def test_ends_well(self):
        for result in self.results.values():
            self.assertEqual(result.exit, 0, result)
            self.assertIn("Atlantis", result.err)

    def test_jobs_make_no_difference(self):
        self.assertEqual(without_times(self.jsons[1]), without_times(self.jsons[2]))
        for arm in ("static", "device", "evolved"):
            for seed in ("3", "9"):
                for file in ("my.trips.xml", "routes.xml", "e1.xml", "deep/e2.xml"):
                    one, two = (without_comments(self.folders[jobs] / arm / seed / file) for jobs in (1, 2))
                    self.assertEqual(one, two, f"{arm} {seed} {file}")

    def test_seeds_and_arms_differ(self):
        means = {arm["name"]: tuple(run["commute_mean"] for run in arm["runs"]) for arm in self.comparison["arms"]}
        for name, (one, other) in means.items():
            self.assertNotEqual(one, other, name)
        self.assertEqual(len(set(means.values())), 3, means)

    def test_everybody_is_accounted_for(self):
        for name, run in self.runs():
            self.assertEqual(run["vehicles"], sum(run[part] for part in PARTS), (name, run))
            self.assertEqual((run["vehicles"], run["dropped"], run["not_loaded"], run["unknown"]), (242, 1, 1, 0), name)
        self.assertGreater(sum(run["discarded"] for _, run in self.runs()), 0, "max-depart-delay should discard some")
        self.assertGreater(sum(run["running"] for _, run in self.runs()), 0)

    def test_every_key_of_the_contract(self):
        top = self.comparison
        self.assertLessEqual({"thalweg", "sumo", "configuration", "command", "seeds", "arms", "differences"}, set(top))
        self.assertEqual(top["seeds"], [3, 9])
        for arm in top["arms"]:
            self.assertLessEqual({"name", "commute", "runs"}, set(arm))
            self.assertLessEqual({"mean", "low", "high"}, set(arm["commute"]))
            self.assertLessEqual(arm["commute"]["low"], arm["commute"]["mean"])
        for name, run in self.runs():
            self.assertLessEqual({"seed", "vehicles", *PARTS, "commute_mean", "duration_mean", "depart_delay_mean",
                                  "teleports", "reroutes", "wall_s", "router_cpu_s", "simulation_cpu_s", "exit"},
                                 set(run), name)
            self.assertLessEqual({"jam", "yield", "wrong_lane", "collision"}, set(run["teleports"]))
        for difference in top["differences"]:
            self.assertLessEqual({"arm", "baseline", "mean", "low", "high", "relative"}, set(difference))
        pairs = {(difference["arm"], difference["baseline"]) for difference in top["differences"]}
        self.assertLessEqual({("evolved", "static"), ("evolved", "device")}, pairs)

    def test_the_users_folder_is_untouched(self):
        self.assertEqual(hashes(self.configuration.parent), self.before)

    def test_the_users_outputs_are_in_the_runs_folder(self):
        for file in ("my.trips.xml", "deep/summary.xml", "routes.xml", "e1.xml", "deep/e2.xml", "edges.xml", "log.txt"):
            found = self.folders[1] / "evolved" / "3" / file
            self.assertTrue(found.is_file(), file)
            if file.endswith(".xml"):
                read_xml(found)
        self.assertTrue(list((self.folders[1] / "evolved" / "3").glob("state*")), "save-state")


class Outputs(support.TestCase):
    def test_outputs_named_for_sumo_are_each_runs_own(self):
        folder = self.folder()
        city = make_city(folder / "city")
        self.succeeds("compare", "-c", city, "-o", folder / "out", "--arms", "static,evolved", "--seeds", 1, "--",
                      "--fcd-output", folder / "fcd.xml", "--lanechange-output=lanes.xml", cwd=folder)
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["city", "out"])
        for arm in ("static", "evolved"):
            for file in ("fcd.xml", "lanes.xml"):
                read_xml(folder / "out" / arm / "23423" / file)


    def test_names_with_the_time(self):
        """SUMO would put the time in place of TIME; the weights of its device are those of the arms that have it."""
        folder = self.folder()
        net = support.make_grid(folder)
        trips = support.write_routes(folder / "t.xml", support.random_trips(net, 20, 20))
        city = support.write(folder / "city.sumocfg", f"""<configuration><net-file value="{net}"/>
            <route-files value="{trips}"/><output-prefix value="TIME-"/><output-suffix value="_${{UTC}}"/>
            <device.rerouting.output value="weights.xml"/><device.rerouting.period value="30"/>
            <tripinfo-output value="t.csv"/></configuration>""")
        call = ("compare", "-c", city, "--seeds", 1)
        self.assertNotIn("rerouting.output", self.succeeds(*call, "-o", folder / "o", "--arms", "device,evolved").err)
        times = "20*-*-*-*-*-*"
        for arm in ("device", "evolved"):
            self.assertEqual(len(list((folder / "o" / arm).glob(f"*/{times}-statistics_{times}.xml"))), 1)
        self.assertEqual([file.parts[-3] for file in (folder / "o").glob(f"*/*/{times}-weights_{times}.xml")], ["device"])
        told = self.succeeds(*call, "-o", folder / "none", "--arms", "given,evolved").err
        self.assertEqual(told.count("device.rerouting.output is not written"), 1)
        self.assertEqual(told.count("tripinfo-output 't.csv' is written as XML"), 1)
        self.assertEqual(told.count("device.rerouting.period of the configuration does not count"), 1)


@expand
class CompareFails(support.TestCase):
    def test_an_option_that_sumo_does_not_know(self):
        folder = self.folder()
        city = make_city(folder / "city")
        result = thalweg("compare", "-c", city, "-o", folder / "out", "--arms", "static,evolved", "--seeds", 1,
                         "--", "--no-such-option")
        self.assertEqual(result.exit, 1, result)
        for arm in json.loads((folder / "out" / "comparison.json").read_text())["arms"]:
            self.assertNotEqual(arm["runs"][0]["exit"], 0)
            self.assertIn("no-such-option", arm["runs"][0]["error"])
        self.assertIn("no-such-option", result.out + result.err)

    def test_one_arm_fails_and_the_others_go_on(self):
        folder = self.folder()
        city = make_city(folder / "city")
        result = thalweg("compare", "-c", city, "-o", folder / "out", "--arms", "device:routing-algorithm=guess,static", "--seeds", 1)
        self.assertEqual(result.exit, 1, result)
        bad, good = json.loads((folder / "out" / "comparison.json").read_text())["arms"]
        self.assertNotEqual(bad["runs"][0]["exit"], 0)
        self.assertIn("guess", bad["runs"][0]["error"])
        self.assertEqual(good["runs"][0]["exit"], 0)
        self.assertGreater(good["runs"][0]["finished"], 0)

    def test_options_of_the_runs_are_checked_before_any_work(self):
        folder = self.folder()
        for option in ("--share=2", "--period=never", "--window=0", "--threads=0", "--toll=-1"):
            result = thalweg("compare", "-c", HEAVY, "-o", folder / "out", option)
            self.assertEqual(result.exit, 1, result)
            self.assertIn(option.split("=")[0], result.err)
            self.assertFalse((folder / "out").exists())

    def test_a_setting_that_is_no_number(self):
        """SUMO would run on, without the setting."""
        folder = self.folder()
        for setting in ("probability=lots", "period=soon", "threshold.factor="):
            result = thalweg("compare", "-c", HEAVY, "-o", folder, "--arms", f"static,device:{setting}")
            self.assertEqual(result.exit, 1, result)
            self.assertIn(setting, result.err)

    def start(self, *arguments):
        process = subprocess.Popen([str(support.PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, start_new_session=True)
        self.addCleanup(self.kill, process)
        return process

    @staticmethod
    def kill(process):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.stdout.close()
        process.stderr.close()

    @staticmethod
    def children(process):
        return [int(child) for task in Path(f"/proc/{process.pid}/task").iterdir()
                for child in (task / "children").read_text().split()]

    def wait_for(self, what):
        for _ in range(6000):
            if what():
                return
            time.sleep(0.05)
        self.fail("nothing happened for 5 minutes")

    def simulating(self, folder):
        """SUMO writes tripinfos as vehicles arrive: once there are some, it is in the midst of it."""
        return any(file.stat().st_size > 4000 for file in folder.rglob("tripinfo.xml"))

    def end(self, process):
        out, err = process.communicate(timeout=300)
        with self.assertRaises(ProcessLookupError, msg="children are left"):
            os.killpg(process.pid, 0)
        return support.Result(process.returncode, out, err)

    @on_each(("the_program", "the_terminal"))  # which sends it to the children as well
    def test_interrupt_from(self, where):
        folder = self.folder()
        process = self.start("compare", "-c", HEAVY, "-o", folder, "--arms", "static,evolved", "--seeds", 4, "--jobs", 2)
        self.wait_for(lambda: self.simulating(folder))
        (os.kill if where == "the_program" else os.killpg)(process.pid, signal.SIGINT)
        result = self.end(process)
        self.assertEqual(result.exit, 1, result)
        self.assertIn("static, seed 23423, was interrupted", result.out)
        comparison = json.loads((folder / "comparison.json").read_text())
        self.assertTrue(any(arm["runs"] for arm in comparison["arms"]))
        outputs = [file for name in ("tripinfo.xml", "statistics.xml", "edgedata.xml") for file in folder.rglob(name)]
        self.assertGreaterEqual(len(outputs), 3)
        for file in outputs:
            read_xml(file)
        self.assertEqual(list(folder.rglob("*.tmp")), [])

    @on_each(("prepared", "loaded"))
    def test_interrupt_before_the_first_step(self, when):
        """While duarouter is at work, and while SUMO loads."""
        folder = self.folder()
        file = folder / ("demand" if when == "prepared" else "run.sumocfg")
        process = self.start("run", "-c", HEAVY, "-o", folder)
        self.wait_for(file.exists)
        process.send_signal(signal.SIGTERM)
        result = self.end(process)
        self.assertEqual(result.exit, 1, result)
        self.assertRegex(result.err, "^(Error|Warning): interrupted ")

    @on_each(("int", "term", "hup"))
    def test_interrupt_of_a_run(self, name):
        folder = self.folder()
        process = self.start("run", "-c", HEAVY, "-o", folder, "--decision-output", "decisions.xml.gz")
        self.wait_for(lambda: self.simulating(folder))
        process.send_signal(getattr(signal, "SIG" + name.upper()))
        result = self.end(process)
        self.assertEqual(result.exit, 1, result)
        self.assertRegex(result.err, r"Warning: interrupted at \d+")
        self.assertRegex(result.out, r"\n  forecast +\d+\.\d")  # the figures up to there
        for name in ("tripinfo.xml", "statistics.xml", "decisions.xml.gz"):
            self.assertGreater(len(read_xml(folder / name)), 0, name)
        summary = json.loads((folder / "run.json").read_text())
        self.assertEqual(summary["vehicles"], sum(summary[part] for part in PARTS))

    def kill_program(self, process):
        """With -9; returns when its children are gone, too."""
        children = self.children(process)
        process.kill()
        process.communicate(timeout=60)
        self.wait_for(lambda: not any(is_alive(pid) for pid in children))

    def test_duarouter_does_not_outlive_us(self):
        folder = self.folder()
        process = self.start("run", "-c", HEAVY, "-o", folder)
        self.wait_for(lambda: any(name_of(pid) == "duarouter" for pid in self.children(process)))
        os.kill(self.children(process)[0], signal.SIGSTOP)  # else it ends in any case
        self.kill_program(process)

    def test_runs_do_not_outlive_us(self):
        """They end in order, with what they have."""
        folder = self.folder()
        process = self.start("compare", "-c", HEAVY, "-o", folder, "--arms", "static", "--seeds", 1)
        self.wait_for(lambda: self.simulating(folder))
        self.kill_program(process)
        summary = json.loads((folder / "static" / "23423" / "run.json").read_text())
        self.assertEqual(summary["error"], "interrupted")

    def test_a_child_that_is_killed(self):
        folder = self.folder()
        process = self.start("compare", "-c", HEAVY, "-o", folder, "--arms", "static", "--seeds", 2, "--", "--end", 600)
        self.wait_for(lambda: self.simulating(folder))
        os.kill(self.children(process)[0], signal.SIGKILL)
        result = self.end(process)
        self.assertEqual(result.exit, 1, result)
        runs = json.loads((folder / "comparison.json").read_text())["arms"][0]["runs"]
        self.assertEqual([run["exit"] for run in runs], [128 + signal.SIGKILL, 0])
        self.assertNotIn("commute_mean", {key for key, value in runs[0].items() if value is not None})


if __name__ == "__main__":
    support.main()
