#!/usr/bin/env bash
# Checks that results that cannot be written where they are wanted are refused by every verb before it begins: with
# exit code 2, with the path and the way out, and with nothing changed.
#
#   outputs.sh HARMOS SCENE.xml STUDY.xml WORK_DIR
#
# SCENE makes its own mesh and is solved in a fraction of a second; STUDY is about it.
set -uo pipefail

harmos=$1 scene=$2 study=$3 work=$4
name=$(basename "$scene" .xml) stem=$(basename "$study" .xml)
rm -rf "$work"
mkdir -p "$work"
. "$(dirname "$0")/../expect.sh"
cd "$work" || exit 1

"$harmos" run "$scene" --output results --quiet
"$harmos" mesh "$scene" --output mesh.e --quiet
"$harmos" study "$study" --output studies --quiet
echo "in the way" >file
mkfifo pipe
ln -s nowhere/at/all dangling
long=$(printf 'x%.0s' {1..250})

snapshot() { find . \( -type f -o -type l -o -type d \) | sort | xargs ls -dlU --time-style=full-iso; }

# refused PATTERN COMMAND...: exit code 2 with the pattern and a way out, and nothing has changed.
refused() {
  local before output status pattern=$1
  shift
  before=$(snapshot)
  output=$("$@" 2>&1)
  status=$?
  for wanted in "$pattern" 'another folder' 'Nothing was written'; do
    expect 0 "$wanted" echo "$*: $output"
  done
  expect 0 '^2$' echo $status
  if [ "$before" != "$(snapshot)" ]; then
    echo "FAILED: $* has changed files"
    failures=$((failures + 1))
  fi
}

folders=("run $scene" "study $study" "import mesh.e" "export results/$name.e" "trade $scene"
         "report studies/$stem.h5 --output page.html --pictures")
for command in "${folders[@]}"; do
  case $command in *--pictures) option= ;; *) option=--output ;; esac
  refused 'file is no folder' "$harmos" $command $option file
  refused 'file is no folder' "$harmos" $command $option file/below
  refused 'pipe is no folder' "$harmos" $command $option pipe
  refused 'dangling is a link to what is not there' "$harmos" $command $option dangling
  refused 'is too long' "$harmos" $command $option "$long$long"
done

mkdir folder
files=("mesh $scene" "picture results/$name.e" "show results/$name.e" "report studies/$stem.h5"
       "predict studies/$stem.h5 --at mu=0.4 --at pressure=20")
for command in "${files[@]}"; do
  refused 'it is a folder' "$harmos" $command --output folder
  refused 'it names a folder' "$harmos" $command --output new/
  refused 'file is no folder' "$harmos" $command --output file/below
  refused 'dangling is a link to what is not there' "$harmos" $command --output dangling/new
  refused 'its name is too long' "$harmos" $command --output "$long.e"
  refused 'no file, but a device' "$harmos" $command --output pipe
  refused 'no file, but a device' "$harmos" $command --output /dev/null
done

# Also in folders that are not there.
cp "$scene" "$long.xml"
for output in new new/below; do
  refused "$long.e cannot be written: its name is too long" "$harmos" run "$long.xml" --output $output
  refused 'is too long' "$harmos" run "$scene" --output "$output/$long$long"
done

# A folder of the name of a result.
mkdir -p taken/{"$name.e","${name}_trade.html","$stem.h5",mesh.xml,"${name}_interfaces.pvd"}
refused "taken/$name.e cannot be written: it is a folder" "$harmos" run "$scene" --output taken
refused "taken/$stem.h5 cannot be written: it is a folder" "$harmos" study "$study" --output taken
refused "taken/mesh.xml cannot be written: it is a folder" "$harmos" import mesh.e --output taken
refused "taken/${name}_trade.html cannot be written: it is a folder" "$harmos" trade "$scene" --output taken
refused "taken/${name}_interfaces.pvd cannot be written: it is a folder" "$harmos" export "results/$name.e" --output taken

# The record is read for what it says of the result.
cp -r results kept
refused 'would replace the input' "$harmos" picture "results/$name.e" --output "results/${name}_result.json"
refused 'would replace the input' "$harmos" show "results/$name.e" --output "results/${name}_result.json"
expect 0 '^$' diff -r results kept

# One message of two ranks.
expect 0 '^1$' sh -c "mpirun -np 2 '$harmos' run '$scene' --output file 2>&1 | grep -c 'file is no folder'"

# Folders that are not there are made.
expect 0 '' "$harmos" run "$scene" --output some/where --quiet
expect 0 '' "$harmos" mesh "$scene" --output some/where/else/mesh.e --quiet
expect 0 '' "$harmos" picture "results/$name.e" --output some/where/else/picture.png
expect 0 '' "$harmos" report "studies/$stem.h5" --output some/thing/page.html
expect 0 '' "$harmos" import mesh.e --output some/other/place

# Whom nobody lets write there; root may everywhere.
if [ "$(id -u)" -ne 0 ]; then
  mkdir -m 555 locked
  refused 'locked: Permission denied' "$harmos" run "$scene" --output locked
  refused 'locked: Permission denied' "$harmos" mesh "$scene" --output locked/new/mesh.e
fi

[ $failures -eq 0 ] && echo "all as promised"
exit $((failures > 0))
