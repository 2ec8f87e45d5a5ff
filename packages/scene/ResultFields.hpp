#pragma once

#include <string>
#include <vector>

namespace harmos::scene {

/// A variable of the result files.
struct ResultField {
  std::string name;       // as in the file; of a vector without "_x", "_y" and, in space, "_z"
  std::string unit;       // in brackets, such as "[stress]"
  std::string doc;        // what it is, in a few words
  bool isVector = false;  // has a component per direction
};

/// At the nodes of parts, always.
std::vector<ResultField> nodalPartFields();
/// At the nodes of parts, where "Nodal Stress" is asked for.
std::vector<ResultField> nodalStressFields();
/// Means over the elements of parts.
std::vector<ResultField> elementFields();
/// At the points of interfaces and boundaries, in the order of the file.
std::vector<ResultField> interfaceFields();

/// Their names in a file of this dimension.
std::vector<std::string> namesOf(const std::vector<ResultField>& fields, int dimension);

}  // namespace harmos::scene
