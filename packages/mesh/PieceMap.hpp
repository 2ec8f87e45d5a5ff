#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// Which part, or which piece of a part that was cut, the elements of a mesh belong to. Keeps a reference to the
/// pieces: they must outlive it and stay as they are. Pieces and elements are numbered from 0, as in their lists.
class PieceMap {
 public:
  /// Throws base::Error(input) if two parts share an element.
  PieceMap(const Mesh& mesh, const Elements& elements, const std::vector<Piece>& pieces);

  /// How many pieces there are.
  int count() const { return static_cast<int>(pieces_.size()); }
  /// Piece of an element; -1 if it is in no part.
  int of(int element) const { return piece_[element]; }
  /// Name of the part before it was cut.
  const std::string& part(int piece) const;
  /// The pieces of a part, ascending. Throws base::Error(input), starting with `where`, if there is no such part.
  std::vector<int> named(const std::string& where, const std::string& name) const;
  /// Mesh element numbers of some pieces, ascending.
  std::vector<int> elements(const std::vector<int>& pieces) const;
  /// Whether a piece has a mesh node.
  bool has(int piece, int node) const { return localNode(pieces_[piece], node) >= 0; }

 private:
  const std::vector<Piece>& pieces_;
  std::vector<int> piece_;
};

}  // namespace harmos::mesh
