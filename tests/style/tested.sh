#!/usr/bin/env bash
# Fails where a source of a layer has neither a test of its name, tests/**/NAME_test.cpp, nor a line that says where it is
# tested: `// Tested by tests/unit/core/shapes_test.cpp.` A header counts where it has code: a function with a body.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 - <<'PYTHON'
import pathlib, re, sys

of_name = {path.stem.removesuffix("_test") for path in pathlib.Path("tests").rglob("*_test.cpp")}
wrong, seen = [], 0
for folder in ("core", "fe", "sph", "contact", "io"):
    for path in sorted(pathlib.Path(folder).rglob("*.[hc]pp")):
        text = path.read_text()
        named = re.findall(r"^// Tested by (tests/[\w/.-]+?)\.?$", text, re.M)
        wrong += [f"{path}: there is no {test}" for test in named if not pathlib.Path(test).is_file()]
        has_code = path.suffix == ".cpp" or re.search(r"^\s+return |^\s*(for|if) \(", text, re.M)
        if not has_code:
            continue
        seen += 1
        if path.stem not in of_name and not named:
            wrong.append(f"{path}: no tests/**/{path.stem}_test.cpp, and no line `// Tested by tests/...`")
if seen < 200:
    wrong.append(f"only {seen} sources were seen: the search for them is broken")
print("\n".join(wrong), end="\n" if wrong else "")
sys.exit(1 if wrong else 0)
PYTHON
