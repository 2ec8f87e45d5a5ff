#include <harmos/latin/EliminatedBoundaries.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/latin/detail/RigidWork.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

// Relative difference of the stiffness from one load step to another that is round-off.
constexpr double roundOff = 1e-10;
// Square of the sine between two normals, below which they hold one direction.
constexpr double parallel = 1e-6;
// Of the largest stiffness against rigid motions: less holds no body.
constexpr double unheld = 1e-10;
// Relative difference of two places to which a node is held that is round-off.
constexpr double agree = 1e-9;

bool isRigid(const laws::AffineComponent& component) {
  return std::isinf(component.stiffness);
}

/// That of `first` at all load steps.
bool haveOneStiffness(const std::vector<std::array<laws::AffineComponent, 3>>& components,
                      const std::array<laws::AffineComponent, 3>& stiffness) {
  return std::all_of(components.begin(), components.end(), [&](const auto& at) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double k = at[c].stiffness, first = stiffness[c].stiffness;
      if (k != first && (std::isinf(first) || !(std::abs(k - first) <= roundOff * std::abs(first)))) return false;
    }
    return true;
  });
}

}  // namespace

EliminatedBoundaries::EliminatedBoundaries(const assembly::Assembly& assembly,
                                           const assembly::SearchDirection& searchDirection, Elimination which,
                                           const std::vector<ResistedMotions>& resisted)
    : assembly_(assembly),
      searchDirection_(searchDirection),
      cases_(static_cast<std::size_t>(assembly.loadCases())),
      boundaries_(assembly.interfaces.size()),
      bodies_(assembly.bodies.size()) {
  if (which == Elimination::none) return;
  choose(which);
  keepBodiesHeld(resisted);
  gather();
  update();
}

void EliminatedBoundaries::giveUp() {
  boundaries_.assign(boundaries_.size(), {});
  bodies_.assign(bodies_.size(), {});
  isEmpty_ = true;
}

base::Vector3 EliminatedBoundaries::axis(const assembly::Interface& interface, int pair, std::size_t component) const {
  if (assembly_.dimension == 2 && component == 2) return {};
  if (interface.law->frame() == laws::Frame::interface) return interface.frame[pair][component];
  base::Vector3 axis{};
  axis[component] = 1.0;
  return axis;
}

std::vector<std::array<laws::AffineComponent, 3>> EliminatedBoundaries::componentsOf(int interfaceIndex) const {
  const laws::InterfaceLaw& law = *assembly_.interfaces[interfaceIndex].law;
  const double compliance = 1.0 / searchDirection_.of(interfaceIndex)[0];
  std::vector<std::array<laws::AffineComponent, 3>> components;
  for (int t = 0; t < assembly_.steps(); ++t) components.push_back(laws::affineComponents(law, t, compliance));
  if (!assembly_.path) return components;
  components.push_back(components.front());
  const bool isScaled = assembly_.path->scales(interfaceIndex);
  for (std::size_t t = 0; t < cases_; ++t) {
    const bool isUnit = t + 1 == cases_;
    for (laws::AffineComponent& component : components[t]) {
      if (isScaled != isUnit) component.offset = 0.0;
    }
  }
  return components;
}

void EliminatedBoundaries::choose(Elimination which) {
  std::vector<bool> isConsistent(assembly_.bodies.size(), false);
  for (const assembly::Interface& interface : assembly_.interfaces) {
    for (int side = 0; side < interface.sides(); ++side) {
      if (!interface.mass.empty()) isConsistent[interface.body(side)] = true;
    }
  }
  for (std::size_t i = 0; i < boundaries_.size(); ++i) {
    const assembly::Interface& interface = assembly_.interfaces[i];
    const laws::InterfaceLaw& law = *interface.law;
    // A direction is held at a node, not at a mean of several.
    if (interface.sides() != 1 || interface.pairs() == 0 || !interface.trace1.isSelection() ||
        isConsistent[interface.body1] || !law.isAffine() || law.prescribesTraction()) {
      continue;
    }
    Boundary& boundary = boundaries_[i];
    boundary.components = componentsOf(static_cast<int>(i));
    const auto& first = boundary.components[0];
    const bool hasSprings =
        std::any_of(first.begin(), first.end(), [](const auto& c) { return !isRigid(c) && c.stiffness != 0.0; });
    boundary.isEliminated =
        haveOneStiffness(boundary.components, first) && (which == Elimination::affine || !hasSprings);
  }
}

void EliminatedBoundaries::keepBodiesHeld(const std::vector<ResistedMotions>& resisted) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::vector<base::Vector3>& nodes = assembly_.bodies[b].nodes;
    base::Vector3 centre{};
    for (const base::Vector3& x : nodes) centre = centre + (1.0 / static_cast<double>(nodes.size())) * x;
    centre = centreOfMotions(resisted[b], centre);
    double size = 0.0;
    for (const base::Vector3& x : nodes) size = std::max(size, base::distance(x, centre));
    base::Matrix gram(6, 6);
    for (std::size_t i = 0; i < boundaries_.size(); ++i) {
      const assembly::Interface& interface = assembly_.interfaces[i];
      if (interface.law->prescribesTraction()) continue;
      for (int side = 0; side < interface.sides(); ++side) {
        if (interface.body(side) != static_cast<int>(b)) continue;
        for (int p = 0; p < interface.pairs(); ++p) {
          const double k = searchDirection_.of(static_cast<int>(i))[p];
          for (std::size_t c = 0; c < 3; ++c) {
            const double spring = boundaries_[i].isEliminated ? boundaries_[i].components[0][c].stiffness : k;
            const base::Vector3 r = (1.0 / size) * (interface.trace(side).at(p, nodes) - centre);
            const auto worked = rigidWork(r, axis(interface, p, c));
            for (int row = 0; row < 6; ++row) {
              for (int column = 0; column < 6; ++column) {
                gram(row, column) += interface.area[p] * std::min(spring, k) * worked[row] * worked[column];
              }
            }
          }
        }
      }
    }
    if (assembly_.dimension == 2) {
      for (const int unused : {2, 3, 4}) gram(unused, unused) = gram(0, 0) + gram(1, 1);
    }
    for (int i = 0; i < 6; ++i) {
      if (resisted[b][i]) gram(i, i) += gram.normInf();
    }
    const std::vector<double> values = symmetricEigen(gram);
    if (values.front() > unheld * values.back()) continue;
    for (std::size_t i = 0; i < boundaries_.size(); ++i) {
      if (assembly_.interfaces[i].body1 == static_cast<int>(b)) boundaries_[i].isEliminated = false;
    }
  }
}

void EliminatedBoundaries::gather() {
  std::vector<std::map<int, std::size_t>> found(bodies_.size());
  for (std::size_t i = 0; i < boundaries_.size(); ++i) {
    if (!boundaries_[i].isEliminated) continue;
    isEmpty_ = false;
    const assembly::Interface& interface = assembly_.interfaces[i];
    for (int p = 0; p < interface.pairs(); ++p) found[interface.body1].emplace(interface.trace1.node(p), 0);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (auto& [node, position] : found[b]) {
      position = bodies_[b].nodes.size();
      bodies_[b].nodes.push_back({});
      bodies_[b].nodes.back().node = node;
    }
  }
  for (std::size_t i = 0; i < boundaries_.size(); ++i) {
    Boundary& boundary = boundaries_[i];
    if (!boundary.isEliminated) continue;
    const assembly::Interface& interface = assembly_.interfaces[i];
    for (int p = 0; p < interface.pairs(); ++p) {
      boundary.node.push_back(found[interface.body1].at(interface.trace1.node(p)));
      Node& node = bodies_[interface.body1].nodes[boundary.node.back()];
      for (std::size_t c = 0; c < 3; ++c) {
        const laws::AffineComponent& component = boundary.components[0][c];
        const base::Vector3 a = axis(interface, p, c);
        if (isRigid(component)) {
          node.isHeld = node.isHeld || base::norm(a) > 0.0;
          base::addDyad(node.inverse, interface.area[p], a);
        } else {
          base::addDyad(node.springs, interface.area[p] * component.stiffness, a);
        }
      }
    }
  }
  for (Body& body : bodies_) {
    for (Node& node : body.nodes) {
      for (std::size_t c = 0; c < 3; ++c) node.free[c][c] = 1.0;
      if (!node.isHeld) continue;
      base::Matrix vectors(3, 3);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) vectors(row, column) = node.inverse[row][column];
      }
      const std::vector<double> values = symmetricEigen(vectors);
      node.inverse = {};
      for (int j = 0; j < 3; ++j) {
        if (values[j] <= parallel * values.back()) continue;
        const base::Vector3 v{vectors(0, j), vectors(1, j), vectors(2, j)};
        base::addDyad(node.inverse, 1.0 / values[j], v);
        base::addDyad(node.free, -1.0, v);
      }
    }
  }
}

void EliminatedBoundaries::update() {
  for (Body& body : bodies_) {
    body.force.assign(body.nodes.size() * cases_, {});
    body.held.assign(body.nodes.size() * cases_, {});
  }
  const auto visit = [&](const auto& action) {
    for (std::size_t i = 0; i < boundaries_.size(); ++i) {
      const assembly::Interface& interface = assembly_.interfaces[i];
      for (std::size_t p = 0; p < boundaries_[i].node.size(); ++p) {
        for (std::size_t t = 0; t < cases_; ++t) {
          for (std::size_t c = 0; c < 3; ++c) {
            action(static_cast<int>(i), static_cast<int>(p), t, axis(interface, static_cast<int>(p), c),
                   boundaries_[i].components[t][c]);
          }
        }
      }
    }
  };
  for (std::size_t i = 0; i < boundaries_.size(); ++i) {
    if (!boundaries_[i].isEliminated) continue;
    const std::array<laws::AffineComponent, 3> stiffness = boundaries_[i].components[0];
    boundaries_[i].components = componentsOf(static_cast<int>(i));
    if (haveOneStiffness(boundaries_[i].components, stiffness)) continue;
    throw base::Error("boundary \"" + assembly_.interfaces[i].name +
                      "\": the springs of its law have changed, but are part of the operators; make the solver with "
                      "Elimination::rigid");
  }
  visit([&](int i, int p, std::size_t t, const base::Vector3& a, const laws::AffineComponent& component) {
    const assembly::Interface& interface = assembly_.interfaces[i];
    Body& body = bodies_[interface.body1];
    const std::size_t at = boundaries_[i].node[p] * cases_ + t;
    // The ground is side 2, so the jump is -w.
    std::vector<base::Vector3>& sums = isRigid(component) ? body.held : body.force;
    const double sign = isRigid(component) ? -1.0 : 1.0;
    sums[at] = sums[at] + (sign * interface.area[p] * component.offset) * a;
  });
  for (Body& body : bodies_) {
    for (std::size_t n = 0; n < body.nodes.size(); ++n) {
      for (std::size_t t = 0; t < cases_; ++t) {
        body.held[n * cases_ + t] = base::product(body.nodes[n].inverse, body.held[n * cases_ + t]);
      }
    }
  }
  visit([&](int i, int p, std::size_t t, const base::Vector3& a, const laws::AffineComponent& component) {
    if (!isRigid(component)) return;
    const int body = assembly_.interfaces[i].body1;
    const base::Vector3& place = held(body, boundaries_[i].node[p], static_cast<int>(t));
    const double found = base::dot(place, a), wanted = -component.offset * base::dot(a, a);
    if (std::abs(found - wanted) > agree * std::max(std::abs(wanted), base::norm(place))) {
      refuse(i, p, static_cast<int>(t), found);
    }
  });
}

void EliminatedBoundaries::refuse(int interfaceIndex, int pair, int step, double found) const {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  std::string others;
  for (std::size_t i = 0; i < boundaries_.size(); ++i) {
    const assembly::Interface& other = assembly_.interfaces[i];
    if (static_cast<int>(i) == interfaceIndex || !boundaries_[i].isEliminated || other.body1 != interface.body1) {
      continue;
    }
    bool isThere = false;
    for (int p = 0; p < other.pairs(); ++p) isThere = isThere || other.trace1.node(p) == interface.trace1.node(pair);
    if (isThere) others += (others.empty() ? "\"" : ", \"") + other.name + "\"";
  }
  const base::Vector3& x = interface.position[pair];
  std::ostringstream message;
  message << "boundary \"" << interface.name << "\" and " << (others.empty() ? "itself" : others)
          << " hold the node at (" << x[0] << ", " << x[1] << ", " << x[2] << ") at different places in load step "
          << step + 1 << " (their mean along an axis of the former: " << found
          << "); let one of them leave the node or the direction free";
  throw base::Error(message.str(), base::ExitCode::input);
}

EliminatedBoundaries::GroundMotion EliminatedBoundaries::followGround(int interfaceIndex, int pair,
                                                                      const base::Vector3& motion) const {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  const Boundary& boundary = boundaries_[interfaceIndex];
  GroundMotion result;
  for (std::size_t c = 0; c < 3; ++c) {
    const double stiffness = boundary.components[0][c].stiffness;
    const base::Vector3 a = axis(interface, pair, c);
    const base::Vector3 along = (interface.area[pair] * base::dot(motion, a)) * a;
    if (isRigid(boundary.components[0][c])) {
      result.held = result.held + along;
    } else {
      result.force = result.force + stiffness * along;
    }
  }
  result.held = base::product(bodies_[interface.body1].nodes[boundary.node[pair]].inverse, result.held);
  return result;
}

base::Vector3 EliminatedBoundaries::traction(int interfaceIndex, int pair, int step, const base::Vector3& displacement,
                                             const base::Vector3& reaction) const {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  const Boundary& boundary = boundaries_[interfaceIndex];
  const Node& node = bodies_[interface.body1].nodes[boundary.node[pair]];
  const base::Vector3 share = base::product(node.inverse, reaction);
  base::Vector3 traction{};
  for (std::size_t c = 0; c < 3; ++c) {
    const laws::AffineComponent& component = boundary.components[step][c];
    const base::Vector3 a = axis(interface, pair, c);
    const double along =
        isRigid(component) ? base::dot(share, a) : component.offset - component.stiffness * base::dot(displacement, a);
    traction = traction + along * a;
  }
  return traction;
}

}  // namespace harmos::latin
