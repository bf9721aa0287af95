# Sourced by scripts that call the program as a user does.
fail() { echo "FAILED: $*" >&2; exit 1; }
# expect STATUS COMMAND...: leaves out.txt and err.txt; at most $limit seconds where that is set.
expect() {
  local wanted=$1 status=0
  shift
  ${limit:+timeout "$limit"} "$@" >out.txt 2>err.txt || status=$?
  [ "$status" = "$wanted" ] || { cat out.txt err.txt; fail "status $status instead of $wanted: $*"; }
}
