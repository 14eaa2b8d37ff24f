# SPDX-License-Identifier: Apache-2.0
"""What other people's configurations hold: it must mean here what it means to SUMO alone."""
import support
from support import make_grid, random_trips, read_xml, run_tool, write, write_routes


class OtherCities(support.RunCase):
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


if __name__ == "__main__":
    support.main()
