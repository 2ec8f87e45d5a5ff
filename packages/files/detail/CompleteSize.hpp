#pragma once

#include <cstdint>
#include <istream>

namespace harmos::files {

/// The least number of bytes that a netCDF (classic, 64-bit offset, 64-bit data) or HDF5 file must have, by its own
/// header; the largest number if the header itself is cut off, 0 for other files.
///
/// The libraries read the missing end of a truncated classic file as zeros without an error. Time steps do not count.
/// Source: NetCDF Classic Format Specification (Unidata); HDF5 File Format Specification, section II.A.
std::uint64_t completeSize(std::istream& file);

}  // namespace harmos::files
