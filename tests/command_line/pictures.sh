#!/usr/bin/env bash
# Draws results: pictures without a display, and a page that a browser without a network shows and turns. What is no
# result, field or step is refused, and nothing is written.
#
#   pictures.sh HARMOS SCENE.xml WORK_DIR [CHROMIUM]
set -uo pipefail

harmos=$1 scene=$2 work=$3 chromium=${4:-}
name=$(basename "$scene" .xml)
rm -rf "$work"
mkdir -p "$work"
. "$(dirname "$0")/../expect.sh"
here=$(cd "$(dirname "$0")" && pwd)
cd "$work" || exit 1
unset DISPLAY

expect 0 'largest von Mises stress (nodes)' "$harmos" run "$scene" --output . --set 'Units=mm N s'
grep -q ',"\?units: mm N s"\?$' "${name}_history.csv" || { echo "FAILED: the table has no units"; failures=$((failures + 1)); }
for field in von_mises displacement pressure slip status safety gaping principal_1 stress_xx; do
  expect 0 "$field.png" "$harmos" picture "$name.e" --field "$field" --width 400 --output "$field.png"
  "$here/drawn.py" "$field.png" || failures=$((failures + 1))
done
expect 0 'first.png' "$harmos" picture "$name.e" --step 1 --scale 10 --interfaces contact --field pressure --width 400 \
  --output first.png
cmp -s first.png pressure.png && { echo "FAILED: two steps look alike"; failures=$((failures + 1)); }
expect 0 'drawn_twice.png' "$harmos" picture "$name.e" --field pressure --width 400 --output drawn_twice.png
cmp pressure.png drawn_twice.png || failures=$((failures + 1))

# What is not certified says so: on the picture, which is another one without the record, and on the page below.
mkdir doubted
expect 3 'not converged' "$harmos" run "$scene" --output doubted --set 'Solver/Maximum Iterations=1'
expect 0 'with.png' "$harmos" picture "doubted/$name.e" --output doubted/with.png
mv "doubted/${name}_result.json" doubted/record
expect 0 'without.png' "$harmos" picture "doubted/$name.e" --output doubted/without.png
cmp -s doubted/with.png doubted/without.png && { echo "FAILED: nothing tells that it is not certified"; failures=$((failures + 1)); }
mv doubted/record "doubted/${name}_result.json"

# refused PATTERN COMMAND...: it ends with 2, and no file of the folder has changed.
refused() {
  local pattern=$1 before
  shift
  before=$(find . -type f | sort | xargs md5sum)
  expect 2 "$pattern" "$@"
  if [ "$before" != "$(find . -type f | sort | xargs md5sum)" ]; then
    echo "FAILED: $* has changed files"
    failures=$((failures + 1))
  fi
}

expect 0 "${name}_interfaces.pvd" "$harmos" export "$name.e" --output vtu
expect 0 "$name.pvd" "$harmos" export "$name.e" --output one --step -1
[ "$(find one -type f | wc -l)" -eq 4 ] || { echo "FAILED: more than one step is exported"; failures=$((failures + 1)); }
"$here/exported.py" "$name.e" vtu || failures=$((failures + 1))

for verb in picture show export; do
  refused 'there is no such file' "$harmos" "$verb" missing.e
  refused 'is not an Exodus file' "$harmos" "$verb" "$scene" --output new
  [ "$verb" = export ] && continue
  refused 'would replace the input' "$harmos" "$verb" "$name.e" --output "$name.e"
  refused 'would replace the input' "$harmos" "$verb" "$name.e" --output "${name}_interfaces.e"
done
refused 'is no folder' "$harmos" export "$name.e" --output "$name.e"
refused 'there is no step 9' "$harmos" export "$name.e" --step 9 --output new
refused 'Did you mean "von_mises"' "$harmos" picture "$name.e" --field von_misses --output new
refused 'there is no step 9' "$harmos" picture "$name.e" --step 9 --output new
refused 'there is no step -9' "$harmos" picture "$name.e" --step -9 --output new
refused 'there is no interface "contcat"' "$harmos" picture "$name.e" --interfaces contcat --output new
refused 'give 100 to 10000 pixels' "$harmos" picture "$name.e" --width 3 --output new
refused 'invalid int value' "$harmos" picture "$name.e" --step last --output new
refused 'give 2 or more' "$harmos" show "$name.e" --steps 1 --output new
mkdir -p damaged
head -c 20000 "$name.e" >"damaged/$name.e"
cp "${name}_interfaces.e" damaged
refused 'Nothing was written' "$harmos" picture "damaged/$name.e" --output new
# The end of a step is missing, which the libraries read as zeros.
for half in "$name.e" "${name}_interfaces.e"; do
  cp "$name.e" "${name}_interfaces.e" damaged
  truncate -s -100 "damaged/$half"
  for verb in picture show export; do
    refused 'is cut off: it has' "$harmos" "$verb" "damaged/$name.e" --output new
  done
done
"$harmos" mesh "$scene" --output "damaged/mesh.e" --quiet
cp damaged/mesh.e damaged/mesh_interfaces.e
refused 'is not a result of Harmos' "$harmos" picture damaged/mesh.e --output new
rm "damaged/${name}_interfaces.e"
cp "$name.e" damaged
refused "${name}_interfaces.e" "$harmos" show "damaged/$name.e" --output new

if [ -f "$(dirname "$(readlink -f "$harmos")")/../share/harmos/vtk.js" ]; then
  expect 0 page.html "$harmos" show "$name.e" --output page.html
  [ "$(stat -c %s page.html)" -lt 10000000 ] || { echo "FAILED: the page is too large"; failures=$((failures + 1)); }
  expect 0 doubted.html "$harmos" show "doubted/$name.e" --output doubted.html
  grep -q '<div>not converged, error not estimated</div>' doubted.html || { echo "FAILED: the page keeps that it is not certified"; failures=$((failures + 1)); }
  grep -q '<div>certified, error estimate' page.html || { echo "FAILED: the page does not say that it is certified"; failures=$((failures + 1)); }
  grep -q '<div>Units: mm N s</div>' page.html || { echo "FAILED: the page has no units"; failures=$((failures + 1)); }
  grep -qE '<(script|link|img)[^>]* (src|href)=' page.html &&
    { echo "FAILED: the page loads something"; failures=$((failures + 1)); }
  if [ -n "$chromium" ]; then
    "$here/browse.py" "$chromium" "$work/page.html" || failures=$((failures + 1))
  fi
else
  expect 1 'Configure again with a connection\|again with a connection' "$harmos" show "$name.e" --output page.html
fi
[ $failures -eq 0 ]
