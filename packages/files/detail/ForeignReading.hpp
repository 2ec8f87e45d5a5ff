#pragma once

#include <functional>
#include <string>
#include <vector>

#include <harmos/files/detail/ByteStream.hpp>

namespace harmos::files {

/// Reads `paths`, files that somebody else may have written or damaged, in a child process: netCDF and HDF5 crash, hang
/// or ask for any amount of memory where a file is not as it should be, and only the child is lost.
///
/// `read` does all reading, in the child, and writes what it has learned; `take` then reads that, here. The child may
/// take processor time and memory in proportion to the size of the files. It is a copy of this process, not a new
/// program, so that hosts need nothing beside the library; it uses neither MPI nor other threads. Descriptors that are
/// open stay open in it; what it prints is lost.
///
/// Throws base::Error: that of `read` as it is; (input) with the cause when the child died or was ended; the plain one
/// when there can be no child. Not collective.
void readForeign(const std::vector<std::string>& paths, const std::function<void(ByteWriter&)>& read,
                 const std::function<void(ByteReader&)>& take);

}  // namespace harmos::files
