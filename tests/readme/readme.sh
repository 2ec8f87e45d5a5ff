#!/usr/bin/env bash
# Runs every command of the README except `test` itself, and the scene that it prints, with the built program.
#   readme.sh SOURCE_DIRECTORY PROGRAM
set -euo pipefail
source_dir=$1
program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ln -s "$source_dir/xml" xml

blocks() { awk -v fence='```'"$1" '$0 == fence {inside = 1; next} /^```/ {inside = 0} inside' "$source_dir/README.md"; }

count=0
while read -r line; do
  [[ $line == "drivers/harmos test"* ]] && continue
  [[ $line == "drivers/harmos "* ]] || { echo "not a command of Harmos: $line"; exit 1; }
  echo "+ $line"
  eval "\"$program\" ${line#drivers/harmos }" >output.txt 2>&1 || { cat output.txt; exit 1; }
  count=$((count + 1))
done < <(blocks bash)
[ "$count" -ge 4 ] || { echo "only $count commands found"; exit 1; }

blocks xml >scene.xml
"$program" run scene.xml
test -s results/scene.e
