#!/usr/bin/env bash
# Runs a scene and compares its results with the gold; called by ctest, see harmos_regression_test().
#
#   run.sh HARMOS LAUNCHER CASE_DIR OUTPUT_DIR SCENE [options of "harmos run"]
#   run.sh --make-gold HARMOS CASE_DIR OUTPUT_DIR SCENE [options of "harmos run"]
#
# LAUNCHER is empty or the words that start several ranks. CASE_DIR holds gold/ and the tolerances parts.cmp and
# interfaces.cmp. Gold is made only by the second form.
set -euo pipefail

if [ "$1" = --make-gold ]; then
  harmos=$2 case_dir=$3 output_dir=$4 scene=$5
  shift 5
  "$harmos" run "$scene" --output "$output_dir" --quiet "$@"
  mkdir -p "$case_dir/gold"
  name=$(basename "$scene" .xml)
  cp "$output_dir/$name.e" "$case_dir/gold/parts.e"
  cp "$output_dir/${name}_interfaces.e" "$case_dir/gold/interfaces.e"
  echo "made the gold in $case_dir/gold; look at it before you commit it"
  exit
fi

harmos=$1 launcher=$2 case_dir=$3 output_dir=$4 scene=$5
shift 5
for file in parts interfaces; do
  if [ ! -f "$case_dir/gold/$file.e" ]; then
    echo "missing gold: $case_dir/gold/$file.e; build the target gold_$(basename "$case_dir") to make it"
    exit 1
  fi
done
# shellcheck disable=SC2086  # the launcher is several words
$launcher "$harmos" run "$scene" --output "$output_dir" --quiet "$@"
name=$(basename "$scene" .xml)
status=0
"$harmos" compare "$case_dir/gold/parts.e" "$output_dir/$name.e" --tolerances "$case_dir/parts.cmp" || status=1
"$harmos" compare "$case_dir/gold/interfaces.e" "$output_dir/${name}_interfaces.e" \
  --tolerances "$case_dir/interfaces.cmp" || status=1
exit $status
