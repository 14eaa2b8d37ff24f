# SPDX-License-Identifier: Apache-2.0
"""What the tests that drive the program share. Only the standard library and SUMO's own sumolib."""
import gzip
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("THALWEG", PROJECT / "build" / "thalweg"))
SAMPLES = ("grid", "twin", "spider", "random")
SKIPPED = 77  # ctest: this file could run none of its tests


def sumo_home():
    home = os.environ.get("THALWEG_SUMO_HOME") or os.environ.get("SUMO_HOME")
    if not home:
        home = next(iter(PROJECT.glob(".venv/lib/python3*/site-packages/sumo")), "/usr/share/sumo")
    return Path(home)


os.environ["SUMO_HOME"] = str(sumo_home())
sys.path.insert(0, str(sumo_home() / "tools"))
import sumolib  # noqa: E402  (SUMO's own, from the folder just named)

# ----------------------------------------------------------------------------------------------- cities

CITIES_FOLDER = Path(os.environ.get("THALWEG_CITIES", PROJECT.parent / "shared" / "cities"))
CITY_FILES = {  # configuration, network
    "bologna-acosta": ("run.sumocfg", "acosta_buslanes.net.xml"),
    "bologna-joined": ("run.sumocfg", "joined_buslanes.net.xml"),
    "wildau": ("wildau.sumocfg", "Netzmodell2.net.xml.gz"),
    "luxembourg": ("luxembourg.sumocfg", "luxembourg.net.xml.gz"),
}


class City:
    """One of the public cities; a test that asks for one that is not there is skipped."""

    def __init__(self, name):
        folder = CITIES_FOLDER / name
        if not folder.is_dir():
            raise unittest.SkipTest(f"the city '{name}' is not in '{CITIES_FOLDER}' (set THALWEG_CITIES)")
        self.name = name
        self.configuration = folder / CITY_FILES[name][0]
        self.net = folder / CITY_FILES[name][1]


def sample_net(name):
    return PROJECT / "networks" / f"{name}.net.xml.gz"


# --------------------------------------------------------------------------------------------- programs

def tool(name):
    """One of SUMO's programs."""
    for folder in (sumo_home() / "bin", sumo_home() / ".." / ".." / "bin"):
        if (folder / name).exists():
            return str(folder / name)
    found = shutil.which(name)
    if found is None:
        raise unittest.SkipTest(f"SUMO's {name} is not installed")
    return found


def run_tool(name, *arguments, cwd=None):
    """Runs one of SUMO's programs to a good end; returns what it printed."""
    call = [tool(name), *map(str, arguments)]
    done = subprocess.run(call, cwd=cwd, capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        raise AssertionError(f"{name} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


class Result:
    def __init__(self, exit_code, out, err):
        self.exit, self.out, self.err = exit_code, out, err

    def __str__(self):
        return f"exit {self.exit}\n--- stdout\n{self.out[-3000:]}\n--- stderr\n{self.err[-3000:]}"


def thalweg(*arguments, cwd=None, timeout=900, env=None):
    done = subprocess.run([str(PROGRAM), *map(str, arguments)], cwd=cwd, capture_output=True, text=True,
                          errors="replace", timeout=timeout, env=env)
    return Result(done.returncode, done.stdout, done.stderr)


# ------------------------------------------------------------------------------------------------ tests

class TestCase(unittest.TestCase):
    maxDiff = 4000

    def folder(self):
        """A folder of this test alone, removed at its end (kept when THALWEG_KEEP is set)."""
        path = Path(tempfile.mkdtemp(prefix=f"thalweg-{self._testMethodName}-"))
        if os.environ.get("THALWEG_KEEP"):
            print(f"kept: {path}")
        else:
            self.addCleanup(shutil.rmtree, path, ignore_errors=True)
        return path

    def succeeds(self, *arguments, **how):
        """Runs the program; it must end with 0."""
        result = thalweg(*arguments, **how)
        self.assertEqual(result.exit, 0, f"thalweg {' '.join(map(str, arguments))}\n{result}")
        return result


def on_each(names):
    """Makes test_x into test_x_<name> for each name, so that every one passes, fails and skips by itself."""
    def mark(method):
        method.each = tuple(names)
        return method
    return mark


def expand(case):
    """Class decorator that goes with on_each."""
    for name, method in list(vars(case).items()):
        if not hasattr(method, "each"):
            continue
        delattr(case, name)
        for value in method.each:
            def one(self, method=method, value=value):
                method(self, value)
            one.__doc__ = method.__doc__
            setattr(case, f"{name}_{re.sub('[^a-z0-9]', '_', value)}", one)
    return case


def main():
    """unittest.main, but nothing is skipped in silence: exit 77 when nothing at all ran."""
    program = unittest.main(module="__main__", exit=False, verbosity=2)
    result = program.result
    for test, reason in result.skipped:
        print(f"LEFT OUT: {test.id()}: {reason}", file=sys.stderr)
    if not result.wasSuccessful():
        sys.exit(1)
    sys.exit(SKIPPED if result.skipped and len(result.skipped) == result.testsRun else 0)


# -------------------------------------------------------------------------------------------------- XML

def open_text(file):
    return gzip.open(file, "rt", encoding="utf-8") if str(file).endswith(".gz") else open(file, encoding="utf-8")


def read_xml(file):
    """The root of a whole file."""
    opened = gzip.open(file, "rb") if str(file).endswith(".gz") else open(file, "rb")
    with opened:
        return ElementTree.parse(opened).getroot()


def without_comments(file):
    """The text of an output without the header comment, which names the date and the paths."""
    with open_text(file) as stream:
        return re.sub(r"<!--.*?-->", "", stream.read(), flags=re.DOTALL)


def write(file, text):
    Path(file).write_text(text, encoding="utf-8")
    return Path(file)


# ----------------------------------------------------------------------------------------------- cities of ours

def make_grid(folder, *options, number=5):
    """A grid of signalised junctions, 150 m apart, junction names A0, A1 .. and roads A0A1 ..; its net."""
    net = Path(folder) / "grid.net.xml"
    run_tool("netgenerate", "--grid", "--grid.number", number, "--grid.length", 150, "--default.lanenumber", 2,
             "--default-junction-type", "traffic_light", "--no-turnarounds", "true", "-o", net, *options)
    return net


def normal_roads(net):
    return sorted(road.getID() for road in sumolib.net.readNet(str(net)).getEdges(withInternal=False))


def random_trips(net, count, duration, seed=7, **more):
    """`count` trips within `duration` seconds between roads drawn at random; `more`: attributes of each."""
    draw, roads = random.Random(seed), normal_roads(net)
    extra = "".join(f' {name}="{value}"' for name, value in more.items())
    trips = []
    for i in range(count):
        origin, destination = draw.sample(roads, 2)
        trips.append(f'<trip id="t{i}" depart="{i * duration / count:.2f}" from="{origin}" to="{destination}"{extra}/>')
    return trips


def write_routes(file, elements):
    return write(file, "<routes>\n" + "\n".join(elements) + "\n</routes>\n")


# ------------------------------------------------------------------------------------------------- runs

def in_order(parts, whole):
    """Whether `whole` has all of `parts`, in their order."""
    remaining = iter(whole)
    return all(part in remaining for part in parts)


class Run:
    """What `thalweg run` left in its folder."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.summary = json.loads((self.folder / "run.json").read_text())
        self.trips = {trip.get("id"): trip for trip in read_xml(self.folder / "tripinfo.xml").iter("tripinfo")}

    def decisions(self):
        return list(read_xml(self.folder / "decisions.xml"))

    def route_lists(self):
        """Of each vehicle: its routes one after the other, as (the time it was replaced or None, roads)."""
        routes = {}
        for vehicle in read_xml(self.folder / "vehroute.xml").iter("vehicle"):
            lists = [(route.get("replacedAtTime"), route.get("edges").split()) for route in vehicle.iter("route")]
            routes[vehicle.get("id")] = [(None if time is None else float(time), roads) for time, roads in lists]
        return routes

    def routes(self):
        """Of each vehicle: the route it drove in the end."""
        return {vehicle: routes[-1][1] for vehicle, routes in self.route_lists().items()}


class RunCase(TestCase):
    """For tests of `thalweg run`."""

    def assert_accounted(self, summary):
        parts = ("finished", "running", "waiting", "dropped", "discarded", "not_loaded")
        self.assertEqual(summary["vehicles"], sum(summary[part] for part in parts), summary)
        self.assertEqual((summary["unknown"], summary["exit"], summary["error"]), (0, 0, None))

    def run_city(self, *arguments, sumo=(), name="run", folder=None, **how):
        """`thalweg run` with a decision log and SUMO's routes of each vehicle; checks that nobody is lost."""
        folder = (folder or self.folder()) / name
        folder.mkdir()
        self.succeeds("run", "-o", folder, "--decision-output", "decisions.xml", *arguments, "--",
                      "--vehroute-output", folder / "vehroute.xml", "--vehroute-output.write-unfinished", *sumo, **how)
        run = Run(folder)
        self.assert_accounted(run.summary)
        return run


class GridCase(RunCase):
    """
        A4 - B4 - C4 - D4 - E4      25 signalised junctions, 150 m apart
        |    |    |    |    |
        ..                  ..
        |    |    |    |    |
        A0 - B0 - C0 - D0 - E0
    """

    def setUp(self):
        self.place = self.folder()
        self.net = make_grid(self.place)
