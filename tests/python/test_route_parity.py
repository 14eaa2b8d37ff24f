# SPDX-License-Identifier: Apache-2.0
"""`thalweg route` finds ways that cost what duarouter's cost, in every city and every sample network."""
import functools
import random
import re

import support
from support import City, expand, on_each, read_xml, run_tool, sample_net, sumolib, write

PAIRS = 1000
SEED = 20240
PENALTIES = {  # minor, turn-around, signal
    "none": (0, 0, 0),
    "default": (1.5, 5, 0),
    "others": (3, 10, 2),
}


@functools.lru_cache(maxsize=1)
def load(file):
    return sumolib.net.readNet(str(file), withInternal=True)


def free_flow(road):
    """Of the fastest lane, the first of these, as SUMO's routers have it."""
    fastest = max(road.getLanes(), key=lambda lane: lane.getSpeed())
    return fastest.getLength() / fastest.getSpeed()


def weight_file(net, file, draw):
    """1 to 3 times the free flow for every road, those within the junctions included."""
    lines = [f'<edge id="{road.getID()}" traveltime="{free_flow(road) * draw.uniform(1.0001, 3):.6f}"/>'
             for road in net.getEdges() if road.getFunction() in ("", "internal")]
    return write(file, '<meandata><interval begin="0" end="10000000">\n' + "\n".join(lines)
                 + "\n</interval></meandata>\n")


def trip_file(net, file, draw, vehicle_class="passenger"):
    roads = sorted(road.getID() for road in net.getEdges(withInternal=False) if road.allows(vehicle_class))
    trips = []
    while len(trips) < PAIRS:
        origin, destination = draw.choice(roads), draw.choice(roads)
        if origin != destination:
            trips.append(f'<trip id="{len(trips)}" type="car" depart="0" from="{origin}" to="{destination}"/>')
    return write(file, f'<routes>\n<vType id="car" vClass="{vehicle_class}" speedFactor="1" speedDev="0"/>\n'
                 + "\n".join(trips) + "\n</routes>\n")


def routes_of(file):
    """Of each vehicle in the file: the cost and the roads."""
    return {vehicle.get("id"): (float(vehicle.find("route").get("cost")), vehicle.find("route").get("edges").split())
            for vehicle in read_xml(file).iter("vehicle")}


def junction_roads(net, before, after):
    """How many internal roads there are at most between two roads."""
    most = 0
    for connection in net.getEdge(before).getConnections(net.getEdge(after)):
        count, via = 0, connection.getViaLaneID()
        while via:
            count += 1
            following = [c for edges in net.getLane(via).getEdge().getOutgoing().values() for c in edges]
            via = following[-1].getViaLaneID() if following and count < 9 else ""
        most = max(most, count)
    return most


@expand
class RouteParity(support.TestCase):
    def penalties(self, name):
        minor, turnaround, signal = PENALTIES[name]
        return ["--weights.minor-penalty", minor, "--weights.turnaround-penalty", turnaround,
                "--weights.tls-penalty", signal]

    def duarouter(self, net, trips, folder, options):
        run_tool("duarouter", "-n", net, "-r", trips, "-o", folder / "theirs.xml", "--alternatives-output", "NUL",
                 "--write-costs", "--routing-algorithm", "dijkstra", "--ignore-errors", "--no-step-log",
                 "--no-warnings", "--junction-taz", "false", *options)
        return routes_of(folder / "theirs.xml")

    def thalweg(self, net, trips, folder, options, strategy, vehicle_class="passenger"):
        self.succeeds("route", "-n", net, "-r", trips, "-o", folder / "ours.xml", "--write-costs", "--ignore-errors",
                      "--strategy", strategy, "--vclass", vehicle_class, *options)
        return routes_of(folder / "ours.xml")

    def assert_equal_costs(self, net, ours, theirs, least):
        self.assertEqual(sorted(set(ours) ^ set(theirs)), [], "routed by the one and not by the other")
        self.assertGreaterEqual(len(ours), least, "hardly any pair is connected: this test would show nothing")
        for trip, (cost, roads) in ours.items():
            junctions = sum(junction_roads(net, *pair) for pair in zip(roads, roads[1:]))
            self.assertAlmostEqual(cost, theirs[trip][0], delta=0.01 + 0.0005 * (len(roads) + junctions),
                                   msg=f"trip {trip}\nours   {' '.join(roads)}\ntheirs {' '.join(theirs[trip][1])}")

    def compare(self, file, penalties, with_weights, vehicle_class="passenger"):
        folder, net, draw = self.folder(), load(file), random.Random(SEED)
        trips = trip_file(net, folder / "trips.xml", draw, vehicle_class)
        options = self.penalties(penalties)
        if with_weights:
            options += ["--weight-files", weight_file(net, folder / "weights.xml", draw)]
        theirs = self.duarouter(file, trips, folder, options)
        evolved = self.thalweg(file, trips, folder, options, "evolved", vehicle_class)
        dijkstra = self.thalweg(file, trips, folder, options, "dijkstra", vehicle_class)
        hybrid = self.thalweg(file, trips, folder, options, "hybrid", vehicle_class)
        self.assert_equal_costs(net, evolved, theirs, PAIRS // 2)
        self.assertEqual({trip: cost for trip, (cost, _) in evolved.items()},
                         {trip: cost for trip, (cost, _) in dijkstra.items()})
        self.assertEqual(set(hybrid), set(evolved))
        for trip, (cost, roads) in hybrid.items():
            self.assertGreaterEqual(cost, evolved[trip][0], f"trip {trip}")
            self.assertLessEqual(len(roads), len(evolved[trip][1]), f"trip {trip}: hybrid has the fewest turns")

    @on_each(support.CITY_FILES)
    def test_weights_city(self, name):
        self.compare(City(name).net, "none", True)

    @on_each(support.SAMPLES)
    def test_weights_sample(self, name):
        self.compare(sample_net(name), "none", True)

    @on_each(support.CITY_FILES)
    def test_default_penalties_city(self, name):
        self.compare(City(name).net, "default", False)

    @on_each(support.SAMPLES)
    def test_default_penalties_sample(self, name):
        self.compare(sample_net(name), "default", False)

    @on_each(support.CITY_FILES)
    def test_other_penalties_city(self, name):
        self.compare(City(name).net, "others", False)

    @on_each(("bus", "truck", "bicycle"))
    def test_classes(self, vehicle_class):
        """Bus lanes, forbidden roads, and the class's own top speed."""
        self.compare(City("bologna-joined").net, "default", False, vehicle_class)

    @on_each(("passenger", "truck"))
    def test_speed_restrictions(self, vehicle_class):
        """Road types that slow trucks down, or let them drive faster than the lane says."""
        net = self.folder() / "restricted.net.xml"
        run_tool("netgenerate", "--grid", "--grid.number", 5, "-o", net)
        types = ('<type id="slow"><restriction vClass="truck" speed="3"/></type>'
                 '<type id="fast"><restriction vClass="truck" speed="30"/></type><type id="usual"/>')
        text = re.sub(r"(<location [^>]*/>)", r"\1" + types, net.read_text())
        draw = random.Random(SEED)
        text = re.sub(r'<edge (id="[A-Z])', lambda found: f'<edge type="{draw.choice(("slow", "fast", "usual"))}" '
                      + found.group(1), text)
        self.assertGreater(text.count('type="slow"'), 10)
        write(net, text)
        self.compare(net, "default", False, vehicle_class)

    def test_no_way(self):
        """Both leave the same trips out, and ours says why.

             A ---> B     C ---> D
        """
        folder = self.folder()
        nodes = "".join(f'<node id="{n}" x="{100 * x}" y="0"/>' for x, n in enumerate("ABCD"))
        write(folder / "n.nod.xml", f"<nodes>{nodes}</nodes>")
        write(folder / "e.edg.xml", '<edges><edge id="AB" from="A" to="B"/><edge id="CD" from="C" to="D"/></edges>')
        net = folder / "parts.net.xml"
        run_tool("netconvert", "-n", folder / "n.nod.xml", "-e", folder / "e.edg.xml", "-o", net)
        trips = write(folder / "t.xml", '<routes><trip id="no" depart="0" from="AB" to="CD"/>'
                      '<trip id="yes" depart="0" from="CD" to="CD"/></routes>')
        options = self.penalties("default")
        self.assert_equal_costs(load(net), self.thalweg(net, trips, folder, options, "evolved"),
                                self.duarouter(net, trips, folder, options), 1)
        result = support.thalweg("route", "-n", net, "-r", trips, "-o", folder / "ours.xml", "--ignore-errors")
        self.assertIn("there is no way from 'AB' to 'CD'", result.err)
        result = support.thalweg("route", "-n", net, "-r", trips, "-o", folder / "strict.xml")
        self.assertEqual(result.exit, 1)
        self.assertIn("there is no way from 'AB' to 'CD'", result.err)
        self.assertFalse((folder / "strict.xml").exists())


if __name__ == "__main__":
    support.main()
