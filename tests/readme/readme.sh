#!/usr/bin/env bash
# Runs every command of a page except `test` itself, and the scene that it prints if there is one, with the built program.
#   readme.sh SOURCE_DIRECTORY PROGRAM PAGE LEAST_COMMANDS
set -euo pipefail
source_dir=$1
program=$2
page=$source_dir/$3
least=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ln -s "$source_dir/xml" xml
ln -s "$source_dir/tests" tests

blocks() { awk -v fence='```'"$1" '$0 == fence {inside = 1; next} /^```/ {inside = 0} inside' "$page"; }

# A page of harmos show needs vtk.js, which a build without a connection does not have.
has_vtk_js=$([ -f "$(dirname "$program")/../share/harmos/vtk.js" ] && echo yes || echo no)
count=0
while read -r line; do
  [[ $line == "drivers/harmos show "* && $has_vtk_js == no ]] && continue
  case $line in
    "drivers/harmos test"*) continue ;;
    "drivers/harmos "*) command="\"$program\" ${line#drivers/harmos }" ;;
    tests/*) command=$line ;;
    *) echo "neither a command of Harmos nor a script of its tests: $line" && exit 1 ;;
  esac
  echo "+ $line"
  eval "$command" >output.txt 2>&1 || { cat output.txt; exit 1; }
  count=$((count + 1))
done < <(blocks bash | sed -e ':join' -e '/\\$/{N;s/\\\n *//;bjoin}')
[ "$count" -ge "$least" ] || { echo "only $count commands found"; exit 1; }

blocks xml >scene.xml
[ -s scene.xml ] || exit 0
"$program" run scene.xml
test -s results/scene.e
