#include <harmos/scene/detail/Contradictions.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <harmos/base/Names.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/latin/PrescribedForces.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/scene/FaceNames.hpp>
#include <harmos/scene/detail/HeldNodes.hpp>
#include <harmos/scene/detail/HeldPairs.hpp>
#include <harmos/scene/detail/Span.hpp>
#include <harmos/scene/detail/Wording.hpp>

namespace harmos::scene {
namespace {

// What is left of a unit vector beside motions that are held, which is round-off.
constexpr double alongIt = 1e-6;

/// Whether others may act on the points of its face as they like.
bool leavesFaceFree(const laws::InterfaceLaw& law) {
  const auto* ofFace = dynamic_cast<const laws::FaceLaw*>(&law);
  return ofFace != nullptr && ofFace->leavesFaceFree();
}

/// Those of `motions` that follow from `others`.
std::vector<std::string> dependentMotions(const std::vector<laws::FaceLaw::HeldMotion>& motions,
                                          const std::vector<laws::FaceLaw::HeldMotion>& others) {
  using Six = laws::FaceMotions::Six;
  const auto dot = [](const Six& a, const Six& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); };
  double length = 0.0;  // that makes rotations comparable
  for (const auto* all : {&motions, &others}) {
    for (const auto& motion : *all) {
      if (motion.of[0] == 0.0 && motion.of[1] == 0.0 && motion.of[2] == 0.0) continue;
      for (std::size_t i = 3; i < 6; ++i) length = std::max(length, std::abs(motion.of[i]));
    }
  }
  std::vector<Six> axes;
  /// Takes it among the axes; false: it lies in their span.
  const auto add = [&](Six v) {
    for (std::size_t i = 3; i < 6 && length > 0.0; ++i) v[i] /= length;
    const double size = std::sqrt(dot(v, v));
    for (int again = 0; again < 2; ++again) {
      for (const Six& axis : axes) {
        const double along = dot(v, axis);
        for (std::size_t i = 0; i < 6; ++i) v[i] -= along * axis[i];
      }
    }
    const double rest = std::sqrt(dot(v, v));
    if (rest <= alongIt * size) return false;
    for (double& one : v) one /= rest;
    axes.push_back(v);
    return true;
  };
  for (const auto& other : others) add(other.of);
  std::vector<std::string> dependent;
  for (const auto& motion : motions) {
    if (!add(motion.of)) dependent.push_back(motion.name);
  }
  return dependent;
}

class Checker {
 public:
  Checker(const Scene& scene, const LawPlaces& places, input::ErrorList& errors)
      : scene_(scene),
        places_(places),
        errors_(errors),
        held_(places.interfaces, nodeCounts(places.pieces), places.components, static_cast<int>(scene.times.size())) {
    for (const char* kind : {"Interfaces", "Boundaries"}) {
      for (const input::Parameters& list : scene.input.lists(kind)) lists_.push_back(&list);
    }
  }

  void checkDisplacements() {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Conflict>> found;  // by the places of both in the input
    for (const Conflict& conflict : held_.conflicts()) {
      found[{order(name(conflict.holding.interface)), order(name(conflict.other))}].push_back(conflict);
    }
    for (const auto& [both, conflicts] : found) {
      const Conflict& first = conflicts[0];
      const input::Parameters& later = *lists_[both.first];
      const input::Parameters& earlier = *lists_[both.second];
      errors_.add(later.where(),
                  "it holds " + counted(conflicts.size(), "node") + ", the first at " + text(place(first)) +
                      ", at a displacement of " + number((*first.holding.displacement)[first.step]) + " along " +
                      text(first.holding.direction) + ", but \"" + earlier.name() + "\" at " + earlier.location() +
                      " at " + number(first.expected) + ", both at load step " + std::to_string(first.step + 1) + ".",
                  "Prescribe the same in both, or leave the nodes or the component out of one of them.");
    }
  }

  void checkPairs() { checkHeldPairs(scene_, places_, held_, errors_); }

  void checkFaces() {
    std::map<Face, std::set<std::size_t>> owners;  // interfaces and boundaries, by their places in the input
    std::map<std::size_t, std::size_t> counts;     // of their faces
    for (const mesh::InterfaceSurface& surface : places_.surfaces) {
      if (scene_.laws.count(surface.name) == 0) continue;  // a cut
      if (!surface.trace1.isSelection() && (surface.piece2 < 0 || !surface.trace2.isSelection())) continue;
      const std::size_t owner = order(surface.name);
      for (const auto& face : surface.face) counts[owner] += owners[faceOf(surface, face)].insert(owner).second ? 1 : 0;
    }
    std::map<std::pair<std::size_t, std::size_t>, std::set<Face>> common;
    for (const auto& [face, all] : owners) {
      for (const std::size_t one : all) {
        for (const std::size_t other : all) {
          if (one != other) common[{one, other}].insert(face);
        }
      }
    }
    for (const auto& [both, faces] : common) {
      const input::Parameters &list = *lists_[both.first], &other = *lists_[both.second];
      const bool isLater = both.first > both.second, areAll = faces.size() == counts[both.first];
      compare(list, other, isLater, faces, areAll);
      if (areAll) compareMotions(list, other, isLater, faces.size() == counts[both.second]);
    }
  }

 private:
  /// Pieces on both sides, the second -1 on a boundary, and mesh nodes of the first, ascending.
  struct Face {
    int piece1, piece2;
    std::vector<int> nodes;
    bool operator<(const Face& other) const {
      return std::tie(piece1, piece2, nodes) < std::tie(other.piece1, other.piece2, other.nodes);
    }
  };

  static std::vector<int> nodeCounts(const std::vector<mesh::Piece>& pieces) {
    std::vector<int> counts;
    for (const mesh::Piece& piece : pieces) counts.push_back(static_cast<int>(piece.nodes.size()));
    return counts;
  }

  Face faceOf(const mesh::InterfaceSurface& surface, const std::vector<int>& pairs) const {
    const bool hasTwoSides = surface.piece2 >= 0 && surface.trace2.isSelection();
    const bool isTurned = hasTwoSides && (surface.piece2 < surface.piece1 || !surface.trace1.isSelection());
    Face face{isTurned ? surface.piece2 : surface.piece1, isTurned ? surface.piece1 : surface.piece2, {}};
    for (const int pair : pairs) {
      face.nodes.push_back(places_.pieces[face.piece1].nodes[(isTurned ? surface.trace2 : surface.trace1).node(pair)]);
    }
    std::sort(face.nodes.begin(), face.nodes.end());
    return face;
  }

  const std::string& name(int interfaceIndex) const { return places_.interfaces[interfaceIndex].name; }
  base::Vector3 place(const Conflict& conflict) const {
    return places_.mesh.nodes[places_.pieces[conflict.holding.body].nodes[conflict.holding.node]];
  }

  std::size_t order(const std::string& wanted) const {
    return static_cast<std::size_t>(std::find_if(lists_.begin(), lists_.end(),
                                                 [&](const auto* list) { return list->name() == nameOfList(wanted); }) -
                                    lists_.begin());
  }

  /// What the law of `list` makes of the one of `other` on their common faces, which are all that it has if `areAll`.
  void compare(const input::Parameters& list, const input::Parameters& other, bool isLater,
               const std::set<Face>& common, bool areAll) {
    const laws::InterfaceLaw& law = *scene_.laws.at(list.name());
    const laws::InterfaceLaw& otherLaw = *scene_.laws.at(other.name());
    const std::string shared =
        "it shares " + counted(common.size(), "face") + " with \"" + other.name() + "\" at " + other.location();
    if (law.prescribesTraction()) {
      if (areAll && actsOnlyOnHeld(list.name(), other.name())) {
        errors_.add(list.where(),
                    shared + ", which holds them along the traction or a component of it, so that this has no effect.",
                    "Remove the component of one of them, or choose other faces.");
      }
    } else if (leavesFaceFree(law) || leavesFaceFree(otherLaw)) {
      return;
    } else if (!law.isAffine() && (otherLaw.bonds() || holdsNormals(list.name(), other.name(), common))) {
      errors_.add(list.where(), shared + ", which holds them along their normal; what each carries is not determined.",
                  "Give every face one of the two.");
    } else if (!law.isAffine() && !otherLaw.isAffine() && isLater) {
      errors_.add(list.where(), shared + "; what each carries is not determined.", "Give every face one of the two.");
    }
  }

  /// What the law of a list holds of the motion of its face, null where it is none of a face.
  const laws::FaceLaw* faceLaw(const std::string& listName) const {
    const auto found = std::find_if(places_.interfaces.begin(), places_.interfaces.end(),
                                    [&](const assembly::Interface& one) { return one.name == listName; });
    return found == places_.interfaces.end() ? nullptr : dynamic_cast<const laws::FaceLaw*>(found->law.get());
  }

  /// `holder` has all faces of `list`, and `list` all of it when they are `same`.
  void compareMotions(const input::Parameters& list, const input::Parameters& holder, bool isLater, bool same) {
    const laws::FaceLaw* law = faceLaw(list.name());
    if (law == nullptr) return;
    const laws::FaceLaw* other = faceLaw(holder.name());
    std::vector<std::string> twice;
    if (other == nullptr) {
      for (const auto& motion : law->heldMotions()) {
        if (nodesHold(holder.name(), list.name(), *law, motion)) twice.push_back(motion.name);
      }
    } else if (isLater && same) {
      twice = dependentMotions(law->heldMotions(), other->heldMotions());
    }
    if (twice.empty()) return;
    errors_.add(list.where(),
                "it holds " + base::joinNames(twice, twice.size()) + " of the faces whose motion \"" + holder.name() +
                    "\" at " + holder.location() +
                    " holds already; they contradict each other, or what each carries is not determined.",
                "Hold it in one of the two.");
  }

  /// The motion is that of nodes which a boundary holds along all that it consists of.
  bool nodesHold(const std::string& holder, const std::string& listName, const laws::FaceLaw& law,
                 const laws::FaceLaw::HeldMotion& motion) const {
    const laws::FaceMotions::Six weights = law.face()->divided(motion.of);
    std::vector<std::pair<std::pair<int, int>, base::Vector3>> parts;
    double largest = 0.0;
    for (const assembly::Interface& interface : places_.interfaces) {
      if (interface.name != listName || !interface.trace1.isSelection()) continue;
      for (int p = 0; p < interface.pairs(); ++p) {
        const int node = interface.trace1.node(p);
        const base::Vector3& place = places_.mesh.nodes[places_.pieces[interface.body1].nodes[node]];
        parts.push_back({{interface.body1, node}, law.face()->at(weights, place)});
        largest = std::max(largest, norm(parts.back().second));
      }
    }
    return !parts.empty() && std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
      return norm(part.second) <= alongIt * largest ||
             holdsWholly(holder, part.first.first, part.first.second, part.second);
    });
  }

  /// Whether what a boundary holds leaves no part of a direction free.
  bool holdsWholly(const std::string& holder, int body, int node, const base::Vector3& direction) const {
    Span span;
    for (const Holding& holding : held_.of(body, node)) {
      if (name(holding.interface) == holder) span.add(holding.direction);
    }
    return span.contains(direction);
  }

  /// A traction in global components is looked at component by component, others as a whole: that part of a pressure on
  /// an inclined face is held is as it should be.
  bool actsOnlyOnHeld(const std::string& loaded, const std::string& holder) const {
    const bool isGlobal = scene_.laws.at(loaded)->frame() == laws::Frame::global;
    for (int c = 0; c < (isGlobal ? places_.components : 1); ++c) {
      const auto part = [&](const base::Vector3& traction) {
        if (!isGlobal) return traction;
        base::Vector3 component{};
        component[c] = traction[c];
        return component;
      };
      if (std::all_of(places_.interfaces.begin(), places_.interfaces.end(), [&](const assembly::Interface& interface) {
            return interface.name != loaded || isWasted(interface, holder, part);
          })) {
        return true;
      }
    }
    return false;
  }

  /// A part of the traction is not 0 at any pair, and nowhere along a free direction.
  template <typename Part>
  bool isWasted(const assembly::Interface& interface, const std::string& holder, const Part& part) const {
    std::vector<bool> acts(static_cast<std::size_t>(interface.pairs()), false);
    for (std::size_t t = 0; t < scene_.times.size(); ++t) {
      const auto tractions = latin::prescribedTractions(interface, scene_.times, static_cast<int>(t));
      for (std::size_t p = 0; p < tractions.size(); ++p) {
        const base::Vector3 acting = part(tractions[p]);
        if (norm(acting) == 0.0) continue;
        for (const auto& entry : interface.trace1.row(static_cast<int>(p))) {
          if (!holdsWholly(holder, interface.body1, entry.node, acting)) return false;
        }
        acts[p] = true;
      }
    }
    return std::all_of(acts.begin(), acts.end(), [](bool one) { return one; });
  }

  /// On one of the common faces, all nodes of a boundary are held along their normals.
  bool holdsNormals(const std::string& contact, const std::string& holder, const std::set<Face>& common) const {
    return std::any_of(places_.surfaces.begin(), places_.surfaces.end(), [&](const mesh::InterfaceSurface& surface) {
      if (surface.name != contact || surface.piece2 >= 0 || !surface.trace1.isSelection()) return false;
      return std::any_of(surface.face.begin(), surface.face.end(), [&](const std::vector<int>& face) {
        return common.count(faceOf(surface, face)) > 0 && std::all_of(face.begin(), face.end(), [&](int p) {
                 return holdsWholly(holder, surface.piece1, surface.trace1.node(p), surface.frame[p][0]);
               });
      });
    });
  }

  const Scene& scene_;
  const LawPlaces& places_;
  input::ErrorList& errors_;
  HeldNodes held_;
  std::vector<const input::Parameters*> lists_;  // of interfaces and boundaries, in the order of the input
};

}  // namespace

void checkContradictions(const Scene& scene, const LawPlaces& places, input::ErrorList& errors) {
  Checker checker(scene, places, errors);
  checker.checkDisplacements();
  checker.checkPairs();
  checker.checkFaces();
}

}  // namespace harmos::scene
