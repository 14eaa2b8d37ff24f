# SPDX-License-Identifier: Apache-2.0
"""The tables that tools/commute makes of runs.csv: one row a scenario, and one row an arm."""
import math
import statistics

from calls import Mistake
from commute_table import BASELINES, TUNED, commutes, current, tuned, tuning

BEGIN, END = "<!-- tools/commute --report: begin -->", "<!-- tools/commute --report: end -->"
MAIN = "forecast"  # the strategy that the short tables are about
STUDENT = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131,
           2.120, 2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042]


def half_width(values):
    """Of the 95 % interval of the mean (Student); None of one value."""
    values, count = list(values), len(values)
    if count < 2:
        return None
    return (STUDENT[count - 2] if count - 2 < len(STUDENT) else 1.96) * statistics.stdev(values) / math.sqrt(count)


def ratio(arm, other):
    """Mean commute of an arm over that of another, both over the seeds that both were run with; None without."""
    common = arm.keys() & other.keys()
    return statistics.fmean(arm[s] for s in common) / statistics.fmean(other[s] for s in common) if common else None


def ranges(seeds):
    """1, 2, 3 and 7 as '1-3, 7'."""
    parts = []
    for seed in sorted(seeds):
        if parts and parts[-1][1] == seed - 1:
            parts[-1][1] = seed
        else:
            parts.append([seed, seed])
    return ", ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in parts)


def row_of(cells):
    return f"| {' | '.join(cells)} |"


def header(*names):
    return [row_of(names), row_of("---" for _ in names).replace(" ", "")]


def total(lines, *columns):
    return sum(float(line[column]) for line in lines for column in columns)


class Judged:
    """One scenario: its arms with their lines of these seeds (all when None), the tuned device without the seeds that
    chose its setting, the best baseline."""

    def __init__(self, scenario, lines, seeds=None):
        self.name, self.arms, kind = scenario["name"], {}, scenario["tuning"]
        for line in sorted(lines, key=lambda line: int(line["seed"])):
            if seeds is None or int(line["seed"]) in seeds:
                self.arms.setdefault(line["arm"], []).append(line)
        try:
            self.setting = tuned(lines, kind)
        except LookupError:
            self.setting = None
        choosing = tuning(kind).seeds
        judging = [line for line in self.arms.get(self.setting, []) if int(line["seed"]) not in choosing]
        if judging:
            self.arms[TUNED] = judging
        self.commute = {arm: commutes(lines) for arm, lines in self.arms.items()}
        self.own = sorted(arm for arm in self.arms if arm not in BASELINES and not arm.startswith("device:"))
        self.baselines = [arm for arm in BASELINES if arm in self.arms]
        self.shown = self.baselines + self.own

    def over(self, arm, baseline):
        return ratio(self.commute[arm], self.commute[baseline]) if baseline in self.commute else None

    def over_best(self, arm):
        """(the largest ratio to a baseline, that baseline); (None, None) where there is none with its seeds."""
        ratios = [(self.over(arm, baseline), baseline) for baseline in self.baselines]
        return max((pair for pair in ratios if pair[0] is not None), key=lambda pair: pair[0], default=(None, None))

    def router_share(self, arm):
        lines = self.arms[arm]
        all_of_it = max(total(lines, "router_cpu_s", "simulation_cpu_s"), 1e-9)
        return f"{100 * total(lines, 'router_cpu_s') / all_of_it:.0f} %"

    def arm_row(self, arm, newest):
        """`newest`: the newest router of each arm; one that is older is named."""
        lines, values = self.arms[arm], self.commute[arm].values()
        width, best = half_width(values), self.over_best(arm)[0]
        router = lines[0]["router"]
        name = (f"`{arm}`" + (f" ({self.setting})" if arm == TUNED else "")
                + (" *" if arm in self.baselines and best == 1 else "")
                + (f" of {router}" if router != newest[lines[0]["arm"]] else ""))
        return row_of([self.name, name, ranges(self.commute[arm]), f"{statistics.fmean(values):.1f}",
                       "-" if width is None else f"±{width:.1f}",
                       *("-" if r is None else f"{r:.3f}" for r in (best, self.over(arm, TUNED))),
                       f"{total(lines, 'teleports') / len(lines):.1f}",
                       f"{total(lines, 'running', 'waiting') / len(lines):.1f}",
                       self.router_share(arm) if arm in self.own else "-"])

    def main_row(self):
        """MAIN against each baseline, over the seeds that it shares with the tuned device."""
        reference = self.commute.get(TUNED, self.commute[MAIN])
        own = {seed: value for seed, value in self.commute[MAIN].items() if seed in reference}
        lines = {arm: [line for line in self.arms.get(arm, []) if int(line["seed"]) in own] for arm in (MAIN, TUNED)}

        def mean(arm):
            values = {seed: value for seed, value in self.commute.get(arm, {}).items() if seed in own}
            if not values:
                return "-"
            return f"{statistics.fmean(values.values()):.1f}" + ("" if values.keys() == own.keys()
                                                                 else f" ({ranges(values)})")

        def teleports(arm):
            return f"{total(lines[arm], 'teleports') / len(lines[arm]):.1f}" if lines[arm] else "-"

        def with_width(values):
            width = half_width(values)
            return f"{statistics.fmean(values):.1f}" + ("" if width is None else f" ±{width:.1f}")

        less = [reference[seed] - own[seed] for seed in own]
        best, which = self.over_best(MAIN)
        paired = self.over(MAIN, TUNED)
        return row_of([
            self.name, ranges(own), *(mean(arm) for arm in BASELINES), self.setting or "-",
            with_width(own.values()),
            *(("-", "-", "-") if paired is None else
              (with_width(less), f"{sum(d > 0 for d in less)} of {len(less)}", f"{paired:.3f}")),
            "-" if best is None else f"{best:.3f} ({which})", f"{teleports(TUNED)}, {teleports(MAIN)}",
            self.router_share(MAIN)])


def verdict(arm, judged, kind):
    """The line on a strategy over many scenarios."""
    compared = [(scenario, scenario.over(arm, TUNED)) for scenario in judged if arm in scenario.arms]
    ratios = [r for _, r in compared if r is not None]
    parts = [f"`{arm}`: {len(compared)} {kind}"]
    if ratios:
        parts.append(f"better than `{TUNED}` in {sum(r < 1 for r in ratios)} of {len(ratios)} "
                     f"({100 * sum(r < 1 for r in ratios) / len(ratios):.0f} %)")
        parts.append(f"geometric mean of the ratio {statistics.geometric_mean(ratios):.3f}")
    against_best = [(*scenario.over_best(arm), scenario) for scenario, _ in compared]
    against_best = [(r, which, scenario) for r, which, scenario in against_best if r is not None]
    if against_best:
        worst, which, where = max(against_best, key=lambda entry: entry[0])
        parts.append(f"worst against the best baseline: {where.name}, {worst:.3f} of `{which}`")
    return "; ".join(parts)


class Report:
    """`scenarios`: the rows of scenarios.csv that are shown; Mistake when none of them was run."""

    def __init__(self, lines, scenarios, seeds=None, options=""):
        names = {scenario["name"] for scenario in scenarios}
        self.lines = [line for line in current(lines, options) if line["scenario"] in names]
        if not self.lines:
            raise Mistake("there is no run to report")
        self.options, self.groups = options, {}
        for scenario in scenarios:
            lines = [line for line in self.lines if line["scenario"] == scenario["name"]]
            judged = Judged(scenario, lines, seeds)
            if judged.shown:
                self.groups.setdefault(scenario["group"], []).append(judged)

    def origin(self):
        routers = {}
        for line in self.lines:
            if line["router"]:
                routers.setdefault(line["arm"], {})[line["router"]] = None
        dates = [line["date"][:10] for line in self.lines]
        return "; ".join([f"SUMO {self.lines[0]['sumo']}", *([f"options {self.options}"] if self.options else []),
                          *(f"`{arm}` of src {', '.join(own)}" for arm, own in sorted(routers.items())),
                          f"{min(dates)} to {max(dates)}"]) + "."

    def short(self):
        """One row a scenario of the groups that are no population, and a line on each population."""
        scenarios = [scenario for group, judged in self.groups.items() if group != "population"
                     for scenario in judged if MAIN in scenario.arms]
        text = [self.origin(), ""]
        if scenarios:
            text += [*header("scenario", "seeds", *(f"`{arm}`" for arm in BASELINES), "its setting", f"`{MAIN}`",
                             "less than tuned, seed by seed", "earlier in", f"{MAIN} / tuned",
                             f"{MAIN} / best of the others", f"teleports tuned, {MAIN}", "CPU of the router"),
                     *(scenario.main_row() for scenario in scenarios), "",
                     f"- {verdict(MAIN, scenarios, 'scenarios')}"]
        population = [scenario for scenario in self.groups.get("population", []) if MAIN in scenario.arms]
        if population:
            text += [f"- {verdict(MAIN, population, 'generated cities')}"]
        return "\n".join(text)

    def long(self):
        """One row an arm."""
        newest = {line["arm"]: line["router"] for line in self.lines}
        text = ["# All arms in all scenarios", "", "Made by `tools/commute --report` of [runs.csv](runs.csv). "
                + self.origin(), "",
                "Mean commute in s with its 95 % interval (Student, over seeds); ratios over the seeds that both arms "
                "have, that to the best with the baseline against which it is the largest; "
                f"`{TUNED}` is the setting with the least mean over the seeds of its tuning, on other seeds; * the best "
                "baseline; teleports and unfinished vehicles a run; the router's share of the CPU time.", ""]
        for group, judged in self.groups.items():
            text += [f"## {group}", ""]
            if group == "population":
                arms = dict.fromkeys(arm for scenario in judged for arm in scenario.own)
                text += [f"- {verdict(arm, judged, 'cities')}" for arm in arms] + [""] * bool(arms)
            text += header("scenario", "arm", "seeds", "commute", "95 %", "/ best", f"/ {TUNED}", "teleports",
                           "unfinished", "router")
            text += [scenario.arm_row(arm, newest) for scenario in judged for arm in scenario.shown] + [""]
        return "\n".join(text)


def between_markers(page, text):
    """The page with the text between the two markers."""
    if page.count(BEGIN) != 1 or page.count(END) != 1 or page.index(BEGIN) > page.index(END):
        raise Mistake(f"the page must have the lines '{BEGIN}' and '{END}', once each, in this order")
    return page[:page.index(BEGIN) + len(BEGIN)] + "\n" + text.rstrip() + "\n" + page[page.index(END):]
