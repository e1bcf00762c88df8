#!/usr/bin/env python3
"""cost.py LIGNE [--methods appel,...] [--families NAME,...] [--check FILE] [--limit SECONDS]

Draws families of growing scenes (cost_inputs.py) with the methods and prints a Markdown table: processor time and peak memory
at the largest size, and the exponents e of time ~ n^e and of the drawing's bytes, fitted over three sizes. With --check FILE
it compares the exponents with those in the table in FILE and exits with 1 where one has grown by more than 0.25: by hand,
since the machine must be quiet. In the NAMEs of families ";" stands for ",".
Runs that take more than SECONDS (60) of processor time end and count as that."""

import argparse
import math
import os
import re
import resource
import subprocess
import sys
import tempfile
import time

import cost_inputs

START_SECONDS = 0.01  # the start of the program and one triangle: 9 to 10 ms; beside it growth is not seen


def run(ligne, path, out, options, limit):
    """Processor seconds, peak MB, bytes written; None where it did not end well."""
    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    process = subprocess.Popen([ligne, "draw", "-q", path, "-o", out, *options], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, preexec_fn=bound)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = status
    if status != 0:
        return None
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, os.path.getsize(out)


def exponent(sizes, values):
    """Slope of the line of least squares through the logarithms."""
    x, y = [math.log(s) for s in sizes], [math.log(v) for v in values]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def measure(ligne, family, method, folder, limit):
    _, sizes, options = cost_inputs.FAMILIES[family]
    results = []
    for n in sizes:
        path = os.path.join(folder, f"{re.sub('[^a-z]+', '_', family)}_{n}.obj")
        if not os.path.exists(path):
            cost_inputs.write(family, n, path)
        best = None
        for _ in range(2):
            result = run(ligne, path, os.path.join(folder, "out.svg"), [*options, "--method", method], limit)
            if result is None:
                break
            best = result if best is None or result[0] < best[0] else best
            if best[0] > 2:
                break
        if best is None:
            return {"failed": n}
        results.append(best)
    times = [max(r[0] - START_SECONDS, 0.005) for r in results]
    return {"n": sizes[-1], "seconds": results[-1][0], "mb": results[-1][1], "time": exponent(sizes, times),
            "bytes": exponent(sizes, [r[2] for r in results])}


def row(family, method, r):
    if "failed" in r:
        return f"| {family} | {method} | {r['failed']} | over the limit | | | |"
    return (f"| {family} | {method} | {r['n']} | {r['seconds']:.2f} | {r['mb']:.0f} | {r['time']:.2f} | {r['bytes']:.2f} |")


def exponents_in(path):
    found = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            cells = [c.strip() for c in line.strip().strip("|").split("|")]
            if len(cells) == 7 and re.fullmatch(r"-?\d+\.\d+", cells[5]):
                found[cells[0], cells[1]] = float(cells[5])
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ligne")
    parser.add_argument("--methods", default="appel,warnock,watkins,atherton-weiler")
    parser.add_argument("--families", default=",".join(f.replace(",", ";") for f in cost_inputs.FAMILIES))
    parser.add_argument("--check")
    parser.add_argument("--limit", type=int, default=60)
    a = parser.parse_args()
    known = exponents_in(a.check) if a.check else {}
    grown = []
    print("| family | method | n | processor s | peak MB | exponent of time | of the drawing |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for family in (f.replace(";", ",") for f in a.families.split(",")):
            for method in a.methods.split(","):
                r = measure(a.ligne, family, method, folder, a.limit)
                print(row(family, method, r), flush=True)
                before = known.get((family, method))
                if before is not None and ("failed" in r or r["time"] > before + 0.25):
                    grown.append(f"{family}, {method}: {before:.2f} became {r.get('time', 'over the limit')}")
    for line in grown:
        print(line, file=sys.stderr)
    return 1 if grown else 0


if __name__ == "__main__":
    started = time.time()
    code = main()
    print(f"{time.time() - started:.0f} s", file=sys.stderr)
    sys.exit(code)
