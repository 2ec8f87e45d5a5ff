#!/usr/bin/env bash
# Runs a scene and a study with laws of a plugin by an installed Harmos, and plugins that must be refused.
#
#   plugin.sh PREFIX BUILD_DIR    BUILD_DIR: of the consumer project
set -uo pipefail

harmos=$1/bin/harmos build=$2
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../expect.sh"
work=$build/plugin
rm -rf "$work"
mkdir -p "$work"
cp "$here"/consumer/laws/*.xml "$build/seven_laws.so" "$work"
cp "$work/seven_laws.so" "$work/again.so"
scene=$work/relaxation.xml

expect 0 'is valid' "$harmos" check "$scene"
expect 0 'Maxwell (1867)' "$harmos" doc --plugin "$work/seven_laws.so" Outside Maxwell
expect 0 'certified' "$harmos" run "$scene" --output "$work/one"
expect 0 'certified' mpirun -np 2 "$harmos" run "$scene" --output "$work/two"
for run in one two; do
  expect 0 '^right$' awk -F, 'END { print (0.44663 < $3 && $3 < 0.44665 ? "right" : $0) }' "$work/$run/relaxation_history.csv"
done
expect 0 '' "$harmos" study "$work/relaxation_study.xml" --output "$work" --quiet

# A law over all points of an interface: by itself, and on a face that bends, cut into pieces or not, on one rank or two.
bolt=$work/bolt.xml
value() { tail -1 "$work/$1/bolt_history.csv" | cut -d, -f3; }
expect 0 'certified' "$harmos" run "$bolt" --output "$work/rest"
bent=(--set Boundaries/held/Law/Z=0.01 --set Interfaces/bolt/Law/Stiffness=1000)
expect 0 'certified' "$harmos" run "$bolt" --output "$work/whole" "${bent[@]}"
expect 0 'certified' mpirun -np 2 "$harmos" run "$bolt" --output "$work/cut" "${bent[@]}" --set Parts/lower/Pieces=2 --set Parts/upper/Pieces=3
expect 0 '^right$' awk -v rest="$(value rest)" -v whole="$(value whole)" -v cut="$(value cut)" 'BEGIN {
  isRight = (rest - 5 / 3) ^ 2 < 1e-12 && (whole - 5.75 / 21) ^ 2 < 1e-12 && (cut - 5.75 / 21) ^ 2 < 1e-12
  print (isRight ? "right" : rest " " whole " " cut) }'

# Laws in Python, where Harmos was built with them: beside the installed program lie the library and the package.
if compgen -G "$1/lib*/harmos/python_laws.so" >/dev/null; then
  expect 0 'Linear glue' "$harmos" doc --plugin "$here/../../docs/guide/laws_in_python.py" Python Glue
fi

# Plugins that cannot be used: exit code 2, and nothing is run or written.
mkdir "$work/bad"
refused() { expect 2 "$1" "$harmos" run "$scene" --output "$work/bad" --set "Plugins={$2}"; }
refused 'Harmos / Plugins: ".*/nowhere.so" does not exist' nowhere.so
refused 'relaxation.xml" cannot be loaded' relaxation.xml
refused 'libc.so.6" is a shared library, but no Harmos plugin' "$(ldd "$harmos" | awk '/libc\.so\.6/ { print $3 }')"
refused '"Outside Cohesion" is registered already' "seven_laws.so, again.so"
expect 2 'unknown type\|"Outside Maxwell"' "$harmos" check "$scene" --set 'Plugins={}'
expect 0 '^$' ls "$work/bad"
[ $failures -eq 0 ] && echo "all as promised"
exit $((failures > 0))
