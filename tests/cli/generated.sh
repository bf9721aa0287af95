#!/usr/bin/env bash
# Fails when a generated file is stale: the reference manual, the page of columns and the JSON schema of decks.
#   generated.sh PROGRAM SOURCE
set -euo pipefail
"$1" schema --markdown | cmp - "$2/docs/deck.md" ||
  { echo "docs/deck.md is stale: brunt schema --markdown > docs/deck.md"; exit 1; }
"$1" schema --columns | cmp - "$2/docs/columns.md" ||
  { echo "docs/columns.md is stale: brunt schema --columns > docs/columns.md"; exit 1; }
"$1" schema | cmp - "$2/decks/schema.json" ||
  { echo "decks/schema.json is stale: brunt schema > decks/schema.json"; exit 1; }
