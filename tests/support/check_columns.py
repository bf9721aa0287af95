#!/usr/bin/env python3
"""docs/columns.md describes what runs write: each column of history.csv and each field of a frame stands there with a unit
and a meaning, and none stands there that no run writes.

  check_columns.py PROGRAM SOURCE

The decks are those that ship, a step of each: elements, particles, heat, rigid bodies, contact, friction, gravity; a pressure; one of
them with a probe and a section, one on two ranks.
"""
import csv, pathlib, re, subprocess, sys, tempfile

RUNS = [
    ("bars", ["--set", "materials.steel.damage={principal_stress: 1 GPa}", "--set", "output.state_hash=true"]), ("block-on-incline", []), ("hot-block", []), ("taylor-bar", []),
    ("taylor-bar-axisymmetric", ["--set", "boundaries={sea: {body: bar, where: {side: max-x}, pressure: 1 MPa}}"]),
    ("hot-rod", []), ("tumbling-blocks", []),
    ("sliding-blocks", ["--set", "materials.rubber.strength={drucker-prager: {cohesion: 1 MPa, friction_angle: 30 deg}}"]),
    ("cutting-2d", ["--set", "probes={edge: {body: work, at: [3.4 mm, 0.6 mm], fields: [pressure, stress.xx, velocity.x]}}",
                    "--set", "sections={foot: {body: work, plane: {axis: y, at: 0.45 mm}}}"]),
    ("hot-block", ["--ranks", "2", "--oversubscribe"]),
    ("bars", ["--set", "output.fields=[rank]"]),
    ("concrete-cylinder", ["--set", "materials.concrete.strength={concrete-cap: {fc: 30 MPa}}",
                           "--set", "bodies.cylinder.erode={when: {strain: 2}}"]),
]


def rows_of(page):
    """Name, unit and meaning of each row, by the heading of second level above it."""
    rows, part = {}, None
    for line in page.splitlines():
        if line.startswith("## "):
            part = rows.setdefault(line[3:], [])
        found = re.match(r"\| `([^`]+)` \| (.*?) \| (.*?) \|$", line)
        if found:
            part.append(found.groups())
    return rows


def pattern_of(name):
    """The columns that a row describes."""
    text = re.escape(name).replace("NAME", r".+").replace("AXIS", r"[xyz]")
    return re.compile(text.replace("FIELD", r"[a-z_]+(?:\.[a-z]+)?"))


def arrays_of(file):
    """Names of the point and cell arrays of a piece."""
    head = file.read_bytes().split(b"<AppendedData")[0].decode("latin-1")
    return {name for part in re.findall(r"<(?:Point|Cell)Data.*?</(?:Point|Cell)Data>", head, re.S)
            for name in re.findall(r'<DataArray[^>]* Name="([^"]+)"', part)}


def main():
    program, source = sys.argv[1:3]
    rows = rows_of(pathlib.Path(source, "docs/columns.md").read_text())
    columns, fields = rows["Columns of `history.csv`"], {name for name, _, _ in rows["Fields of frames"]}
    wrong = [f"docs/columns.md: {name} has no unit or no meaning"
             for part in rows.values() for name, unit, meaning in part if not unit.strip() or not meaning.strip()]
    patterns = {name: pattern_of(name) for name, _, _ in columns}
    seen = set()
    with tempfile.TemporaryDirectory() as work:
        for number, (deck, options) in enumerate(RUNS):
            out = pathlib.Path(work, str(number))
            call = [program, "run", f"{source}/decks/{deck}/{deck}.yaml", "--quiet", "--until", "1 ns", "--out", out]
            done = subprocess.run(call + options, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{deck}: status {done.returncode}\n{done.stderr}")
            for column in next(csv.reader(open(out / "history.csv"))):
                found = [name for name, pattern in patterns.items() if pattern.fullmatch(column)]
                seen.update(found)
                if not found:
                    wrong.append(f"{deck}: docs/columns.md has no column {column}")
            for file in [*out.rglob("*.vtu"), *out.rglob("*.vtp")]:
                written = arrays_of(file)
                seen |= written
                wrong += [f"{deck}: docs/columns.md has no field {name}" for name in sorted(written - fields)]
    wrong += [f"docs/columns.md: no deck writes {name}" for name in sorted({*patterns, *fields} - seen)]
    print("\n".join(wrong), end="\n" if wrong else "")
    sys.exit(1 if wrong else 0)


main()
