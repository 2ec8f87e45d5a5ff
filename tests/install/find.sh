#!/usr/bin/env bash
# What find_package(Harmos) takes and refuses, and the same version in the header, the library and harmos.pc.
#
#   find.sh PREFIX WORK_DIR VERSION SOURCE_DIR
set -euo pipefail

prefix=$1 work_dir=$2/find version=$3 source_dir=$4
rm -rf "$work_dir"
mkdir -p "$work_dir"

# found ARGUMENTS OF find_package...: whether Harmos is found
found() {
  mkdir -p "$work_dir/project"
  cat >"$work_dir/project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(Find LANGUAGES C CXX)
set(CMAKE_CXX_EXTENSIONS OFF)
find_package(Harmos $* REQUIRED)
file(WRITE "$work_dir/found" "\${Harmos_VERSION}")
END
  rm -f "$work_dir/found"
  cmake -S "$work_dir/project" -B "$work_dir/build" -DCMAKE_PREFIX_PATH="$prefix" >"$work_dir/log" 2>&1 || return 1
  [ "$(cat "$work_dir/found")" = "$version" ]
}
found "$version" COMPONENTS latin thyra scene || { cat "$work_dir/log"; echo "version $version was not found"; exit 1; }
! found "$version" COMPONENTS latin warp || { echo "a package that there is not was found"; exit 1; }
! found 99.0 || { echo "version 99.0 was found"; exit 1; }

# Without CMake.
cat >"$work_dir/main.cpp" <<'END'
#include <cstring>
#include <iostream>

#include <harmos/files/Version.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/version.hpp>

#if !HARMOS_VERSION_AT_LEAST(0, 0, 9) || HARMOS_VERSION_AT_LEAST(99, 0, 0)
#error "the macros are wrong"
#endif

int main() {
  std::cout << HARMOS_VERSION_STRING << " " << harmos::laws::builtInLaws().forms().size() << " laws\n";
  return std::strcmp(HARMOS_VERSION_STRING, harmos::files::version());
}
END
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
[ "$(pkg-config --modversion harmos)" = "$version" ]
# shellcheck disable=SC2046
c++ "$work_dir/main.cpp" -o "$work_dir/main" $(pkg-config --cflags --libs harmos)
"$work_dir/main"
# The program of the tutorial, which needs the solver with all that it is made of.
# shellcheck disable=SC2046
c++ -O1 "$source_dir/tests/install/consumer/main.cpp" -o "$work_dir/consumer" $(pkg-config --cflags --libs harmos)
"$work_dir/consumer"
