# SPDX-License-Identifier: Apache-2.0
"""The pure half of tools/commute: arms, seeds, the lines of runs.csv, and the tuned device."""
import csv
import datetime
import statistics
from collections import namedtuple

from calls import Mistake

KEY = ["scenario", "hash", "arm", "options", "seed", "sumo", "router"]
COLUMNS = KEY + ["vehicles", "finished", "running", "waiting", "mean_commute_s", "duration_s", "depart_delay_s",
                 "teleports", "reroutings", "router_cpu_s", "simulation_cpu_s", "date"]
TUNED = "device-tuned"
BASELINES = ["given", "static", "one-shot", "device", TUNED]


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


Tuning = namedtuple("Tuning", "arms seeds")  # which settings of SUMO's device are tried, by which seeds they are chosen


def tuning(kind=""):
    """Of a scenario, by its column `tuning`: 15 settings and two seeds, or in a large city `few`. `device` (probability
    1, period 60) is one of them."""
    if kind == "few":
        settings = ["device:period=120,probability=0.7", "device:period=120,probability=0.5",
                    "device:period=300,probability=0.5", "device:period=300,probability=0.3", "device:threshold.factor=1.1"]
        return Tuning(["device", *map(canonical, settings)], (1,))
    settings = [f"device:period={period},probability={probability}" for probability in ("0.3", "0.5", "0.7", "1")
                for period in ("60", "120", "300")]
    return Tuning(list(map(canonical, [*settings, "device:threshold.factor=1.1", "device:threshold.factor=1.3",
                                       "device:threshold.constant=30"])), (1, 2))


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


def tuned(lines, kind=""):
    """Which setting of the device has the least mean over the seeds of its tuning; `lines` are those of one scenario.
    LookupError names the settings that were not run."""
    means, missing, tried = {}, [], tuning(kind)
    for arm in tried.arms:
        of_seed = commutes(line for line in lines if line["arm"] == arm)
        if set(tried.seeds) <= of_seed.keys():
            means[arm] = statistics.fmean(of_seed[seed] for seed in tried.seeds)
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
