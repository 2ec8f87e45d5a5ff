#include <harmos/files/detail/ExodusCoordinates.hpp>

#include <algorithm>

#include <exodusII.h>
#include <netcdf.h>

namespace harmos::files {

ExodusCoordinates readCoordinates(int exodus, std::size_t count) {
  ExodusCoordinates result;
  for (auto& axis : result.axis) axis.assign(count, 0.0);
  if (count == 0) return result;
  double* const to[] = {result.axis[0].data(), result.axis[1].data(), result.axis[2].data()};
  result.status = ex_get_coord(exodus, to[0], to[1], to[2]);
  constexpr const char* names[] = {"coordx", "coordy", "coordz"};
  for (int i = 0; i < 3 && result.status >= 0; ++i) {
    int variable = -1;
    if (nc_inq_varid(exodus, names[i], &variable) == NC_NOERR && variable == 0)
      result.status = std::min(0, nc_get_var_double(exodus, variable, to[i]));
  }
  return result;
}

}  // namespace harmos::files
