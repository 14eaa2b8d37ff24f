# SPDX-License-Identifier: Apache-2.0
"""`thalweg days`: one simulation after the other, each with the memory of those before."""
import gzip
import json
import tempfile
from pathlib import Path

import support
from support import expand, make_grid, on_each, random_trips, read_xml, run_tool, thalweg, without_comments, write, write_routes

DAYS = 3
VEHICLES = 150


@expand
class Days(support.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="thalweg-days-")))
        cls.net = make_grid(cls.place)
        write_routes(cls.place / "trips.xml", random_trips(cls.net, VEHICLES, 100))
        cls.configuration = write(cls.place / "city.sumocfg", """<configuration><input>
            <net-file value="grid.net.xml"/><route-files value="trips.xml"/></input></configuration>""")
        cls.out = cls.place / "out"
        cls.result = cls.days("--days", DAYS)
        cls.json = json.loads((cls.out / "days.json").read_text())

    @classmethod
    def days(cls, *arguments, out=None):
        return thalweg("days", "-c", cls.configuration, "-o", out or cls.out, *arguments)

    def memory(self, day, file, out=None):
        return (out or self.out) / f"day-{day:03}" / "memory" / file

    def test_a_line_and_an_entry_for_each_day(self):
        self.assertEqual(self.result.exit, 0, self.result)
        self.assertEqual([day["day"] for day in self.json["days"]], [1, 2, 3])
        self.assertEqual([day["seed"] for day in self.json["days"]], [23423, 23424, 23425])
        for day in self.json["days"]:
            self.assertEqual((day["finished"], day["exit"], day["arm"]), (VEHICLES, 0, "memory"))
            self.assertIn(f"{day['commute_mean']:.1f}", self.result.out)
        self.assertTrue(self.result.out.startswith("SUMO 1"), self.result.out)

    def test_each_day_remembers_those_before(self):
        for day in range(1, DAYS + 1):
            times = read_xml(self.memory(day, "times.xml.gz"))
            self.assertEqual(int(times.get("days")), day)
            most = max(int(edge.get("days")) for edge in times.iter("edge"))
            self.assertEqual(most, day, "some road is driven every day")
            routes = read_xml(self.memory(day, "routes.rou.xml.gz"))
            self.assertEqual(len({vehicle.get("id") for vehicle in routes}), VEHICLES)

    def test_the_times_are_those_of_sumos_own_measurement(self):
        """Day 1's vehicle-seconds by road against edgeData's, over the bins that the memory has a time for: those with less
        than half a traversal are left out by design. Of all bins together it has nearly all."""
        bin = next(read_xml(self.memory(1, "times.xml.gz")).iter("interval"))
        period = float(bin.get("end")) - float(bin.get("begin"))
        folder = self.folder()
        write(folder / "e.add.xml",
              f'<additional><edgeData id="e" file="edges.xml" withInternal="true" period="{period}"/></additional>')
        self.succeeds("run", "-c", self.configuration, "-a", folder / "e.add.xml", "-o", folder / "run",
                           "--strategy", "memory", "--memory-output", folder / "memory")

        def by_bin(file, seconds):
            return {(float(interval.get("begin")), edge.get("id")): seconds(edge)
                    for interval in read_xml(file).iter("interval") for edge in interval.iter("edge")}

        def by_road(times, bins):
            roads = {}
            for bin_and_road in bins:
                roads[bin_and_road[1]] = roads.get(bin_and_road[1], 0) + times[bin_and_road]
            return roads

        measured = by_bin(folder / "run" / "edges.xml", lambda edge: float(edge.get("sampledSeconds")))
        remembered = by_bin(folder / "memory" / "times.xml.gz",
                            lambda edge: float(edge.get("traveltime")) * float(edge.get("observations")))
        seen, lived = by_road(measured, remembered), by_road(remembered, remembered)
        self.assertTrue(any(road.startswith(":") for road in lived), "junction roads are lived as well")
        everything = by_road(measured, measured)
        normal = [road for road in everything if not road.startswith(":") and everything[road] > 200]
        self.assertGreater(len(normal), 20)
        for road in normal:
            self.assertLess(abs(lived[road] - seen[road]), 0.15 * seen[road], road)
        total = sum(everything[road] for road in normal)
        self.assertLess(abs(sum(lived[road] for road in normal) - total), 0.05 * total)

    def test_duarouter_reads_the_memory(self):
        folder = self.folder()
        run_tool("duarouter", "-n", self.net, "-r", self.place / "trips.xml", "--weight-files",
                 self.memory(DAYS, "times.xml.gz"), "-o", folder / "routes.xml")
        self.assertEqual(len(list(read_xml(folder / "routes.xml").iter("vehicle"))), VEHICLES)

    def test_goes_on_after_the_days_that_are_there(self):
        folder = self.folder()
        self.assertEqual(self.days("--days", 1, out=folder).exit, 0)
        first = without_comments(self.memory(1, "routes.rou.xml.gz", folder))
        result = self.days("--days", 2, out=folder)
        self.assertEqual(result.exit, 0, result)
        self.assertIn("1 day(s) are there already", result.err)
        self.assertEqual(without_comments(self.memory(1, "routes.rou.xml.gz", folder)), first)
        for day in (1, 2):
            for file in ("times.xml.gz", "routes.rou.xml.gz"):
                self.assertEqual(without_comments(self.memory(day, file, folder)),
                                 without_comments(self.memory(day, file)), f"day {day}: {file}")

    @on_each(("--seed=5", "--same-seed"))
    def test_does_not_go_on_after_days_of_another_call(self, other):
        result = self.days("--days", 4, other)
        self.assertEqual(result.exit, 1, result)
        self.assertIn("another call", result.err)

    def test_more_days_than_asked_for_are_there_already(self):
        result = self.days("--days", 2)
        self.assertEqual(result.exit, 0, result)
        self.assertIn("3 day(s) are there already", result.err)

    def test_a_damaged_memory_ends_it_in_words(self):
        folder = self.folder()
        self.assertEqual(self.days("--days", 1, out=folder).exit, 0)
        file = self.memory(1, "times.xml.gz", folder)
        file.write_bytes(file.read_bytes()[:100])
        result = self.days("--days", 3, out=folder)
        self.assertEqual(result.exit, 1, result)
        self.assertIn("times.xml.gz", result.out)
        self.assertEqual(len(json.loads((folder / "days.json").read_text())["days"]), 2, "no day learns from it")

    def test_a_router_without_memory_starts_anew_each_day(self):
        folder = self.folder()
        result = self.days("--days", 2, "--strategy", "device", "--same-seed", out=folder)
        self.assertEqual(result.exit, 0, result)
        one, two = json.loads((folder / "days.json").read_text())["days"]
        self.assertEqual(one["commute_mean"], two["commute_mean"])
        self.assertFalse((folder / "day-001" / "memory").exists())

    def test_the_ways_of_the_memory_are_driven(self):
        """Everybody is remembered to have gone round by B1 and C1, which nobody would do today."""
        folder = self.folder()
        way, round_about = "A0B0 B0C0 C0D0", "A0B0 B0B1 B1C1 C1C0 C0D0"
        write_routes(folder / "trips.xml", [f'<vehicle id="v{i}" depart="{9 * i}"><route edges="{way}"/></vehicle>'
                                            for i in range(20)])
        (folder / "memory").mkdir()
        for name, text in (
                ("times.xml.gz", '<memory days="1" bin="90" commute="1000"/>'),
                ("routes.rou.xml.gz", "<routes>" + "".join(
                    f'<vehicle id="v{i}" depart="{9 * i}"><route edges="{round_about}"/></vehicle>'
                    for i in range(20)) + "</routes>")):
            (folder / "memory" / name).write_bytes(gzip.compress(text.encode()))
        taken = {}
        for name, options in (("anew", ()), ("remembered", ("--memory-input", folder / "memory"))):
            self.succeeds("run", "-n", self.net, "-r", folder / "trips.xml", "-o", folder / name, "--strategy", "memory",
                          "--memory-output", folder / f"{name}-after", *options)
            routes = read_xml(folder / f"{name}-after" / "routes.rou.xml.gz").iter("route")
            taken[name] = sum(route.get("edges") == round_about for route in routes)
        self.assertEqual(taken["anew"], 0)
        self.assertGreater(taken["remembered"], 12, "a few look for better ways, the others stay")
        self.assertLess(taken["remembered"], 20)

    def test_memory_options_without_the_strategy(self):
        result = thalweg("run", "-c", self.configuration, "-o", self.folder(), "--strategy", "forecast",
                         "--memory-output", self.folder() / "memory")
        self.assertEqual(result.exit, 1, result)
        self.assertIn("--strategy memory", result.err)


if __name__ == "__main__":
    support.main()
