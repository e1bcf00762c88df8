#!/usr/bin/env python3
"""Names what of src/, plotting/ and studies/ a newcomer could not find their way in: folders of more files than are taken in at a glance,
files of more lines than one subject needs, and headers that include each other in a circle. A header X.hpp and its second half X.inl.hpp may."""
import collections
import os
import re
import subprocess
import sys

MOST_FILES = 30  # in a folder
MOST_LINES = 400  # in a file


def crowded_folders():
    """(folder, number of files) of those that hold too many."""
    names = subprocess.run(["git", "ls-files", "src", "plotting", "studies"], capture_output=True, text=True, check=True)
    counts = collections.Counter(os.path.dirname(name) for name in names.stdout.split())
    return sorted((folder, count) for folder, count in counts.items() if count > MOST_FILES)


def long_files():
    """(file, number of lines) of the sources that have too many."""
    names = subprocess.run(["git", "ls-files", "*.cpp", "*.hpp"], capture_output=True, text=True, check=True)
    found = []
    for name in names.stdout.split():
        if os.path.exists(name):
            with open(name, encoding="utf-8") as file:
                count = sum(1 for _ in file)
            if count > MOST_LINES:
                found.append((name, count))
    return found


def includes_of_headers():
    """By header, as an include names it: the headers that it includes."""
    names = subprocess.run(["git", "ls-files", "src/*.hpp", "plotting/*.hpp", "studies/*.hpp"], capture_output=True, text=True, check=True)
    found = {}
    for name in names.stdout.split():
        if os.path.exists(name):
            with open(name, encoding="utf-8") as file:
                text = file.read()
            own = name.removeprefix("src/")
            half = own.replace(".inl.hpp", ".hpp")
            found[own] = [i for i in re.findall(r'^#include "([^"]+)"', text, re.M) if own == half or i != half]
    return found


def circle_from(start, includes, done):
    """A list of headers, each of which includes the next and the last of which the first; none if no circle is reached."""
    path, stack = [], [(start, iter(includes[start]))]
    path.append(start)
    while stack:
        header, rest = stack[-1]
        for included in rest:
            if included in path:
                return path[path.index(included):] + [included]
            if included in includes and included not in done:
                path.append(included)
                stack.append((included, iter(includes[included])))
                break
        else:
            done.add(header)
            path.pop()
            stack.pop()
    return []


def main():
    failed = False
    for folder, count in crowded_folders():
        print(f"{folder}: {count} files, more than {MOST_FILES}", file=sys.stderr)
        failed = True
    for name, count in long_files():
        print(f"{name}: {count} lines, more than {MOST_LINES}", file=sys.stderr)
        failed = True
    includes = includes_of_headers()
    done = set()
    for header in includes:
        circle = circle_from(header, includes, done) if header not in done else []
        if circle:
            print("headers include each other: " + " -> ".join(circle), file=sys.stderr)
            failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
