#!/usr/bin/env python3
"""Puts sources into batches that one compiler reads as one file: batches.py SIZE SOURCE...

Prints a line a source: its batch and its path. Sources of one batch share
their unnamed namespace, so that no private name of one may stand in another: as a private name of its own, or as
that of something else, which it would hide. Sources with such names come into different batches. Names are read
from the text, as clang-format leaves it; more names than there are only make smaller batches.
"""
import pathlib, re, sys

KINDS = re.compile(r"(?:struct|class|enum class|enum|union)\s+(?:\[\[.*?\]\]\s*)?(\w+)|using\s+(\w+)\s*=")
# A function or a variable: the words of its type, then its name.
NAMED = re.compile(r"[\w:<>,&*\[\] .\"]*?[ &*>\]](\w+)\s*(?=\(|=|\{|\[|;|$)")
INNER = re.compile(r"^namespace brunt::(testing)\b", re.M)
OUTER = re.compile(r"(?<![\w:])(testing)::")
MORE = re.compile(r",\s*(\w+)\s*(?==|\{|,|;)")  # constexpr Real kA = 1, kB = 2;


def without_comments(text):
    pattern = r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|//(?! namespace\b)[^\n]*|/\*.*?\*/'
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def private_names(text):
    """Names of unnamed namespaces and macros. What is declared there begins at the margin."""
    names = set(re.findall(r"^#define\s+(\w+)", text, re.M))
    for part in re.findall(r"^namespace \{\n(.*?)^\}  // namespace$", text, re.S | re.M):
        part = re.sub(r"^template\s*<[^\n]*>\n", "", part, flags=re.M)
        for declared in re.findall(r"^[A-Za-z_\[].*(?:\n .*)?", part, re.M):
            line = declared.split("\n")[0]
            kind = KINDS.match(line)
            if re.match(r"(?:TEST|TEST_F|TEST_P|TYPED_TEST\w*|INSTANTIATE\w*|BENCHMARK\w*|static_assert|template|using namespace)\b", line):
                continue
            if kind:
                names.add(kind.group(1) or kind.group(2))
                continue
            named = NAMED.match(line if re.search(r"[(={;]", line) else declared.replace("\n", " "))
            if named:
                names.add(named.group(1))
            if "(" not in line.split("=")[0]:
                names.update(MORE.findall(line))
    return names


def used_names(text):
    """Words that a private name of another source would hide; members and qualified names are safe."""
    return set(re.findall(r"(?<![\w.])(?<!->)(?<!::)[A-Za-z_]\w*", text))


class Sources:
    """What sources say, and the headers of the project below them."""

    def __init__(self, root):
        self.root, self.text, self.below = root, {}, {}

    def text_of(self, path):
        if path not in self.text:
            whole = (self.root / path).read_text()
            self.text[path] = without_comments(whole), re.findall(r'^#include "([^"]+)"', whole, re.M)
        return self.text[path]

    def headers(self, path):
        if path not in self.below:
            self.below[path] = found = set()
            for header in self.text_of(path)[1]:
                if (self.root / header).is_file():
                    found |= {header} | self.headers(header)
        return self.below[path]


class Batch:
    def __init__(self):
        self.sources, self.private, self.used, self.headers, self.spaces = [], set(), set(), set(), set()


def batches(root, paths, size):
    sources, made = Sources(root), []
    for path in paths:
        text = sources.text_of(path)[0]
        mine, uses, headers = private_names(text), used_names(text), sources.headers(path)
        # Namespaces that hide another of their name, as brunt::testing does testing.
        spaces = {s for h in {path} | headers for s in INNER.findall(sources.text_of(h)[0])}
        outer = {s for s in OUTER.findall(text) if s not in spaces}
        for batch in made:
            if len(batch.sources) == size:
                continue
            # Headers that come in behind the others are read among their private names.
            late = set().union(*(used_names(sources.text_of(h)[0]) for h in headers - batch.headers)) if batch.private else set()
            if not (mine & (batch.private | batch.used) or (uses | late) & batch.private or outer & batch.spaces):
                break
        else:
            batch = Batch()
            made.append(batch)
        batch.sources.append(path)
        batch.spaces |= spaces
        batch.private |= mine
        batch.used |= uses
        batch.headers |= headers
    return [batch.sources for batch in made]


root = pathlib.Path(__file__).resolve().parent.parent
for number, batch in enumerate(batches(root, sys.argv[2:], int(sys.argv[1]))):
    for path in batch:
        print(number, path)
