#!/usr/bin/env python3
"""Names the comments of sources and tests that begin with a word that hides their subject. CONTRIBUTING.md says how comments begin."""
import re
import subprocess
import sys

FOLDERS = "src", "plotting", "studies", "python", "bench", "scripts", "tests"
COMMENT = re.compile(r"(?://+<?|^\s*#)\s*(What|Of|That of|The same|Whether what)\b")


def main():
    names = subprocess.run(["git", "ls-files", *FOLDERS], capture_output=True, text=True, check=True).stdout.split()
    failed = False
    for name in names:
        if not name.endswith((".cpp", ".hpp", ".py", ".sh")):
            continue
        with open(name, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                if COMMENT.search(line):
                    print(f"{name}:{number}: begins without its subject: {line.strip()}", file=sys.stderr)
                    failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
