#!/usr/bin/env bash
# `brunt report`: one page of HTML, whole by itself, of a run that has ended.
#   report.sh PROGRAM SOURCE
set -euo pipefail
. "$2/tests/support/expect.sh"
brunt=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
limit=60
deck=$2/decks/bars/bars.yaml

expect 0 "$brunt" run "$deck" --quiet --set "time.end=30 us" --set "title=Bars <of steel> & more" --out bars
cp "$2/docs/taylor-bar.png" bars/own.png # of the user, not of the run: stays out
expect 0 "$brunt" report bars
[ "$("$brunt" report bars)" = bars/report.html ] || fail "does not say where the page is"
python3 - bars <<'PYTHON'
import csv, html.parser, json, pathlib, re, sys

folder = pathlib.Path(sys.argv[1])
page = (folder / "report.html").read_text()


class Tree(html.parser.HTMLParser):
    """Every element that is opened is closed, in order."""
    single = {"meta", "img", "line", "circle", "rect", "br"}

    def __init__(self):
        super().__init__()
        self.open, self.text, self.title = [], [], ""

    def handle_starttag(self, tag, attributes):
        if tag not in self.single:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in self.single:
            assert self.open and self.open.pop() == tag, f"</{tag}> closes nothing"

    def handle_data(self, data):
        self.text.append(data)
        if self.open and self.open[-1] == "title":
            self.title += data


tree = Tree()
tree.feed(page)
assert not tree.open, tree.open
assert tree.title == "Bars <of steel> & more", tree.title
text = "\n".join(tree.text)
summary = json.loads((folder / "summary.json").read_text())
for name, measure in summary["measures"].items():
    assert name in text and f"{measure['value']:.6g}"[:6] in text, name
rows = list(csv.reader(open(folder / "history.csv")))
for name, value in zip(rows[0], rows[-1]):
    if name.startswith("energy.") and name != "energy.drift" and float(value) != 0:
        assert name in text, name
for title in ("Energies", "Contact forces", "Speeds of bodies", "Time step", "striker-target", "kinetic"):
    assert title in text, title
assert "http" not in re.sub(r'xmlns="[^"]*"', "", page), "needs something beside it"
assert "data:image/png" not in page, "a picture that is the user's own"
PYTHON
# The page is the run's own: a run that replaces it takes it away.
expect 0 "$brunt" run "$deck" --quiet --set "time.end=20 us" --out bars --force
[ ! -e bars/report.html ] && [ -e bars/own.png ] || fail "--force leaves the page, or takes what is not the run's"

# A run that broke has a page too, and says why.
expect 3 "$brunt" run "$deck" --quiet --set "time.end=30 us" --set "time.min_step=1 ms" --out broke
expect 0 "$brunt" report broke
grep -q 'class="bad">physics error: .*time.min_step' broke/report.html || fail "does not say why it ended"
mkdir empty
expect 2 "$brunt" report empty
expect 2 "$brunt" report missing broke
[ -e broke/report.html ] || fail "a wrong folder keeps the others from their page"
