#include <harmos/latin/detail/RigidParts.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Names.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;
using assembly::Interface;

// Distance of the sides of a pair, over the size of the assembly, that is none: both feel the traction at one place.
constexpr double together = 1e-10;
// Extent of nodes across a line (in the plane across a point), over that along it, that fixes no rotation.
constexpr double flat = 1e-6;
// Forces of a rigid motion, over the terms that they are sums of, that are more than round-off.
constexpr double resists = 1e-10;

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

/// Whether equal displacements at these places are equal rigid motions.
bool areFixed(const std::vector<base::Vector3>& places, int dimension) {
  const base::Vector3& origin = places.front();
  const auto farthest = std::max_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
    return base::distance(a, origin) < base::distance(b, origin);
  });
  const double length = base::distance(*farthest, origin);
  if (dimension == 2 || length == 0.0) return length > 0.0;
  const base::Vector3 along = (1.0 / length) * (*farthest - origin);
  return std::any_of(places.begin(), places.end(), [&](const base::Vector3& x) {
    return base::norm(base::cross(along, x - origin)) > flat * length;
  });
}

/// Groups of bodies that are joined, directly or through others; the ground is the last element.
class Groups {
 public:
  explicit Groups(std::size_t bodies) : parent_(bodies + 1) { std::iota(parent_.begin(), parent_.end(), 0); }
  int rootOf(int body) {
    int root = body < 0 ? static_cast<int>(parent_.size()) - 1 : body;
    while (parent_[root] != root) root = parent_[root] = parent_[parent_[root]];
    return root;
  }
  void join(int a, int b) { parent_[rootOf(a)] = rootOf(b); }

 private:
  std::vector<int> parent_;
};

/// Whether |K r| is more than round-off for the rigid motions r about the first node. Rotations about another place
/// differ by translations, so that those that are resisted make all rotations resisted; but where both across an axis
/// of the coordinates are, the turn about that axis may be free, as that of a half plane with torsion is about y.
ResistedMotions resistedMotions(const substructure::Substructure& body) {
  const substructure::CrsView k = substructure::viewOf(*body.stiffness, body.name);
  const int dimension = body.dimension;
  std::vector<double> displacement(static_cast<std::size_t>(k.rows));
  const auto isResisted = [&](const statics::Motion& motion, const base::Vector3& centre) {
    const statics::RigidBody rigid{centre, 1.0, {}};
    for (std::size_t node = 0; node < body.nodes.size(); ++node) {
      const base::Vector3 u = statics::displacementOf(rigid, motion, body.nodes[node]);
      std::copy_n(u.begin(), dimension, displacement.begin() + static_cast<std::ptrdiff_t>(node) * dimension);
    }
    double force = 0.0, terms = 0.0;
    for (int row = 0; row < k.rows; ++row) {
      double sum = 0.0, size = 0.0;
      for (std::size_t at = k.rowPointers[row]; at < k.rowPointers[row + 1]; ++at) {
        const double term = k.values[at] * displacement[k.columns[at]];
        sum += term;
        size += std::abs(term);
      }
      force = std::max(force, std::abs(sum));
      terms = std::max(terms, size);
    }
    return force > resists * terms;
  };
  ResistedMotions resisted{};
  bool anyTranslation = false;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
    statics::Motion motion;
    motion.translation[c] = 1.0;
    resisted[c] = isResisted(motion, body.nodes.front());
    anyTranslation = anyTranslation || resisted[c];
  }
  for (std::size_t c = dimension == 2 ? 2 : 0; c < 3; ++c) {
    statics::Motion motion;
    motion.rotation[c] = 1.0;
    const bool isAcross = dimension == 3 && resisted[(c + 1) % 3] && resisted[(c + 2) % 3];
    resisted[dimension == 2 ? 2 : 3 + c] =
        isAcross ? isResisted(motion, base::Vector3{}) : anyTranslation || isResisted(motion, body.nodes.front());
  }
  return resisted;
}

}  // namespace

std::vector<ResistedMotions> resistedMotions(const Assembly& assembly, const Teuchos::Comm<int>& comm) {
  constexpr std::size_t motions = 6;
  std::vector<int> mine(motions * assembly.bodies.size(), 0), all(mine);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    if (assembly.ownerOf(static_cast<int>(b)) != comm.getRank()) continue;
    const auto& congruence = assembly.bodies[b].congruence;
    const ResistedMotions resisted =
        resistedMotions(assembly.bodies[congruence ? static_cast<std::size_t>(congruence->representative) : b]);
    const bool any = std::any_of(resisted.begin(), resisted.end(), [](bool one) { return one; });
    // What turns with the body is not told apart: it claims less then.
    for (std::size_t i = 0; i < motions; ++i) mine[motions * b + i] = (congruence ? any : resisted[i]) ? 1 : 0;
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, static_cast<int>(mine.size()), mine.data(), all.data());
  std::vector<ResistedMotions> result(assembly.bodies.size());
  for (std::size_t b = 0; b < result.size(); ++b) {
    for (std::size_t i = 0; i < motions; ++i) result[b][i] = all[motions * b + i] != 0;
  }
  return result;
}

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
  Groups groups(assembly.bodies.size());
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction() || interface.pairs() == 0) continue;
    const auto tractions = interface.law->admissibleTractions(step);
    if (!tractions && unknown == Unknown::carriesNothing) continue;
    Connection connection{i, tractions.value_or(laws::AdmissibleTractions{}), {}};
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
  }

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
    for (std::size_t c = 0; c < 3 && assembly.dimension == 3; ++c) {
      const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
      if (!body.isHeld[3 + c] && body.isHeld[d] && body.isHeld[e]) body.centre[d] = body.centre[e] = 0.0;
    }
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
}

std::string RigidParts::nameOf(int rigidBody) const {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < rigidBodyOf_.size(); ++b) {
    if (rigidBodyOf_[b] == rigidBody) names.push_back(base::quoted(assembly_.bodies[b].name));
  }
  constexpr std::size_t most = 4;
  return (names.size() == 1 ? "part " : "parts ") + base::joinNames(names, most);
}

}  // namespace harmos::latin
