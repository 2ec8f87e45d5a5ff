#!/usr/bin/env bash
# Builds Harmos as shared libraries, moves what was installed, and runs it.
#
#   shared.sh SOURCE_DIR WORK_DIR [options of cmake]
set -euo pipefail

source_dir=$1 work_dir=$2/shared
shift 2
rm -rf "$work_dir/prefix" "$work_dir/moved"
cmake -G Ninja -S "$source_dir" -B "$work_dir/build" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON \
  -DHARMOS_TESTS=OFF "$@"
cmake --build "$work_dir/build"
cmake --install "$work_dir/build" --prefix "$work_dir/prefix" >/dev/null
mv "$work_dir/prefix" "$work_dir/moved"
mv "$work_dir/build" "$work_dir/gone"  # nothing may be found there
trap 'mv "$work_dir/gone" "$work_dir/build"' EXIT
libraries=$(ldd "$work_dir/moved/bin/harmos" | grep -c "$work_dir/moved.*libharmos_")
[ "$libraries" -gt 10 ] || { echo "only $libraries shared libraries are used"; exit 1; }
# Laws, responses and designs are known, though no file names them at start.
"$work_dir/moved/bin/harmos" doc "Coulomb Friction" | grep -q "Friction Coefficient"
"$work_dir/moved/bin/harmos" run "$source_dir/tests/regression/sliding_blocks/sliding_blocks.xml" \
  --output "$work_dir/results" --quiet
