#!/usr/bin/env python3
"""build_site.py FOLDER: the pages of the project as a static web page, made from the Markdown with Debian's python3-markdown.

README.md becomes FOLDER/index.html, every other page NAME.html at its place. Pictures and other files that pages lead to are
copied. Fails where a link leads nowhere.
"""
import re
import shutil
import sys
from pathlib import Path

import markdown

ROOT = Path(__file__).resolve().parent.parent
PAGES = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "bench/README.md", "tests/*/README.md", "docs/**/*.md"]
NAVIGATION = {"Ligne Claire": "README.md", "Gallery": "docs/gallery.md", "Options": "docs/options.md", "Python": "docs/python.md",
              "C++": "docs/library.md", "All pages": "docs/README.md", "Changes": "CHANGELOG.md"}
STYLE = """
body { font: 17px/1.55 system-ui, sans-serif; color: #222; max-width: 62rem; margin: 0 auto; padding: 0 1rem 4rem }
nav { border-bottom: 1px solid #ccc; padding: .8rem 0; margin-bottom: 1.5rem } nav a { margin-right: 1.2rem }
a { color: #05a } img { max-width: 100%; background: #fff } h1, h2, h3 { line-height: 1.2; margin-top: 2rem }
pre { background: #f4f4f2; padding: .8rem; overflow-x: auto } code { font-size: .9em } table { border-collapse: collapse }
td, th { border: 1px solid #ddd; padding: .3rem .6rem; text-align: left; vertical-align: top }
"""
TEMPLATE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title><link rel="stylesheet" href="{up}style.css"></head>
<body><nav>{navigation}</nav>
{body}
</body></html>
"""


def html_name(page):
    """docs/surfaces.md -> docs/surfaces.html; the README of a folder is its index."""
    return page.with_name("index.html") if page.name == "README.md" else page.with_suffix(".html")


def slug(text, separator):
    """Anchors as GitHub makes them."""
    return re.sub(r"[^\w \-]", "", text.lower()).strip().replace(" ", separator)


class Site:
    def __init__(self, folder):
        self.folder = folder
        self.pages = sorted({p.relative_to(ROOT) for pattern in PAGES for p in ROOT.glob(pattern)})
        self.faults = []

    def link(self, page, target):
        """The link of a page as the site has it; files that are no pages are copied."""
        if re.match(r"[a-z]+:|#", target):
            return target
        name, _, anchor = target.partition("#")
        file = (ROOT / page.parent / name).resolve()
        inside = file.relative_to(ROOT) if file.is_relative_to(ROOT) else None
        if inside is None or not file.exists():
            self.faults.append(f"{page}: there is no {target}")
            return target
        if (inside / "README.md") in self.pages:
            inside /= "README.md"
        if inside in self.pages:
            return "../" * len(page.parent.parts) + str(html_name(inside)) + (f"#{anchor}" if anchor else "")
        copy = self.folder / inside
        if file.is_dir():
            shutil.copytree(file, copy, dirs_exist_ok=True)
            names = "\n".join(sorted(p.name + "/" * p.is_dir() for p in file.iterdir()))
            (copy / "index.html").write_text(f"<!DOCTYPE html><title>{inside}</title><pre>{names}</pre>", encoding="utf-8")
        else:
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
        return target

    def write(self, page):
        text = (ROOT / page).read_text(encoding="utf-8")
        options = {"toc": {"slugify": slug}}
        body = markdown.markdown(text, extensions=["fenced_code", "sane_lists", "tables", "toc"], extension_configs=options)
        body = re.sub(r'(href|src)="([^"]+)"', lambda m: f'{m[1]}="{self.link(page, m[2])}"', body)
        up = "../" * len(page.parent.parts)
        navigation = "".join(f'<a href="{up}{html_name(Path(p))}">{name}</a>' for name, p in NAVIGATION.items())
        title = re.sub(r"[#`]", "", text.split("\n", 1)[0]).strip()
        file = self.folder / html_name(page)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(TEMPLATE.format(title=title, up=up, navigation=navigation, body=body), encoding="utf-8")

    def check_anchors(self):
        """Every link inside the site leads to a file, and its anchor to a heading."""
        for page in self.pages:
            file = self.folder / html_name(page)
            for target in re.findall(r'(?:href|src)="([^"]+)"', file.read_text(encoding="utf-8")):
                if re.match(r"[a-z]+:", target):
                    continue
                name, _, anchor = target.partition("#")
                goal = (file.parent / name) if name else file
                if not goal.exists() or (anchor and f'id="{anchor}"' not in goal.read_text(encoding="utf-8")):
                    self.faults.append(f"{page}: {target} leads nowhere")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip().split("\n", 1)[0])
    site = Site(Path(sys.argv[1]).resolve())
    site.folder.mkdir(parents=True, exist_ok=True)
    (site.folder / "style.css").write_text(STYLE.lstrip(), encoding="utf-8")
    for page in site.pages:
        site.write(page)
    site.check_anchors()
    print("\n".join(site.faults) or f"{len(site.pages)} pages in {site.folder}", file=sys.stderr if site.faults else sys.stdout)
    return 1 if site.faults else 0


if __name__ == "__main__":
    sys.exit(main())
