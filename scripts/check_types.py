#!/usr/bin/env python3
"""Names the types that two files define in one namespace. The linker takes either definition without a word where both are in one
program, since each source sees only one of them (the one-definition rule). check_odr.sh compares what the optimizer sees of each
type, and takes long; this check takes a second and goes by the names alone."""
import collections
import re
import subprocess
import sys

FOLDERS = "src", "plotting", "studies", "python"
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
SCOPE = re.compile(r"namespace\s*([\w:]*)\s*\{|\b(?:class|struct|union|enum(?:\s+class)?)\s+([A-Z]\w*)\s*(?:final\s*)?(?::(?!:)[^;{()]*)?\{|\{|\}")


def types_of(text):
    """The full names of the types defined at the scope of a named namespace."""
    scopes = []
    for match in SCOPE.finditer(COMMENT_OR_TEXT.sub("", text)):
        if match[0] == "}":
            if scopes:
                scopes.pop()
        elif match[0].startswith("namespace"):
            scopes.append(match[1])
        elif match[0] == "{":
            scopes.append("")
        else:
            if all(scopes):
                yield "::".join([*scopes, match[2]])
            scopes.append("")


def main():
    names = subprocess.run(["git", "ls-files", *FOLDERS], capture_output=True, text=True, check=True).stdout.split()
    files = collections.defaultdict(set)
    for name in names:
        if name.endswith((".cpp", ".hpp")):
            with open(name, encoding="utf-8") as file:
                for type_name in types_of(file.read()):
                    files[type_name].add(name)
    twice = {type_name: sorted(where) for type_name, where in files.items() if len(where) > 1}
    for type_name, where in sorted(twice.items()):
        print(f"{type_name} is defined in {' and in '.join(where)}", file=sys.stderr)
    return bool(twice)


if __name__ == "__main__":
    sys.exit(main())
