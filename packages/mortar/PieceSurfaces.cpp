#include <harmos/mortar/PieceSurfaces.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace harmos::mortar {
namespace {

using PiecePair = std::pair<int, int>;

/// Adds points of a joined interface to the surfaces of pairs of pieces.
class Divider {
 public:
  Divider(const std::string& name, const JoinedSurface& joined, const std::vector<mesh::Piece>& pieces)
      : name_(name), joined_(joined), pieces_(pieces) {}

  /// Position in the surface of a point, or of a corner that has no point (see JoinedSurface::face); these, and points
  /// that have their unknowns elsewhere, become copies.
  int add(const PiecePair& where, int corner, bool isCopy) {
    const auto [entry, isNew] = position_.try_emplace({where, corner}, 0);
    if (!isNew) return entry->second;
    const int point = pointOf(corner);
    mesh::InterfaceSurface& surface = at(where);
    entry->second = surface.pairs();
    surface.patch.push_back(joined_.patch[point]);
    surface.frame.push_back(joined_.frame[point]);
    surface.normal.push_back(isCopy ? base::Vector3{} : joined_.normal[point]);
    surface.area.push_back(isCopy ? 0.0 : joined_.area[point]);
    surface.share.push_back(surface.area.back());
    surface.flux.push_back(surface.normal.back());
    surface.gap.push_back(joined_.gap[point]);
    surface.position.push_back(corner == point ? joined_.place[point] : joined_.creased[corner - points()].place);
    surface.point.push_back(point);
    for (int side = 0; side < 2; ++side) {
      std::vector<mesh::TraceOperator::Entry> row;
      for (const auto& [node, weight] : joined_.trace[side].row(point)) {
        if (!isCopy) row.push_back({localNode(pieces_[side == 0 ? where.first : where.second], node), weight});
      }
      (side == 0 ? surface.trace1 : surface.trace2).append(row);
    }
    return entry->second;
  }

  int pointOf(int corner) const { return corner < points() ? corner : joined_.creased[corner - points()].point; }

  mesh::InterfaceSurface& at(const PiecePair& where) {
    const auto [entry, isNew] = surfaces_.try_emplace(where);
    if (isNew) {
      entry->second.name = name_;
      entry->second.piece1 = where.first;
      entry->second.piece2 = where.second;
    }
    return entry->second;
  }

  std::vector<mesh::InterfaceSurface> take() {
    std::vector<mesh::InterfaceSurface> result;
    for (auto& [where, surface] : surfaces_) result.push_back(std::move(surface));
    return result;
  }

 private:
  int points() const { return static_cast<int>(joined_.area.size()); }

  const std::string& name_;
  const JoinedSurface& joined_;
  const std::vector<mesh::Piece>& pieces_;
  std::map<PiecePair, mesh::InterfaceSurface> surfaces_;
  std::map<std::pair<PiecePair, int>, int> position_;
};

}  // namespace

PieceSurfaces divideByPieces(const std::string& name, const JoinedSurface& joined, const Side& side1, const Side& side2,
                             const std::vector<mesh::Piece>& pieces, const mesh::PieceMap& map) {
  const std::array<const Side*, 2> sides = {&side1, &side2};
  std::array<std::set<int>, 2> holders;
  for (int side = 0; side < 2; ++side) {
    for (const mesh::Face& face : sides[side]->faces) holders[side].insert(map.of(face.element));
  }
  PieceSurfaces result;
  Divider divider(name, joined, pieces);
  std::vector<PiecePair> where;
  for (int p = 0; p < static_cast<int>(joined.area.size()); ++p) {
    std::array<int, 2> piece = {-1, -1};
    for (int side = 0; side < 2; ++side) {
      const auto row = joined.trace[side].row(p);
      const auto holdsAll = [&](int candidate) {
        return std::all_of(row.begin(), row.end(), [&](const auto& entry) { return map.has(candidate, entry.node); });
      };
      const auto found = std::find_if(holders[side].begin(), holders[side].end(), holdsAll);
      if (found != holders[side].end()) {
        piece[side] = *found;
        continue;
      }
      if (result.crossed[0] + result.crossed[1] == 0) result.firstCrossed = joined.place[p];
      ++result.crossed[side];
    }
    where.emplace_back(piece[0], piece[1]);
    if (piece[0] >= 0 && piece[1] >= 0) divider.add(where.back(), p, false);
  }
  if (result.crossed[0] + result.crossed[1] > 0) return result;
  for (const std::vector<int>& face : joined.face) {
    const PiecePair& first = where[divider.pointOf(face[0])];
    std::vector<int> corners;
    for (const int corner : face) {
      const int point = divider.pointOf(corner);
      corners.push_back(divider.add(first, corner, corner != point || where[point] != first));
    }
    divider.at(first).face.push_back(std::move(corners));
  }
  result.surfaces = divider.take();
  return result;
}

}  // namespace harmos::mortar
