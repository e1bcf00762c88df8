#!/usr/bin/env python3
"""Writes every scene of the corpus beside this file; with --check says whether the files are what it would write.

Scenes are made in maker/, one module by theme, and checked before they are written (maker/check.py). families.txt says which
module a scene is from.
"""

import pathlib
import sys

from maker import check, faces, large, overlaps, solids, thesis, thesis_contours, touching

FOLDER = pathlib.Path(__file__).parent


MODULES = (solids, faces, touching, overlaps, large, thesis, thesis_contours)


def main():
    families = {module.__name__.split(".")[-1]: module.scenes() for module in MODULES}
    scenes = [scene for family in families.values() for scene in family]
    names = [s.name for s in scenes]
    faults = [f"{n}: name twice" for n in sorted(set(names)) if names.count(n) > 1]
    faults += [fault for scene in scenes for fault in check.scene_faults(scene)]
    known = {s.name + ".json" for s in scenes}
    faults += [f"{p.name}: nothing makes this file" for p in sorted(FOLDER.glob("*.json")) if p.name not in known]
    texts = {scene.name + ".json": scene.text() for scene in scenes}
    texts["families.txt"] = "".join(sorted(f"{s.name} {family}\n" for family, of in families.items() for s in of))
    for name, text in texts.items():
        path = FOLDER / name
        if "--check" not in sys.argv[1:]:
            path.write_text(text, encoding="utf-8")
        elif not path.is_file() or path.read_text(encoding="utf-8") != text:
            faults.append(f"{name}: is not what make_corpus.py writes")
    for fault in faults:
        print(fault)
    print(f"{len(scenes)} scenes, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
