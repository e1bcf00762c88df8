#!/usr/bin/env python3
"""method_parts.py LIGNE [--write]: the tables "The seven parts" of docs/methods against `ligne methods --json`.

Without --write a table that differs is one line, FILE: what differs; the exit status is 1 then. With --write the tables are
made anew. Nothing but Python 3 is needed.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

METHODS = Path(__file__).resolve().parent.parent / "docs" / "methods"
TABLE = re.compile(r"(?<=^## The seven parts\n\n)\|(?:.*\n)(?:\|.*\n)+", re.MULTILINE)


def table_of(parts):
    """The Markdown table of the parts of one method."""
    rows = [f"| {part['symbol']}, {part['meaning']} | {part['text']} |\n" for part in parts]
    return "| part | here |\n|---|---|\n" + "".join(rows)


def main():
    """Compares or writes the tables of all methods."""
    output = subprocess.run([sys.argv[1], "methods", "--json"], check=True, capture_output=True).stdout
    write = "--write" in sys.argv[2:]
    wrong = 0
    for method in json.loads(output)["methods"]:
        file = METHODS / f"{method['name']}.md"
        text = file.read_text(encoding="utf-8")
        found = TABLE.search(text)
        table = table_of(method["parts"])
        if found and found[0] == table:
            continue
        if found and write:
            file.write_text(text[: found.start()] + table + text[found.end() :], encoding="utf-8")
            continue
        print(f"{file.name}: " + ("the table differs from that of the program" if found else "there is no such table"))
        wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main())
