#!/usr/bin/env bash
# Builds Harmos as shared libraries, moves what was installed, and runs it.
#
#   shared.sh SOURCE_DIR WORK_DIR [options of cmake]
set -euo pipefail

source_dir=$1 work_dir=$2/shared
shift 2
rm -rf "$work_dir/prefix" "$work_dir/moved" "$work_dir/consumer"
# Seen from its build folder the source lies where it lies seen from that of the static libraries: ccache has the objects.
mkdir -p "$work_dir"
for each in "$source_dir"/*; do
  [ -f "$each/CMakeCache.txt" ] || ln -sfn "$each" "$work_dir/$(basename "$each")"
done
cmake -G Ninja -S "$work_dir" -B "$work_dir/build" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON \
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
# An application that links them.
cmake -G Ninja -S "$source_dir/tests/install/consumer" -B "$work_dir/consumer" -DCMAKE_PREFIX_PATH="$work_dir/moved" \
  -DCMAKE_BUILD_TYPE=Release
cmake --build "$work_dir/consumer" --target consumer
"$work_dir/consumer/consumer"
