# SPDX-License-Identifier: Apache-2.0
"""Whatever is wrong with the input: a clear error, exit 1, nothing half-written, in a moment."""
import gzip
import json
import os
import re
import shutil
import subprocess
import time

import support
from support import expand, make_grid, on_each, random_trips, thalweg, write, write_routes

NET = """<net version="1.20">
    <edge id="a" from="A" to="B" priority="1">
        <lane id="a_0" index="0" speed="10" length="100" shape="0,0 100,0"/>
    </edge>
    <edge id="b" from="B" to="C" priority="1">
        <lane id="b_0" index="0" speed="10" length="100" shape="100,0 200,0"/>
    </edge>
    <junction id="A" type="dead_end" x="0" y="0" incLanes="" intLanes="" shape="0,0"/>
    <junction id="B" type="priority" x="100" y="0" incLanes="a_0" intLanes="" shape="100,0"/>
    <junction id="C" type="dead_end" x="200" y="0" incLanes="b_0" intLanes="" shape="200,0"/>
    <connection from="a" to="b" fromLane="0" toLane="0" dir="s" state="M"/>
</net>
"""
LANE = '<lane id="a_0" index="0" speed="10" length="100" shape="0,0 100,0"/>'
A_LINE = 3  # where that lane is

DAMAGE = {  # name: what is replaced, by what, what the error must say (the line and the element included)
    "lane_without_length": (LANE, '<lane id="a_0" index="0" speed="10"/>', r":3: <lane id='a_0'>: .*length"),
    "negative_length": ('length="100" shape="0', 'length="-1" shape="0', r":3: <lane id='a_0'>: .*length.*-1.*negative"),
    "nan_length": ('length="100" shape="0', 'length="NaN" shape="0', r":3: <lane id='a_0'>: .*length.*NaN"),
    "infinite_length": ('length="100" shape="0', 'length="inf" shape="0', r":3: <lane id='a_0'>: .*length.*inf"),
    "negative_speed": ('speed="10" length="100" shape="0', 'speed="-3" length="100" shape="0',
                       r":3: <lane id='a_0'>: .*speed.*-3.*negative"),
    "nan_speed": ('speed="10" length="100" shape="0', 'speed="nan" length="100" shape="0',
                  r":3: <lane id='a_0'>: .*speed.*nan"),
    "lane_without_speed": ('speed="10" length="100" shape="0', 'length="100" shape="0', r":3: <lane id='a_0'>: .*speed"),
    "length_is_a_word": ('length="100" shape="0', 'length="long" shape="0', r":3: <lane id='a_0'>: .*length.*long"),
    "connection_to_nowhere": ('to="b" fromLane', 'to="x" fromLane', r":11: <connection>: to='x'"),
    "connection_from_nowhere": ('from="a" to="b" fromLane', 'from="x" to="b" fromLane', r":11: <connection>: from='x'"),
    "connection_to_no_lane": ('toLane="0"', 'toLane="7"', r":11: <connection>: toLane='7'"),
    "connection_via_nowhere": ('toLane="0"', 'toLane="0" via=":B_0_0"', r":11: <connection>: via=':B_0_0'"),
    "same_edge_twice": ('<edge id="b"', '<edge id="a"', r":5: <edge id='a'>: .*already"),
    "same_lane_twice": ('<lane id="b_0"', '<lane id="a_0"', r":6: <lane id='a_0'>: .*already"),
    "same_junction_twice": ('<junction id="C"', '<junction id="B"', r":10: <junction id='B'>: .*already"),
    "road_without_lanes": (LANE, "", r":2: <edge id='a'>: .*no lanes"),
    "junction_missing": (re.search('<junction id="C".*\n', NET).group(), "", r"'C'"),
    "not_a_net": ("net", "routes", r":1: <routes.*no SUMO network"),
    "not_xml": ("<edge id=\"b\"", "<edge id=\"b\" <", r":5: .*XML"),
    "two_roots": ("</net>\n", "</net>\n<net/>", r":1[23]: .*XML"),
}


@expand
class BadInput(support.TestCase):
    def setUp(self):
        self.place = self.folder()

    def fails(self, pattern, *arguments, seconds=5, **how):
        """Exit 1 within 5 s, SUMO's manner of saying so, and nothing new in the folder but what was there."""
        before = sorted(self.place.rglob("*"))
        begin = time.monotonic()
        result = thalweg(*arguments, cwd=self.place, **how)
        taken = time.monotonic() - begin
        self.assertEqual(result.exit, 1, result)
        self.assertRegex(result.err, "(?m)^Error: ")
        self.assertTrue(result.err.endswith("Quitting (on error).\n"), result)
        self.assertRegex(result.err, pattern)
        self.assertLess(taken, seconds)
        self.assertLess(len(result.err), 5000, "an error is a few lines")
        for file in set(self.place.rglob("*")) - set(before):
            if file.is_file():  # what an earlier stage finished may stay, a half of something may not
                self.assertNotRegex(file.name, r"\.tmp$|probe|options\.")
        return result

    def net(self, text, name="bad.net.xml"):
        return write(self.place / name, text)

    def fails_everywhere(self, pattern, net):
        """The same words from every command that reads a net."""
        self.fails(pattern, "network", "-n", net)
        self.fails(pattern, "route", "-n", net, "--from", "a", "--to", "b")
        trips = write_routes(self.place / "ok.trips.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        self.fails(pattern, "run", "-n", net, "-r", trips, "-o", "out")

    def test_the_net_is_good_before_it_is_damaged(self):
        self.succeeds("network", "-n", self.net(NET))

    @on_each(DAMAGE)
    def test_net(self, name):
        old, new, pattern = DAMAGE[name]
        self.assertIn(old, NET)
        damaged = NET.replace(old, new, 1) if name != "not_a_net" else NET.replace("<net", "<routes").replace(
            "</net", "</routes")
        self.fails_everywhere(r"bad\.net\.xml" + pattern if pattern.startswith(":") else pattern, self.net(damaged))

    def test_missing_files(self):
        self.fails_everywhere(r"none\.net\.xml", self.place / "none.net.xml")
        net = self.net(NET)
        self.fails(r"none\.rou\.xml", "run", "-n", net, "-r", "none.rou.xml", "-o", "out")
        self.fails(r"none\.add\.xml", "run", "-n", net, "-r", net, "-a", "none.add.xml", "-o", "out")
        self.fails(r"none\.sumocfg", "run", "-c", "none.sumocfg", "-o", "out")
        self.fails(r"none\.sumocfg", "compare", "-c", "none.sumocfg", "-o", "out")
        self.fails(r"none\.xml", "route", "-n", net, "-r", "none.xml", "-o", "o.xml")
        self.fails(r"none\.xml", "route", "-n", net, "--from", "a", "--to", "b", "--weight-files", "none.xml")

    def test_a_folder_that_sumo_cannot_name(self):
        net = self.net(NET)
        write_routes(self.place / "t.trips.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        for folder in ("a,b", "a;b"):
            self.fails(f"{folder}.*end of a file's name.*--output-folder", "run", "-n", net, "-r", self.place / "t.trips.xml",
                       "-o", folder)
        self.fails("a:b.*host's port.*--output-folder", "run", "-n", net, "-r", self.place / "t.trips.xml", "-o", "a:b")
        odd = self.place / "c,d"
        odd.mkdir()
        write(odd / "x.sumocfg", '<configuration><net-file value="x.net.xml"/></configuration>')
        self.fails("comma", "run", "-c", "c,d/x.sumocfg", "-o", "out")

    def test_a_decision_log_that_cannot_be_written(self):
        net = self.net(NET)
        trips = write_routes(self.place / "t.trips.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        self.fails("no/such/folder", "run", "-n", net, "-r", trips, "-o", "out", "--decision-output", "no/such/folder/d.xml")

    def test_a_folder_in_place_of_a_file(self):
        (self.place / "folder").mkdir()
        self.fails(r"folder", "network", "-n", "folder")

    @on_each(("", " ", "\n\n", "\0\0\0\0", "text"))
    def test_no_content(self, content):
        self.fails_everywhere(r"bad\.net\.xml", self.net(content))

    def test_truncated(self):
        for length in (len(NET) - 8, len(NET) // 2, 20):
            self.fails_everywhere(r"bad\.net\.xml:\d+: .*XML", self.net(NET[:length]))
        packed = gzip.compress(NET.encode() * 1 + b"<!-- " + os.urandom(30000).hex().encode() + b" -->")
        whole = self.place / "whole.net.xml.gz"
        whole.write_bytes(packed)
        self.succeeds("network", "-n", whole)
        short = self.place / "bad.net.xml.gz"
        for length in (len(packed) - 4, len(packed) // 2, 30):
            short.write_bytes(packed[:length])
            self.fails(r"bad\.net\.xml\.gz.* cut short", "network", "-n", short)
        damaged = bytearray(packed)
        damaged[len(packed) // 2] ^= 255
        short.write_bytes(damaged)
        self.fails(r"bad\.net\.xml\.gz", "network", "-n", short)

    def test_a_class_that_nobody_knows_is_a_warning(self):
        net = self.net(NET.replace('index="0" speed', 'index="0" allow="passenger hovercraft" speed', 1))
        result = self.succeeds("network", "-n", net)
        self.assertRegex(result.err, r"Warning: .*bad\.net\.xml:3: .*hovercraft")
        self.fails("hovercraft", "network", "-n", net, "--vclass", "hovercraft")

    def test_entities(self):
        bomb = "".join(f'<!ENTITY x{i} "{f"&x{i - 1};" * 10}">' for i in range(1, 12))
        self.fails_everywhere(r"bad\.net\.xml:\d+: .*entities", self.net(
            f'<!DOCTYPE net [<!ENTITY x0 "ha">{bomb}]>' + NET.replace('id="a"', 'id="&x11;"')))
        secret = write(self.place / "secret.txt", "a secret")
        result = self.fails(r"bad\.net\.xml:\d+: .*entities", "network", "-n", self.net(
            f'<!DOCTYPE net [<!ENTITY x SYSTEM "file://{secret}">]>' + NET.replace('id="a"', 'id="&x;"')))
        self.assertNotIn("a secret", result.out + result.err)

    def test_an_attribute_of_100_megabytes(self):
        net = self.net(NET.replace('id="a_0"', f'id="{"x" * 100_000_000}"'))
        self.fails(r"bad\.net\.xml", "network", "-n", net)
        shape = self.net(NET.replace("0,0 100,0", "0,0 " * 25_000_000))
        self.fails(r"bad\.net\.xml", "network", "-n", shape)

    # ------------------------------------------------------------------------------------------ demand

    def test_damaged_demand(self):
        net = self.net(NET)
        good = '<trip id="t" depart="0" from="a" to="b"/>'
        for name, text, pattern in (
                ("twice", f"<routes>{good}\n{good}</routes>", r"demand\.xml:2: <trip id='t'>: .*already"),
                ("no id", '<routes>\n<trip depart="0" from="a" to="b"/></routes>', r"demand\.xml:2: <trip>: .*id"),
                ("no vehicles", "<routes/>", "no demand"),
                ("a net", NET, r"demand\.xml:1: <net.*no route file"),
                ("cut", "<routes><trip", r"demand\.xml:1: .*XML"),
                ("empty", "", r"demand\.xml")):
            with self.subTest(name):
                demand = write(self.place / "demand.xml", text)
                self.fails(pattern, "run", "-n", net, "-r", demand, "-o", "out")
                self.fails(pattern, "compare", "-n", net, "-r", demand, "-o", "out")

    def city(self):
        """A net with an island and a pedestrian street.

             A ---> B ---> C        D ---> E
               a      b               island
                    B ---> F
                      walk
        """
        nodes = {"A": (0, 0), "B": (100, 0), "C": (200, 0), "D": (400, 0), "E": (500, 0), "F": (100, -100)}
        walk = 'allow="pedestrian"'
        roads = {"a": "AB", "b": "BC", "island": "DE", "walk": "BF"}
        write(self.place / "n.nod.xml", "<nodes>" + "".join(
            f'<node id="{name}" x="{x}" y="{y}"/>' for name, (x, y) in nodes.items()) + "</nodes>")
        write(self.place / "e.edg.xml", "<edges>" + "".join(
            f'<edge id="{name}" from="{ends[0]}" to="{ends[1]}" {walk if name == "walk" else ""}/>'
            for name, ends in roads.items()) + "</edges>")
        support.run_tool("netconvert", "-n", self.place / "n.nod.xml", "-e", self.place / "e.edg.xml",
                         "-o", self.place / "city.net.xml")
        return self.place / "city.net.xml"

    TRIPS = {"from_unknown": ("atlantis", "b"), "to_unknown": ("a", "atlantis"), "to_forbidden": ("a", "walk"),
             "from_forbidden": ("walk", "b"), "unreachable": ("a", "island"), "backwards": ("b", "a")}

    def test_trips_that_cannot_be_routed(self):
        """Named, counted, dropped before all arms."""
        net = self.city()
        trips = write_routes(self.place / "trips.xml", ['<trip id="good" depart="0" from="a" to="b"/>'] + [
            f'<trip id="{name}" depart="1" from="{origin}" to="{destination}"/>'
            for name, (origin, destination) in self.TRIPS.items()])
        for strategy in ("evolved", "static"):
            out = self.place / strategy
            result = self.succeeds("run", "-n", net, "-r", trips, "-o", out, "--strategy", strategy)
            run = support.Run(out)
            self.assertEqual((run.summary["vehicles"], run.summary["dropped"], run.summary["finished"]), (7, 6, 1))
            self.assertEqual(set(run.trips), {"good"})
            self.assertRegex(result.err, r"Warning: 6 vehicle\(s\)")
            dropped = {v.get("id"): v.get("reason") for v in support.read_xml(out / "demand" / "dropped.xml")}
            self.assertEqual(set(dropped), set(self.TRIPS))
            for name in ("from_unknown", "to_unknown"):
                self.assertIn("atlantis", dropped[name])
            for name, reason in dropped.items():
                self.assertGreater(len(reason), 10, name)
                self.assertNotIn("left it out", reason, f"{name}: this says nothing")
        self.fails("6 vehicle", "run", "-n", net, "-r", trips, "-o", "strict", "--strict")
        self.fails("6 vehicle", "compare", "-n", net, "-r", trips, "-o", "strict", "--strict")

    def test_route_names_what_it_cannot_route(self):
        net = self.city()
        for origin, destination in self.TRIPS.values():
            bad = "atlantis" if "atlantis" in (origin, destination) else "walk" if "walk" in (
                origin, destination) else f"from '{origin}' to '{destination}'"
            self.fails(bad, "route", "-n", net, "--from", origin, "--to", destination)
            trips = write_routes(self.place / "trips.xml", [f'<trip id="t" depart="0" from="{origin}" to="{destination}"/>'])
            self.fails(r"trips\.xml:2: <trip id='t'>: .*" + bad, "route", "-n", net, "-r", trips, "-o", "out.xml")
            self.assertFalse((self.place / "out.xml").exists())
        self.fails("did you mean 'island'|'island'", "route", "-n", net, "--from", "ilsand", "--to", "a")

    def test_a_net_of_one_road(self):
        """It is a net: there is one way, from the road to itself.

             A ---> B
        """
        connection = re.search("    <connection.*\n", NET).group()
        road_b = re.search('    <edge id="b"(.|\n)*?</edge>\n', NET).group()
        net = self.net(NET.replace(connection, "").replace(road_b, "").replace('incLanes="b_0"', 'incLanes=""'))
        self.succeeds("network", "-n", net)
        trips = write_routes(self.place / "t.xml", ['<trip id="t" depart="0" from="a" to="a"/>'])
        for strategy in ("cch", "dijkstra", "evolved", "hybrid"):
            result = self.succeeds("route", "-n", net, "--from", "a", "--to", "a", "--strategy", strategy)
            self.assertEqual(result.out, "a\ncost 10.000 s\n")
            self.succeeds("route", "-n", net, "-r", trips, "-o", self.place / "o.xml", "--strategy", strategy)
            self.assertEqual([v.find("route").get("edges") for v in support.read_xml(self.place / "o.xml")], ["a"])
        for strategy in ("cch", "forecast"):
            self.succeeds("run", "-n", net, "-r", trips, "-o", self.place / strategy, "--strategy", strategy)
            self.assertEqual(support.Run(self.place / strategy).summary["finished"], 1)

    def test_a_net_that_falls_apart(self):
        """Each part is routed by itself; what is asked across is named and counted, by every strategy."""
        net = self.city()
        trips = write_routes(self.place / "t.xml", [
            '<trip id="one" depart="0" from="a" to="b"/>', '<trip id="other" depart="1" from="island" to="island"/>',
            '<trip id="out" depart="2" from="a" to="island"/>', '<trip id="in" depart="3" from="island" to="b"/>'])
        for strategy in ("cch", "dijkstra", "evolved", "hybrid"):
            result = self.succeeds("route", "-n", net, "-r", trips, "-o", self.place / "o.xml", "--ignore-errors",
                                   "--strategy", strategy)
            self.assertEqual({v.get("id"): v.find("route").get("edges") for v in support.read_xml(self.place / "o.xml")},
                             {"one": "a b", "other": "island"})
            self.assertIn("there is no way from 'a' to 'island'", result.err)
            self.assertIn("there is no way from 'island' to 'b'", result.err)
            self.assertIn("Warning: 2 left out", result.err)

    def test_zones(self):
        net = self.city()
        for zone, pattern in (('<taz id="z" edges="a atlantis"/>', r"z\.xml:2: <taz id='z'>: .*'atlantis'"),
                              ('<taz id="z"><tazSink id="atlantis" weight="1"/></taz>', "'atlantis'"),
                              ('<taz id="z"/><taz id="z"/>', "'z-source' already"), ("<taz/>", "'id' is missing")):
            zones = write(self.place / "z.xml", f"<additional>\n{zone}</additional>")
            self.fails(pattern, "route", "-n", net, "-a", zones, "--from", "a", "--to", "b")

    def test_weights(self):
        net = self.net(NET)
        for text, pattern in (('<d><interval begin="0" end="9">\n<edge id="x" traveltime="1"/></interval></d>',
                               r"w\.xml:2: <edge id='x'>"),
                              ('<d><interval begin="0" end="9">\n<edge id="a" traveltime="-1"/></interval></d>',
                               r"w\.xml:2: <edge id='a'>: .*negative"),
                              ('<d><interval begin="0" end="9">\n<edge id="a" traveltime="NaN"/></interval></d>',
                               r"w\.xml:2: <edge id='a'>: .*NaN"),
                              ('<d><interval begin="0" end="9">\n<edge id="a" traveltime="inf"/></interval></d>',
                               r"w\.xml:2: <edge id='a'>: .*inf"),
                              ('<d><interval begin="0" end="9">\n<edge id="a" traveltime="soon"/></interval></d>',
                               r"w\.xml:2: <edge id='a'>: .*soon"),
                              ('<d><interval begin="5" end="9"/></d>', r"w\.xml.*no interval"),
                              ('<d><interval begin="soon" end="9"/></d>', r"w\.xml:1: <interval>: .*soon")):
            weights = write(self.place / "w.xml", text)
            self.fails(pattern, "route", "-n", net, "--from", "a", "--to", "b", "--weight-files", weights)

    # ----------------------------------------------------------------------------------------- options

    def test_options(self):
        net = self.net(NET)
        trips = write_routes(self.place / "t.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        for arguments, pattern in (
                (["run", "--stratgy", "evolved"], "stratgy.*strategy"),
                (["run", "--strategy", "evolvd", "-n", net, "-r", trips], "evolvd.*evolved"),
                (["route", "-n", net, "--from", "a", "--to", "b", "--strategy", "dikstra"], "dikstra.*dijkstra"),
                (["compare", "-n", net, "-r", net, "--arms", "static,devise"], "devise.*device"),
                (["compare", "-n", net, "-r", net, "--arms", "device:perod=3"], "perod.*period"),
                (["compare", "-n", net, "-r", net, "--arms", ""], "arm"),
                (["compare", "--seeds", "0", "-n", net, "-r", trips], "seeds"),
                (["compare", "--seeds", "1,x", "-n", net, "-r", trips], "'x'"),
                (["compare", "--seeds", "4,5,4", "-n", net, "-r", trips], "seed twice"),
                (["compare", "--arms", "static,static", "-n", net, "-r", trips], "arm twice"),
                (["compare", "--jobs", "0", "-n", net, "-r", trips], "jobs"),
                (["run", "--period", "0", "-n", net, "-r", trips], "period"),
                (["run", "--period", "often", "-n", net, "-r", trips], "period.*often"),
                (["run", "--end", "soon"], "end.*soon"),
                (["run", "--share", "2", "-n", net, "-r", trips], "share"),
                (["run", "--share", "some"], "share.*some"),
                (["run", "--seed", "-1", "-n", net, "-r", trips], "seed.*-1"),
                (["run", "--threads", "0", "-n", net, "-r", trips], "threads"),
                (["run", "--verbose", "--strict=perhaps"], "strict.*perhaps"),
                (["run", "-n"], "net-file"),
                (["run", "stray"], "'stray'"),
                (["run", "city.sumocfg"], "did you mean '-c city.sumocfg'"),
                (["run"], "net-file"),
                (["network"], "net-file"),
                (["route", "-n", net], "route"),
                (["rn"], "'rn'.*'run'"),
                (["compare", "--stepp-length", "1"], "stepp-length.*step-length")):
            with self.subTest(" ".join(map(str, arguments))):
                extra = ["-o", "out"] if arguments[0] in ("run", "compare") else []
                self.fails("(?s)" + pattern, *arguments, *extra)

    def test_a_configuration_with_an_unknown_option(self):
        self.net(NET)
        write_routes(self.place / "t.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        configuration = write(self.place / "c.sumocfg", '<configuration><net-file value="bad.net.xml"/>'
                              '<route-files value="t.xml"/><stp-length value="1"/></configuration>')
        self.fails(r"c\.sumocfg.*stp-length.*step-length", "run", "-c", configuration, "-o", "out")

    def test_another_file_in_place_of_the_configuration(self):
        for root, option in (("net", "-n"), ("routes", "-r"), ("additional", "-a")):
            file = write(self.place / "it.xml", f'<{root}><param key="a" value="b"/></{root}>')
            self.fails(f"it.xml:1: <{root}>: no configuration, but .*name it with {option}", "run", "-c", file, "-o", "out")

    # ----------------------------------------------------------------------------------------- outputs

    def test_an_output_folder_that_cannot_be_written(self):
        """A file in its place; that holds for root as well."""
        net = self.net(NET)
        trips = write_routes(self.place / "t.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        write(self.place / "occupied", "")
        for command in ("run", "compare"):
            self.fails("occupied", command, "-n", net, "-r", trips, "-o", "occupied")
            self.fails("occupied", command, "-n", net, "-r", trips, "-o", "occupied/below")
        self.fails("occupied", "route", "-n", net, "-r", trips, "-o", "occupied/routes.xml")
        self.fails("none", "route", "-n", net, "-r", trips, "-o", "none/routes.xml")

    def test_a_folder_without_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        net = self.net(NET)
        trips = write_routes(self.place / "t.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        (self.place / "locked").mkdir(mode=0o500)
        self.fails("locked", "run", "-n", net, "-r", trips, "-o", "locked")
        self.fails("locked", "run", "-n", net, "-r", trips, "-o", "locked/below")

    def test_no_room_for_an_output(self):
        """Under a file size limit of 0 every write fails, as on a full disk."""
        net = self.net(NET)
        trips = write_routes(self.place / "t.xml", ['<trip id="t" depart="0" from="a" to="b"/>'])
        (self.place / "full").mkdir()
        program = support.PROGRAM
        result = subprocess.run(["bash", "-c", f"ulimit -f 0; trap '' XFSZ; exec '{program}' route -n '{net}' "
                                         f"-r '{trips}' -o full/routes.xml"], cwd=self.place, capture_output=True, text=True)
        self.assertEqual(result.returncode, 1, result)
        self.assertRegex(result.stderr, r"Error: .*full/routes\.xml")
        self.assertEqual(list((self.place / "full").iterdir()), [])

    def test_sumo_is_missing(self):
        """The program alone, without the module that holds SUMO's library."""
        net = make_grid(self.place)
        trips = write_routes(self.place / "t.xml", random_trips(net, 3, 3))
        shutil.copy2(support.PROGRAM, self.place / "alone")
        self.addCleanup(setattr, support, "PROGRAM", support.PROGRAM)
        support.PROGRAM = self.place / "alone"
        self.succeeds("network", "-n", net)
        self.fails("SUMO.*(tools/setup|doctor)", "run", "-n", net, "-r", trips, "-o", "out")

    @on_each(("--net-file", "--seed", "--tripinfo-output.write-unfinished"))
    def test_sumo_alone_gets_nothing_that_a_run_stands_on(self, option):
        net = make_grid(self.place)
        trips = write_routes(self.place / "t.xml", random_trips(net, 3, 3))
        self.fails(f"{option}.*cannot be given to SUMO alone", "run", "-n", net, "-r", trips, "-o", "out", "--", option, "1")

    @on_each(("run", "compare", "days"))
    def test_a_road_that_is_closed_for_ours_only_is_told(self, command):
        """A closingReroute without classes, on the road B0C0: SUMO's device drives through."""
        net = make_grid(self.place)
        trips = write_routes(self.place / "t.xml", random_trips(net, 3, 3))
        closed = write(self.place / "c.add.xml", '<additional><rerouter id="r" edges="A0B0"><interval begin="0" end="60">'
                       '<closingReroute id="B0C0"/></interval></rerouter></additional>')
        router = ["--arms", "device", "--seeds", 1] if command == "compare" else ["--strategy", "device"]
        more = ["--days", 1] if command == "days" else []
        result = self.succeeds(command, "-n", net, "-r", trips, "-a", closed, "-o", "out", *router, *more, cwd=self.place)
        self.assertIn("the closingReroute of 'B0C0' names no classes", result.err)

    def test_a_memory_that_cannot_be_written(self):
        net = make_grid(self.place)
        trips = write_routes(self.place / "t.xml", random_trips(net, 3, 3))
        self.fails("cannot write to the folder '/proc/none'", "run", "-n", net, "-r", trips, "-o", "out", "--strategy",
                   "memory", "--memory-output", "/proc/none")

    def test_sumo_gives_up(self):
        """What SUMO alone notices is told in its words. (A run that dies in the middle: test_compare.)"""
        net = make_grid(self.place)
        trips = write_routes(self.place / "t.xml", random_trips(net, 20, 20))
        sign = write(self.place / "sign.add.xml", '<additional><variableSpeedSign id="v" lanes="A0A1_0">'
                     '<step time="10" speed="fast"/></variableSpeedSign></additional>')
        reason = "Error: SUMO: Attribute 'speed' in definition of step 'v' .* fast"
        self.fails(reason, "run", "-n", net, "-r", trips, "-a", sign, "-o", "out", seconds=15)
        summary = json.loads((self.place / "out" / "run.json").read_text())
        self.assertEqual(summary["exit"], 1)
        self.assertIn("fast", summary["error"])
        self.assertIn("fast", (self.place / "out" / "sumo.log").read_text())


if __name__ == "__main__":
    support.main()
