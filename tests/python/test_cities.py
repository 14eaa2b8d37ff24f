# SPDX-License-Identifier: Apache-2.0
"""Real cities, their configurations unchanged but for an early end: nobody is lost, every output can be read."""
import hashlib
import json

import support
from support import City, expand, on_each, sumolib

MINUTES = 10
BEGIN = {"wildau": 53990}  # the others begin at 0


def elements(file, kind):
    """As SUMO's users read an output."""
    return list(sumolib.xml.parse(str(file), kind))


def hashes(folder):
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in folder.iterdir() if file.is_file()}


@expand
class Cities(support.RunCase):
    @on_each(support.CITY_FILES)
    def test_run(self, name):
        city, folder = City(name), self.folder()
        before = hashes(city.configuration.parent)
        end = BEGIN.get(name, 0) + 60 * MINUTES
        self.succeeds("run", "-c", city.configuration, "-o", folder, "--end", end, "--decision-output", "decisions.xml.gz")
        self.assertEqual(hashes(city.configuration.parent), before)
        summary = json.loads((folder / "run.json").read_text())
        self.assert_accounted(summary)
        self.assertEqual(summary["end_s"], end)
        self.assertGreater(summary["finished"], 50)

        tripinfo = next(folder.glob("tripinfo*.xml"))
        trips = elements(tripinfo, "tripinfo")
        self.assertEqual(len({trip.id for trip in trips}), len(trips))
        self.assertEqual(summary["finished"], sum(float(trip.arrival) >= 0 for trip in trips))
        self.assertEqual(summary["running"], sum(float(trip.depart) >= 0 > float(trip.arrival) for trip in trips))
        # SUMO also writes who is due at the very end, and has had no chance to depart
        undeparted = [trip for trip in trips if float(trip.depart) < 0 < float(trip.departDelay)]
        self.assertEqual(summary["waiting"], len(undeparted))
        statistics = elements(folder / "statistics.xml", "vehicles")
        self.assertEqual(int(statistics[0].running), summary["running"])
        net = sumolib.net.readNet(str(city.net), withInternal=True)
        roads = {road.getID() for road in net.getEdges(withInternal=True)}
        measured = {edge.id for edge in elements(folder / "edgedata.xml", "edge")}
        self.assertGreater(len(measured), 20)
        self.assertLessEqual(measured, roads)
        decisions = support.read_xml(folder / "decisions.xml.gz")
        self.assertGreater(len(decisions), 100)
        changed = [d for d in decisions if d.get("changed") == "true"]
        self.assertEqual(len(changed), summary["reroutes"])
        self.assertLessEqual({road for d in changed for road in d.get("newRoute").split()}, roads)


if __name__ == "__main__":
    support.main()
