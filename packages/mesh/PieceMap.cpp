#include <harmos/mesh/PieceMap.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::mesh {

PieceMap::PieceMap(const Mesh& mesh, const Elements& elements, const std::vector<Piece>& pieces)
    : pieces_(pieces), piece_(static_cast<std::size_t>(elements.count()), -1) {
  for (int piece = 0; piece < count(); ++piece) {
    for (const int element : pieces[piece].elements) {
      int& owner = piece_[element];
      if (owner >= 0) {
        throw base::Error("Parts \"" + part(owner) + "\" and \"" + part(piece) + "\": both have elements of block \"" +
                              mesh.blocks[elements.block(element)].name + "\"; give every block to one part only.",
                          base::ExitCode::input);
      }
      owner = piece;
    }
  }
}

const std::string& PieceMap::part(int piece) const {
  const Piece& one = pieces_[piece];
  return one.part.empty() ? one.name : one.part;
}

std::vector<int> PieceMap::named(const std::string& where, const std::string& name) const {
  std::vector<int> pieces;
  std::vector<std::string> known;
  for (int piece = 0; piece < count(); ++piece) {
    if (part(piece) == name) pieces.push_back(piece);
    if (known.empty() || known.back() != part(piece)) known.push_back(part(piece));
  }
  if (pieces.empty()) {
    throw base::Error(where + ": there is no part \"" + name + "\". " + base::suggestName(name, known, "Parts"),
                      base::ExitCode::input);
  }
  return pieces;
}

std::vector<int> PieceMap::elements(const std::vector<int>& pieces) const {
  std::vector<int> elements;
  for (const int piece : pieces) {
    const auto& more = pieces_[piece].elements;
    elements.insert(elements.end(), more.begin(), more.end());
  }
  std::sort(elements.begin(), elements.end());
  return elements;
}

}  // namespace harmos::mesh
