#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <harmos/files/detail/ByteStream.hpp>

namespace harmos::files {

/// Numbers or texts, whichever an attribute or an array of an HDF5 file has; of an array by rows.
struct Hdf5Values {
  bool isText = false;
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// An object of an HDF5 file, with all that is below it.
struct Hdf5Node {
  std::map<std::string, Hdf5Values> attributes;
  Hdf5Values values;                                               // of an array
  std::map<std::string, std::shared_ptr<const Hdf5Node>> members;  // of a group
};

/// Reads a whole file. Throws base::Error (input) when it cannot, if HDF5 does not crash.
Hdf5Node readHdf5(const std::string& path);

void put(ByteWriter& writer, const Hdf5Node& node);
Hdf5Node takeHdf5(ByteReader& reader);

}  // namespace harmos::files
