#!/usr/bin/env bash
# Fails where a source cites an equation of docs/theory that is not there, where a page defines one twice, and where
# a page of theory names a file that is not in the repository.
#
# A page defines **(S7)** once; a source cites `docs/theory/sph.md (S7), (S9)` or `(S26) to (S28)` on one line.
set -euo pipefail
cd "$(dirname "$0")/../.."
status=0
complain() { printf '%s\n' "$*"; status=1; }

twice=$(grep -ohE '^\*\*\([A-Z][0-9]+[a-z]?\)\*\*' docs/theory/*.md | sort | uniq -d)
[ -z "$twice" ] || complain "docs/theory: defined twice: $twice"

while IFS=: read -r file line text; do
  page=$(grep -oE 'docs/theory/[a-z]+\.md' <<< "$text" | head -1)
  [ -f "$page" ] || { complain "$file:$line: there is no $page"; continue; }
  for number in $(grep -oE '\([A-Z][0-9]+[a-z]?\)' <<< "${text#*"$page"}" | tr -d '()'); do
    grep -qE "^\*\*\($number\)\*\*" "$page" || complain "$file:$line: $page has no ($number)"
  done
done < <(grep -rnE 'docs/theory/[a-z]+\.md' --include='*.hpp' --include='*.cpp' core fe sph contact io app tests)

while IFS=: read -r page file; do
  [ -e "$file" ] || complain "$page: there is no $file"
done < <(grep -oE '`(core|fe|sph|contact|io|app|tests|decks|docs)/[A-Za-z0-9_/.-]+`' docs/theory/*.md | tr -d '`' | sort -u)
exit $status
