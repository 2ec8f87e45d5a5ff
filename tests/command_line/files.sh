#!/usr/bin/env bash
# Checks that nothing that exists is lost by accident: no result replaces an input, old results stay until new ones are
# complete, and what could not be written is an error.
#
#   files.sh HARMOS SCENE.xml STUDY.xml WORK_DIR
#
# SCENE makes its own mesh and is solved in a fraction of a second; STUDY is about it.
set -uo pipefail

harmos=$1 scene=$2 study=$3 work=$4
name=$(basename "$scene" .xml)
rm -rf "$work"
mkdir -p "$work"
. "$(dirname "$0")/../expect.sh"
cd "$work" || exit 1

# same COMMAND...: it ends with 2, and no file of the folder has changed.
same() {
  local before
  before=$(find . -type f -o -type l | sort | xargs md5sum)
  expect 2 'Nothing was written' "$@"
  if [ "$before" != "$(find . -type f -o -type l | sort | xargs md5sum)" ]; then
    echo "FAILED: $* has changed files"
    failures=$((failures + 1))
  fi
}

# The same scene with its mesh in a file that has the name of the result.
"$harmos" mesh "$scene" --output "$name.e" --quiet
python3 - "$scene" "$name" <<'END'
import re, sys
scene, name = sys.argv[1:]
mesh = '<ParameterList name="Mesh"><Parameter name="Type" type="string" value="Exodus"/>' \
       f'<Parameter name="File" type="string" value="{name}.e"/></ParameterList>'
text = open(scene).read()
begin = text.index('<ParameterList name="Mesh">')
depth, end = 0, begin
for tag in re.finditer(r'<ParameterList\b[^>]*?(/?)>|</ParameterList>', text[begin:]):
    depth += -1 if tag[0].startswith('</') else 0 if tag[1] else 1
    if depth == 0:
        end = begin + tag.end()
        break
open(f'{name}.xml', 'w').write(text[:begin] + mesh + text[end:])
END
mkdir links
ln -s "../$name.e" "links/$name.e"
ln "$name.xml" "links/${name}_interfaces.e"

same "$harmos" run "$name.xml" --output .
same "$harmos" run "$name.xml" --output ./links/..
same "$harmos" run "$name.xml" --output links
same mpirun -np 2 "$harmos" run "$name.xml" --output .
same "$harmos" mesh "$name.xml" --output "$name.xml"
same "$harmos" mesh "$name.xml" --output "./links/../$name.e"
same "$harmos" mesh "$name.xml" --output "links/${name}_interfaces.e"
expect 0 '' "$harmos" run "$name.xml" --output results --quiet

# The effective input finds the mesh from anywhere, also when scene, mesh and results have moved together.
cp -r . ../moved_files
expect 0 '' sh -c "cd / && '$harmos' run '$PWD/results/${name}_effective.xml' --output '$PWD/again' --quiet"
mv ../moved_files moved
mv "$name.e" elsewhere.e
expect 0 '' "$harmos" run "moved/results/${name}_effective.xml" --output moved/again --quiet
expect 0 '' cmp "again/${name}_effective_history.csv" "moved/again/${name}_effective_history.csv"
mv elsewhere.e "$name.e"
rm -r moved again

# A warning is printed once, counted, and stands in the record.
spare='<ParameterList name="spare"><Parameter name="Type" type="string" value="Isotropic"/>'
spare+='<Parameter name="Young'"'"'s Modulus" type="double" value="1"/>'
spare+='<Parameter name="Poisson'"'"'s Ratio" type="double" value="0"/></ParameterList>'
sed "s#<ParameterList name=\"Materials\">#&$spare#" "$name.xml" >spare.xml
for command in "check" "run --output spare"; do
  expect 0 '^1$' sh -c "'$harmos' $command spare.xml 2>&1 | grep -c 'Materials / spare: no part has this material'"
  expect 0 '^1 warning$' "$harmos" $command spare.xml
done
expect 0 'Materials / spare: no part has this material' cat spare/spare_result.json

# A study: its points, samples and scene are inputs, too.
sed "s#value=\"[^\"]*/$name.xml\"#value=\"$name.xml\"#" "$study" >"$(basename "$study")"
study=$(basename "$study")
stem=$(basename "$study" .xml)
expect 0 '' "$harmos" study "$study" --output studies --quiet
cp "studies/$stem.csv" kept.csv
same "$harmos" predict "studies/$stem.h5" --at mu=0.1 --output "studies/$stem.h5"
same "$harmos" predict "studies/$stem.h5" --points kept.csv --output ./kept.csv
same "$harmos" report "studies/$stem.h5" --output "studies/../studies/$stem.h5"
mkdir taken
ln -s "../$study" "taken/${stem}.csv"
same "$harmos" study "$study" --output taken

# Old results stay, with their record, until new ones are there: also when these cannot be written.
cp -r results old
expect 2 'Acuracy' "$harmos" run "$name.xml" --output results --set Solver/Acuracy=1
expect 0 '^$' diff -r results old

# A folder that is removed while a run goes on is missed. On this mesh it takes many seconds.
long=(--set Mesh/Refine=2 --set Solver/Accuracy=1e-10 --set Solver/Algorithm=Plain --set 'Solver/Maximum Iterations=1000000000')
cp -r old removed
"$harmos" run "$name.xml" --output removed --quiet "${long[@]}" >removed.log 2>&1 &
process=$!
for _ in $(seq 200); do
  grep -q '"status": "running"' "removed/${name}_result.json" && break
  sleep 0.05
done
expect 0 '"earlier_run"' cat "removed/${name}_result.json"
for file in .e _interfaces.e _history.csv _effective.xml; do
  expect 0 '^$' cmp "old/$name$file" "removed/$name$file"
done
until rm -rf removed 2>removed.txt; do # something was just being written
  sleep 0.05
done
kill -INT $process
wait $process
expect 0 '^1$' echo $?
expect 0 'Cannot write' cat removed.log
expect 1 '' test -e removed

# Files may not become as large as these want to be (in blocks of 1024 bytes).
for size in 1 8 40; do
  expect 1 'annot' sh -c "ulimit -f $size; '$harmos' run '$scene' --output limited --quiet"
  expect 1 'annot' sh -c "ulimit -f $size; '$harmos' study '$study' --output limited --quiet"
  expect 0 '^$' find limited -name '*.partial.*'
done

expect 1 'Cannot create the directory' "$harmos" run "$scene" --output /proc/none

# What cannot be printed is an error.
for command in "doc" "--help" "check $scene" "run $scene --output full"; do
  expect 0 '^1$' sh -c "'$harmos' $command > /dev/full 2>/dev/null; echo \$?"
done
expect 1 'The output cannot be written' sh -c "'$harmos' doc 2>&1 >/dev/full"
sh -c "'$harmos' run '$scene' --output unread --verbose 2>&1 | true"
for _ in $(seq 200); do
  grep -q '"status": "certified' "unread/${name}_result.json" 2>/dev/null && break
  sleep 0.05
done
expect 0 "" cmp "unread/${name}_history.csv" "full/${name}_history.csv"
expect 0 '' test -s "full/$name.e"
expect 0 '^1$' sh -c "'$harmos' report studies/$stem.h5 --output page.html >/dev/full 2>/dev/null; echo \$?"

[ $failures -eq 0 ] && echo "all as promised"
exit $((failures > 0))
