#pragma once

#include <string>

#include <harmos/elasticity/detail/PartElements.hpp>

namespace harmos::elasticity {

/// Collects the elements of a part that cannot be integrated over, for one message about all of them.
class ElementFaults {
 public:
  /// Keeps references to both.
  ElementFaults(const mesh::Mesh& mesh, const mesh::Piece& piece) : mesh_(mesh), piece_(piece) {}

  /// Element `number` of the group has a Jacobian that is not positive.
  void add(const ElementGroup& group, int number);
  /// Throws base::Error (input) that counts the elements and says of the first what is wrong: the order of its corners,
  /// or which node in the middle of an edge or a face is how far out of place.
  void throwIfAny() const;

 private:
  const mesh::Mesh& mesh_;
  const mesh::Piece& piece_;
  int count_ = 0;
  std::string first_;
};

}  // namespace harmos::elasticity
