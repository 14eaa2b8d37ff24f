# SPDX-License-Identifier: Apache-2.0
"""`thalweg network` counts what sumolib counts, in every city and every sample network."""
import re

import support
from support import City, expand, on_each, sample_net, sumolib

CLASSES = ("passenger", "bus", "bicycle", "truck")


def counted_by_thalweg(test, net):
    out = test.succeeds("network", "-n", net, "--vclass", ",".join(CLASSES)).out
    counts = {name: int(count) for name, count in re.findall(r"^(\w+) (\d+)$", out, re.MULTILINE)}
    turns = {name: int(count) for name, count in re.findall(r"^(\w+): \d+ roads, (\d+) turns", out, re.MULTILINE)}
    return ({name: counts[name] for name in ("roads", "lanes", "junctions", "connections", "signals")},
            {name: turns[name] for name in CLASSES})


def turns_by_sumolib(net, vehicle_class):
    """Pairs of roads joined by a connection that the class may use from its lane to its lane."""
    turns = set()
    for road in net.getEdges(withInternal=False):
        for connections in road.getOutgoing().values():
            for connection in connections:
                lanes = [connection.getFromLane(), connection.getToLane()]
                if connection.getViaLaneID():
                    lanes.append(net.getLane(connection.getViaLaneID()))
                if all(lane.allows(vehicle_class) for lane in lanes) and connection.allows(vehicle_class):
                    turns.add((connection.getFrom().getID(), connection.getTo().getID()))
    return len(turns)


def counted_by_sumolib(file):
    net = sumolib.net.readNet(str(file), withInternal=True, withPrograms=True)
    roads = net.getEdges(withInternal=False)
    return ({"roads": len(roads),
             "lanes": sum(road.getLaneNumber() for road in roads),
             "junctions": sum(node.getType() != "internal" for node in net.getNodes()),
             "connections": sum(len(c) for road in roads for c in road.getOutgoing().values()),
             "signals": len(net.getTrafficLights())},
            {name: turns_by_sumolib(net, name) for name in CLASSES})


@expand
class NetworkParity(support.TestCase):
    def compare(self, net):
        ours, theirs = counted_by_thalweg(self, net), counted_by_sumolib(net)
        self.assertEqual(ours, theirs)
        self.assertGreater(min(ours[1]["passenger"], ours[0]["lanes"]), 0)

    @on_each(support.CITY_FILES)
    def test_city(self, name):
        self.compare(City(name).net)

    @on_each(support.SAMPLES)
    def test_sample(self, name):
        self.compare(sample_net(name))


if __name__ == "__main__":
    support.main()
