#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws a city with its roads coloured by the change in speed between two runs.

    .venv/bin/python tools/speed_map.py NET.net.xml[.gz] BEFORE/edgedata.xml AFTER/edgedata.xml -o map.png

Several runs (seeds) of a side are given by commas and averaged. Every run of thalweg leaves an edgedata.xml.
"""

import argparse
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.colors import TwoSlopeNorm  # noqa: E402

for home in pathlib.Path(__file__).resolve().parent.parent.glob(".venv/lib/python3*/site-packages/sumo/tools"):
    sys.path.insert(0, str(home))
import sumolib  # noqa: E402


def vehicle_seconds_and_metres(files):
    """Per road: vehicle-seconds and metres driven, summed over the files. Their ratio is the mean speed."""
    seconds, metres = {}, {}
    for file in files.split(","):
        for edge in sumolib.xml.parse(file, "edge"):
            if edge.speed is None:  # nobody came through
                continue
            time = float(edge.sampledSeconds)
            seconds[edge.id] = seconds.get(edge.id, 0) + time
            metres[edge.id] = metres.get(edge.id, 0) + time * float(edge.speed)
    return seconds, metres


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net")
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--title", default="Change in mean speed")
    parser.add_argument("--limit", type=float, default=15, help="km/h at the ends of the colours")
    options = parser.parse_args()

    net = sumolib.net.readNet(options.net)
    before, after = vehicle_seconds_and_metres(options.before), vehicle_seconds_and_metres(options.after)
    quiet, lines, changes, widths = [], [], [], []
    for edge in net.getEdges():
        shape = edge.getShape()
        road = edge.getID()
        if before[0].get(road, 0) < 60 or after[0].get(road, 0) < 60:
            quiet.append(shape)
            continue
        change = after[1][road] / after[0][road] - before[1][road] / before[0][road]
        lines.append(shape)
        changes.append(3.6 * change)
        widths.append(1.6 + 0.5 * math.log10(1 + before[0][road] / 60))

    figure, axes = plt.subplots(figsize=(10, 7), constrained_layout=True, facecolor="#dcdce0")
    axes.add_collection(LineCollection(quiet, colors="#bdbdbd", linewidths=0.7))
    norm = TwoSlopeNorm(0, -options.limit, options.limit)
    coloured = LineCollection(lines, cmap="PuOr", norm=norm, linewidths=widths, capstyle="round")
    coloured.set_array(changes)
    axes.add_collection(coloured)
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(options.title)
    bar = figure.colorbar(coloured, ax=axes, shrink=0.6, extend="both")
    bar.set_label("km/h slower  <   change   >  km/h faster")
    figure.savefig(options.output, dpi=110)


if __name__ == "__main__":
    main()
