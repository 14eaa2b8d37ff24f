# SPDX-License-Identifier: Apache-2.0
"""One run of SUMO with our router in charge: what comes out, and what is kept."""
import json
import statistics

import support
from support import (PROJECT, expand, in_order, make_grid, on_each, random_trips, read_xml, sumolib,
                     without_comments, write, write_routes)

LIGHT = PROJECT / "scenarios" / "grid" / "light.sumocfg"
EAGER = ("--gain.relative", 0, "--gain.spread", 0, "--gain.absolute", 0, "--period", 10)  # changes often


@expand
class GridLight(support.RunCase):
    """The sample city."""

    @classmethod
    def setUpClass(cls):
        cls.network = sumolib.net.readNet(str(PROJECT / "networks" / "grid.net.xml.gz"))

    def test_everybody_is_accounted_for(self):
        run = self.run_city("-c", LIGHT)
        self.assertEqual((run.summary["vehicles"], run.summary["finished"], len(run.trips)), (600, 600, 600))
        commutes = [float(t.get("duration")) + float(t.get("departDelay")) for t in run.trips.values()]
        self.assertAlmostEqual(run.summary["commute_mean"], statistics.mean(commutes), places=2)
        self.assertGreater(run.summary["reroutes"], 0)
        changed = sum(decision.get("changed") == "true" for decision in run.decisions())
        self.assertEqual(run.summary["reroutes"], changed)

    @on_each(("evolved", "forecast"))
    def test_same_seed_same_bytes(self, strategy):
        files = ("tripinfo.xml", "vehroute.xml", "decisions.xml")
        first, again, threads, other = (
            [without_comments(self.run_city("-c", LIGHT, "--strategy", strategy, *more).folder / file) for file in files]
            for more in ((), (), ("--threads", 2), ("--seed", 1)))
        self.assertEqual(first, again)
        self.assertEqual(first, threads)
        for file, text, different in zip(files, first, other):
            self.assertNotEqual(text, different, f"{file}: another seed should give another run")

    def test_who_knows_what_signals_show_is_earlier(self):
        """All signals of this city show the same in every cycle, and hardly anybody queues."""
        known, mean = (self.run_city("-c", LIGHT, *more).summary["commute_mean"]
                       for more in ((), ("--no-signal-phases",)))
        self.assertLess(known, 0.95 * mean)

    def test_decisions(self):
        """The log's routes are connected, end where the trip ends, and predict arrivals that make sense."""
        run = self.run_city("-c", LIGHT)
        roads = {road.getID(): {to.getID() for to in road.getOutgoing()} for road in self.network.getEdges()}
        ratios = []
        for decision in run.decisions():
            vehicle, time = decision.get("vehicle"), float(decision.get("time"))
            routes = [decision.get("oldRoute").split()]
            if decision.get("changed") == "true":
                routes.append(decision.get("newRoute").split())
                self.assertLessEqual(float(decision.get("newCost")), float(decision.get("oldCost")))
                self.assertNotEqual(*routes)
            for route in routes:
                for before, after in zip(route, route[1:]):
                    self.assertIn(after, roads[before], f"{vehicle} at {time}: {route}")
            self.assertEqual({route[0] for route in routes}, {routes[0][0]})
            self.assertEqual({route[-1] for route in routes}, {routes[0][-1]})
            arrival, predicted = float(decision.get("arrival")), float(decision.get("predictedArrival"))
            self.assertAlmostEqual(arrival, float(run.trips[vehicle].get("arrival")), delta=1)
            self.assertLess(time, arrival)
            self.assertLess(time, predicted)
            ratios.append((arrival - time) / (predicted - time))
        self.assertGreater(len(ratios), 600)
        self.assertTrue(0.8 < statistics.median(ratios) < 2.5, statistics.median(ratios))

    def test_the_routes_driven_are_the_ones_decided(self):
        run = self.run_city("-c", LIGHT)
        last = {}
        for decision in run.decisions():
            last[decision.get("vehicle")] = decision.get("newRoute" if decision.get("changed") == "true" else "oldRoute")
        for vehicle, route in run.routes().items():
            decided = last[vehicle].split()
            self.assertEqual(route[-len(decided):], decided, vehicle)

    def test_share(self):
        run = self.run_city("-c", LIGHT, "--share", 0.3)
        touched = {decision.get("vehicle") for decision in run.decisions()}
        self.assertTrue(0.24 < len(touched) / 600 < 0.36, len(touched))
        given = routes_of(run.folder / "demand" / "given.rou.xml")
        for vehicle, route in run.routes().items():
            if vehicle not in touched:
                self.assertEqual(route, given[vehicle], vehicle)
        changed = {decision.get("vehicle") for decision in run.decisions() if decision.get("changed") == "true"}
        self.assertGreater(len(changed), 10)


def routes_of(file):
    return {vehicle.get("id"): vehicle.find("route").get("edges").split() for vehicle in read_xml(file).iter("vehicle")}


@expand
class SmallGrid(support.GridCase):
    def trips(self, elements, name="trips.xml"):
        return write_routes(self.place / name, elements)

    def drive(self, elements, *arguments, **how):
        return self.run_city("-n", self.net, "-r", self.trips(elements), *EAGER, *arguments, **how)

    def test_waiting_vehicles_are_routed_before_insertion(self):
        """60 vehicles want to start on one road at once: most wait, and drive what was decided last."""
        trips = [f'<trip id="q{i}" depart="0" from="A0B0" to="D4E4"/>' for i in range(60)]
        run = self.drive(trips, "--period", 10)
        decisions = {}
        for decision in run.decisions():
            decisions.setdefault(decision.get("vehicle"), []).append(decision)
        waited = changed = 0
        for vehicle, routes in run.route_lists().items():
            depart = float(run.trips[vehicle].get("depart"))
            before = [d for d in decisions[vehicle] if float(d.get("time")) <= depart]
            self.assertGreater(float(before[-1].get("time")), depart - 11, f"{vehicle} departs at {depart}")
            decided = before[-1].get("newRoute" if before[-1].get("changed") == "true" else "oldRoute").split()
            at_depart = next(roads for replaced, roads in routes if replaced is None or replaced > depart)
            self.assertEqual(at_depart, decided, vehicle)
            waited += len(before) > 1
            changed += any(d.get("changed") == "true" for d in before)
        self.assertGreater(waited, 20)
        self.assertGreater(changed, 5)

    def test_period_step(self):
        """Everybody decides as soon as there is another road or other costs: at every look of the forecast."""
        run = self.drive(random_trips(self.net, 60, 60), "--period", "step")
        of_one = [float(d.get("time")) for d in run.decisions() if d.get("vehicle") == "t0"]
        duration = float(run.trips["t0"].get("duration"))
        self.assertGreater(len(of_one), duration / 6)
        self.assertLessEqual(statistics.median(b - a for a, b in zip(of_one, of_one[1:])), 5)

    @on_each(("0.1", "0.5"))
    def test_step_length(self, length):
        run = self.drive(random_trips(self.net, 60, 60), "--step-length", length, "--period", "step")
        self.assertEqual(run.summary["finished"], 60)
        times = sorted({round(float(d.get("time")) / float(length), 6) for d in run.decisions()})
        self.assertEqual([time for time in times if time != int(time)], [])
        self.assertTrue(any(time % 2 for time in times), "somebody decided after an odd number of steps")
        self.assertGreater(run.summary["reroutes"], 0)

    def test_meso(self):
        run = self.drive(random_trips(self.net, 200, 100), sumo=["--mesosim"])
        self.assertEqual(run.summary["finished"], 200)
        self.assertGreater(run.summary["reroutes"], 0)
        self.assertEqual((run.folder / "sumo.log").read_text(), "", "a warning for every decision")

    def test_meso_is_foretold(self):
        """Mesoscopic vehicles are on no lane; not seen on their roads, everybody is foretold 70 % too long."""
        run = self.drive(random_trips(self.net, 400, 100), sumo=["--mesosim"])
        errors = [horizon for horizon in run.summary["forecast_error"] if horizon["predictions"]]
        bias, realised = (sum(e["predictions"] * e[key] for e in errors) for key in ("bias", "realised_mean"))
        self.assertLess(abs(bias), 0.5 * realised)

    def test_a_saved_configuration_runs(self):
        """The file of -C names the user's configuration, wherever it is read from."""
        folder = self.folder()
        trips = self.trips(random_trips(self.net, 20, 10))
        city = write(self.place / "city.sumocfg", f"""<configuration><net-file value="{self.net.name}"/>
            <route-files value="{trips.name}"/><end value="500"/></configuration>""")
        self.succeeds("run", "-c", city.name, "--period", 30, "--end", 60, "-C", folder / "saved.cfg", cwd=self.place)
        self.succeeds("run", "-c", folder / "saved.cfg", "-o", folder / "out")
        self.assertEqual(json.loads((folder / "out" / "run.json").read_text())["end_s"], 60)

    @on_each(("none.sumocfg", "city.sumocfg", "other.sumocfg"))
    def test_a_configuration_that_names_none_or_itself_or_one_that_names_it(self, named):
        """SUMO does not look at such a name."""
        trips = self.trips(random_trips(self.net, 20, 10))
        for name, other in (("city.sumocfg", named), ("other.sumocfg", "city.sumocfg")):
            write(self.place / name, f"""<configuration><configuration-file value="{other}"/>
                <net-file value="{self.net.name}"/><route-files value="{trips.name}"/></configuration>""")
        run = self.run_city("-c", self.place / "city.sumocfg")
        self.assertEqual(run.summary["finished"], 20)

    def test_left_hand(self):
        self.net = make_grid(self.place, "--lefthand")
        run = self.drive(random_trips(self.net, 200, 100))
        self.assertEqual(run.summary["finished"], 200)
        self.assertGreater(run.summary["reroutes"], 0)

    @on_each(("hybrid", "evolved", "forecast", "cch", "dijkstra", "given", "static", "one-shot", "device", "device:period=10"))
    def test_way_points(self, strategy):
        """`via` is driven through, in its order, whoever routes."""
        via = ("B4C4", "D1D0", "A2A3")
        with_via = [f'<trip id="v{i}" depart="{2 * i}" from="A0B0" to="D4E4" via="{" ".join(via)}"/>'
                    for i in range(30)]
        run = self.drive(sorted(with_via + random_trips(self.net, 150, 60), key=departure), "--strategy", strategy)
        for vehicle, route in run.routes().items():
            if vehicle.startswith("v"):
                self.assertTrue(in_order(via, route), f"{vehicle}: {route}")
        if strategy in ("evolved", "cch", "dijkstra"):
            of_via = {d.get("vehicle") for d in run.decisions() if d.get("changed") == "true"}
            self.assertTrue(any(vehicle.startswith("v") for vehicle in of_via), "nobody with via was re-routed")

    def test_a_flow_of_a_trips_id(self):
        """SUMO takes both; each has its own way points."""
        ends = 'from="A0B0" to="D4E4"'
        run = self.drive([f'<trip id="7" depart="0" {ends} via="B4C4"/>',
                          f'<flow id="7" begin="0" end="40" number="4" {ends} via="D1D0"/>'])
        routes = run.routes()
        self.assertEqual(set(routes), {"7", "7.0", "7.1", "7.2", "7.3"})
        self.assertIn("B4C4", routes.pop("7"))
        for vehicle, route in routes.items():
            self.assertIn("D1D0", route, vehicle)

    @on_each(("hybrid", "evolved", "forecast", "device"))
    def test_stops(self, strategy):
        """Who has stops makes them all, in their order."""
        stops = ("C2C3", "D1D0")
        made_of = "".join(f'<stop lane="{road}_0" duration="5" parking="true"/>' for road in stops)
        with_stops = [f'<trip id="s{i}" depart="{3 * i}" from="A0B0" to="D4E4">{made_of}</trip>' for i in range(20)]
        run = self.drive(sorted(with_stops + random_trips(self.net, 150, 60), key=departure), "--strategy", strategy,
                         sumo=["--stop-output", self.place / "stops.xml"])
        made = {}
        for stop in read_xml(self.place / "stops.xml"):
            made.setdefault(stop.get("id"), []).append(stop.get("lane").rpartition("_")[0])
        self.assertEqual(made, {f"s{i}": list(stops) for i in range(20)})
        if strategy == "evolved":
            changed = {d.get("vehicle") for d in run.decisions() if d.get("changed") == "true"}
            self.assertTrue(any(vehicle.startswith("s") for vehicle in changed), "nobody with stops was re-routed")

    @on_each(("device", "evolved", "forecast"))
    def test_a_loop_is_cut_as_by_sumo(self, strategy):
        """Round the block and on: SUMO's device drives on at once, unless there is a stop on the way; so do we."""
        loop = '<route edges="A0A1 A1B1 B1B0 B0A0 A0A1 A1A2 A2A3"/>'
        run = self.drive([f'<vehicle id="round" depart="0">{loop}</vehicle>',
                          f'<vehicle id="stops" depart="60">{loop}<stop edge="B1B0" duration="5"/></vehicle>'],
                         "--strategy", strategy)
        self.assertEqual(run.routes()["round"], ["A0A1", "A1A2", "A2A3"])
        self.assertEqual(run.routes()["stops"], ["A0A1", "A1B1", "B1B0", "B0A0", "A0A1", "A1A2", "A2A3"])

    def test_warnings_of_sumo_do_not_drown_ours(self):
        """The same for many vehicles: three, and how many more; the log has them all."""
        trips = [f'<trip id="q{i}" depart="0" from="A0B0" to="D4E4"/>' for i in range(60)]
        folder = self.place / "run"
        result = self.succeeds("run", "-n", self.net, "-r", self.trips(trips), "-o", folder, "--", "--time-to-teleport", 5)
        kind = "waited too long (yield)"
        all_of_them = (folder / "sumo.log").read_text().count(kind)
        self.assertGreater(all_of_them, 10)
        shown = [line for line in result.err.splitlines() if line.startswith("Warning: Teleporting") and kind in line]
        self.assertEqual(len(shown), 3)
        self.assertRegex(result.err, rf"\.\.\. and {all_of_them - 3} more like this one of SUMO's: Teleporting .*sumo\.log")

    def test_buses_are_left_alone(self):
        bus = '<vType id="bus" vClass="bus"/>'
        route = "A0B0 B0C0 C0D0 D0D1 D1D2 D2C2 C2C3 C3C4"
        buses = [f'<vehicle id="b{i}" type="bus" line="7" depart="{5 * i}"><route edges="{route}"/></vehicle>'
                 for i in range(12)]
        run = self.drive([bus, *sorted(buses + random_trips(self.net, 200, 60), key=departure)])
        routes = run.routes()
        self.assertEqual([routes[f"b{i}"] for i in range(12)], [route.split()] * 12)
        self.assertEqual({d.get("vehicle") for d in run.decisions() if d.get("vehicle").startswith("b")}, set())
        self.assertEqual(run.summary["fixed"]["vehicles"], 12)
        self.assertGreater(run.summary["reroutes"], 0)

    def configuration(self, elements):
        """A city whose type and whose configuration both ask for SUMO's rerouting."""
        vehicle_type = ('<vType id="eager"><param key="has.rerouting.device" value="true"/>'
                        '<param key="device.rerouting.period" value="5"/></vType>')
        routes = self.trips([vehicle_type, *elements])
        return write(self.place / "eager.sumocfg", f"""<configuration><input>
            <net-file value="{self.net.name}"/><route-files value="{routes.name}"/></input>
            <routing><device.rerouting.probability value="1"/><device.rerouting.period value="5"/>
            <device.rerouting.adaptation-steps value="10"/></routing></configuration>""")

    @on_each(("static", "given", "evolved", "forecast"))
    def test_sumo_does_not_reroute_beside_us(self, strategy):
        file = self.configuration(random_trips(self.net, 300, 60, type="eager"))
        run = self.run_city("-c", file, "--strategy", strategy, "--share", 0, folder=self.place)
        wanted = routes_of(run.folder / "demand" / ("static.rou.xml" if strategy == "static" else "given.rou.xml"))
        self.assertEqual(run.routes(), wanted)
        device = self.run_city("-c", file, "--strategy", "device:period=5", folder=self.place, name="device")
        self.assertNotEqual(device.routes(), wanted, "nobody would have changed anyway: this test shows nothing")

    def test_a_device_of_a_vehicle_writes_to_the_runs_folder(self):
        elsewhere = self.place / "elsewhere" / "ssm.xml"
        types = ['<vType id="plain"><param key="has.ssm.device" value="true"/></vType>',
                 f'<vType id="named"><param key="has.ssm.device" value="true"/>'
                 f'<param key="device.ssm.file" value="{elsewhere}"/></vType>']
        trips = [f'<trip id="{t}" type="{t}" depart="0" from="A0B0" to="D4E4"/>' for t in ("plain", "named")]
        run = self.drive(types + trips, cwd=self.place)
        self.assertTrue((run.folder / "ssm.xml").is_file())
        self.assertEqual([file for file in self.place.rglob("*ssm*") if run.folder not in file.parents], [])

    def test_log_and_headers(self):
        """As SUMO's programs: a log on request, and every output says what made it."""
        run = self.drive(random_trips(self.net, 20, 20), "--log", self.place / "log.txt")
        self.assertRegex((self.place / "log.txt").read_text(), r"Loading net-file from '.*' \.\.\. done \(\d+ms\)\.")
        for file in ("decisions.xml", "run.sumocfg", "demand/given.rou.xml", "demand/static.rou.xml", "demand/dropped.xml"):
            head = (run.folder / file).read_text()[:3000]
            self.assertRegex(head, r"generated on \d{4}-\d\d-\d\dT[\d:]{8} by thalweg run ", file)
            self.assertIn(f'<net-file value="{self.net}"/>', head, file)

    def test_all_kinds_of_demand(self):
        """Flows, trips between zones, vehicles of an additional file, routes by name."""
        additional = write(self.place / "more.add.xml", """<additional>
            <taz id="west" edges="A0A1 A1A2"/><taz id="east" edges="E2E3 E3E4"/>
            <vType id="van" vClass="delivery"/>
            <route id="known" edges="B0B1 B1B2 B2B3"/>
            <vehicle id="extra" depart="5" type="van"><route edges="A0B0 B0C0 C0D0"/></vehicle></additional>""")
        trips = self.trips(['<flow id="f" begin="0" end="60" number="20" from="A0B0" to="D4E4" type="van"/>',
                            '<trip id="zones" depart="1" fromTaz="west" toTaz="east"/>',
                            '<trip id="junctions" depart="2" fromJunction="A0" toJunction="E4"/>',
                            '<vehicle id="named" depart="3" route="known"/>'])
        file = write(self.place / "all.sumocfg", f"""<configuration><input><net-file value="{self.net.name}"/>
            <route-files value="{trips.name}"/><additional-files value="{additional.name}"/></input>
            <processing><junction-taz value="true"/></processing></configuration>""")
        run = self.run_city("-c", file, *EAGER)
        wanted = {f"f.{i}" for i in range(20)} | {"zones", "junctions", "named", "extra"}
        self.assertEqual(set(run.trips), wanted)
        self.assertEqual((run.summary["vehicles"], run.summary["finished"]), (24, 24))
        self.assertEqual({d.get("vehicle") for d in run.decisions()}, wanted)
        routes = run.routes()
        self.assertIn(routes["zones"][0], ("A0A1", "A1A2"))
        self.assertIn(routes["zones"][-1], ("E2E3", "E3E4"))


def departure(element):
    return float(element.split('depart="')[1].split('"')[0])


if __name__ == "__main__":
    support.main()
