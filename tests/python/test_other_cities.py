# SPDX-License-Identifier: Apache-2.0
"""What other people's configurations hold: it must mean here what it means to SUMO alone."""
import support
from support import expand, on_each, random_trips, read_xml, run_tool, write, write_routes


@expand
class OtherCities(support.GridCase):
    def city(self, elements, settings="", additional=""):
        """A configuration with this demand, these settings and this additional file."""
        write_routes(self.place / "trips.xml", elements)
        write(self.place / "more.add.xml", f"<additional>{additional}</additional>")
        return write(self.place / "city.sumocfg", f"""<configuration><net-file value="{self.net.name}"/>
            <route-files value="trips.xml"/><additional-files value="more.add.xml"/>{settings}</configuration>""")

    def test_types_of_an_included_file(self):
        (self.place / "sub").mkdir()
        write(self.place / "sub" / "types.add.xml", '<additional><vType id="van" vClass="delivery"/></additional>')
        file = self.city(['<trip id="t" type="van" depart="1" from="A0A1" to="C4C3"/>'],
                         additional='<include href="sub/types.add.xml"/>')
        run = self.run_city("-c", file)
        self.assertEqual(run.trips["t"].get("vType"), "van")

    def test_who_departs_before_the_begin(self):
        """As in SUMO he is not in the simulation: nobody is missed. (From a flow by probability that begins before
        the begin, SUMO's duarouter does not return.)"""
        demand = ['<flow id="p" begin="0" end="200" probability="0.2" from="A0A1" to="C4C3"/>',
                  '<flow id="over" begin="0" end="90" probability="0.2" from="A0A1" to="C4C3"/>',
                  '<flow id="r" begin="0" end="200" period="10" from="A0A1" to="C4C3"/>',
                  '<trip id="early" depart="1" from="A0A1" to="C4C3"/>', '<trip id="due" depart="150" from="A0A1" to="C4C3"/>']
        run = self.run_city("-c", self.city(demand, '<begin value="100"/>'), "--strict", timeout=60)
        by_flow = {name: sum(trip.split(".")[0] == name for trip in run.trips) for name in ("r", "over", "early", "due")}
        self.assertEqual(by_flow, {"r": 10, "over": 0, "early": 0, "due": 1})
        self.assertGreater(len(run.trips), 15)
        self.assertEqual(run.summary["vehicles"], len(run.trips))
        result = support.thalweg("run", "-c", self.city(demand, '<begin value="1000"/>'), "-o", self.place / "none")
        self.assertEqual(result.exit, 1)
        self.assertIn("all departs before the begin (1000.00 s)", result.err)

    def test_a_flow_that_duarouter_drops_is_counted(self):
        """Junctions are no zones unless the configuration says so; duarouter leaves the flow out as a whole."""
        ends = 'fromJunction="A0" toJunction="E4"'
        file = self.city(['<trip id="good" depart="0" from="A0A1" to="C4C3"/>', f'<trip id="lost" depart="1" {ends}/>',
                          f'<flow id="flow" begin="1" end="9" number="3" {ends}/>'])
        run = self.run_city("-c", file)
        self.assertEqual((run.summary["vehicles"], run.summary["dropped"]), (3, 2))
        dropped = {v.get("id"): v.get("reason") for v in read_xml(run.folder / "demand" / "dropped.xml")}
        self.assertEqual(set(dropped), {"lost", "flow"})
        self.assertTrue(dropped["flow"].startswith("the whole flow: "), dropped)
        for reason in dropped.values():
            self.assertRegex(reason, "junction 'A0' not known .* Set option '--junction-taz'")

    def test_flows_without_an_end(self):
        """They end with the simulation; who is due after it is no loss of the router's."""
        ends = 'from="A0A1" to="C4C3"'
        file = self.city([f'<flow id="open" begin="0" period="10" {ends}/>', f'<trip id="late" depart="500" {ends}/>'],
                         '<end value="100"/>')
        run = self.run_city("-c", file)
        parts = tuple(run.summary[part] for part in ("vehicles", "dropped", "not_loaded"))
        self.assertEqual(parts, (11, 0, 1))

    def test_persons_that_cannot_be_routed_are_named(self):
        """They are no vehicles, so the table does not count them; who stays in is not named."""
        file = self.city(['<trip id="u" depart="0" from="A0A1" to="C4C3"/>',
                          '<person id="good" depart="1"><walk from="A0A1" to="C4C3"/></person>',
                          '<person id="u" depart="1"><walk from="A0A1" to="Atlantis"/></person>',
                          '<personFlow id="pf" begin="2" end="9" number="2"><walk from="A0A1" to="Atlantis"/></personFlow>',
                          '<personFlow id="on" begin="3" end="9" number="2"><walk from="A0A1" to="C4C3"/></personFlow>'],
                         '<end value="300"/>')
        result = self.succeeds("run", "-c", file, "-o", self.place / "run")
        self.assertRegex(result.err, r"2 person\(s\) or container\(s\) cannot be routed .*'pf' \(The edge 'Atlantis'")
        run = support.Run(self.place / "run")
        self.assertEqual((run.summary["vehicles"], run.summary["dropped"]), (1, 0))
        self.assertEqual([(e.tag, e.get("id")) for e in read_xml(run.folder / "demand" / "dropped.xml")],
                         [("person", "pf"), ("person", "u")])
        self.succeeds("compare", "-c", file, "-o", self.place / "compare", "--arms", "static", "--seeds", 1)

    def test_a_city_of_persons(self):
        file = self.city(['<person id="p" depart="1"><walk from="A0A1" to="C4C3"/></person>',
                          '<container id="c" depart="1"><tranship from="A0A1" to="A1A2"/></container>'])
        result = self.succeeds("compare", "-c", file, "-o", self.place / "compare", "--seeds", 2)
        self.assertIn("the demand has no vehicles", result.err)
        self.assertRegex(result.out, r"\n  forecast +0 +0 +0")
        walked = read_xml(self.place / "compare" / "forecast" / "23423" / "tripinfo.xml")
        self.assertEqual(sorted(trip.get("id") for trip in walked), ["c", "p"])

    def test_a_city_of_calibrators(self):
        """What a calibrator inserts is no vehicle of the demand, and told apart."""
        calibrator = """<route id="r" edges="A0A1 A1A2 A2A3"/><calibrator id="c" edge="A0A1" pos="0" period="60">
            <flow begin="0" end="300" route="r" vehsPerHour="600" speed="10"/></calibrator>"""
        file = self.city([], '<end value="400"/>', calibrator)
        result = self.succeeds("run", "-c", file, "-o", self.place / "run")
        self.assertIn("not of the demand (forecast 50 a run;", result.out)
        self.assertEqual(support.Run(self.place / "run").summary["unknown"], 50)

    @on_each(("alone", "and_begin"))
    def test_a_state_is_gone_on_with(self, how):
        """Who is on the road in it is led as everybody is; who had arrived is not in this run."""
        begin = '<begin value="100"/>' if how == "and_begin" else ""
        file = self.city(random_trips(self.net, 200, 200), f'<load-state value="state.xml"/>{begin}')
        run_tool("sumo", "-n", self.net, "-r", self.place / "trips.xml", "--end", 101, "--save-state.times", 100,
                 "--save-state.files", self.place / "state.xml", "--tripinfo-output", self.place / "past.xml")
        past = {trip.get("id") for trip in read_xml(self.place / "past.xml").iter("tripinfo")
                if float(trip.get("arrival")) < 100}
        self.assertGreater(len(past), 3)
        result = self.run_city("-c", file)
        parts = [result.summary[part] for part in ("vehicles", "finished", "not_loaded")]
        self.assertEqual(parts, [200, 200 - len(past), len(past)])
        self.assertEqual(set(result.trips) & past, set())
        on_the_road = {f"t{i}" for i in range(100)} - past
        self.assertGreater(len(on_the_road & {d.get("vehicle") for d in result.decisions()}), 60)
        self.assertNotIn("Invalid route", (result.folder / "sumo.log").read_text())

    def test_a_state_with_flows(self):
        """It has the flows as well: nobody is inserted by the state and by the demand (nobody is 'unknown')."""
        ends = 'from="A0A1" to="C4C3"'
        file = self.city([f'<flow id="p" begin="0" end="900" probability="0.1" {ends}/>',
                          f'<flow id="r" begin="5" end="905" period="10" {ends}/>'], '<load-state value="state.xml"/>')
        run_tool("sumo", "-n", self.net, "-r", self.place / "trips.xml", "--end", 101, "--save-state.times", 100,
                 "--save-state.files", self.place / "state.xml")
        self.assertEqual(sum(e.tag == "flowState" for e in read_xml(self.place / "state.xml")), 2)
        run = self.run_city("-c", file)
        departs = [float(trip.get("depart")) for trip in run.trips.values() if trip.get("id").startswith("r.")]
        self.assertEqual(len([depart for depart in departs if depart >= 100]), 80)  # from 105 to 895
        self.assertEqual(run.summary["finished"], len(read_xml(run.folder / "tripinfo.xml")))

    def test_a_state_beside_the_configuration(self):
        result = support.thalweg("run", "-c", self.city([]), "-o", self.place / "o", "--", "--load-state", "state.xml")
        self.assertEqual(result.exit, 1)
        self.assertIn("write it in the configuration", result.err)


if __name__ == "__main__":
    support.main()
