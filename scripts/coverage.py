#!/usr/bin/env python3
"""Compares the lines of src/, plotting/ and studies/ that the first tier of the tests runs with those that --all runs.

    scripts/coverage.py               builds with gcov, runs both tiers, prints a table
    scripts/coverage.py --part X      the tests of ctest alone whose names match X
    scripts/coverage.py --bound       runs the first tier alone: --all can run no more lines than there are, so the share of all
                                      lines is a lower bound of the share of those that --all runs
    scripts/coverage.py --lines FILE  writes to FILE the lines that --all runs and the first tier does not; with --bound, all
                                      lines that the first tier does not run

The build is in build/coverage. Only the programs of tests are run, not those of the Python module, the packages and the
documents. Fails where the first tier runs less than 95 % of the lines that --all runs.
"""

import argparse
import collections
import gzip
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "coverage"
LEAST_SHARE = 0.95


def build(jobs):
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1", "-DLIGNE_COVERAGE=ON", "-DLIGNE_UNITY=ON"]
    options += ["-DLIGNE_TESTS=ON", "-DLIGNE_PYTHON=OFF", "-DLIGNE_INSTALL=OFF"]
    subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", *options], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD, "--parallel", str(jobs)], check=True, stdout=subprocess.DEVNULL)


def objects():
    """The notes of the compiler for the objects of src/, plotting/ and studies/."""
    return [p for folder in ("src", "plotting", "studies") for p in (BUILD / folder).rglob("*.gcno")]


def run(tier, jobs, part):
    """Runs the tier; the sets of lines that there are, and of those that ran."""
    for counts in BUILD.rglob("*.gcda"):
        counts.unlink()
    command = ["ctest", "--test-dir", str(BUILD), "--parallel", str(jobs), "--output-on-failure", "-L", "gtest"]
    environment = dict(os.environ, LIGNE_TEST_TIER=tier)
    result = subprocess.run(command + (["-R", part] if part else []), env=environment, stdout=sys.stderr)
    if result.returncode != 0:
        print(f"coverage.py: tests fail in tier {tier}; their lines are counted all the same", file=sys.stderr)
    known, ran = set(), set()
    with tempfile.TemporaryDirectory() as folder:
        for notes in objects():
            if not notes.with_suffix(".gcda").exists():
                continue
            subprocess.run(["gcov", "--json-format", str(notes)], cwd=folder, check=True, stdout=subprocess.DEVNULL)
            for result in pathlib.Path(folder).glob("*.gcov.json.gz"):
                with gzip.open(result) as text:
                    add_lines(json.load(text), known, ran)
                result.unlink()
    return known, ran


def add_lines(result, known, ran):
    for file in result["files"]:
        path = pathlib.Path(os.path.normpath(os.path.join(result["current_working_directory"], file["file"])))
        path = path.resolve()
        if not any(path.is_relative_to(ROOT / folder) for folder in ("src", "plotting", "studies")):
            continue
        name = str(path.relative_to(ROOT))
        for line in file["lines"]:
            known.add((name, line["line_number"]))
            if line["count"] > 0:
                ran.add((name, line["line_number"]))


def folder_of(line):
    parts = pathlib.Path(line[0]).parts
    return "/".join(parts[:2]) if parts[0] == "src" else parts[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--part", help="tests of ctest whose names match")
    parser.add_argument("--bound", action="store_true", help="run the first tier alone")
    parser.add_argument("--lines", type=pathlib.Path, help="file for the lines that the first tier does not run")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    build(options.jobs)
    known, first = run("first", options.jobs, options.part)
    everything = known
    if not options.bound:
        known_by_all, everything = run("all", options.jobs, options.part)
        known |= known_by_all
    count = lambda lines: collections.Counter(map(folder_of, lines))
    lines, by_first, by_all, by_both = count(known), count(first), count(everything), count(first & everything)
    of_all = "--all at most" if options.bound else "--all"
    print(f"| folder | lines | first tier | {of_all} | first tier, of those of --all |\n|---|---|---|---|---|")
    for folder in sorted(lines):
        share = by_both[folder] / max(1, by_all[folder])
        print(f"| {folder} | {lines[folder]} | {by_first[folder]} | {by_all[folder]} | {100 * share:.1f} % |")
    if options.lines:
        options.lines.write_text("".join(f"{name}:{line}\n" for name, line in sorted(everything - first)))
    share = len(first & everything) / max(1, len(everything))
    print(f"| together | {len(known)} | {len(first)} | {len(everything)} | {100 * share:.1f} % |")
    return 0 if share >= LEAST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
