#!/usr/bin/env python3
"""Validates decks against decks/schema.json, as editors do: those that ship, those of the cases and
those that are only warned of are accepted; wrong ones are refused, but for what no schema can see.
   validate_decks.py SOURCE"""
import json
import pathlib
import re
import sys

import jsonschema
import yaml

# Wrong decks that a schema accepts, and why.
NOT_SEEN = {
    "another value decides": """
        drucker-prager-dilation-above-friction steinberg-guinan-cap-below-yield
        ambient-hotter-than-melting body-hotter-than-melting boundaries-that-contradict
        boundary-box-upside-down boundary-fixes-and-moves boundary-heats-nothing box-upside-down
        elastic-constants-mixed elastic-constants-twice grading-twice
        expansion-twice hardening-falls heat-of-free-rigid-bodies hourglass-with-full-integration
        johnson-cook-melts-below-reference melting-twice wedge-wrong gravity-wrong symmetry-particles symmetry-rigid expression-before-its-measures checks-before-other-keys gravity-beside-measures johnson-cook-thermal-strength-without-thermal
        mie-gruneisen-singular motion-of-a-body-that-deforms
        output-window rigid-free rigid-with-velocity size-and-cells size-missing unit-missing
        step-longest-below-shortest table-falls tube-inside-out
        boundary-does-nothing grading-of-a-wall grading-of-particles particles-of-three-spacings pair-precision-of-far-spacings
        hourglass-of-updated-particles total-of-one-layer total-with-what-moves-particles
        element-options-on-particles particle-options-on-elements plane-that-deforms process-speed-of-impacts
        measure-temperature-of-a-cold-body measure-weighed-by-no-mass measures-wrong only-rigid bonded-elements
        fluid-with-strength fluid-hourglass-stiffness material-without-elastic
        mesh-beside-size damage two-closures erode-concrete-by-damage
        stress-above-yield stress-of-a-fluid stress-of-a-gas stress-of-bodies-without""",
    "the geometry decides": """
        too-much-added-mass axis-out-of-plane axisymmetric-across-the-axis axisymmetric-cylinder-off-the-axis
        axisymmetric-particles erode-to-particles-axisymmetric axisymmetric-spin boundary-axis-z-in-2d cells-of-three-dimensions
        cells-of-two-dimensions flat-shape-in-3d polygon-flat-in-3d solid-shape-in-plane-strain
        velocity-of-two-components""",
    "a name": """
        boundary-of-a-rigid-body contact-pairs-double 
        history-column-unknown piece-of-a-body include-cycle include-not-found library-unknown
        material-unknown parameter-unknown-and-unused stop-when-syntax stop-when-unknown""",
    "a mesh or a surface": """
        bodies-overlap boundary-of-no-points grading-of-one-cell mesh-wrong
        ogive-of-elements open-surface particles-in-one-place particles-larger-than-the-shape
        particles-overlap polygon-crosses-itself polygon-folds-over polygon-of-no-area
        polygon-without-corners rod-inside-a-tube-too-narrow size-far-too-small
        pressure-without-faces wall-gap-wider-than-a-brick""",
    "what an expression or a parameter is": """
        temperature-over-the-place start-over-time expression-nan expression-of-time-nan expression-unknown-name measure-expression-syntax motion-of-the-place
        gravity-of-the-place gravity-of-time-nan""",
    "how YAML is written": "keys-double",
}

CORE = [  # the core schema of YAML 1.2: `off` is a word, and 1e9 a number
    ("tag:yaml.org,2002:bool", r"^(?:true|false)$", list("tf")),
    ("tag:yaml.org,2002:int", r"^[-+]?[0-9]+$", list("-+0123456789")),
    ("tag:yaml.org,2002:float", r"^[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?$",
     list("-+0123456789.")),
    ("tag:yaml.org,2002:null", r"^(?:null|~|)$", ["n", "~", ""]),
]


class Loader(yaml.SafeLoader):
    yaml_implicit_resolvers = {}


for tag, pattern, first in CORE:
    Loader.add_implicit_resolver(tag, re.compile(pattern), first)
Loader.add_constructor("tag:yaml.org,2002:float", lambda l, node: float(node.value))
Loader.add_constructor("tag:yaml.org,2002:int", lambda l, node: int(node.value))


def main():
    source = pathlib.Path(sys.argv[1])
    schema = json.loads((source / "decks/schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    unseen = {name for names in NOT_SEEN.values() for name in names.split()}
    failures = []

    def first_error(path):
        try:
            deck = yaml.load(path.read_text(), Loader)
        except yaml.YAMLError as error:
            return "YAML: " + str(error).splitlines()[0]
        errors = list(validator.iter_errors(deck))
        if not errors:
            return ""
        error = jsonschema.exceptions.best_match(errors)
        return ".".join(str(part) for part in error.absolute_path) + ": " + error.message[:200]

    sound = sorted(source.glob("decks/*/*.yaml")) + sorted(source.glob("tests/cases/*.yaml"))
    sound += sorted(source.glob("tests/parallel/decks/*.yaml"))
    n_refused = 0
    for path in sorted((source / "tests/wrong").glob("*.yaml")):
        if not re.search("^#! ", path.read_text(), re.M):
            sound.append(path)
            continue
        refused = first_error(path) != ""
        n_refused += refused
        if refused == (path.stem in unseen):
            failures.append(f"{path}: " + ("refused, and listed as not seen" if refused else "accepted"))
    for path in sound:
        if error := first_error(path):
            failures.append(f"{path}: refused: {error}")
    print("\n".join(failures))
    print(f"{len(sound)} decks accepted, {n_refused} wrong ones refused, {len(failures)} failures")
    return 1 if failures or len(sound) < 30 else 0


sys.exit(main())
