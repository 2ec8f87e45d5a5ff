#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace harmos::files {

/// Coordinates x, y, z [length] of `count` nodes in an open Exodus file; 0 along axes that its mesh has not.
struct ExodusCoordinates {
  int status = 0;  ///< negative: reading failed, Exodus or netCDF knows why
  std::array<std::vector<double>, 3> axis;
};

/// Reads them as ex_get_coord, which takes the netCDF variable of number 0 for a missing one: where the coordinates are
/// the first variable of a file, as programs write that do not use Exodus itself, it leaves them out without an error.
ExodusCoordinates readCoordinates(int exodus, std::size_t count);

}  // namespace harmos::files
