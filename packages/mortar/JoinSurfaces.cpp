#include <harmos/mortar/JoinSurfaces.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/InterfaceFrame.hpp>
#include <harmos/mortar/detail/BeyondReach.hpp>
#include <harmos/mortar/detail/DoublyHeld.hpp>
#include <harmos/mortar/detail/FacingCells.hpp>
#include <harmos/mortar/detail/MortarSide.hpp>
#include <harmos/mortar/detail/PointBuilder.hpp>
#include <harmos/mortar/detail/Sagitta.hpp>

namespace harmos::mortar {
namespace {

constexpr double roundOff = 1e-13;  // gap over the coordinates of the interface

[[noreturn]] void refuseDistantSides(const std::string& where, const mesh::Mesh& mesh,
                                     const std::array<const Side*, 2>& sides, const FacingCells& facing,
                                     const Reach& reach) {
  const auto counted = [](const Side& side) {
    return side.name + " (" + std::to_string(side.faces.size()) + (side.faces.size() == 1 ? " face)" : " faces)");
  };
  std::ostringstream message;
  message << where << ": no face of " << counted(*sides[0]) << " lies opposite one of " << counted(*sides[1])
          << " within ";
  if (reach.distance) {
    message << "a distance of " << *reach.distance;
  } else {
    if (reach.relative != 1.0) message << reach.relative << " times ";
    message << "the length of their longest edge";
  }
  message << "; the nearest nodes are "
          << mesh::separation(mesh.nodes, mesh::nodesOf(sides[0]->faces), mesh::nodesOf(sides[1]->faces)).smallest
          << " apart. ";
  if (facing.lookingTheSameWay > 0) {
    message << facing.lookingTheSameWay << (facing.lookingTheSameWay == 1 ? " pair" : " pairs")
            << " of faces within that distance look the same way instead of at each other. ";
  }
  message << "Name the faces that touch by side sets, or raise Search Distance.";
  throw base::Error(message.str(), base::ExitCode::input);
}

[[noreturn]] void refuseHardlyCovered(const std::string& where, const std::array<const Side*, 2>& sides, int mortar,
                                      std::size_t faces) {
  throw base::Error(where + ": " + sides[1 - mortar]->name + " covers so little of " + std::to_string(faces) +
                        (faces == 1 ? " face of " : " faces of ") + sides[mortar]->name +
                        " that none of their corners can be a point. Put the points on the other side, Points On = "
                        "Side " +
                        std::to_string(2 - mortar) + ", or mesh " + sides[mortar]->name + " finer there.",
                    base::ExitCode::input);
}

/// Of the joined faces of both sides, in sum.
double sagittaOfBoth(const std::array<SideCells, 2>& cells, const std::array<std::set<int>, 2>& joined,
                     double creaseAngle) {
  double sum = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<Cell> ofJoined;
    std::copy_if(cells[side].cells.begin(), cells[side].cells.end(), std::back_inserter(ofJoined),
                 [&](const Cell& cell) { return joined[side].count(cell.face) > 0; });
    sum += sagittaOf(ofJoined, creaseAngle);
  }
  return sum;
}

/// Share of the area of the other side's covered faces that is not covered.
double uncoveredShare(const SideCells& other, const std::set<int>& faces, double covered, int dimension,
                      const mesh::Depth& depth) {
  double whole = 0.0;
  for (const Cell& cell : other.cells) {
    if (faces.count(cell.face) > 0) whole += cell.area * (dimension == 2 ? depth.at(cell.centre) : 1.0);
  }
  return whole > 0.0 ? std::max(0.0, 1.0 - covered / whole) : 0.0;
}

/// Turns the normals out of side 1 and makes frames of them.
void addFrames(int dimension, int mortar, JoinedSurface& surface) {
  surface.frame.clear();
  for (base::Vector3& normal : surface.normal) {
    if (mortar == 1) normal = -1.0 * normal;
    surface.frame.push_back(mesh::frameFromNormal(normal, dimension));
  }
}

/// Places and gaps of the points, and what is reported of them.
void place(const mesh::Mesh& mesh, JoinedSurface& surface) {
  base::Vector3 lower{}, upper{};
  double farthest = 0.0, area = 0.0;
  for (std::size_t p = 0; p < surface.node.size(); ++p) {
    const std::array<base::Vector3, 2> places = {surface.trace[0].at(static_cast<int>(p), mesh.nodes),
                                                 surface.trace[1].at(static_cast<int>(p), mesh.nodes)};
    surface.place.push_back(places[surface.pointsOn]);
    surface.gap.push_back(dot(places[1] - places[0], surface.frame[p][0]));
    farthest = std::max(farthest, distance(places[0], places[1]));
    area += surface.area[p];
    for (int d = 0; d < 3; ++d) {
      lower[d] = p == 0 ? surface.place[p][d] : std::min(lower[d], surface.place[p][d]);
      upper[d] = p == 0 ? surface.place[p][d] : std::max(upper[d], surface.place[p][d]);
    }
  }
  for (JoinedSurface::Creased& corner : surface.creased) corner.place = mesh.nodes[corner.node];
  const double diameter = distance(lower, upper);
  const double count = static_cast<double>(surface.node.size());
  surface.report.spacing = mesh.dimension == 3 ? std::sqrt(area / count) : diameter / count;
  surface.report.rigidMotion = farthest / (diameter > 0.0 ? diameter : std::sqrt(area));
  for (double& gap : surface.gap) {
    if (std::abs(gap) <= roundOff * (norm(lower) + norm(upper))) gap = 0.0;
    surface.report.largestGap = std::max(surface.report.largestGap, gap);
  }
  for (std::size_t p = 0; p < surface.gap.size(); ++p) {
    if (-surface.gap[p] <= surface.report.largestOverlap) continue;
    surface.report.largestOverlap = -surface.gap[p];
    surface.report.overlapPlace = surface.place[p];
  }
}

void closeGaps(const JoinOptions& options, JoinedSurface& surface) {
  if (options.gap == GapTreatment::geometric) return;
  for (double& gap : surface.gap) {
    if (options.gap == GapTreatment::closedWithin && std::abs(gap) > options.within) continue;
    surface.report.closed += gap != 0.0 ? 1 : 0;
    surface.report.largestClosed = std::max(surface.report.largestClosed, std::abs(gap));
    gap = 0.0;
  }
}

}  // namespace

JoinedSurface joinSurfaces(const std::string& where, const mesh::Mesh& mesh, const Side& side1, const Side& side2,
                           const JoinOptions& options) {
  const std::array<const Side*, 2> sides = {&side1, &side2};
  for (const Side* side : sides) {
    if (side->faces.empty()) throw base::Error(where + ": " + side->name + " has no faces.", base::ExitCode::input);
  }
  const std::array<SideCells, 2> cells = {SideCells{side1.faces, cellsOf(mesh.dimension, mesh.nodes, side1.faces)},
                                          SideCells{side2.faces, cellsOf(mesh.dimension, mesh.nodes, side2.faces)}};
  FacingCells facing = findFacingCells(cells[0].cells, cells[1].cells, options.reach);
  const int mortar = options.pointsOn ? *options.pointsOn
                                      : chooseMortarSide(mesh.dimension, {&cells[0].cells, &cells[1].cells},
                                                         facing.pairs, {side1.stiffness, side2.stiffness});
  if (mortar == 1) {
    for (auto& [first, second] : facing.pairs) std::swap(first, second);
    std::sort(facing.pairs.begin(), facing.pairs.end());
  }
  const auto couplings = coupleFaces(mesh.dimension, mesh.nodes, options.depth, cells[mortar], cells[1 - mortar],
                                     facing.pairs, options.reach);
  if (couplings.empty()) refuseDistantSides(where, mesh, sides, facing, options.reach);

  PointBuilder builder(sides[mortar]->faces, couplings, options.creaseAngle);
  if (!options.hasPointsAtCreases) builder.leaveOutCreases();
  JoinedSurface surface = builder.build();
  if (surface.node.empty()) refuseHardlyCovered(where, sides, mortar, couplings.size());
  leaveOutStrayWeights(surface, options.held);
  addFrames(mesh.dimension, mortar, surface);
  if (const int held = builder.leaveOut(findDoublyHeld(surface, options.held)); held > 0) {
    surface = builder.build();
    surface.report.held = held;
    leaveOutStrayWeights(surface, options.held);
    addFrames(mesh.dimension, mortar, surface);
  }
  surface.pointsOn = mortar;
  std::set<int> opposite;
  double covered = 0.0;
  for (const FaceCoupling& coupling : couplings) {
    opposite.insert(coupling.facing.begin(), coupling.facing.end());
    covered += coupling.area;
  }
  JoinReport& report = surface.report;
  std::set<int> own;
  for (const FaceCoupling& coupling : couplings) own.insert(coupling.face);
  const std::array<std::set<int>, 2> joined =
      mortar == 0 ? std::array<std::set<int>, 2>{own, opposite} : std::array<std::set<int>, 2>{opposite, own};
  const BeyondReach beyond = findBeyondReach(mesh.dimension, {&cells[0].cells, &cells[1].cells}, joined, options.reach);
  report.beyondReach = beyond.faces;
  report.nearestBeyond = beyond.nearest;
  report.sagitta = sagittaOfBoth(cells, joined, options.creaseAngle);
  report.uncovered[1] = uncoveredShare(cells[1 - mortar], opposite, covered, mesh.dimension, options.depth);
  report.faces = {static_cast<int>(couplings.size()), static_cast<int>(opposite.size())};
  if (mortar == 1) {
    std::swap(report.uncovered[0], report.uncovered[1]);
    std::swap(report.faces[0], report.faces[1]);
    std::swap(surface.trace[0], surface.trace[1]);
  }
  for (int side = 0; side < 2; ++side) report.given[side] = static_cast<int>(sides[side]->faces.size());
  place(mesh, surface);
  closeGaps(options, surface);
  return surface;
}

}  // namespace harmos::mortar
