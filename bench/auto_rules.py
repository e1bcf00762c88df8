#!/usr/bin/env python3
"""auto_rules.py LIGNE --traits -o TRAITS.csv [--models FOLDER]
auto_rules.py --table TABLE.csv --with TRAITS.csv

Asks whether a rule on the traits of a scene would save time over what --method auto takes.

The first form writes the traits of every scene of auto_scenes.py, as `ligne info` counts them. The second fits rules to the times
of auto_table.py: "where a trait is above (or below) a bound another method is taken". Scenes count alike: the gain of a rule is the
mean of the logarithm of auto's time over that of the rule. Scenes below 20 ms are left out. It prints

- the gain that the best method for every scene would have, which no rule can exceed;
- the rules with the most gain, with the scenes that they change, and how many of them gain or lose more than a tenth, by which two
  runs of one method differ;
- the gain where each family of scenes is left out of the fit and then takes the rule of the others: what a rule is worth for a
  scene that is not in the table."""

import argparse
import csv
import json
import math
import subprocess
import sys
import tempfile

import auto_scenes
from auto_table import MEASURABLE_MS, ROOT, milliseconds

NOISE = 1.1
COUNTS = ("faces", "visible_faces", "nonconvex_faces", "zones", "largest_zone", "conflicts", "penetrations", "turning_vertices",
          "convex_objects", "most_overlap")
PLAIN = ("mean_visible_part", "covered_part", "mean_corners", "most_corners", "mean_overlap", "height_field")
COLUMNS = [*COUNTS, *PLAIN, "apart_x", "apart_y", "apart_z"]
METHODS = ("atherton-weiler", "warnock", "watkins", "newell", "bsp", "convex-tree")


def traits_of(ligne, path, options):
    done = subprocess.run([ligne, "info", path, *[o for o in options if o not in ("--hidden", "dashed")], "--quality", "exact", "-q",
                           "--json"], capture_output=True, text=True, check=True)
    traits = json.loads(done.stdout)["traits"]
    count = lambda v: v["at_least"] if isinstance(v, dict) else v
    row = {name: count(traits[name]) for name in [*COUNTS, *PLAIN]}
    row["height_field"] = int(row["height_field"])
    row.update({"apart_" + "xyz"[k]: part for k, part in enumerate(traits["pairs_apart"])})
    return {name: value if isinstance(value, int) else f"{value:.6g}" for name, value in row.items()}


def write_traits(ligne, output, models):
    with open(output, "w", encoding="utf-8", newline="") as file, tempfile.TemporaryDirectory() as folder:
        writer = csv.DictWriter(file, ["scene", "drawn", *COLUMNS])
        writer.writeheader()
        for name, drawn, path, options in auto_scenes.scenes(folder, ROOT, models):
            writer.writerow({"scene": name, "drawn": drawn, **traits_of(ligne, path, options)})
            file.flush()


class Case:
    """A scene of the table: auto's time, the times of the methods, and the values that rules look at."""

    def __init__(self, times, traits):
        self.name = f"{times['scene']}, {times['drawn']}"
        first, _, last = times["scene"].rpartition(" ")
        self.family = first if first and last.isdigit() else times["scene"]
        self.auto = float(times["auto"])
        # One that was ended took at least as long as stands after ">".
        self.times = {m: float(times[m].lstrip(">")) for m in METHODS if milliseconds(times[m]) is not None}
        self.best = min([self.auto, *[milliseconds(times[m]) for m in self.times], milliseconds(times["appel"])])
        values = {name: float(traits[name]) for name in COLUMNS}
        for name in COUNTS[1:]:
            values[name + " of a face"] = values[name] / max(values["faces"], 1)
        self.values = values

    def gain(self, method):
        """Logarithm of the factor by which the method is faster; 0 where the scene is not for it."""
        return math.log(self.auto / self.times[method]) if method in self.times else 0.0


def read_cases(table, traits):
    with open(traits, encoding="utf-8", newline="") as file:
        by_scene = {(row["scene"], row["drawn"]): row for row in csv.DictReader(file)}
    with open(table, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    cases = [Case(row, by_scene[row["scene"], row["drawn"]]) for row in rows if float(row["auto"]) >= MEASURABLE_MS]
    return len(rows), cases


class Rule:
    def __init__(self, trait, above, bound, method):
        self.trait, self.above, self.bound, self.method = trait, above, bound, method

    def holds(self, case):
        value = case.values[self.trait]
        return value > self.bound if self.above else value < self.bound

    def gains(self, cases):
        return [case.gain(self.method) for case in cases if self.holds(case)]

    def words(self):
        return f"{self.trait} {'above' if self.above else 'below'} {self.bound:.4g}: {self.method}"


def rules_of(cases, trait, method):
    """The best rule of the trait and method above a bound, and the best below one, with their gains. O(n log n)."""
    order = sorted(cases, key=lambda case: case.values[trait])
    best = []
    for above in (False, True):
        run = order[::-1] if above else order
        total, most, bound = 0.0, 0.0, None
        for i, case in enumerate(run):
            total += case.gain(method)
            last = i + 1 == len(run)
            if total > most and (last or run[i + 1].values[trait] != case.values[trait]):
                most = total
                bound = (case.values[trait] + run[i + 1].values[trait]) / 2 if not last else (-math.inf if above else math.inf)
        if bound is not None:
            best.append((most, Rule(trait, above, bound, method)))
    return best


def fit(cases):
    """All best rules, those of the most gain first."""
    found = []
    for trait in cases[0].values:
        for method in METHODS:
            found += rules_of(cases, trait, method)
    return sorted(found, key=lambda pair: -pair[0])


def percent(log_gain):
    return f"{100 * (math.exp(log_gain) - 1):.2f} %"


def sum_up(count, cases):
    n = len(cases)
    print(f"{count} scenes, of which {n} take {MEASURABLE_MS} ms or more")
    print(f"the best method for every scene: {percent(sum(math.log(c.auto / c.best) for c in cases) / n)} faster than auto on the mean; "
          f"{sum(c.auto > NOISE * c.best for c in cases)} scenes by more than a tenth")
    print("| rule | scenes | faster by a tenth | slower by a tenth | gain over all scenes |\n|---|---|---|---|---|")
    for gain, rule in fit(cases)[:12]:
        gains = rule.gains(cases)
        faster, slower = (sum(sign * g > math.log(NOISE) for g in gains) for sign in (1, -1))
        print(f"| {rule.words()} | {len(gains)} | {faster} | {slower} | {percent(gain / n)} |")
    total, changed, slower = 0.0, 0, 0
    for family in sorted({c.family for c in cases}):
        others = [c for c in cases if c.family != family]
        found = fit(others)
        if not found:
            continue
        gains = found[0][1].gains([c for c in cases if c.family == family])
        total += sum(gains)
        changed += len(gains)
        slower += sum(-g > math.log(NOISE) for g in gains)
    print(f"the best rule of the other families: {percent(total / n)} over all scenes; it changes {changed}, and {slower} of them are "
          "slower by a tenth")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ligne", nargs="?")
    parser.add_argument("--traits", action="store_true")
    parser.add_argument("-o", "--output")
    parser.add_argument("--models")
    parser.add_argument("--table")
    parser.add_argument("--with", dest="traits_file")
    a = parser.parse_args()
    if a.traits and a.ligne and a.output:
        write_traits(a.ligne, a.output, a.models)
    elif a.table and a.traits_file:
        sum_up(*read_cases(a.table, a.traits_file))
    else:
        parser.error("LIGNE --traits -o TRAITS.csv, or --table TABLE.csv --with TRAITS.csv")


if __name__ == "__main__":
    sys.exit(main())
