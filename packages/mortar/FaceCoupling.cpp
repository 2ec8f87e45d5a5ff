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
constexpr std::size_t usualColumns = 16;  // of four quadrilaterals, so that lists hardly ever grow

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
    coupling.columns[1].reserve(usualColumns);
    return coupling;
  }

  /// A cell of the mortar side as it is seen along its normal.
  struct View {
    const Cell& cell;
    Plane plane;
    ConvexPolygon polygon;
    FlatFace face;
  };
  View viewOf(const Cell& cell) const {
    const Plane plane(cell.centre, cell.normal, dimension_);
    return {cell, plane, cell.on(plane),
            FlatFace(shapeOf(mortar_, cell.face), points_, nodesOf(mortar_, cell.face), plane)};
  }

  void addWhole(FaceCoupling& coupling, const View& view) {
    const FlatFace& own = view.face;
    integratePolygon(view.polygon, degreeOfCorners(own.shape()) + moreDegrees(own, own.size()) + degreeOfDepth(),
                     quadrature_);
    for (const QuadraturePoint& at : quadrature_) {
      const CornerVector psi = own.shape().cornerValues(own.parentOf(at.place));
      const double weight = at.weight * depthAt(view.plane, at.place);
      for (int p = 0; p < FaceShape::mostCorners; ++p) coupling.whole[p] += psi[p] * weight;
    }
  }

  void add(FaceCoupling& coupling, const View& view, const Cell& facing, const Reach& reach) {
    const Cell& cell = view.cell;
    const Plane& plane = view.plane;
    const ConvexPolygon common = intersection(view.polygon, facing.on(plane));
    if (common.corners() == 0 || common.area() <= nothing * std::min(cell.area, facing.area)) return;
    if (!areWithinReach(cell, facing, plane.heightOf(facing.centre, facing.normal, common.middle()), reach)) return;
    const FlatFace& own = view.face;
    const FlatFace opposite(shapeOf(other_, facing.face), points_, nodesOf(other_, facing.face), plane);
    const int degree = degreeOfCorners(own.shape()) + degreeOfDepth() +
                       std::max(own.shape().polynomialDegree(), opposite.shape().polynomialDegree()) +
                       std::max(moreDegrees(own, common.diameter()), moreDegrees(opposite, common.diameter()));
    integratePolygon(common, degree, quadrature_);
    Block ownBlock{}, oppositeBlock{};
    CornerMatrix mass{};
    CornerVector shares{};
    const bool isOwnQuadratic = own.shape().isQuadratic(), isOppositeQuadratic = opposite.shape().isQuadratic();
    for (const QuadraturePoint& at : quadrature_) {
      const double weight = at.weight * depthAt(plane, at.place);
      const Parent parent = own.parentOf(at.place), oppositeParent = opposite.parentOf(at.place);
      CornerVector n = own.shape().cornerValues(parent);
      coupling.area += weight;
      CornerVector weighted;
      for (int p = 0; p < FaceShape::mostCorners; ++p) weighted[p] = n[p] * weight;
      for (int p = 0; p < FaceShape::mostCorners; ++p) shares[p] += weighted[p];
      addTo(mass, n, weighted);
      if (isOwnQuadratic) addTo(ownBlock, own.shape().values(parent), weighted);
      if (isOppositeQuadratic) {
        addTo(oppositeBlock, opposite.shape().values(oppositeParent), weighted);
      } else {
        addTo(oppositeBlock, opposite.shape().cornerValues(oppositeParent), weighted);
      }
    }
    for (int p = 0; p < FaceShape::mostCorners; ++p) {
      coupling.normal[p] = coupling.normal[p] + shares[p] * cell.normal;
      for (int q = 0; q < FaceShape::mostCorners; ++q) coupling.mass[p][q] += mass[p][q];
    }
    if (isOwnQuadratic) append(coupling.columns[0], nodesOf(mortar_, cell.face), ownBlock);
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
  int degreeOfCorners(const FaceShape& shape) const { return shape.corners() == 4 ? 2 : 1; }

  /// Adds products of functions, row by row, with weighted corner functions.
  template <typename Rows, typename Functions>
  static void addTo(Rows& rows, const Functions& functions, const CornerVector& weighted) {
    for (std::size_t j = 0; j < functions.size(); ++j) {
      for (int p = 0; p < FaceShape::mostCorners; ++p) rows[j][p] += functions[j] * weighted[p];
    }
  }

  static void append(std::vector<FaceCoupling::Column>& columns, const std::vector<int>& nodes, const Block& block) {
    for (std::size_t j = 0; j < nodes.size(); ++j) columns.push_back({nodes[j], block[j]});
  }

  static void merge(std::vector<FaceCoupling::Column>& columns) {
    std::stable_sort(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
    std::size_t count = 0;
    for (const auto& column : columns) {
      if (count == 0 || columns[count - 1].node != column.node) {
        columns[count++] = column;
        continue;
      }
      for (std::size_t p = 0; p < column.value.size(); ++p) columns[count - 1].value[p] += column.value[p];
    }
    columns.resize(count);
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
  std::vector<Coupler::View> views;  // of the cells of a face
  auto pair = pairs.begin();
  for (std::size_t first = 0, last = 0; first < mortar.cells.size(); first = last) {
    const int face = mortar.cells[first].face;
    FaceCoupling coupling = coupler.start(face);
    views.clear();
    for (; last < mortar.cells.size() && mortar.cells[last].face == face; ++last) {
      views.push_back(coupler.viewOf(mortar.cells[last]));
      for (; pair != pairs.end() && pair->first == static_cast<int>(last); ++pair) {
        coupler.add(coupling, views.back(), other.cells[pair->second], reach);
      }
    }
    if (!(coupling.area > 0.0)) continue;
    for (const auto& view : views) coupler.addWhole(coupling, view);
    coupler.finish(coupling);
    couplings.push_back(std::move(coupling));
  }
  return couplings;
}

}  // namespace harmos::mortar
