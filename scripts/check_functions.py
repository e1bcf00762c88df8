#!/usr/bin/env python3
"""Names the functions of src/ and plotting/ that are longer than a screen. Reads the layout that clang-format gives."""
import subprocess
import sys

MOST_LINES = 60
MARGINS = 0, 2  # of functions, and of those written in a class


def long_functions(lines):
    """(first line, number of lines, text) of each. All between its first line and its closing brace stands further in."""
    begin = {}
    for number, line in enumerate(lines, 1):
        text = line.strip()
        margin = len(line) - len(line.lstrip())
        if not text or margin not in MARGINS:
            continue
        if text != "}":
            begin[margin] = (number, text)
        elif margin in begin:
            first, name = begin.pop(margin)
            if number - first >= MOST_LINES:
                yield first, number - first + 1, name


def main():
    names = subprocess.run(["git", "ls-files", "src/*.[ch]pp", "plotting/*.[ch]pp"], capture_output=True, text=True, check=True)
    failed = False
    for name in names.stdout.split():
        with open(name, encoding="utf-8") as file:
            for first, count, text in long_functions(file.readlines()):
                print(f"{name}:{first}: {count} lines, more than {MOST_LINES}: {text}", file=sys.stderr)
                failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
