#include <harmos/mortar/detail/FaceCoupling.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/mortar/detail/FacingCells.hpp>
#include <harmos/mortar/detail/FlatFace.hpp>
#include <harmos/mortar/detail/PolygonQuadrature.hpp>

namespace harmos::mortar {
namespace {

constexpr double nothing = 1e-12;         // area over that of the smaller cell
constexpr double quadratureError = 1e-8;  // that the order is chosen for where faces are distorted
constexpr int mostMoreDegrees = 20;

/// What a distorted face asks for beyond the degree of an affine one on a polygon of that diameter. Its parent
/// coordinates are analytic functions of the place up to where its Jacobian would vanish; the farther that is from the
/// polygon, over its radius, the faster Gauss' rules converge.
int moreDegrees(const FlatFace& face, double diameter) {
  if (face.distortion() == 0.0) return 0;
  const double away = std::max(1.5, face.size() / (2.0 * face.distortion() * diameter));
  const double rate = away + std::sqrt(away * away - 1.0);
  return std::min(mostMoreDegrees, static_cast<int>(std::ceil(-std::log(quadratureError) / std::log(rate))));
}

/// Sums up the pairs of cells of one face of the mortar side.
class Coupler {
 public:
  Coupler(int dimension, const std::vector<base::Vector3>& points, const mesh::Depth& depth, const SideCells& mortar,
          const SideCells& other)
      : dimension_(dimension), points_(points), depth_(depth), mortar_(mortar), other_(other) {}

  FaceCoupling start(int face) const {
    FaceCoupling coupling;
    coupling.face = face;
    coupling.corners = shapeOf(mortar_, face).corners();
    return coupling;
  }

  void addWhole(FaceCoupling& coupling, const Cell& cell) {
    const Plane plane(cell.centre, cell.normal, dimension_);
    const FlatFace own(shapeOf(mortar_, cell.face), points_, nodesOf(mortar_, cell.face), plane);
    const FaceShape& corners = cornersOf(own.shape());
    integratePolygon(cell.on(plane), corners.polynomialDegree() + moreDegrees(own, own.size()) + degreeOfDepth(),
                     quadrature_);
    for (const QuadraturePoint& at : quadrature_) {
      const auto psi = corners.values(own.parentOf(at.place));
      const double weight = at.weight * depthAt(plane, at.place);
      for (int p = 0; p < coupling.corners; ++p) coupling.whole[p] += psi[p] * weight;
    }
  }

  void add(FaceCoupling& coupling, const Cell& cell, const Cell& facing, const Reach& reach) {
    const Plane plane(cell.centre, cell.normal, dimension_);
    const ConvexPolygon common = intersection(cell.on(plane), facing.on(plane));
    if (common.corners() == 0 || common.area() <= nothing * std::min(cell.area, facing.area)) return;
    if (!areWithinReach(cell, facing, plane.heightOf(facing.centre, facing.normal, common.middle()), reach)) return;
    const FlatFace own(shapeOf(mortar_, cell.face), points_, nodesOf(mortar_, cell.face), plane);
    const FlatFace opposite(shapeOf(other_, facing.face), points_, nodesOf(other_, facing.face), plane);
    const FaceShape& corners = cornersOf(own.shape());
    const int degree = corners.polynomialDegree() + degreeOfDepth() +
                       std::max(own.shape().polynomialDegree(), opposite.shape().polynomialDegree()) +
                       std::max(moreDegrees(own, common.diameter()), moreDegrees(opposite, common.diameter()));
    integratePolygon(common, degree, quadrature_);
    Block ownBlock{}, oppositeBlock{};
    for (const QuadraturePoint& at : quadrature_) {
      const double weight = at.weight * depthAt(plane, at.place);
      const Parent parent = own.parentOf(at.place);
      const auto n = corners.values(parent);
      const auto oppositeValues = opposite.shape().values(opposite.parentOf(at.place));
      coupling.area += weight;
      for (int p = 0; p < coupling.corners; ++p) {
        coupling.normal[p] = coupling.normal[p] + n[p] * weight * cell.normal;
        for (int q = 0; q < coupling.corners; ++q) coupling.mass[p][q] += n[p] * n[q] * weight;
      }
      if (own.shape().isQuadratic()) addTo(ownBlock, own.shape().values(parent), n, weight, own.shape());
      addTo(oppositeBlock, oppositeValues, n, weight, opposite.shape());
    }
    if (own.shape().isQuadratic()) append(coupling.columns[0], nodesOf(mortar_, cell.face), ownBlock);
    append(coupling.columns[1], nodesOf(other_, facing.face), oppositeBlock);
    coupling.facing.push_back(facing.face);
  }

  void finish(FaceCoupling& coupling) const {
    const std::vector<int>& nodes = nodesOf(mortar_, coupling.face);
    if (coupling.columns[0].empty()) {  // the shape functions are the corner functions
      for (int q = 0; q < coupling.corners; ++q) coupling.columns[0].push_back({nodes[q], coupling.mass[q]});
    }
    for (auto& columns : coupling.columns) merge(columns);
    auto& facing = coupling.facing;
    std::sort(facing.begin(), facing.end());
    facing.erase(std::unique(facing.begin(), facing.end()), facing.end());
  }

 private:
  using Block = std::array<CornerVector, FaceShape::mostNodes>;  // by node of a face

  /// The circumference grows linearly with the radius.
  int degreeOfDepth() const { return depth_.isRevolved() ? 1 : 0; }
  double depthAt(const Plane& plane, const Flat& place) const {
    return dimension_ == 2 ? depth_.at(plane.pointAt(place)) : 1.0;
  }
  const std::vector<int>& nodesOf(const SideCells& side, int face) const { return side.faces[face].nodes; }
  const FaceShape& shapeOf(const SideCells& side, int face) const {
    return FaceShape::of(dimension_, nodesOf(side, face).size());
  }
  const FaceShape& cornersOf(const FaceShape& shape) const {
    return FaceShape::of(dimension_, static_cast<std::size_t>(shape.corners()));
  }

  static void addTo(Block& block, const FaceShape::Values& values, const FaceShape::Values& corners, double weight,
                    const FaceShape& shape) {
    for (int j = 0; j < shape.nodes(); ++j) {
      for (int p = 0; p < FaceShape::mostCorners; ++p) block[j][p] += corners[p] * values[j] * weight;
    }
  }

  static void append(std::vector<FaceCoupling::Column>& columns, const std::vector<int>& nodes, const Block& block) {
    for (std::size_t j = 0; j < nodes.size(); ++j) columns.push_back({nodes[j], block[j]});
  }

  static void merge(std::vector<FaceCoupling::Column>& columns) {
    std::stable_sort(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
    std::vector<FaceCoupling::Column> merged;
    for (const auto& column : columns) {
      if (merged.empty() || merged.back().node != column.node) {
        merged.push_back(column);
        continue;
      }
      for (std::size_t p = 0; p < column.value.size(); ++p) merged.back().value[p] += column.value[p];
    }
    columns = std::move(merged);
  }

  int dimension_;
  const std::vector<base::Vector3>& points_;
  mesh::Depth depth_;
  const SideCells& mortar_;
  const SideCells& other_;
  std::vector<QuadraturePoint> quadrature_;
};

}  // namespace

std::vector<FaceCoupling> coupleFaces(int dimension, const std::vector<base::Vector3>& points, const mesh::Depth& depth,
                                      const SideCells& mortar, const SideCells& other,
                                      const std::vector<std::pair<int, int>>& pairs, const Reach& reach) {
  Coupler coupler(dimension, points, depth, mortar, other);
  std::vector<FaceCoupling> couplings;
  auto pair = pairs.begin();
  for (std::size_t first = 0, last = 0; first < mortar.cells.size(); first = last) {
    const int face = mortar.cells[first].face;
    FaceCoupling coupling = coupler.start(face);
    for (; last < mortar.cells.size() && mortar.cells[last].face == face; ++last) {
      for (; pair != pairs.end() && pair->first == static_cast<int>(last); ++pair) {
        coupler.add(coupling, mortar.cells[last], other.cells[pair->second], reach);
      }
    }
    if (!(coupling.area > 0.0)) continue;
    for (std::size_t c = first; c < last; ++c) coupler.addWhole(coupling, mortar.cells[c]);
    coupler.finish(coupling);
    couplings.push_back(std::move(coupling));
  }
  return couplings;
}

}  // namespace harmos::mortar
