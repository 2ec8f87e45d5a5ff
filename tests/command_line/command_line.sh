#!/usr/bin/env bash
# Checks what the program promises on its command line: exit codes, messages, and which files it leaves.
#
#   command_line.sh HARMOS SCENE.xml LARGE_SCENE.xml WORK_DIR
#
# SCENE is solved in a fraction of a second; LARGE_SCENE takes long enough to be interrupted.
set -uo pipefail

harmos=$1 scene=$2 large_scene=$3 work=$4
name=$(basename "$scene" .xml)
rm -rf "$work"
mkdir -p "$work"
. "$(dirname "$0")/../expect.sh"

expect 0 '^harmos [0-9]*\.[0-9]*\.[0-9]*$' "$harmos" --version
# Alone it starts no daemon of Open MPI, which would not be found there.
expect 0 '^harmos ' env -u OMPI_MCA_ess_singleton_isolated OPAL_BINDIR="$work/nothing" "$harmos" --version
expect 0 'Exit codes' "$harmos" --help
expect 2 'Usage' "$harmos"
for verb in run check doc mesh compare study report predict import picture show export trade; do
  expect 0 "harmos $verb" "$harmos" $verb --help
done
expect 2 'unknown command "rum". Did you mean "run"' "$harmos" rum
expect 2 'unknown option "--ouput". Did you mean "--output"' "$harmos" run "$scene" --ouput x
expect 2 'SCENE.xml' "$harmos" run
expect 2 'no_such_scene.xml' "$harmos" run no_such_scene.xml
expect 0 'Accuracy' "$harmos" doc Solver
expect 2 'Solvre' "$harmos" doc Solvre
expect 0 'is valid' "$harmos" check "$scene"
expect 0 'nodes' "$harmos" mesh "$scene" --output "$work/mesh.e"
expect 0 'are the same' "$harmos" compare "$work/mesh.e" "$work/mesh.e"
expect 2 'not an Exodus file' "$harmos" compare "$work/mesh.e" "$scene"

# Bad input leaves nothing, and does not touch what is there.
mkdir "$work/bad"
expect 2 'Acuracy' "$harmos" run "$scene" --output "$work/bad" --set Solver/Acuracy=1
expect 0 '^$' ls "$work/bad"

# A run replaces all of its files; a second one gives the same.
mkdir "$work/first"
for file in .e _interfaces.e _history.csv _effective.xml _result.json; do echo stale >"$work/first/$name$file"; done
expect 0 'certified' "$harmos" run "$scene" --output "$work/first"
grep -l -r '^stale$' "$work/first" && failures=$((failures + 1))
expect 0 '"status": "certified"' cat "$work/first/${name}_result.json"
expect 0 '^step,time,' head -n 1 "$work/first/${name}_history.csv"
expect 0 '' "$harmos" run "$scene" --output "$work/second" --quiet
expect 0 'are the same' "$harmos" compare "$work/first/$name.e" "$work/second/$name.e"

# A solver that does not exist is bad input like any other: what is there stays.
bad_solver=(--set 'Solver/Linear Solver/Name=choldmo')
expect 2 'Solver / Linear Solver / Name: there is no direct solver "choldmo"' "$harmos" check "$scene" "${bad_solver[@]}"
cp -r "$work/first" "$work/kept"
expect 2 'Solver / Linear Solver / Name: ' "$harmos" run "$scene" --output "$work/kept" "${bad_solver[@]}"
expect 0 '^$' diff -r "$work/first" "$work/kept"

# The effective input is a scene that gives the same results again.
expect 0 '' "$harmos" run "$work/first/${name}_effective.xml" --output "$work/again" --quiet
expect 0 'are the same' "$harmos" compare "$work/first/$name.e" "$work/again/${name}_effective.e"

# Ended at the iteration limit: says so, and the files of the last state are there.
expect 3 'iteration' "$harmos" run "$scene" --output "$work/limit" --set 'Solver/Maximum Iterations=2'
expect 0 '"status": "not converged"' cat "$work/limit/${name}_result.json"
expect 0 '' test -s "$work/limit/$name.e"

# However many ranks meet it, one message tells that nothing holds the parts, with numbers that mean something; without
# loads that lack a balance it is no lack of equilibrium.
floating=$(dirname "$0")/floating_blocks.xml
for ranks in 1 2; do
  expect 1 'smallest eigenvalue of the macro problem [-0-9.]*[1-9][0-9.]*e-[0-9]*)' \
    mpirun -np $ranks "$harmos" run "$floating" --output "$work/floating"
  expect 0 '^1$' sh -c "mpirun -np $ranks '$harmos' run '$floating' --output '$work/floating' 2>&1 | grep -c 'nothing holds'"
done

expect 0 '"error_estimate": null' cat "$work/floating/floating_blocks_result.json"

# Load steps that were not solved are no copies of the last one: they are left out, and the record says which was the last.
pulled=$(dirname "$0")/pulled_off.xml
expect 4 'the last load step that was solved, and is written, is 2 of 4, time 2' "$harmos" run "$pulled" --output "$work/pulled"
expect 0 '^2,2,' tail -n 1 "$work/pulled/pulled_off_history.csv"
expect 0 '"solved_steps": 2' cat "$work/pulled/pulled_off_result.json"
expect 0 '^3$' sh -c "ncdump -h '$work/pulled/pulled_off.e' | sed -n 's/.*time_step = UNLIMITED ; .. (\([0-9]*\) currently)/\1/p'"
# A response that is determined at the last load step only says where it is not.
expect 0 'drag along x .* not unique at load step 1: from -75 to 75' "$harmos" run "$(dirname "$0")/../extremes/driven_block.xml" \
  --output "$work/driven"
# What readers choke on is not written.
expect 3 'field "von_mises", load step 1: a value is not finite' "$harmos" run "$pulled" --output "$work/endless" \
  --set Boundaries/ground/Law/X=1e300
expect 0 '^pulled_off_result.json$' ls "$work/endless"
# A response that is next to nothing has its absolute error beside it, and what it is small beside; or a scale of its own.
only_pressed=(--set 'Histories/press and pull/Values={1, 2, 3, 4}')
expect 0 'sideways .*+- .*counts as zero: not above 0.' "$harmos" run "$pulled" --output "$work/pulled" "${only_pressed[@]}"
expect 0 'sideways .*counts as zero: not above 7$' "$harmos" run "$pulled" --output "$work/pulled" \
  "${only_pressed[@]}" --set Responses/sideways/Scale=7
expect 2 'Responses / sideways / Scale' "$harmos" check "$pulled" --set Responses/sideways/Scale=0

# What is foreseen not to fit into the memory is refused before it is made, and nothing is written.
# (Sanitizers take all address space.)
glued=$(dirname "$large_scene")/glued_assembly.xml
if [ -z "${ASAN_OPTIONS:-}" ]; then
  expect 2 'Take a coarser mesh' sh -c "ulimit -v 8000000; '$harmos' check '$glued' --set 'Mesh/Cell Size=0.01'"
  expect 2 'Take a coarser mesh' \
    sh -c "ulimit -v 8000000; '$harmos' run '$glued' --set 'Mesh/Cell Size=0.01' --output '$work/huge'"
  # Threads of OpenBLAS that get no memory would keep the program from its end.
  expect 0 'is valid' sh -c "ulimit -v 320000; unset OPENBLAS_NUM_THREADS OMP_NUM_THREADS; timeout 60 '$harmos' check '$pulled'"
  expect 2 'of which .* are free' \
    sh -c "ulimit -v 800000; '$harmos' run '$large_scene' --set Mesh/Refinement=2 --output '$work/huge'"
  expect 1 '' test -e "$work/huge"
  # OpenBLAS that gets no buffer would keep it, too.
  expect 1 'not enough memory' \
    sh -c "ulimit -v 300000; timeout 60 '$harmos' run '$pulled' --any-size --output '$work/huge'"
  expect 1 '' test -e "$work/huge"
fi

# Interrupted after some iterations: says so, and the files of the last state are readable.
name=$(basename "$large_scene" .xml)
"$harmos" run "$large_scene" --output "$work/interrupted" --verbose --set Solver/Accuracy=1e-10 \
  --set Solver/Algorithm=Plain --set 'Solver/Maximum Iterations=1000000' >/dev/null 2>"$work/interrupted.log" &
for _ in $(seq 300); do
  grep -q 'iteration 3' "$work/interrupted.log" && break
  sleep 0.1
done
expect 0 '"status": "running"' cat "$work/interrupted/${name}_result.json"
kill -INT $!
wait $!
expect 0 '^130$' echo $?
expect 0 '"status": "interrupted"' cat "$work/interrupted/${name}_result.json"
expect 0 'are the same' "$harmos" compare "$work/interrupted/$name.e" "$work/interrupted/$name.e"

[ $failures -eq 0 ] && echo "all as promised"
exit $((failures > 0))
