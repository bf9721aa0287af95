#!/usr/bin/env python3
"""Mutated decks: `brunt check` ends with 0 or 2, says what is wrong where it ends with 2, within 5 s and 1 GB.

  mutate_decks.py PROGRAM SOURCE COUNT [SEED]

Starts from the decks that ship, those of tests/cases and those of the guide; one to four mutations each, of keys and values
or of the text itself. Prints the seed of each failure: COUNT 1 and that seed make the same deck again and print it.
"""
import os, pathlib, random, re, resource, subprocess, sys, tempfile

import yaml

SECONDS, BYTES = 5, 1 << 30
JUNK = ["qqq", "", None, "3 kg^7", "-1", "0", "1e400", "nan", "-inf", "1e-300", "true", [], {}, [[]], "= 1/0", "= $nobody",
        "= " + "(" * 200, "$", "$$", "2 m", "5 %", "auto", "none", "\u00e4", "x" * 5000, [1, 2, 3, 4, 5, 6, 7], {"a": {"b": 1}},
        "9" * 40, "1 1 1", "../..", "/dev/null", "\x07", "0x10", "1_000", "~", "*", "&a", "!!int 3"]


def places(value, path=()):
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, below in list(items):
        yield path + (key,)
        yield from places(below, path + (key,))


def at(value, path):
    for key in path:
        value = value[key]
    return value


def rescaled(word, dice):
    number = re.search(r"[-+]?\d+\.?\d*(e[-+]?\d+)?", str(word))
    if not number:
        return str(word) + dice.choice(["x", " m", " ", "0", "$"])
    factor = dice.choice([-1, 0, 1e-9, 1e-3, 0.5, 2, 1e3, 1e9, 1e30])
    return str(word)[: number.start()] + repr(float(number.group()) * factor) + str(word)[number.end():]


def mutate_tree(deck, others, dice):
    path = dice.choice(list(places(deck)))
    holder, key = at(deck, path[:-1]), path[-1]
    kind = dice.randrange(7)
    if kind == 0:
        del holder[key]
    elif kind == 1:
        holder[key] = dice.choice(JUNK)
    elif kind == 2 and isinstance(holder, dict):
        holder[str(key)[:-1] + dice.choice("aexz") + dice.choice(["", "_", str(key)])] = holder.pop(key)
    elif kind == 3 and not isinstance(holder[key], (dict, list)):
        holder[key] = rescaled(holder[key], dice)
    elif kind == 4:
        other = dice.choice(others)
        holder[key] = at(other, dice.choice(list(places(other))))
    elif kind == 5 and isinstance(holder, dict):
        other = dice.choice(others)
        given = dice.choice(list(places(other)))
        holder[given[-1]] = at(other, given)
    else:
        holder[key] = [holder[key]] if dice.random() < 0.5 else {"value": holder[key]}


def mutate_text(text, dice):
    start = dice.randrange(len(text))
    end = min(len(text), start + dice.randrange(1, 40))
    kind = dice.randrange(5)
    if kind == 0:
        return text[:start] + text[end:]
    if kind == 1:
        return text[:end] + text[start:end] + text[end:]
    if kind == 2:
        return text[:start] + dice.choice(list("{}[]:,#\"'|>&*!%@`\t\n\r \0-=$")) + text[start:]
    if kind == 3:
        lines = text.split("\n")
        a, b = dice.randrange(len(lines)), dice.randrange(len(lines))
        lines[a], lines[b] = lines[b], lines[a]
        return "\n".join(lines)
    return text[:start] + chr(dice.choice([0, 9, 127, 160, 255, 0x2028, 0xFFFD, 0x1F600])) + text[end:]


def mutated(seed, texts, trees):
    dice = random.Random(seed)
    which = dice.randrange(len(texts))
    for _ in range(20):  # until there is one that can be written
        deck = yaml.load(texts[which], yaml.BaseLoader)
        try:
            if dice.random() < 0.7:
                for _ in range(dice.randrange(1, 5)):
                    mutate_tree(deck, trees, dice)
            text = yaml.safe_dump(deck, sort_keys=False, width=200, allow_unicode=True)
            if dice.random() < 0.4:
                for _ in range(dice.randrange(1, 4)):
                    text = mutate_text(text, dice)
            return text
        except (IndexError, KeyError, TypeError, ValueError):
            continue
    return texts[which]


def bounded():
    resource.setrlimit(resource.RLIMIT_AS, (4 * BYTES, 4 * BYTES))
    resource.setrlimit(resource.RLIMIT_CPU, (2 * SECONDS, 2 * SECONDS))


def failure_of(program, deck):
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    try:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        result = subprocess.run([program, "check", deck], capture_output=True, timeout=4 * SECONDS, env=environment,
                                preexec_fn=bounded)
        after = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    except subprocess.TimeoutExpired:
        return f"not done after {4 * SECONDS} s", None
    said = (result.stdout + result.stderr).decode(errors="replace")
    if result.returncode not in (0, 2):
        return f"status {result.returncode}: {said[-600:]}", result.returncode
    if result.returncode == 2 and deck.name not in said:
        return f"does not say where: {said[:600]}", 2
    if after > before and after * 1024 > BYTES:
        return f"took {after >> 10} MB", result.returncode
    return "", result.returncode


def main():
    program, source, count = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]), int(sys.argv[3])
    first = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    files = sorted((source / "decks").glob("*/*.yaml")) + sorted((source / "tests/cases").glob("*.yaml"))
    texts = [f.read_text() for f in files]
    for page in sorted((source / "docs/guide").glob("*.md")):
        texts += re.findall(r"^```yaml\n(.*?)^```", page.read_text(), re.M | re.S)[:1]
    trees = [yaml.load(text, yaml.BaseLoader) for text in texts]
    ends, failures = {}, 0
    with tempfile.TemporaryDirectory() as folder:
        deck = pathlib.Path(folder) / "mutated.yaml"
        for seed in range(first, first + count):
            deck.write_text(mutated(seed, texts, trees), newline="", encoding="utf-8", errors="surrogateescape")
            if count == 1:
                print(deck.read_text())
            failure, status = failure_of(program, deck)
            ends[status] = ends.get(status, 0) + 1
            if failure:
                failures += 1
                print(f"seed {seed}: {failure}", flush=True)
    print(f"seeds {first} .. {first + count - 1}: {failures} failures; by status {ends}")
    return 1 if failures else 0


sys.exit(main())
