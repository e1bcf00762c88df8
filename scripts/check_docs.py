#!/usr/bin/env python3
"""check_docs.py [FOLDER]: checks the Markdown pages of the project (FOLDER, default: the one this script belongs to).

In every page: relative links and anchors lead somewhere.
In the pages for readers, that is those in docs/ and in the top folder, also:
- a path in backticks (`src/...`, `docs/...` and the like) exists;
- a line of prose has at most 100 columns; tables, code and lines that can not be broken are free;
- "the thesis" stands in one sentence with the key of a source;
- every key, such as [Appel1967], is defined in docs/bibliography.md.
In docs/architecture.md the lines of C++ of each folder in the table of folders are right to a tenth.

A fault is one line, FILE:LINE: what is wrong; the exit status is 1 then. Nothing but Python 3 is needed.
"""
import re
import sys
from pathlib import Path

MAX_COLUMNS = 100
PATH = re.compile(r"^(?:src|studies|tests|docs|plotting|scripts|bench|examples|cmake|python)/[\w./-]*$")
PLACEHOLDER = re.compile(r"NAME|FORMAT|FOLDER")
KEY = re.compile(r"\[([A-Z][A-Za-z]*(?:\d{4}[a-z]?|-nd))\](?!\()")
DEFINITION = re.compile(r"\*\*\[([^\]]+)\]\*\*")
THESIS = re.compile(r"\bthe\s+(?:French\s+)?thesis\b|\bthesis's", re.IGNORECASE)
LINK = re.compile(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"")
SENTENCE = re.compile(r"(?<=[.!?])[*)\"]*\s+(?=[A-Z\"*\[`(])|\s\|\s")
FOLDER = re.compile(r"^\| `([\w/]+/)` \| ([\d,]+) \|")
BLOCK = re.compile(r"^\s*(?:[-*]|\d+\.)\s|^\s*\||^#")


def without_code(line):
    """The line with the contents of its code spans blanked out, so that columns stay."""
    return re.sub(r"`[^`]*`", lambda m: "`" + " " * (len(m[0]) - 2) + "`", line)


def prose_lines(text):
    """(number, line) of every line outside of fenced code."""
    fenced = False
    for number, line in enumerate(text.split("\n"), 1):
        if re.match(r"^\s*(?:```|~~~)", line):
            fenced = not fenced
        elif not fenced:
            yield number, line


def blocks(text):
    """Paragraphs, list items and table rows, each as its (number, line) pairs."""
    block = []
    for number, line in prose_lines(text):
        if block and (not line.strip() or BLOCK.match(line) or number != block[-1][0] + 1):
            yield block
            block = []
        if line.strip():
            block.append((number, line))
    if block:
        yield block


def anchors(text):
    """The anchors of a page as GitHub makes them; a repeated heading gets -1, -2 and so on."""
    found, count = set(), {}
    for _, line in prose_lines(text):
        heading = re.match(r"^#+\s+(.*?)\s*$", line)
        if heading:
            words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).lower()
            slug = re.sub(r"[^\w \-]", "", words).replace(" ", "-")
            found.add(f"{slug}-{count[slug]}" if slug in count else slug)
            count[slug] = count.get(slug, 0) + 1
    return found


class Checker:
    def __init__(self, root):
        self.root = root
        self.faults = []
        self.anchors = {}
        bibliography = root / "docs/bibliography.md"
        text = bibliography.read_text(encoding="utf-8") if bibliography.is_file() else ""
        self.keys = set(DEFINITION.findall(text))

    def fault(self, page, number, what):
        self.faults.append(f"{page.relative_to(self.root)}:{number}: {what}")

    def check_links(self, page, text):
        for number, line in prose_lines(text):
            for match in LINK.finditer(without_code(line)):
                target = match[1] or match[2]
                if re.match(r"^[a-z]+:", target):
                    continue
                name, _, anchor = target.partition("#")
                path = (page.parent / name).resolve() if name else page
                if not path.exists():
                    self.fault(page, number, f"there is no {target}")
                elif anchor and anchor not in self.anchors_of(path):
                    self.fault(page, number, f"{name or page.name} has no heading for #{anchor}")

    def anchors_of(self, path):
        if path not in self.anchors:
            self.anchors[path] = anchors(path.read_text(encoding="utf-8"))
        return self.anchors[path]

    def check_paths(self, page, number, line):
        for span in re.findall(r"`([^`]+)`", line):
            for word in span.split():
                if PATH.match(word) and not PLACEHOLDER.search(word) and not (self.root / word).exists():
                    self.fault(page, number, f"there is no {word}")

    def check_width(self, page, number, line):
        if len(line) <= MAX_COLUMNS or line.lstrip().startswith(("|", "<img", "![")):
            return
        if " " in re.sub(r"^\s*(?:[-*>]|\d+\.)?\s*", "", line).strip():
            self.fault(page, number, f"{len(line)} columns, more than {MAX_COLUMNS}")

    def check_sources(self, page, block):
        text = "\n".join(without_code(line) for _, line in block)
        for match in KEY.finditer(text):
            if match[1] not in self.keys:
                number = block[0][0] + text.count("\n", 0, match.start())
                self.fault(page, number, f"[{match[1]}] is not in docs/bibliography.md")
        start = 0
        for end in [m.start() for m in SENTENCE.finditer(text)] + [len(text)]:
            thesis = THESIS.search(text, start, end)
            if thesis and not KEY.search(text, start, end):
                number = block[0][0] + text.count("\n", 0, thesis.start())
                self.fault(page, number, "\"the thesis\" without the key of a source in its sentence")
            start = end

    def check_folders(self, page, text):
        rows = [(number, FOLDER.match(line)) for number, line in prose_lines(text)]
        told = {row[1]: (number, int(row[2].replace(",", ""))) for number, row in rows if row}
        if not told:
            self.fault(page, 1, "no table tells the lines of folders")
        for folder, (number, lines) in told.items():
            others = [self.root / name for name in told if name != folder and name.startswith(folder)]
            files = [f for f in (self.root / folder).rglob("*.[ch]pp") if not any(o in f.parents for o in others)]
            counted = sum(len(f.read_text(encoding="utf-8").splitlines()) for f in files)
            if abs(counted - lines) > max(counted / 10, 100):
                self.fault(page, number, f"{folder} has {counted} lines, not {lines}")

    def check(self, page):
        text = page.read_text(encoding="utf-8")
        self.check_links(page, text)
        if page.parent != self.root and self.root / "docs" not in page.parents:
            return
        if page == self.root / "docs/architecture.md":
            self.check_folders(page, text)
        for number, line in prose_lines(text):
            self.check_paths(page, number, line)
            self.check_width(page, number, line)
        for block in blocks(text):
            self.check_sources(page, block)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    checker = Checker(root)
    for page in sorted(root.rglob("*.md")):
        folders = page.relative_to(root).parts[:-1]
        if not any(f.startswith("build") or f in (".git", ".ligne") for f in folders):
            checker.check(page)
    print("\n".join(checker.faults), end="\n" if checker.faults else "", file=sys.stderr)
    return 1 if checker.faults else 0


if __name__ == "__main__":
    sys.exit(main())
