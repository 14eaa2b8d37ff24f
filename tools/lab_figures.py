#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""usage: lab_figures.py FOLDER

Draws the experiments' figures from FOLDER/*.csv alone (FOLDER/*.png), on the axes of the paper's figures, with
the paper's own points beside ours where it prints numbers. Experiments without a CSV are left out.
"""

import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]


class Table:
    def __init__(self, file):
        with open(file, newline="", encoding="utf-8") as stream:
            self.rows = list(csv.DictReader(stream))

    def where(self, **conditions):
        """The rows whose columns (given with _ for a blank) have these values."""
        wanted = {key.replace("_", " "): value for key, value in conditions.items()}
        found = Table.__new__(Table)
        found.rows = [r for r in self.rows if all(r[k] == v for k, v in wanted.items())]
        return found

    def different(self, column):
        return list(dict.fromkeys(row[column] for row in self.rows))

    def numbers(self, *columns):
        """These columns as lists of numbers, over the rows that have them all."""
        rows = [row for row in self.rows if all(row[c] != "" for c in columns)]
        return [[float(row[c]) for row in rows] for c in columns]


def runtime(table, axes):
    for colour, (column, name) in zip(COLOURS, [
            ("total [ms]", "partition + hybrid"), ("breadth-first [ms]", "breadth-first search"),
            ("Dijkstra [ms]", "Dijkstra"), ("Boost Dijkstra [ms]", "Boost.Graph's Dijkstra"),
            ("first form [ms]", "first form of the partition"), ("paper total [ms]", "the paper's total")]):
        side, time = table.numbers("side", column)
        axes.loglog(side, time, "s--" if column.startswith("paper") else "o-", color=colour, label=name, ms=4)
    axes.set(xlabel="side k of the grid", ylabel="time [ms]", title="T-runtime (the paper's Figure 2)")
    axes.legend()


def enumerate_(table, axes):
    for colour, name in zip(COLOURS, ["BOTS", "EBOGP"]):
        rows = table.where(algorithm=name, how="enumerated")
        side, paths = rows.numbers("side", "paths")
        axes.semilogy(side, paths, "o-", color=colour, label=f"{name}, paths")
        side, loops = rows.numbers("side", "loops")
        axes.semilogy(side, loops, "o:", color=colour, label=f"{name}, loops")
        side, paper = rows.numbers("side", "paper paths")
        axes.semilogy(side, paper, "x", color="black", ms=10)
        side, paper = rows.numbers("side", "paper loops")
        axes.semilogy(side, paper, "x", color="black", ms=10)
    axes.plot([], [], "x", color="black", label="the paper's")
    axes.set(xlabel="side k of the grid", ylabel="number", title="T-enumerate")
    axes.legend()


def polygon(table, axes):
    length, anti = table.numbers("shorter side [edges]", "anti events, dealt [%]")
    axes.bar(length, anti, color="0.6", label="measured")
    rest = table.numbers("shorter side [edges]", "mean from here to the end, dealt [%]")
    axes.plot(*rest, color=COLOURS[0], label="mean from this length to the end")
    axes.axhline(10.4, color=COLOURS[1], ls="--", label="the paper's 10.4 %")
    axes.axvline(70, color=COLOURS[1], ls=":", label="the paper's onset, 70")
    axes.set(xlabel="edges of the shorter side", ylabel="anti events [%]", title="F-polygon (Figure 3)")
    axes.legend()


def triangle(table, axes):
    n, exact, drawn, width = table.numbers("n", "x1 + x2 < y, exact", "drawn", "95 % half width")
    axes.errorbar(n, drawn, width, fmt="o", color=COLOURS[0], label="drawn")
    axes.semilogx(n, exact, color=COLOURS[0], label="exact")
    axes.semilogx(*table.numbers("n", "y on the given side, exact"), color=COLOURS[1], label="greatest on e3")
    axes.semilogx(*table.numbers("n", "equal pair, exact"), color=COLOURS[2], label="equal pair")
    axes.axhline(0.48, color="0.5", ls="--", label="the paper's 0.48 and 0.17")
    axes.axhline(0.17, color="0.5", ls="--")
    axes.set(xlabel="n", ylabel="probability", title="P-triangle")
    axes.legend()


def greedy(table, figure):
    for axes, name in zip(figure.subplots(2, 2).flat, table.different("distribution")):
        rows = table.where(distribution=name)
        side, longer, length_equal = rows.numbers(
            "side", "length: greedy longer [%]", "length: equal [%]")
        _, heavier, equal, wins = rows.numbers(
            "side", "weight: greedy heavier [%]", "weight: equal [%]", "weight: greedy wins [%]")
        left = [s - 0.8 for s in side]
        right = [s + 0.8 for s in side]
        axes.bar(left, longer, 1.5, color="0.4", label="greedy longer / heavier")
        axes.bar(left, length_equal, 1.5, bottom=longer, color="0.85", label="equal")
        axes.bar(right, heavier, 1.5, color="0.4")
        axes.bar(right, equal, 1.5, bottom=heavier, color="0.85")
        axes.bar(right, wins, 1.5, bottom=[a + b for a, b in zip(heavier, equal)], color="black",
                 label="greedy wins")
        axes.set(xlabel="side k (left: length, right: weight)", ylabel="tests [%]", title=name)
    axes.legend(fontsize=7)
    figure.suptitle("F-greedy (Figures 4 to 7)")


def dynamic(table, axes):
    n, distinct = table.numbers("N", "mean distinct totals")
    other = axes.twinx()
    other.bar(n, distinct, 10, color="0.85")
    other.set_ylabel("mean number of different totals (bars)")
    for colour, column in zip(COLOURS, ["worst position [%]", "top [%]", "average status [%]"]):
        axes.plot(*table.numbers("N", column), "o-", color=colour, label=column)
    axes.set(xlabel="N (unit: 2k)", ylabel="%", title="F-dynamic (Figure 8)", ylim=(0, None))
    axes.set_zorder(1)
    axes.patch.set_visible(False)
    axes.legend()


def density(table, figure):
    for axes, reading in zip(figure.subplots(2, 2).flat, table.different("reading")):
        rows = table.where(reading=reading)
        for colour, gap in zip(COLOURS, rows.different("c")):
            n, status = rows.where(c=gap).numbers("N", "average status [%]")
            top = rows.where(c=gap).numbers("N", "top [%]")
            axes.plot(n, status, "o-", color=colour, label=f"c = {gap}")
            axes.plot(*top, "o:", color=colour, ms=3)
        axes.set(xlabel="N", ylabel="average status, on top (dotted) [%]", title=reading, ylim=(0, 103))
    axes.legend(fontsize=7)
    figure.suptitle("F-density (Figure 9), by reading")


def regular(table, axes):
    for colour, reading in zip(COLOURS, table.different("reading")):
        rows = table.where(reading=reading)
        y, eta = rows.numbers("|Y|", "eta = |Y| / N")
        axes.plot(y, eta, "o-", color=colour, label=f"eta, {reading}")
        axes.plot(*rows.numbers("|Y|", "log10 eta"), "o:", color=colour, label="log10 eta")
        axes.axhline(sum(eta) / len(eta), color=colour, ls="--", lw=0.8)
    axes.set(xlabel="|Y|", ylabel="eta", title="F-regular (Figure 10)", yscale="symlog")
    axes.legend()


def evolve(table, figure):
    saved, rounds = figure.subplots(1, 2)
    for colour, (mean, width, name) in zip(COLOURS, [
            ("improvement, mean [%]", "95 % half width [%]", "corner to corner"),
            ("improvement, all targets [%]", "95 % half width, all [%]", "to all targets")]):
        side, value, error = table.numbers("side", mean, width)
        saved.errorbar(side, value, error, fmt="o-", color=colour, label=name)
    saved.axhline(5, color="0.5", ls="--", label="the paper's 5 %")
    saved.set(xlabel="side k", ylabel="saved by evolution [%]")
    saved.legend()
    side, value, error, vertices = table.numbers("side", "rounds, mean", "95 % half width", "vertices")
    rounds.errorbar(side, value, error, fmt="o-", color=COLOURS[0], label="rounds")
    rounds.plot(side, vertices, "--", color="0.5", label="n (the paper's guess)")
    rounds.set(xlabel="side k", ylabel="rounds", yscale="log")
    rounds.legend()
    figure.suptitle("C-evolve")


def evolve_rounds(table, figure):
    families = table.different("family")
    columns = min(4, len(families))
    grid = figure.subplots(-(-len(families) // columns), columns, squeeze=False)
    for axes in list(grid.flat)[len(families):]:
        axes.axis("off")
    for axes, family in zip(grid.flat, families):
        rows = table.where(family=family)
        for colour, way in zip(COLOURS, rows.different("rounds go")):
            vertices, mean = rows.where(rounds_go=way).numbers("vertices", "rounds, mean")
            axes.loglog(vertices, mean, "o-", color=colour, label=way)
        if len(rows.different("vertices")) > 1:
            axes.loglog(*rows.numbers("vertices", "bound (V - 1)"), "--", color="0.5", label="V - 1")
        axes.set(xlabel="vertices", title=family[:24])
        axes.set_ylabel("rounds")
    grid.flat[0].legend(fontsize=6)
    figure.suptitle("evolve-rounds")


def city_regions(table, figure):
    optimal, excess = figure.subplots(1, 2)
    for i, network in enumerate(table.different("network")):
        rows = Table.__new__(Table)
        rows.rows = [r for r in table.where(network=network).rows if r["turns apart"] != "all"]
        apart = [int(r["turns apart"].split("-")[0]) for r in rows.rows]
        style = {"color": COLOURS[i % len(COLOURS)], "label": network[:24]}
        line = "o-" if i < len(COLOURS) else "s--"
        optimal.semilogx(apart, *rows.numbers("fewest-turn path optimal [%]"), line, **style)
        excess.semilogx(apart, *rows.numbers("excess, mean [%]"), line, **style)
    optimal.set(xlabel="turns apart (from)", ylabel="fewest-turn path is the best [%]")
    excess.set(xlabel="turns apart (from)", ylabel="mean excess over the best [%]")
    optimal.legend(fontsize=7)
    figure.suptitle("city-regions")


def city_dynamic(table, axes):
    names = table.different("search")
    exact, width = table.numbers("arrives earliest [%]", "95 % half width [%]")
    axes.bar(names, exact, yerr=width, color=COLOURS[:len(names)])
    axes.set(ylabel="pairs that arrive earliest [%]", title="city-dynamic", ylim=(0, 102))


# name of the CSV: (what draws it, whether it wants the whole figure)
FIGURES = {
    "runtime": (runtime, False), "enumerate": (enumerate_, False), "polygon": (polygon, False),
    "triangle": (triangle, False), "greedy": (greedy, True), "dynamic": (dynamic, False),
    "density": (density, True), "regular": (regular, False), "evolve": (evolve, True),
    "evolve-rounds": (evolve_rounds, True), "city-regions": (city_regions, True),
    "city-dynamic": (city_dynamic, False),
}


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        return 0 if sys.argv[1:] in (["--help"], ["-h"]) else 2
    folder = pathlib.Path(sys.argv[1])
    for name, (draw, whole) in FIGURES.items():
        file = folder / f"{name}.csv"
        if not file.exists():
            continue
        figure = plt.figure(figsize=(11, 7) if whole else (7, 4.5), layout="constrained")
        draw(Table(file), figure if whole else figure.subplots())
        figure.savefig(folder / f"{name}.png", dpi=110)
        plt.close(figure)
        print(folder / f"{name}.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
