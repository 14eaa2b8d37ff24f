# SPDX-License-Identifier: Apache-2.0
"""The pure half of tools/commute: arms, seeds, the lines of runs.csv, the tuned device, and the report."""
import csv
import datetime
import math
import statistics

from calls import Mistake

KEY = ["scenario", "hash", "arm", "options", "seed", "sumo", "router"]
COLUMNS = KEY + ["vehicles", "finished", "running", "waiting", "mean_commute_s", "duration_s", "depart_delay_s",
                 "teleports", "reroutings", "router_cpu_s", "simulation_cpu_s", "date"]
TUNED = "device-tuned"
TUNING_SEEDS = (1, 2)
BASELINES = ["given", "static", "one-shot", "device", TUNED]
BEGIN, END = "<!-- tools/commute --report: begin -->", "<!-- tools/commute --report: end -->"
STUDENT = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131,
           2.120, 2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042]


# ------------------------------------------------------------------------------------------------ arms and seeds

def canonical(arm):
    """One name for one arm: a device's settings in order of their names, without those it has anyway."""
    if not arm.startswith("device:"):
        return arm
    settings = {"probability": "1", "period": "60"}
    for part in filter(None, (part.strip() for part in arm[len("device:"):].split(","))):
        name, equals, value = (word.strip() for word in part.partition("="))
        if not equals:
            raise Mistake(f"'{part}' is no setting: write name=value")
        settings[name.removeprefix("device.rerouting.")] = value
    changed = sorted(item for item in settings.items() if item not in {("probability", "1"), ("period", "60")})
    return "device:" + ",".join("=".join(item) for item in changed) if changed else "device"


def split_arms(text):
    """`thalweg compare --arms`: a part with '=' behind a device: goes on with its settings."""
    arms = []
    for part in filter(None, (part.strip() for part in text.split(","))):
        if arms and arms[-1].startswith("device:") and "=" in part and not part.startswith("device:"):
            arms[-1] += "," + part
        else:
            arms.append(part)
    return list(dict.fromkeys(map(canonical, arms)))


def split_seeds(text):
    """'1-3,7' is 1, 2, 3 and 7."""
    seeds = []
    for part in filter(None, (part.strip() for part in text.split(","))):
        first, dash, last = part.partition("-")
        last = last if dash else first
        if not (first.isdecimal() and last.isdecimal() and int(first) <= int(last)):
            raise Mistake(f"--seeds {text}: '{part}' is no seed and no range such as 1-3")
        seeds.extend(range(int(first), int(last) + 1))
    if not seeds:
        raise Mistake(f"--seeds {text}: there is no seed in this list")
    return list(dict.fromkeys(seeds))


def tuning_arms():
    """The settings of SUMO's device that are tried; `device` (probability 1, period 60) is one of them."""
    settings = [f"device:period={period},probability={probability}" for probability in ("0.3", "0.5", "0.7", "1")
                for period in ("60", "120", "300")]
    return list(map(canonical, [*settings, "device:threshold.factor=1.1", "device:threshold.factor=1.3",
                                "device:threshold.constant=30"]))


# --------------------------------------------------------------------------------------------------------- lines

def key(line):
    return tuple(str(line[column]) for column in KEY)


def read(file):
    if not file.exists():
        return []
    with open(file, newline="", encoding="utf-8") as stream:
        lines = list(csv.DictReader(stream))
    if any(None in line or None in line.values() for line in lines):
        raise Mistake(f"{file}: a line has not as many values as there are columns")
    return lines


def append(file, line):
    """At once and in one write, so that a run that was finished is never lost."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with open(file, "a", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
        if stream.tell() == 0:
            writer.writeheader()
        writer.writerow(line)


def measured(run):
    """What a line has of a run.json."""
    now = datetime.datetime.now(datetime.timezone.utc).replace(microsecond=0, tzinfo=None)
    return {"vehicles": run["vehicles"], "finished": run["finished"], "running": run["running"],
            "waiting": run["waiting"], "mean_commute_s": f"{run['commute_mean']:.3f}",
            "duration_s": f"{run['duration_mean'] or 0:.3f}", "depart_delay_s": f"{run['depart_delay_mean'] or 0:.3f}",
            "teleports": sum(run["teleports"].values()), "reroutings": run["reroutes"],
            "router_cpu_s": f"{run['router_cpu_s'] or 0:.2f}", "simulation_cpu_s": f"{run['simulation_cpu_s'] or 0:.2f}",
            "date": now.isoformat()}


def commutes(lines):
    """Of lines of one arm and scenario: the mean commute by seed."""
    return {int(line["seed"]): float(line["mean_commute_s"]) for line in lines}


def tuned(lines):
    """Which setting of the device has the least mean over the tuning seeds; `lines` are those of one scenario.
    LookupError names the settings that were not run."""
    means, missing = {}, []
    for arm in tuning_arms():
        of_seed = commutes(line for line in lines if line["arm"] == arm)
        if set(TUNING_SEEDS) <= of_seed.keys():
            means[arm] = statistics.fmean(of_seed[seed] for seed in TUNING_SEEDS)
        else:
            missing.append(arm)
    if missing:
        raise LookupError(missing)
    return min(means, key=means.get)


def current(lines, options=""):
    """Of lines with these options: those of the newest SUMO, of each scenario's newest input and of each strategy's
    newest router there, in the order of their dates; a run that was done again counts once."""
    lines = sorted((line for line in lines if line["options"] == options), key=lambda line: line["date"])
    sumo = lines[-1]["sumo"] if lines else None
    lines = [line for line in lines if line["sumo"] == sumo]
    newest_hash = {line["scenario"]: line["hash"] for line in lines}
    newest_router = {(line["scenario"], line["arm"]): line["router"] for line in lines}
    lines = [line for line in lines if line["hash"] == newest_hash[line["scenario"]]
             and line["router"] == newest_router[line["scenario"], line["arm"]]]
    return list({key(line): line for line in lines}.values())


# -------------------------------------------------------------------------------------------------------- report

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


class Judged:
    """One scenario: its arms with their lines of these seeds (all when None), the tuned device, the best baseline."""

    def __init__(self, name, lines, seeds=None):
        self.name, self.arms = name, {}
        for line in sorted(lines, key=lambda line: int(line["seed"])):
            if seeds is None or int(line["seed"]) in seeds:
                self.arms.setdefault(line["arm"], []).append(line)
        try:
            self.setting = tuned(lines)
        except LookupError:
            self.setting = None
        if self.setting in self.arms:
            self.arms[TUNED] = self.arms[self.setting]
        self.commute = {arm: commutes(lines) for arm, lines in self.arms.items()}
        own = sorted(arm for arm in self.arms if arm not in BASELINES and not arm.startswith("device:"))
        self.shown = [arm for arm in BASELINES if arm in self.arms] + own
        self.own = own
        self.best = min((arm for arm in BASELINES if arm in self.arms), default=None,
                        key=lambda arm: statistics.fmean(self.commute[arm].values()))

    def over(self, arm, baseline):
        return ratio(self.commute[arm], self.commute[baseline]) if baseline in self.commute else None

    def row(self, arm, newest):
        """`newest`: the newest router of each arm; one that is older is named."""
        lines, values = self.arms[arm], self.commute[arm].values()

        def total(*columns):
            return sum(float(line[column]) for line in lines for column in columns)

        width, against = half_width(values), [self.over(arm, baseline) for baseline in (self.best, TUNED)]
        share = f"{100 * total('router_cpu_s') / max(total('router_cpu_s', 'simulation_cpu_s'), 1e-9):.0f} %"
        router = lines[0]["router"]
        name = (f"`{arm}`" + (f" ({self.setting})" if arm == TUNED else "") + (" *" if arm == self.best else "")
                + (f" of {router}" if router != newest[lines[0]["arm"]] else ""))
        cells = [self.name, name, ranges(self.commute[arm]), f"{statistics.fmean(values):.1f}",
                 "-" if width is None else f"±{width:.1f}", *("-" if r is None else f"{r:.3f}" for r in against),
                 f"{total('teleports') / len(lines):.1f}", f"{total('running', 'waiting') / len(lines):.1f}",
                 share if arm in self.own else "-"]
        return f"| {' | '.join(cells)} |"


def ranges(seeds):
    """1, 2, 3 and 7 as '1-3, 7'."""
    parts = []
    for seed in sorted(seeds):
        if parts and parts[-1][1] == seed - 1:
            parts[-1][1] = seed
        else:
            parts.append([seed, seed])
    return ", ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in parts)


def verdict(arm, judged):
    """The line on a strategy over a population."""
    compared = [(scenario, scenario.over(arm, TUNED)) for scenario in judged if arm in scenario.arms]
    ratios = [r for _, r in compared if r is not None]
    parts = [f"`{arm}`: {len(compared)} cities"]
    if ratios:
        parts.append(f"better than `{TUNED}` in {sum(r < 1 for r in ratios)} of {len(ratios)} "
                     f"({100 * sum(r < 1 for r in ratios) / len(ratios):.0f} %)")
        parts.append(f"geometric mean of the ratio {statistics.geometric_mean(ratios):.3f}")
    against_best = [(r, s) for s, r in ((s, s.over(arm, s.best)) for s, _ in compared) if r is not None]
    if against_best:
        worst, where = max(against_best, key=lambda pair: pair[0])
        parts.append(f"worst against the best baseline: {where.name}, {worst:.3f} of `{where.best}`")
    return "; ".join(parts)


def report(lines, scenarios, seeds=None, options=""):
    """The text between the markers. `scenarios`: (name, group) of those that are shown, in their order."""
    names = {name for name, _ in scenarios}
    lines = [line for line in current(lines, options) if line["scenario"] in names]
    if not lines:
        raise Mistake("there is no run to report")
    newest, routers = {}, {}
    for line in lines:
        newest[line["arm"]] = line["router"]
        if line["router"]:
            routers.setdefault(line["arm"], {})[line["router"]] = None
    origin = [f"SUMO {lines[0]['sumo']}", *([f"options {options}"] if options else []),
              *(f"`{arm}` of src {', '.join(own)}" for arm, own in sorted(routers.items())),
              f"{min(line['date'] for line in lines)[:10]} to {max(line['date'] for line in lines)[:10]}"]
    text = ["; ".join(origin) + ".", "",
            "Mean commute in s with its 95 % interval (Student, over seeds); ratios over the seeds that both arms have; "
            f"`{TUNED}` is the setting with the least mean over seeds {' and '.join(map(str, TUNING_SEEDS))}, and "
            "flattered on these; * the best baseline by mean; teleports and unfinished vehicles a run; the router's "
            "share of the CPU time.", ""]
    for group in dict.fromkeys(group for _, group in scenarios):
        judged = [Judged(name, [line for line in lines if line["scenario"] == name], seeds)
                  for name, of_group in scenarios if of_group == group]
        judged = [scenario for scenario in judged if scenario.shown]
        if not judged:
            continue
        text += [f"### {group}", ""]
        if group == "population":
            arms = dict.fromkeys(arm for scenario in judged for arm in scenario.own)
            text += [f"- {verdict(arm, judged)}" for arm in arms] + [""] * bool(arms)
        text += [f"| scenario | arm | seeds | commute | 95 % | / best | / {TUNED} | teleports | unfinished | router |",
                 "|---|---|---|---|---|---|---|---|---|---|"]
        text += [scenario.row(arm, newest) for scenario in judged for arm in scenario.shown] + [""]
    return "\n".join(text)


def between_markers(page, text):
    """The page with the text between the two markers."""
    if page.count(BEGIN) != 1 or page.count(END) != 1 or page.index(BEGIN) > page.index(END):
        raise Mistake(f"the page must have the lines '{BEGIN}' and '{END}', once each, in this order")
    return page[:page.index(BEGIN) + len(BEGIN)] + "\n" + text.rstrip() + "\n" + page[page.index(END):]
