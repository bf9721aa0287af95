#!/usr/bin/env bash
# Fails on functions of more than 60 lines: what does not fit a screen does more than one thing.
# A body is the braces behind a parameter list (const, noexcept, override, -> type, initializers and attributes may
# stand between), lines counted from the line of its name to its last brace. Lambdas count as part of what holds them.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 - <<'PYTHON'
import pathlib, re, sys

MOST = 60


def blanked(text):
    """The text with comments, literals and preprocessor lines as blanks, so that braces are code."""
    pattern = (r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/'
               r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*")
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S | re.M)


def closing(text):
    """Place of the partner of each opening brace and parenthesis."""
    partner, open_ones = {}, []
    for place, c in enumerate(text):
        if c in "({":
            open_ones.append(place)
        elif c in ")}" and open_ones:
            begin = open_ones.pop()
            partner[begin], partner[place] = place, begin
    return partner


NO_FUNCTION = {"if", "for", "while", "switch", "catch", "constexpr", "return", "requires", "alignas", "decltype", "sizeof"}


def function_name(text, brace, partner):
    """Name and place of the function whose body begins at this brace; None: it is none."""
    begin = max(text.rfind(c, 0, brace) for c in ";}")
    head = text[begin + 1:brace]
    # The first parenthesis that follows a name at the level of the declaration.
    place = begin + 1
    while place < brace:
        if text[place] == "{":
            return None
        if text[place] == "(":
            name = re.search(r"(operator\s*[^\s\w(]+|operator\(\)\s*|[~\w]+)\s*$", text[begin + 1:place])
            if name and name.group(1) not in NO_FUNCTION and "=" not in re.sub(r"operator\S*|[=!<>]=|<[^<>]*>", "", text[begin + 1:place]):
                return name.group(1), begin + 1 + name.start(1)
            place = partner.get(place, place)
        place += 1
    return None


def long_functions(path):
    text = blanked(path.read_text())
    partner = closing(text)
    line = lambda place: text.count("\n", 0, place) + 1
    inside = -1
    for brace in [m.start() for m in re.finditer("{", text)]:
        if brace < inside or brace not in partner:
            continue
        found = function_name(text, brace, partner)
        if not found:
            continue
        name, begin = found
        inside = partner[brace]
        lines = line(inside) - line(begin) + 1
        yield name, line(begin), lines


wrong, count, longest = [], 0, 0
for folder in ("app", "core", "fe", "sph", "contact", "io"):
    for path in sorted(pathlib.Path(folder).rglob("*.[hc]pp")):
        for name, line, lines in long_functions(path):
            count += 1
            longest = max(longest, lines)
            if lines > MOST:
                wrong.append(f"{path}:{line}: {name} has {lines} lines")
if count < 1000:
    wrong.append(f"only {count} functions were seen: the search for them is broken")
print("\n".join(wrong) if wrong else f"{count} functions, the longest has {longest} lines")
sys.exit(1 if wrong else 0)
PYTHON
