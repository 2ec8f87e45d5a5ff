# Sourced by the scripts that try the program: counts what was not as promised in `failures`.
failures=0

# expect CODE PATTERN COMMAND...: the command ends with this code and prints the pattern.
expect() {
  local code=$1 pattern=$2 output status
  shift 2
  output=$("$@" 2>&1)
  status=$?
  if [ $status -ne "$code" ] || ! grep -q -- "$pattern" <<<"$output"; then
    echo "FAILED: $*"
    echo "  exit code $status, expected $code; expected text: $pattern; printed:"
    sed 's/^/  | /' <<<"$output"
    failures=$((failures + 1))
  fi
}
