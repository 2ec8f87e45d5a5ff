#!/usr/bin/env bash
# Builds the applications that use Trilinos' optimiser and continuation against an installed Harmos, and runs them.
#
#   analysis.sh PREFIX WORK_DIR [options of cmake]
set -euo pipefail

prefix=$1 work_dir=$2/analysis
shift 2
rm -rf "$work_dir"
cmake -G Ninja -S "$(dirname "$0")/analysis" -B "$work_dir" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release "$@"
cmake --build "$work_dir"
"$work_dir/identification"
"$work_dir/continuation"
