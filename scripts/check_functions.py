#!/usr/bin/env python3
"""Names the functions of src/, plotting/ and studies/ that are longer than a screen, and those with too many parameters. Reads the layout that
clang-format gives."""
import re
import subprocess
import sys

MOST_LINES = 60
MOST_PARAMETERS = 6  # of a function with a result; constructors keep what they are given
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


def end_of_list(text, at):
    """The place behind the bracket that closes the list whose first element is at `at`."""
    depth = 1
    while depth and at < len(text):
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(text[at], 0)
        at += 1
    return at


def count_elements(text):
    """Number of elements of a list that commas separate."""
    depth = 0
    count = 1 if text.strip() else 0
    for character in text:
        depth += {"<": 1, "(": 1, "[": 1, "{": 1, ">": -1, ")": -1, "]": -1, "}": -1}.get(character, 0)
        count += character == "," and depth == 0
    return count


def crowded_functions(text):
    """(line, number of parameters, name) of each."""
    text = re.sub(r"//[^\n]*", "", text)
    for found in re.finditer(r"^(?:  )?[A-Za-z_][\w:<>,&*\s\[\]]*?[\s&*]((?:\w+::)*\w+)\(", text, re.M):
        end = end_of_list(text, found.end())
        parameters = text[found.end():end - 1]
        is_function = re.match(r"\s*(const|noexcept|override|final|;|\{)", text[end:]) and re.search(r"[\w>&*] +\w", parameters)
        if is_function and count_elements(parameters) > MOST_PARAMETERS:
            yield text.count("\n", 0, found.start()) + 1, count_elements(parameters), found[1]


def main():
    names = subprocess.run(["git", "ls-files", "src/*.[ch]pp", "plotting/*.[ch]pp", "studies/*.[ch]pp"], capture_output=True, text=True, check=True)
    failed = False
    for name in names.stdout.split():
        with open(name, encoding="utf-8") as file:
            lines = file.readlines()
        for first, count, text in long_functions(lines):
            print(f"{name}:{first}: {count} lines, more than {MOST_LINES}: {text}", file=sys.stderr)
            failed = True
        for first, count, text in crowded_functions("".join(lines)):
            print(f"{name}:{first}: {count} parameters, more than {MOST_PARAMETERS}: {text}", file=sys.stderr)
            failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
