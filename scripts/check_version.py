#!/usr/bin/env python3
"""check_version.py: the version of CMakeLists.txt is the one that CHANGELOG.md dates first and that CITATION.cff and the pages name.

A fault is one line; the exit status is 1 then. All else (packages, the Python module, --version) takes it from CMakeLists.txt.
"""
import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)


def first(file, pattern):
    found = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
    return found.groups() if found else (None, None)


def main():
    version = first("CMakeLists.txt", r"^project\(ligne VERSION ([0-9.]+) ")[0]
    short = ".".join(version.split(".")[:2])
    changelog, date = first("CHANGELOG.md", r"^## \[([^]]+)\] - (\d{4}-\d\d-\d\d)$")
    found = {
        "CHANGELOG.md, first dated version": (changelog, version),
        "CITATION.cff, version": (first("CITATION.cff", r"^version: (\S+)")[0], version),
        "CITATION.cff, date-released": (first("CITATION.cff", r"^date-released: (\S+)")[0], date),
        "README.md, name of the shared library's package": (first("README.md", r"`libligne([0-9.]+)`")[0], short),
        "docs/library.md, find_package": (first("docs/library.md", r"^find_package\(ligne ([0-9.]+) ")[0], short),
        "docs/library.md, soname": (first("docs/library.md", r"`libligne\.so\.([0-9.]+)`")[0], short),
        "docs/library.md, tag": (first("docs/library.md", r"GIT_TAG v([0-9.]+)`")[0], version),
    }
    faults = [f"{place}: {seen}, not {wanted}" for place, (seen, wanted) in found.items() if seen != wanted]
    print("\n".join(faults), end="\n" if faults else "", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
