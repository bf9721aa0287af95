#!/usr/bin/env bash
# Fails where a source cites an equation of docs/theory that is not there, or a page that is not in the repository; where
# a page defines an equation twice; and where a page of theory names a file that is not there;
# where docs/decisions.md, the index, and docs/decisions differ; and where a link of a page leads nowhere.
#
# A page defines **(S7)** once, in bold; a source cites `docs/theory/sph.md (S7), (S9)` or `(S26) to (S28)`.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 - <<'PYTHON'
import pathlib, re, sys

wrong = []
pages, owner = {}, {}
for page in sorted(pathlib.Path("docs/theory").glob("*.md")):
    text = page.read_text()
    pages[str(page)] = set()
    for number in re.findall(r"\*\*\(([A-Z]\d+)\)\*\*", text):
        if number in owner:
            wrong.append(f"{page}: ({number}) is defined in {owner[number]} already")
        owner[number] = page
        pages[str(page)].add(number)
    for file in sorted(set(re.findall(r"`((?:core|fe|sph|contact|io|app|tests|decks|docs)/[\w/.-]+)`", text))):
        if not pathlib.Path(file).exists():
            wrong.append(f"{page}: there is no {file}")

for folder in ("core", "fe", "sph", "contact", "io", "app", "tests"):
    for file in sorted(pathlib.Path(folder).rglob("*.[hc]pp")):
        # Comments of several lines are read as one.
        text = re.sub(r"\n\s*//[/!]?<? ?", " ", file.read_text())
        for page, numbers in re.findall(r"(docs/theory/\w+\.md)((?:,? ?(?:to |and )?\([A-Z]\d+\))*)", text):
            for number in re.findall(r"[A-Z]\d+", numbers):
                if page in pages and number not in pages[page]:
                    wrong.append(f"{file}: {page} has no ({number})")
        for page in set(re.findall(r"(?<![\w/*.-])((?:[\w-]+/)*[\w-]+\.md)\b", text)):
            if not pathlib.Path(page).exists():
                wrong.append(f"{file}: there is no {page}")

# The index of decisions has a line for each, and each has a date.
index = pathlib.Path("docs/decisions.md").read_text()
listed = re.findall(r"\]\((decisions/[\w-]+\.md)\)", index)
for file in sorted(pathlib.Path("docs/decisions").glob("*.md")):
    if listed.count(f"decisions/{file.name}") != 1:
        wrong.append(f"docs/decisions.md has no line, or more than one, for {file}")
    if not re.search(r"^Date: \d{4}-\d\d-\d\d", file.read_text(), re.M):
        wrong.append(f"{file} has no date")
for file in listed:
    if not pathlib.Path("docs", file).exists():
        wrong.append(f"docs/decisions.md: there is no docs/{file}")

for file in sorted([pathlib.Path("README.md"), *pathlib.Path("docs").rglob("*.md"), *pathlib.Path("decks").rglob("*.md")]):
    text = re.sub(r"```.*?```", "", file.read_text(), flags=re.S)
    for link in re.findall(r"\]\(([^)#: ]+\.(?:md|png|svg|yaml))[)#]", text):
        if not (file.parent / link).exists():
            wrong.append(f"{file}: there is no {link}")

print("\n".join(wrong), end="\n" if wrong else "")
sys.exit(1 if wrong else 0)
PYTHON
