#!/usr/bin/env bash
# Checks what `harmos study` and `harmos report` promise: exit codes, messages, which files they leave, resuming.
#
#   study.sh HARMOS STUDY.xml WORK_DIR
#
# STUDY is that of this folder: 27 configurations that take less than a second together.
set -uo pipefail

harmos=$1 study=$2 work=$3
name=$(basename "$study" .xml)
rm -rf "$work"
mkdir -p "$work"
. "$(dirname "$0")/../expect.sh"

expect 0 'Latin Hypercube' "$harmos" doc Design
expect 0 '27 configurations' "$harmos" check "$study"
expect 2 'sliding_blocks.xml is a scene' "$harmos" study "$(dirname "$study")/../regression/sliding_blocks/sliding_blocks.xml"

expect 2 'is a study' "$harmos" run "$study"
expect 2 "Write --set 'Scene/Materials/steel/Poisson's Ratio=0'" "$harmos" study "$study" --output "$work/none" \
  --set "Materials/steel/Poisson's Ratio=0"

# The whole study, and a single configuration against the same scene solved by itself.
expect 0 'complete, 27 of 27 configurations: ' "$harmos" study "$study" --output "$work/all"
expect 0 '3 more are left out by the condition "not too tight"' "$harmos" check "$study"
expect 2 '^--set: Conditions / not too tight / Formula: the formula "log(mu - 9) < 1" has no value at mu = ' \
  "$harmos" check "$study" --set 'Conditions/not too tight/Formula=log(mu - 9) < 1'
expect 0 '^id,mu,pressure,push,status,iterations,error_estimate,start,u_max,lost,u_2$' head -n 1 "$work/all/$name.csv"
expect 0 '^28$' sh -c "wc -l <'$work/all/$name.csv'"
expect 0 '^%eval_id interface mu pressure push u_max lost u_2$' head -n 1 "$work/all/${name}_dakota.dat"
scene=$(dirname "$study")/../regression/sliding_blocks/sliding_blocks.xml
expect 0 certified "$harmos" run "$scene" --output "$work/one" --set 'Interfaces/contact/Law/Friction Coefficient=0.35' \
  --set Boundaries/top/Law/Pressure=22 --set Boundaries/push/Law/X=17.6
expect 0 '^(8,) 4.0$' env PYTHONPATH="$(dirname "$0")/../../packages/python" /usr/bin/python3 -c '
import harmos, sys
history = harmos.read_history(sys.argv[1])
print(history["u_push"].shape, history["time"][-1])' "$work/one/sliding_blocks_history.csv"
alone=$(awk -F, 'NR > 1 && $3 > m { m = $3 } END { print m }' "$work/one/sliding_blocks_history.csv")
expect 0 '^same$' awk -F, -v alone="$alone" '$2 == 0.35 && $3 == 22 {
  d = $9 / alone - 1; print (d * d < 4e-8) ? "same" : "u_max = " $9 ", alone " alone }' "$work/all/$name.csv"

# Nothing to do: done points are not solved again.
results=$(grep -c '"id"' "$work/all/$name.journal")
expect 0 '27 of them are known from an earlier run' "$harmos" study "$study" --output "$work/all"
expect 0 "^$results\$" grep -c '"id"' "$work/all/$name.journal"

# A changed study or scene is refused, naming what differs; with --restart it starts over.
expect 2 'Study / Accuracy = 0.001, was 1e-04' "$harmos" study "$study" --output "$work/all" --set Accuracy=1e-3
expect 2 'Materials / steel / Young.s Modulus = 2e+05, was 210000' "$harmos" study "$study" --output "$work/all" \
  --set "Scene/Materials/steel/Young's Modulus=2e5"
expect 0 'complete, 6 of 6' "$harmos" study "$study" --output "$work/all" --set Parameters/mu/Count=1 --restart

# Points from a table instead of the design.
printf 'pressure,mu\n20,0.3\n21.5,0.42\n' >"$work/points.csv"
expect 0 'complete, 2 of 2' "$harmos" study "$study" --output "$work/points" --points "$work/points.csv"
expect 0 '^2,0.42,21.5,17.2' grep '^2,' "$work/points/$name.csv"
printf 'pressure,mu\n20,0.3\n21.5,zero\n' >"$work/wrong.csv"
expect 2 'wrong.csv:3: mu: "zero" is not a finite number' "$harmos" study "$study" --output "$work/wrong" --points "$work/wrong.csv"
expect 1 '' test -e "$work/wrong"
expect 2 'Checksum of the points' sh -c "sed -i s/21.5/22.5/ '$work/points.csv'; '$harmos' study '$study' --output '$work/points' --points '$work/points.csv'"

# Other designs.
for design in Random 'Latin Hypercube' Sobol; do
  expect 0 'complete, ' "$harmos" study "$study" --output "$work/designs" --restart --set "Design/Type=$design" \
    --set Design/Count=4
done

# An adaptive design reaches its tolerance, and a second run has nothing to add.
adaptive=(--set Design/Type=Adaptive --set Design/Response=u_max --set Design/Tolerance=0.01)
expect 0 'surface of u_max: reached: within ' "$harmos" study "$study" --output "$work/adaptive" "${adaptive[@]}"
rows=$(wc -l <"$work/adaptive/$name.csv")
expect 0 'surface of u_max: reached: within ' "$harmos" study "$study" --output "$work/adaptive" "${adaptive[@]}"
expect 0 "^$rows " wc -l "$work/adaptive/$name.csv"

# One that does not reach it, also when it is asked again, does not end as if it had.
short=("${adaptive[@]}" --set Design/Tolerance=1e-5 --set 'Design/Maximum Count=14')
expect 3 'surface of u_max: not reached: ' "$harmos" study "$study" --output "$work/short" "${short[@]}"
expect 3 'surface of u_max: not reached: ' "$harmos" study "$study" --output "$work/short" "${short[@]}"

# A configuration that violates a range is recorded with its reason; the others are solved.
printf 'pressure,mu\n20,0.3\n20,-1\n20,0.31\n' >"$work/range.csv"
expect 3 '2 certified, 1 inadmissible\|1 inadmissible' "$harmos" study "$study" --output "$work/range" --points "$work/range.csv"
expect 0 '^2,-1,20,16,inadmissible,0,,0,,,$' grep '^2,' "$work/range/$name.csv"

# Where none is admissible there is nothing to solve, and nothing is written; check says so, too.
nowhere=(--set Parameters/mu/From=-2 --set Parameters/mu/To=-1)
expect 2 'no configuration is admissible' "$harmos" check "$study" "${nowhere[@]}"
expect 2 'no configuration is admissible' "$harmos" study "$study" --output "$work/nowhere" "${nowhere[@]}"
expect 1 '' test -e "$work/nowhere"

# A sample of two values has few polynomials; Sobol' indices take those that there are.
expect 0 "by least squares of order 1" "$harmos" study "$(dirname "$0")/two_values_study.xml" --output "$work/two"
expect 0 '^complete$' "$(dirname "$0")/state.py" "$work/two/two_values_study.h5"

# One that does not converge is tried again, recorded, replaced, or ends the study, as the policy says.
hopeless=(--points "$work/hopeless.csv" --set 'Scene/Solver/Maximum Iterations=2')
printf 'pressure,mu\n20,0.3\n20,0.31\n' >"$work/hopeless.csv"
expect 3 '2 not converged' "$harmos" study "$study" --output "$work/retry" "${hopeless[@]}"
expect 3 '^  configuration 1.* not converged: .' "$harmos" study "$study" --output "$work/retry" --quiet "${hopeless[@]}"
expect 3 '^no error estimate (asked for ' "$harmos" study "$study" --output "$work/retry" "${hopeless[@]}"
expect 0 'Again from a cold start' cat "$work/retry/$name.journal"
expect 1 '^aborted, ' "$harmos" study "$study" --output "$work/abort" "${hopeless[@]}" \
  --set 'Failure Policy/Type=Abort'
expect 3 '2 not converged' "$harmos" study "$study" --output "$work/recover" "${hopeless[@]}" \
  --set 'Failure Policy/Type=Recover' --set 'Failure Policy/Values={1, 2, 3}'
expect 0 'not converged,.*,1,2,3$' grep '^2,' "$work/recover/$name.csv"
expect 3 '2 not converged' "$harmos" study "$study" --output "$work/walk" "${hopeless[@]}" \
  --set 'Failure Policy/Type=Continuation'

# A material changes the operators: configurations are grouped by it.
expect 0 'with 2 different operators' "$harmos" study "$study" --output "$work/operators" --set Parameters/mu/Count=2 \
  --set "Parameters/mu/Entry=Materials/steel/Poisson's Ratio" --set 'Conditions/not too tight/Formula=1' \
  --set 'Parameters/pressure/Values={20, 21}' --set Parameters/mu/From=0.2 --set Parameters/mu/To=0.3

# Two processes: the second is refused, naming the first. Then the first is interrupted and leaves readable files.
long=(--set Parameters/mu/Count=400 --set Accuracy=1e-6 --quiet --output "$work/long")
"$harmos" study "$study" "${long[@]}" &
first=$!
for _ in $(seq 100); do
  [ -f "$work/long/$name.h5" ] && break
  sleep 0.1
done
expect 2 "is in use by process $first on " "$harmos" study "$study" "${long[@]}"
kill -INT $first
wait $first
expect 0 '^130$' echo $?
expect 0 ',open,' cat "$work/long/$name.csv"
expect 0 '^interrupted$' "$(dirname "$0")/state.py" "$work/long/$name.h5"

# However ranks are split into teams, the same responses come out.
rm -rf "$work/all"
expect 0 '' "$harmos" study "$study" --output "$work/all" --quiet
for layout in '2 1' '2 2' '4 2'; do
  read -r ranks each <<<"$layout"
  expect 0 'complete, 27 of 27' mpirun -np "$ranks" "$harmos" study "$study" --output "$work/ranks" --restart \
    --ranks-per-configuration "$each"
  differing=$(awk -F, 'NR == FNR { u[$1] = $9; next } FNR > 1 && ($9 / u[$1] - 1) ^ 2 > 4e-8' "$work/all/$name.csv" "$work/ranks/$name.csv")
  expect 0 '^$' echo "$differing"
done
expect 2 '3 ranks cannot be split into teams of 2' mpirun -np 3 "$harmos" study "$study" --output "$work/ranks" \
  --ranks-per-configuration 2

for count in x 0 -1 1.5; do
  expect 2 "--ranks-per-configuration $count: write a whole number above 0" "$harmos" study "$study" \
    --output "$work/ranks" --ranks-per-configuration=$count
done

# An interrupted study on several teams leaves readable files, too.
mpirun -np 2 "$harmos" study "$study" --output "$work/teams" --quiet --set Parameters/mu/Count=400 --set Accuracy=1e-6 &
first=$!
for _ in $(seq 100); do
  [ -f "$work/teams/$name.h5" ] && break
  sleep 0.1
done
sleep 1
kill -INT $first
wait $first
expect 0 ',certified,\|,calibrated,' cat "$work/teams/$name.csv"
expect 0 '^interrupted$' "$(dirname "$0")/state.py" "$work/teams/$name.h5"

# The response surface, by the program and by the Python module.
at=(--at mu=0.37 --at pressure=21.3)
expect 0 '^mu,pressure,u_max,u_max_deviation,lost,lost_deviation,u_2,u_2_deviation,extrapolated$' \
  "$harmos" predict "$work/all/$name.h5" "${at[@]}"
expect 0 '^same$' "$(dirname "$0")/surface.py" "$harmos" "$work/all/$name.h5"
expect 2 'there is no value of "pressure"' "$harmos" predict "$work/all/$name.h5" --at mu=0.37
expect 2 'the value of "mu" is given twice' "$harmos" predict "$work/all/$name.h5" "${at[@]}" --at mu=0.3
expect 2 'the study varies no "nu".' "$harmos" predict "$work/all/$name.h5" --at nu=0.37
expect 2 'too few solutions' "$harmos" predict "$work/retry/$name.h5" --at mu=0.3

# The report, of a grid, of scattered points, and of a study that was interrupted.
for result in "$work/designs" "$work/long" "$work/retry"; do
  expect 0 "$name.html" "$harmos" report "$result/$name.h5"
  expect 0 '</html>' tail -n 1 "$result/$name.html"
done
expect 2 'no_such.h5' "$harmos" report no_such.h5
expect 0 "$work/all/$name.html" "$harmos" report "$work/all/$name.h5" --abscissa friction_force --pictures "$work/pictures"
expect 0 'u_max_effects.png' ls "$work/pictures"
expect 2 'there is no curve' "$harmos" report "$work/all/$name.h5" --abscissa u

# HDF5 itself would crash on some damages.
cp "$work/all/$name.h5" "$work/damaged.h5"
printf 'damage' | dd of="$work/damaged.h5" bs=1 seek=9000 conv=notrunc status=none
expect 2 'damaged.h5 is no file of a study, or was damaged or changed' "$harmos" report "$work/damaged.h5"
expect 2 'damaged.h5 is no file of a study, or was damaged or changed' "$harmos" predict "$work/damaged.h5" "${at[@]}"

[ $failures -eq 0 ] && echo "all as promised"
exit $((failures > 0))
