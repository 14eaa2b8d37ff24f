# SPDX-License-Identifier: Apache-2.0
"""`thalweg route` routes whole demands as duarouter does: flows, types and classes, vehicles with routes."""
import gzip
import os

import support
from support import City, make_grid, read_xml, run_tool, write

OPTIONS = ["--weights.minor-penalty", 1.5, "--weights.turnaround-penalty", 5, "--weights.tls-penalty", 0]


def vehicles_of(file):
    return {v.get("id"): (float(v.get("depart")), v.get("type"), float(v.find("route").get("cost")))
            for v in read_xml(file).iter("vehicle") if v.find("route") is not None and v.find("route").get("cost")}


class RouteDemand(support.TestCase):
    def both(self, net, demand, *options, additional=()):
        folder = self.folder()
        options += tuple(additional)
        run_tool("duarouter", "-n", net, "-r", demand, "-o", folder / "theirs.xml", "--alternatives-output", "NUL",
                 "--write-costs", "--ignore-errors", "--no-step-log", "--no-warnings", "--junction-taz", "false", *OPTIONS,
                 *additional)
        self.succeeds("route", "-n", net, "-r", demand, "-o", folder / "ours.xml.gz", "--write-costs", "--ignore-errors",
                      *OPTIONS, *options)
        with gzip.open(folder / "ours.xml.gz", "rb") as packed:
            (folder / "ours.xml").write_bytes(packed.read())
        return vehicles_of(folder / "ours.xml"), vehicles_of(folder / "theirs.xml")

    def assert_same(self, ours, theirs, least):
        self.assertEqual(sorted(set(ours) ^ set(theirs)), [])
        self.assertGreater(len(ours), least)
        for vehicle, (depart, kind, cost) in ours.items():
            self.assertAlmostEqual(depart, theirs[vehicle][0], delta=0.011, msg=vehicle)
            self.assertEqual(kind, theirs[vehicle][1], vehicle)
            self.assertAlmostEqual(cost, theirs[vehicle][2], delta=0.5, msg=vehicle)

    def test_flows_types_and_classes(self):
        net = make_grid(self.folder())
        demand = write(self.folder() / "d.rou.xml", """<routes>
            <vType id="slow" maxSpeed="5" speedFactor="1"/><vType id="car" speedFactor="1"/>
            <vType id="lorry" vClass="truck" speedFactor="1"/>
            <flow id="many" type="car" begin="0" end="100" number="7" from="A0B0" to="D4E4"/>
            <flow id="rate" type="slow" begin="50" end="90" vehsPerHour="360" from="A0B0" to="D4E4" via="B4C4"/>
            <flow id="period" type="lorry" begin="1" number="5" period="20" from="E4D4" to="B0A0"/>
            <trip id="one" type="car" depart="33" from="A0B0" to="B0A0"/>
        </routes>""")
        self.assert_same(*self.both(net, demand), 15)

    def test_every_class_at_its_own_speed(self):
        """One road on which nobody is too fast, 20 km; the default speed of each class is SUMO's."""
        folder = self.folder()
        write(folder / "n.nod.xml", '<nodes><node id="a" x="0" y="0"/><node id="b" x="20000" y="0"/></nodes>')
        write(folder / "e.edg.xml", '<edges><edge id="ab" from="a" to="b" speed="120"/></edges>')
        net = folder / "road.net.xml"
        run_tool("netconvert", "-n", folder / "n.nod.xml", "-e", folder / "e.edg.xml", "-o", net)
        classes = sorted(support.sumolib.net.lane.SUMO_VEHICLE_CLASSES)
        demand = write(folder / "d.rou.xml", "<routes>" + "".join(
            f'<vType id="T{name}" vClass="{name}" speedFactor="1"/><trip id="{name}" type="T{name}" depart="0" '
            'from="ab" to="ab"/>' for name in classes) + "</routes>")
        self.assert_same(*self.both(net, demand), 25)

    def test_zones(self):
        """From and to zones: the best pair of their roads, whatever the weights; a road that is named wins."""
        net, folder = make_grid(self.folder()), self.folder()
        zones = write(folder / "z.taz.xml", """<additional><taz id="east" edges="D4E4 D2E2"/>
            <taz id="west"><tazSource id="A0B0" weight="1"/><tazSource id="A1B1" weight="0"/>
                <tazSource id="A4B4" weight="100"/><tazSink id="B0A0" weight="1"/></taz></additional>""")
        demand = write(folder / "d.rou.xml", """<routes><flow id="f" end="10" number="3" fromTaz="west" toTaz="east"/>
            <trip id="to" depart="11" fromTaz="west" to="B0A0"/>
            <trip id="via" depart="12" from="A2B2" toTaz="east" via="C2C3"/>
            <trip id="back" depart="13" fromTaz="east" toTaz="west"/>
            <trip id="named" depart="14" fromTaz="west" from="C1C2" to="B4C4" toTaz="west"/></routes>""")
        for strategy in ("cch", "dijkstra", "evolved"):
            ours, theirs = self.both(net, demand, "--strategy", strategy, additional=("-a", zones))
            self.assert_same(ours, theirs, 6)
        bad = write(folder / "d.rou.xml", '<routes>\n<trip id="t" depart="0" fromTaz="south" to="A0B0"/></routes>')
        result = support.thalweg("route", "-n", net, "-r", bad, "-a", zones, "-o", folder / "o.xml")
        self.assertEqual(result.exit, 1)
        self.assertRegex(result.err, r"d\.rou\.xml:2: <trip id='t'>: .*'south-source'.*additional-files")

    def test_random_flows(self):
        """As many as duarouter draws, give or take what chance does (5 standard deviations of a difference)."""
        net, folder = make_grid(self.folder()), self.folder()
        demand = write(folder / "d.rou.xml", """<routes>
            <flow id="p" begin="5" end="3005" probability="0.3" from="A0B0" to="B0C0"/>
            <flow id="e" begin="5" end="3005" period="exp(0.3)" from="A0B0" to="B0C0"/></routes>""")
        counts = []
        for vehicles in self.both(net, demand):
            for flow, variance in (("p", 630), ("e", 900)):
                own = sorted(depart for name, (depart, _, _) in vehicles.items() if name.startswith(flow))
                counts.append((len(own), (2 * variance) ** 0.5))
                self.assertGreaterEqual(own[0], 5)
                self.assertTrue(all(depart % 1 == 0 for depart in own) or flow == "e")
        for (ours, spread), (theirs, _) in zip(counts[:2], counts[2:]):
            self.assertLess(abs(ours - theirs), 5 * spread)
        texts = []
        for i, seed in enumerate((1, 1, 2)):
            self.succeeds("route", "-n", net, "-r", demand, "-o", folder / f"{i}.xml", "--seed", seed)
            texts.append(support.without_comments(folder / f"{i}.xml"))
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])

    def test_persons_and_containers(self):
        """A plan that is complete stays as it is, in its place; one that must be routed is refused."""
        net, folder = make_grid(self.folder()), self.folder()
        demand = write(folder / "d.rou.xml", """<routes>
            <trip id="late" depart="20" from="A0B0" to="B0C0"/>
            <person id="p" depart="10"><walk edges="A0B0 B0C0"/><ride from="B0C0" to="C0D0" lines="ANY"/></person>
            <containerFlow id="c" begin="5" number="2" period="9"><tranship edges="A0B0"/></containerFlow></routes>""")
        self.succeeds("route", "-n", net, "-r", demand, "-o", folder / "o.xml")
        written = [element for element in read_xml(folder / "o.xml")]
        self.assertEqual([element.get("id") for element in written], ["c", "p", "late"])
        self.assertEqual([(stage.tag, stage.get("edges")) for stage in written[1]],
                         [("walk", "A0B0 B0C0"), ("ride", None)])
        run_tool("sumo", "-n", net, "-r", folder / "o.xml", "--end", 30)  # it is what SUMO reads

    def test_what_is_left_out_is_counted(self):
        net, folder = make_grid(self.folder()), self.folder()
        demand = write(folder / "d.rou.xml", """<routes><trip id="good" depart="0" from="A0B0" to="B0C0"/>
            <trip id="x" depart="0" from="A0B0" to="atlantis"/><trip id="y" depart="0" fromJunction="A0" to="B0C0"/>
            <flow id="f" begin="0" end="9" from="A0B0" to="B0C0"/><person id="p" depart="0"><personTrip to="A0B0"/></person>
            </routes>""")
        result = self.succeeds("route", "-n", net, "-r", demand, "-o", folder / "o.xml", "--ignore-errors")
        self.assertIn("atlantis", result.err)
        self.assertIn("Warning: 4 left out", result.err)
        self.assertEqual([v.get("id") for v in read_xml(folder / "o.xml")], ["good"])

    def test_luxembourg(self):
        city = City("luxembourg")
        ours, theirs = self.both(city.net, city.net.parent / "demand.0.4.trips.xml", "--threads", 2)
        self.assert_same(ours, theirs, 8000)

    def test_routes_are_kept_and_departures_in_order(self):
        net, folder = make_grid(self.folder()), self.folder()
        demand = write(folder / "d.rou.xml", """<routes><route id="r" edges="A0B0 B0C0"/>
            <trip id="late" depart="50" from="A0B0" to="C0D0"/>
            <vehicle id="named" depart="20" route="r"/>
            <vehicle id="own" depart="10"><route edges="A0B0 B0B1"/></vehicle>
            <flow id="f" begin="5" end="65" number="2" from="A0B0" to="B0B1"/></routes>""")
        self.succeeds("route", "-n", net, "-r", demand, "-o", folder / "o.xml")
        written = read_xml(folder / "o.xml")
        self.assertEqual([v.get("id") for v in written.iter("vehicle")], ["f.0", "own", "named", "f.1", "late"])
        self.assertEqual([v.find("route").get("edges") for v in written.iter("vehicle") if v.get("id") == "own"],
                         ["A0B0 B0B1"])

    def test_included_files(self):
        """Types and zones of an included additional file, trips of an included route file."""
        net, folder = make_grid(self.folder()), self.folder()
        (folder / "sub").mkdir()
        write(folder / "sub" / "inner.add.xml", """<additional><vType id="van" vClass="delivery"/>
            <taz id="west" edges="A0A1"/><taz id="east" edges="E3E4"/></additional>""")
        outer = write(folder / "outer.add.xml", '<additional><include href="sub/inner.add.xml"/></additional>')
        write(folder / "sub" / "inner.rou.xml",
              '<routes><trip id="t" type="van" depart="0" fromTaz="west" toTaz="east"/></routes>')
        demand = write(folder / "d.rou.xml", '<routes><include href="sub/inner.rou.xml"/></routes>')
        self.succeeds("route", "-n", net, "-a", outer, "-r", demand, "-o", folder / "o.xml")
        route = read_xml(folder / "o.xml").find("vehicle").find("route").get("edges").split()
        self.assertEqual((route[0], route[-1]), ("A0A1", "E3E4"))

    def test_what_is_not_routed_is_named(self):
        net, folder = make_grid(self.folder()), self.folder()
        for bad, words in (('<person id="p" depart="0"><personTrip from="A0B0" to="B0C0"/></person>', "duarouter"),
                           ('<container id="c" depart="0"><tranship from="A0B0" to="B0C0"/></container>', "duarouter"),
                           ('<trip id="t" type="odd" depart="0" from="A0B0" to="B0C0"/>', "'odd' is not known"),
                           ('<flow id="f" from="A0B0" to="B0C0"/>', "no end"),
                           ('<flow id="f" end="9" probability="1.1" from="A0B0" to="B0C0"/>', "above 1")):
            demand = write(folder / "d.rou.xml", f"<routes>\n{bad}\n</routes>")
            result = support.thalweg("route", "-n", net, "-r", demand, "-o", folder / "o.xml")
            self.assertEqual(result.exit, 1)
            self.assertRegex(result.err, r"d\.rou\.xml:2: .*" + words)
            self.assertFalse((folder / "o.xml").exists())

    def test_cache(self):
        """The order is kept in the cache folder; --no-cache and a folder that cannot be written change no route."""
        city, folder = City("bologna-joined"), self.folder()
        draw = [road.getID() for road in support.sumolib.net.readNet(str(city.net)).getEdges(withInternal=False)
                if road.allows("passenger")]
        pairs = [(draw[i % len(draw)], draw[(7 * i + 5) % len(draw)]) for i in range(300)]
        trips = "".join(f'<trip id="{i}" depart="{i}" from="{a}" to="{b}"/>' for i, (a, b) in enumerate(pairs))
        demand = write(folder / "t.xml", f"<routes>{trips}</routes>")
        texts = []
        for name, options in (("cache", []), ("cache", []), ("none", ["--no-cache"]), ("t.xml", [])):
            result = support.thalweg("route", "-n", city.net, "-r", demand, "-o", folder / "o.xml", "--ignore-errors",
                                     *options, env={**os.environ, "XDG_CACHE_HOME": str(folder / name)})
            self.assertEqual(result.exit, 0, result.err)
            self.assertEqual("the order of the network is not kept" in result.err, name == "t.xml", result.err)
            texts.append([v.find("route").get("edges") for v in read_xml(folder / "o.xml").iter("vehicle")])
        self.assertEqual(len(list((folder / "cache" / "thalweg").iterdir())), 1)
        self.assertFalse((folder / "none").exists())
        self.assertTrue(all(text == texts[0] for text in texts))
        self.assertGreater(len(texts[0]), 100)


if __name__ == "__main__":
    support.main()
