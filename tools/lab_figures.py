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
            ("both in one pass [ms]", "partition + hybrid, one pass"), ("breadth-first [ms]", "breadth-first search"),
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
    axes.set(xlabel="side k of the grid", ylabel="number", title="T-enumerate", xticks=[int(side) for side in table.different("side")])
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
    axes.semilogx(n, [3 / value for value in n], ":", color=COLOURS[2], label="the paper's 3/n")
    axes.axhline(0.48, color="0.5", ls="--", label="the paper's 0.48 and 0.17")
    axes.axhline(0.17, color="0.5", ls="--")
    axes.set(xlabel="n", ylabel="probability", title="P-triangle", ylim=(-0.02, 0.6))
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
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    figure.suptitle("F-greedy (Figures 4 to 7)")


def dynamic(table, axes):
    table = table.where(weights="table")
    n, distinct = table.numbers("N", "mean distinct totals")
    other = axes.twinx()
    other.bar(n, distinct, 10, color="0.85")
    other.set_ylabel("mean number of different totals (bars)")
    for colour, column in zip(COLOURS, ["worst position [%]", "top [%]", "average status [%]"]):
        axes.plot(*table.numbers("N", column), "o-", color=colour, label=column)
    axes.set(xlabel="N (unit: 2k)", ylabel="%", title="F-dynamic (Figure 8)", ylim=(0, None))
    axes.set_zorder(1)
    axes.patch.set_visible(False)
    axes.figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)


def density(table, figure):
    readings = table.different("reading")
    tops, status = figure.subplots(2, len(readings), sharex=True, sharey="row")
    for top_axes, status_axes, reading in zip(tops, status, readings):
        rows = table.where(reading=reading)
        for colour, mark, gap in zip(COLOURS, "o^sDv", rows.different("c")):
            of_gap = rows.where(c=gap)
            top_axes.plot(*of_gap.numbers("N", "top [%]"), mark + "-", color=colour, ms=5, label=f"c = {gap}")
            status_axes.plot(*of_gap.numbers("N", "average status [%]"), mark + "-", color=colour, ms=5)
        top_axes.set(title=reading, ylim=(0, 103))
        status_axes.set(xlabel="N", ylim=(0, None))
    tops[0].set_ylabel("on top [%]")
    status[0].set_ylabel("average status [%]")
    figure.legend(*tops[0].get_legend_handles_labels(), loc="outside lower center", ncols=5)
    figure.suptitle("F-density (Figure 9), by reading; where the lines of all c are one, c has no effect")


def regular(table, figure):
    plain, logarithm = figure.subplots(1, 2)
    for colour, reading in zip(COLOURS, table.different("reading")):
        rows = table.where(reading=reading)
        for axes, column in ((plain, "eta = |Y| / N"), (logarithm, "log10 eta")):
            y, value = rows.numbers("|Y|", column)
            axes.plot(y, value, "o-", color=colour, label=reading)
            axes.axhline(sum(value) / len(value), color=colour, ls="--", lw=0.8)
            axes.set(xlabel="|Y|", ylabel=column)
    plain.legend()
    figure.suptitle("F-regular (Figure 10); dashed: means")


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
    networks = [f for f in families if len(table.where(family=f).different("vertices")) == 1]
    families = [f for f in families if f not in networks]
    upper, lower = figure.subfigures(2, 1) if networks and families else (figure, figure)
    ways = dict(zip(table.different("rounds go"), zip(COLOURS, "ov^sDPX")))
    if families:
        for axes, family in zip(upper.subplots(1, len(families), squeeze=False).flat, families):
            rows = table.where(family=family)
            for way, (colour, mark) in ways.items():
                vertices, mean = rows.where(rounds_go=way).numbers("vertices", "rounds, mean")
                axes.loglog(vertices, mean, mark + "-", color=colour, label=way, ms=5)
            axes.loglog(*rows.numbers("vertices", "bound (V - 1)"), "--", color="0.5", label="V - 1")
            axes.set(xlabel="vertices", ylabel="rounds", title=family)
    if networks:
        axes = lower.subplots()
        for way, (colour, mark) in ways.items():
            rounds = [table.where(family=f, rounds_go=way).numbers("rounds, mean")[0] for f in networks]
            axes.semilogy([f[:14] for f in networks], [r[0] for r in rounds], mark, color=colour, label=way, ms=6)
        axes.set(ylabel="rounds", title="road networks")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=8)
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


def score(table, figure):
    systems = table.different("system")
    axes_of = figure.subplots(2, len(systems), squeeze=False)
    for row, column in zip(axes_of, ["eta = w_max / |w|", "standard deviation / mean"]):
        for axes, system in zip(row, systems):
            value, excess, width = table.where(system=system).numbers(
                column, "hybrid over optimum [%]", "95 % half width, over [%]")
            axes.errorbar(value, excess, width, fmt="o", ms=4, lw=0.8, color=COLOURS[0])
            axes.set(xlabel=column, ylabel="hybrid over optimum [%]", title=system, ylim=(0, None))
            if column.startswith("eta"):
                axes.set_xscale("log")
    figure.suptitle("score: does eta, read off the weights, tell how far hybrid is from the optimum?")


def crew(table, axes):
    for colour, (mean, width, name) in zip(COLOURS, [
            ("table: arrived [%]", "95 % half width [%]", "with the reserve table"),
            ("no table: arrived [%]", "95 % half width, none [%]", "without, each on its fewest-arc path")]):
        axes.errorbar(*table.numbers("vehicles", mean, width), fmt="o-", color=colour, label=name)
    axes.set(xlabel="vehicles", ylabel="arrived [%]", title="crew in a narrow space", ylim=(0, 105))
    axes.legend()


def memory(table, figure):
    loads = table.different("load [cost a vehicle]")
    renewals = table.different("renewed a day [%]")
    for row, load in zip(figure.subplots(len(loads), len(renewals), squeeze=False, sharey="row"), loads):
        for axes, renewed in zip(row, renewals):
            rows = Table.__new__(Table)
            rows.rows = [r for r in table.rows
                         if r["load [cost a vehicle]"] == load and r["renewed a day [%]"] == renewed]
            for style, vehicles in zip(["o-", "s--", "^:", "v-."], rows.different("vehicles")):
                of_crew = rows.where(vehicles=vehicles)
                for colour, name in zip(COLOURS, ["no", "own", "shared"]):
                    day, excess = of_crew.numbers("day", f"{name} memory: over informed [%]")
                    axes.plot(day, excess, style, color=colour, ms=4, label=f"{name} memory, {vehicles} vehicles")
            axes.axhline(0, color="0.5", lw=0.8)
            axes.set(xlabel="day", ylabel="over the informed crew [%]",
                     title=f"{renewed} % of the roads change each night, load {load}")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3, fontsize=8)
    figure.suptitle("memory: what a crew's ways cost")


# name of the CSV: (what draws it, whether it wants the whole figure)
FIGURES = {
    "runtime": (runtime, False), "enumerate": (enumerate_, False), "polygon": (polygon, False),
    "triangle": (triangle, False), "greedy": (greedy, True), "dynamic": (dynamic, False),
    "density": (density, True), "regular": (regular, True), "evolve": (evolve, True),
    "evolve-rounds": (evolve_rounds, True), "city-regions": (city_regions, True),
    "city-dynamic": (city_dynamic, False), "score": (score, True), "crew": (crew, False),
    "memory": (memory, True),
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
