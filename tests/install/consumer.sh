#!/usr/bin/env bash
# Installs a build of Harmos, then configures, builds and runs the consumer project against it.
#
#   consumer.sh BUILD_DIR WORK_DIR [options of cmake]
set -euo pipefail

build_dir=$1 work_dir=$2
shift 2
source_dir=$(cd "$(dirname "$0")/consumer" && pwd)
prefix=$work_dir/prefix
rm -rf "$prefix" "$work_dir/consumer"
cmake --install "$build_dir" --prefix "$prefix" >/dev/null
cmake -G Ninja -S "$source_dir" -B "$work_dir/consumer" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@"
cmake --build "$work_dir/consumer"
"$work_dir/consumer/consumer"
mpirun -np 2 "$work_dir/consumer/consumer"
"$work_dir/consumer/conformance" --gtest_brief=1
"$prefix/bin/harmos" --version

# The scripts are found where they were installed.
"$prefix/bin/harmos" study "$(dirname "$source_dir")/../study/sliding_blocks_study.xml" --output "$work_dir/study" --restart --quiet
"$prefix/bin/harmos" report "$work_dir/study/sliding_blocks_study.h5"
