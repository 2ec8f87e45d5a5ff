#include <harmos/scene/detail/PartPieces.hpp>

#include <algorithm>

namespace harmos::scene {
namespace {

std::string nameOf(const mesh::Piece& piece) {
  if (piece.side == 0) return piece.part;
  return piece.part + (piece.side < 0 ? " behind its cut" : " beyond its cut");
}

}  // namespace

std::vector<PartPieces> partPieces(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces) {
  std::vector<PartPieces> parts;
  for (std::size_t b = 0; b < pieces.size(); ++b) {
    const mesh::Piece& piece = pieces[b];
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const PartPieces& part) { return part.name == nameOf(piece); });
    PartPieces& part = found != parts.end() ? *found : parts.emplace_back();
    part.name = nameOf(piece);
    part.piece.part = piece.part;
    part.bodies.push_back(static_cast<int>(b));
    part.piece.elements.insert(part.piece.elements.end(), piece.elements.begin(), piece.elements.end());
  }
  for (PartPieces& part : parts) {
    if (part.bodies.size() == 1) {  // whose nodes need not be found anew
      part.piece = pieces[static_cast<std::size_t>(part.bodies.front())];
      part.piece.name = part.name;
      part.piece.side = 0;
      continue;
    }
    std::sort(part.piece.elements.begin(), part.piece.elements.end());
    part.piece = mesh::makePiece(mesh, part.name, std::string(part.piece.part), std::move(part.piece.elements));
  }
  return parts;
}

}  // namespace harmos::scene
