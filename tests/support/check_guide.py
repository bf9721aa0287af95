#!/usr/bin/env python3
"""Decks of docs/guide: each yaml block passes `brunt check`, and together with the README they show every key of a deck.

  check_guide.py PROGRAM SOURCE

The first block of a page is a complete deck. A further one stands beside it, as an including deck does, unless it
includes another or has a geometry and is complete itself.
"""
import pathlib, re, subprocess, sys, tempfile

import yaml

# What the pages read beside decks: two columns, and a tetrahedron of 10 mm.
CURVE = "0, 0\n10, 1\n"
CORNERS = [(0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10)]


def tetrahedron():
    text = "solid tool\n"
    for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)):
        corners = "".join(" vertex %g %g %g\n" % CORNERS[corner] for corner in face)
        text += " facet normal 0 0 0\n outer loop\n" + corners + " endloop\n endfacet\n"
    return text + "endsolid tool\n"


def bracket():
    """Two hexahedra of 10 mm in Gmsh's format: the group "plate", and below it the faces "bed", upwards."""
    nodes = [(10 * i, 10 * j, 10 * k) for k in (0, 1) for j in (0, 1) for i in (0, 1, 2)]
    cells = [(5, 2, "%d %d %d %d %d %d %d %d" % tuple(n + i for n in (1, 2, 5, 4, 7, 8, 11, 10))) for i in (0, 1)]
    cells += [(3, 1, "%d %d %d %d" % tuple(n + i for n in (1, 4, 5, 2))) for i in (0, 1)]
    text = '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 "bed"\n3 2 "plate"\n$EndPhysicalNames\n'
    text += "$Nodes\n12\n" + "".join("%d %g %g %g\n" % (i, *x) for i, x in enumerate(nodes, 1)) + "$EndNodes\n"
    lines = ("%d %d 2 %d 1 %s\n" % (i, kind, group, corners) for i, (kind, group, corners) in enumerate(cells, 1))
    return text + "$Elements\n4\n" + "".join(lines) + "$EndElements\n"


def blocks(page):
    return re.findall(r"^```yaml\n(.*?)^```", page.read_text(), re.M | re.S)


def known_keys(program):
    """Paths of keys, NAME standing for names of the user's; those that a map holds by name end in it."""
    manual = subprocess.run([program, "schema", "--markdown"], capture_output=True, text=True, check=True).stdout
    heads = re.findall(r"^## (\S+)$", manual, re.M)
    return heads + re.findall(r"^\| `([^`]+)` \|", manual, re.M)


def paths(value, at=""):
    """Every path of a deck, and every word as a path, since words may stand for maps."""
    if isinstance(value, dict):
        for key, below in value.items():
            yield f"{at}.{key}".lstrip(".")
            yield from paths(below, f"{at}.{key}")
    elif isinstance(value, list):
        for below in value:
            yield from paths(below, at)
    elif value is not None:
        yield f"{at}.{value}".lstrip(".")


def as_pattern(key):
    return re.compile("^" + re.escape(key).replace("NAME", r"[^.]+") + "$")


def main():
    program, source = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    wrong, shown = [], set()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "curve.csv").write_text(CURVE)
        (folder / "tool.stl").write_text(tetrahedron())
        (folder / "bracket.msh").write_text(bracket())
        for page in sorted((source / "docs/guide").glob("*.md")) + [source / "README.md"]:
            all_blocks = blocks(page)
            if not all_blocks:
                continue
            (folder / "base.yaml").write_text(all_blocks[0])
            for number, block in enumerate(all_blocks, 1):
                shown.update(paths(yaml.load(block, yaml.BaseLoader)))
                deck = folder / f"{page.stem}-{number}.yaml"
                alone = re.search(r"^(geometry|include):", block, re.M)
                deck.write_text(block if alone else "include: [base.yaml]\n" + block)
                result = subprocess.run([program, "check", deck], capture_output=True, text=True, cwd=folder)
                if result.returncode != 0 or "warning" in result.stdout + result.stderr:
                    wrong.append(f"{page.name}, yaml block {number}:\n{result.stdout}{result.stderr}")
    for key in known_keys(program):
        pattern = as_pattern(key)
        if not any(pattern.match(path) for path in shown):
            wrong.append(f"no page of docs/guide shows {key}")
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
