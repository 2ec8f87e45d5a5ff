#include <harmos/latin/detail/RigidParts.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <harmos/base/Names.hpp>
#include <harmos/latin/detail/BodyGroups.hpp>
#include <harmos/latin/detail/CoupledFaces.hpp>
#include <harmos/latin/detail/FixedPlaces.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;
using assembly::Interface;

// Distance of the sides of a pair, over the size of the assembly, that is none: both feel the traction at one place.
constexpr double together = 1e-10;

double sizeOf(const std::vector<base::Vector3>& nodes) {
  double size = 0.0;
  for (const base::Vector3& x : nodes) size = std::max(size, base::distance(x, nodes.front()));
  return size;
}

/// Where the traction of a pair acts on a side: with a consistent interface mass at several nodes, which have a mean.
std::vector<base::Vector3> placesOf(const Assembly& assembly, const Interface& interface, int side) {
  const auto& nodes = assembly.bodies[interface.body(side)].nodes;
  const auto pairs = static_cast<std::size_t>(interface.pairs());
  std::vector<base::Vector3> places;
  for (int p = 0; p < interface.pairs(); ++p) places.push_back(interface.trace(side).at(p, nodes));
  if (interface.mass.empty()) return places;
  std::vector<base::Vector3> sums(pairs, base::Vector3{});
  std::vector<double> total(pairs, 0.0);
  for (const mesh::MassEntry& entry : interface.mass) {
    sums[entry.column] = sums[entry.column] + entry.value * places[entry.row];
    total[entry.column] += entry.value;
  }
  for (std::size_t p = 0; p < pairs; ++p) {
    // The traction of a quadratic element's corner may have a force of 0, but not without area.
    if (total[p] != 0.0) places[p] = (1.0 / total[p]) * sums[p];
  }
  return places;
}

}  // namespace

RigidParts::RigidParts(const Assembly& assembly, const std::vector<ResistedMotions>& resisted, int step,
                       Unknown unknown)
    : assembly_(assembly) {
  double size = 0.0;
  for (const auto& body : assembly.bodies) size = std::max(size, sizeOf(body.nodes));

  struct Connection {
    std::size_t interface;
    laws::AdmissibleTractions tractions;
    std::vector<base::Vector3> places[2];
  };
  std::vector<Connection> connections;
  BodyGroups groups(assembly.bodies.size());
  const auto connect = [&](std::size_t i) {
    const Interface& interface = assembly.interfaces[i];
    const auto tractions = interface.law->admissibleTractions(step);
    if (!tractions && unknown == Unknown::carriesNothing) return;
    const std::array<bool, 3> nothing = interface.law->givesNothing();
    const auto most = laws::AdmissibleTractions::components(!nothing[0], !nothing[1], !nothing[2]);
    Connection connection{i, tractions.value_or(most), {}};
    for (int side = 0; side < interface.sides(); ++side) {
      connection.places[side] = placesOf(assembly, interface, side);
    }
    if (interface.sides() == 1) connection.places[1] = connection.places[0];
    bool isFixed = tractions && tractions->isAny() && areFixed(connection.places[0], assembly.dimension);
    for (std::size_t p = 0; isFixed && p < connection.places[0].size(); ++p) {
      isFixed = base::distance(connection.places[0][p], connection.places[1][p]) <= together * size;
    }
    if (isFixed) {
      groups.join(interface.body1, interface.body2);
    } else {
      connections.push_back(std::move(connection));
    }
  };
  CoupledFaces faces(assembly, step);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const Interface& interface = assembly.interfaces[i];
    if (!interface.law->prescribesTraction() && interface.pairs() > 0 && !faces.contains(i)) connect(i);
  }
  for (const std::size_t i : faces.join(groups)) connect(i);

  std::vector<int> numberOf(assembly.bodies.size() + 1, -1);
  const int ground = groups.rootOf(-1);
  rigid_.dimension = assembly.dimension;
  std::vector<std::vector<base::Vector3>> corners;
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const int root = groups.rootOf(static_cast<int>(b));
    if (root != ground && numberOf[root] < 0) {
      numberOf[root] = static_cast<int>(corners.size());
      corners.push_back({assembly.bodies[b].nodes.front(), assembly.bodies[b].nodes.front()});
    }
    rigidBodyOf_.push_back(numberOf[root]);
    if (numberOf[root] < 0) continue;
    auto& box = corners[numberOf[root]];
    for (const base::Vector3& x : assembly.bodies[b].nodes) {
      for (std::size_t c = 0; c < 3; ++c) {
        box[0][c] = std::min(box[0][c], x[c]);
        box[1][c] = std::max(box[1][c], x[c]);
      }
    }
  }
  for (const auto& box : corners) {
    const double extent = 0.5 * base::distance(box[0], box[1]);
    rigid_.bodies.push_back({0.5 * (box[0] + box[1]), extent > 0.0 ? extent : 1.0, {}});
  }
  for (std::size_t b = 0; b < resisted.size(); ++b) {
    if (rigidBodyOf_[b] < 0) continue;
    auto& isHeld = rigid_.bodies[rigidBodyOf_[b]].isHeld;
    for (std::size_t i = 0; i < isHeld.size(); ++i) isHeld[i] = isHeld[i] || resisted[b][i];
  }
  for (statics::RigidBody& body : rigid_.bodies) {
    if (assembly.dimension == 3) body.centre = centreOfMotions(body.isHeld, body.centre);
  }
  for (const Connection& connection : connections) {
    const Interface& interface = assembly.interfaces[connection.interface];
    statics::Joint joint;
    joint.interface = static_cast<int>(connection.interface);
    joint.body1 = rigidBodyOf_[interface.body1];
    joint.body2 = interface.sides() == 1 ? -1 : rigidBodyOf_[interface.body2];
    joint.tractions = connection.tractions;
    if (joint.body1 < 0 && joint.body2 < 0) continue;
    const base::Frame axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    for (std::size_t p = 0; p < connection.places[0].size(); ++p) {
      joint.pair = static_cast<int>(p);
      joint.frame = interface.law->frame() == laws::Frame::global ? axes : interface.frame[p];
      joint.place1 = connection.places[0][p];
      joint.place2 = connection.places[1][p];
      joint.area = interface.area[p];
      rigid_.joints.push_back(joint);
    }
  }
  rigid_.couplings = faces.couplings(rigid_.bodies, rigidBodyOf_);
}

std::string RigidParts::nameOf(int rigidBody) const {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < rigidBodyOf_.size(); ++b) {
    if (rigidBodyOf_[b] != rigidBody) continue;
    std::string name = base::quoted(assembly_.bodies[b].partName());
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  constexpr std::size_t most = 4;
  return (names.size() == 1 ? "part " : "parts ") + base::joinNames(names, most);
}

}  // namespace harmos::latin
