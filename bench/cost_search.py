#!/usr/bin/env python3
"""cost_search.py LIGNE [--minutes M] [--seed S] [--parts N] [--keep FOLDER]

Looks for small scenes that cost much: scenes of N parts (300) are made by a rule (a part, and how its copies are turned, moved,
stretched and put onto a grid of places), and the rules that took the most processor time for each byte of input are changed
further. Prints the ten worst, of different kinds, as a Markdown table; --keep writes them as OBJ files. Which rules are
tried depends on the seed and on measured times; a find is its rule, and `--rule` makes the same bytes of it again."""

import argparse
import ast
import math
import os
import random
import sys
import tempfile
import time

import cost
import cost_inputs

PARTS = {
    "triangle": ([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], [(0, 1, 2)]),
    "square": ([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2, 3)]),
    "box": (cost_inputs.box((-1, -1, -1), (2, 2, 2)), cost_inputs.CUBE),
    "cross": ([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1)],
              [(0, 1, 2, 3), (4, 5, 6, 7)]),
    "cup": (cost_inputs.box((-1, -1, -1), (2, 2, 2)), cost_inputs.CUBE[1:]),
}
OPTIONS = [[], ["--hidden", "dashed"], ["--edges", "all"], ["--quality", "exact"]]

# A rule: part, options, seed, sizes x y z (logarithms), spread x y z (logarithms), turn, places per unit (0: any place).
RANGES = {"size": (-3.0, 0.3), "spread": (-8.0, 1.0), "turn": (0.0, 3.2)}


def any_rule(rng):
    low, high = RANGES["size"]
    near, far = RANGES["spread"]
    return (rng.choice(sorted(PARTS)), rng.randrange(len(OPTIONS)), rng.randrange(1000),
            *(rng.uniform(low, high) for _ in range(3)), *(rng.uniform(near, far) for _ in range(3)),
            rng.choice((0.0, rng.uniform(*RANGES["turn"]))), rng.choice((0, 0, 1, 2, 5)))


def changed(rule, rng):
    """One or two numbers of the rule anew, or a little different."""
    rule, other = list(rule), any_rule(rng)
    for _ in range(rng.randint(1, 2)):
        k = rng.randrange(len(rule))
        rule[k] = rule[k] + rng.gauss(0, 0.3) if isinstance(rule[k], float) and rng.random() < 0.5 else other[k]
    return tuple(rule)


def write(rule, n, path):
    part, _, seed, *numbers = rule
    size, spread, turn, places = numbers[0:3], numbers[3:6], numbers[6], numbers[7]
    rng, obj = random.Random(seed), cost_inputs.Obj()
    vertices, faces = PARTS[part]
    for _ in range(n):
        axis, angle = cost_inputs.random_direction(rng), rng.uniform(-turn, turn)
        move = [rng.uniform(-1, 1) * math.exp(s) for s in spread]
        if places:
            move = [round(m * places) / places for m in move]
        obj.add([[a + b for a, b in zip(cost_inputs.rotated([math.exp(s) * c for s, c in zip(size, v)], axis, angle), move)]
                 for v in vertices], faces)
    obj.write(path)


def measure(ligne, rule, n, folder, limit):
    """Processor microseconds for each byte of input; None where the scene was refused."""
    path = os.path.join(folder, "scene.obj")
    write(rule, n, path)
    result = cost.run(ligne, path, os.path.join(folder, "out.svg"), OPTIONS[rule[1]], limit)
    seconds = limit if result is None else result[0] - cost.START_SECONDS
    return 1e6 * seconds / os.path.getsize(path)


def kind(rule):
    return rule[0], rule[1], rule[-1] > 0, rule[-2] > 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ligne")
    parser.add_argument("--minutes", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--parts", type=int, default=300)
    parser.add_argument("--limit", type=int, default=20)
    parser.add_argument("--keep")
    parser.add_argument("--rule", type=ast.literal_eval, help="measure this rule, at N and 3 N parts")
    a = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if a.rule:
            print(*(f"{measure(a.ligne, a.rule, n, folder, a.limit):.1f}" for n in (a.parts, 3 * a.parts)))
            return 0
        rng, best, tried, end = random.Random(a.seed), {}, 0, time.time() + 60 * a.minutes
        while time.time() < end:
            worst = sorted(best.values(), reverse=True)[:10]
            rule = changed(rng.choice(worst)[1], rng) if worst and rng.random() < 0.8 else any_rule(rng)
            found = (measure(a.ligne, rule, a.parts, folder, a.limit), rule)
            tried += 1
            best[kind(rule)] = max(found, best.get(kind(rule), found))
        print(f"{tried} scenes of {a.parts} parts\n")
        print("| microseconds a byte | with three times the parts | rule |\n|---|---|---|")
        for i, (value, rule) in enumerate(sorted(best.values(), reverse=True)[:10]):
            print(f"| {value:.1f} | {measure(a.ligne, rule, 3 * a.parts, folder, a.limit):.1f} | `{rule}` |", flush=True)
            if a.keep:
                write(rule, a.parts, os.path.join(a.keep, f"find_{i}.obj"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
