#!/usr/bin/env bash
# Runs every command of a guide in docs/guide with the built program.
#   guide.sh SOURCE_DIRECTORY PROGRAM GUIDE
set -euo pipefail
source_dir=$1
program=$2
page=$source_dir/docs/guide/$3.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ln -s "$source_dir/xml" xml
mkdir drivers
ln -s "$program" drivers/harmos

# Pages of harmos show need vtk.js, which a build without a connection does not have.
hasVtkJs=$([ -f "$(dirname "$program")/../share/harmos/vtk.js" ] && echo yes || echo no)
count=0
while read -r line; do
  [[ $line == "drivers/harmos show "* && $hasVtkJs == no ]] && continue
  echo "+ $line"
  eval "$line" >output.txt 2>&1 || { cat output.txt; exit 1; }
  count=$((count + 1))
done < <(awk '$0 == "```bash" {inside = 1; next} /^```/ {inside = 0} inside' "$page")
[ "$count" -ge 4 ] || { echo "only $count commands found in $page"; exit 1; }
