#!/usr/bin/env python3
"""auto_table.py LIGNE -o FILE.csv [--models FOLDER] [--only TEXT,...] [--repeat N] [--measured FILE.csv]

Measures every exact method, and what --method auto does, on the scenes of auto_scenes.py, and writes a row for each scene: the
milliseconds of the processor in the study by each method, with one thread; for auto it is the study and the choice together. All
methods are run once by `ligne compare`, which ends those that take more than four times what the default one takes. It looks at
the clock, so on a busy machine it may end some too early: where times are large enough these are run by `ligne draw` with twelve
times as long, and what is ended again has ">" and four times the default one's time. Those that come near the best, and auto, are
run again N times by `ligne draw`, in turns, and the least time counts: N more times, three at the most, as long as auto misses the
bound. A method for which the scene is not made (ligne methods, "only for") has "-". The end of the output says how near auto comes
to the best method.

With --measured nothing is measured: the table that was written is summed up again."""

import argparse
import csv
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time

import auto_scenes

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DEFAULT = "appel"
MEASURABLE_MS = 20  # shorter times are the machine's
BOUND = 1.3         # of the best method's time
SLOWER = 4          # times the default method's time: ended
NEAR = 1.6          # times the best: measured again
MOST_ROUNDS = 4
PATIENCE = 12       # times the default method's time, by the clock: ended at last
LEAST_LIMIT_S = 0.2


def draw(ligne, path, options, method, limit_s=None):
    """Milliseconds of the processor in the study, and the method that made it."""
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        subprocess.run([ligne, "draw", path, *options, "--quality", "exact", "--method", method, "--threads", "1", "-q",
                        "-o", os.path.join(folder, "x.svg"), "--stats-json", stats], capture_output=True, check=True, timeout=limit_s)
        with open(stats, encoding="utf-8") as file:
            report = json.load(file)
        return 1000 * report["processor_seconds"]["study"], report["method"]


def compare(ligne, path, options, limit_s):
    """Milliseconds of the study by each exact method; None where the scene is not for it; negative where it was ended."""
    done = subprocess.run([ligne, "compare", path, *options, "--quality", "exact", "--threads", "1", "-q", "--json",
                           "--time-limit", str(limit_s)], capture_output=True, text=True, check=True)
    times = {}
    for m in json.loads(done.stdout)["methods"]:
        if not m["exact"] and m["drawn"]:
            continue
        if not m["drawn"]:
            times[m["name"]] = -1000 * limit_s if m["failure"].startswith("ended") else None
        else:
            times[m["name"]] = None if m["beyond"] else 1000 * m["processor_seconds"]["study"]
    return times


def try_again(ligne, path, options, times, default):
    """Gives methods that compare ended more time; `default` is the default method's milliseconds."""
    start = time.monotonic()
    draw(ligne, path, options, DEFAULT)
    limit_s = time.monotonic() - start + (PATIENCE - 1) * default / 1000
    for m, t in times.items():
        if t is not None and t < 0:
            try:
                times[m] = draw(ligne, path, options, m, limit_s)[0]
            except subprocess.TimeoutExpired:
                times[m] = -SLOWER * default


def text_of(ms):
    return "-" if ms is None else f">{-ms:.0f}" if ms < 0 else f"{ms:.1f}"


def measure(a):
    listed = json.loads(subprocess.run([a.ligne, "methods", "--json"], capture_output=True, text=True, check=True).stdout)
    methods = [m["name"] for m in listed["methods"] if m["exact"] and "strokes" in m["produces"]]
    rows = []
    with open(a.output, "w", encoding="utf-8", newline="") as file, tempfile.TemporaryDirectory() as folder:
        writer = csv.DictWriter(file, ["scene", "drawn", *methods, "auto", "chosen"])
        writer.writeheader()
        for name, drawn, path, options in auto_scenes.scenes(folder, ROOT, a.models):
            if not any(part in name for part in a.only.split(",")):
                continue
            default, _ = draw(a.ligne, path, options, DEFAULT)
            times = compare(a.ligne, path, options, max(LEAST_LIMIT_S, SLOWER * default / 1000))
            if default > MEASURABLE_MS / 2:
                try_again(a.ligne, path, options, times, default)
            best = min(t for t in [*times.values(), default] if t and t > 0)
            near = [m for m, t in times.items() if m == DEFAULT or (t and 0 < t < NEAR * best)]
            times[DEFAULT] = default
            auto, chosen = draw(a.ligne, path, options, "auto")
            for _ in range(MOST_ROUNDS):
                if best < MEASURABLE_MS / 2:
                    break
                for _ in range(a.repeat):  # in turns: what slows the machine slows all of them
                    for m in near:
                        times[m] = min(times[m], draw(a.ligne, path, options, m)[0])
                    auto = min(auto, draw(a.ligne, path, options, "auto")[0])
                if auto < BOUND * min(times[m] for m in near):
                    break
            row = {"scene": name, "drawn": drawn, **{m: text_of(times.get(m)) for m in methods}, "auto": text_of(auto),
                   "chosen": chosen}
            rows.append(row)
            writer.writerow(row)
            file.flush()
            print(", ".join(f"{k} {v}" for k, v in row.items()), flush=True)
    return rows


def milliseconds(text):
    """What a place of the table holds; None for "-", infinite for what was ended."""
    return None if text in ("", "-") else math.inf if text.startswith(">") else float(text)


def sum_up(rows):
    """Prints how near auto, and each method, comes to the best; returns whether auto is within the bound wherever that can be
    measured."""
    methods = [m for m in rows[0] if m not in ("scene", "drawn", "auto", "chosen")]
    factors = {m: [] for m in [*methods, "auto"]}
    best_count, ratios = dict.fromkeys(methods, 0), []
    for row in rows:
        times = {m: milliseconds(row[m]) for m in methods}
        best = min((m for m in methods if times[m] is not None), key=times.get)
        auto = float(row["auto"])
        if times[best] < MEASURABLE_MS and auto < MEASURABLE_MS:
            continue
        best_count[best] += 1
        for m in methods:
            if times[m] is not None:
                factors[m].append(times[m] / times[best])
        factors["auto"].append(auto / times[best])
        ratios.append((auto / times[best], f"{row['scene']} ({row['drawn']}): {best} {times[best]:.0f} ms, "
                       f"auto ({row['chosen']}) {auto:.0f} ms"))
    ratios.sort(reverse=True)
    print(f"{len(rows)} scenes, of which {len(ratios)} take {MEASURABLE_MS} ms or more")
    if not ratios:
        return True
    print("| method | for scenes | the best | within 1.3 times the best | median, by the best |\n|---|---|---|---|---|")
    for m in [*methods, "auto"]:
        within = sum(f <= BOUND for f in factors[m])
        middle = statistics.median(factors[m]) if factors[m] else math.inf
        print(f"| `{m}` | {len(factors[m])} | {best_count.get(m, '')} | {within} | " +
              (f"{middle:.2f} |" if middle < math.inf else "over 4 |"))
    print(f"auto against the best: worst {ratios[0][0]:.2f}")
    for r, words in ratios[:8]:
        print(f"  {r:.2f}  {words}")
    return ratios[0][0] <= BOUND


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ligne", nargs="?")
    parser.add_argument("-o", "--output")
    parser.add_argument("--models")
    parser.add_argument("--only", default="")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--measured")
    a = parser.parse_args()
    if a.measured:
        with open(a.measured, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
    elif a.ligne and a.output:
        rows = measure(a)
    else:
        parser.error("LIGNE and -o FILE.csv, or --measured FILE.csv")
    return 0 if sum_up(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
