#include <harmos/scene/detail/HeldPairs.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <harmos/base/Names.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/scene/FaceNames.hpp>
#include <harmos/scene/detail/AskedJumps.hpp>
#include <harmos/scene/detail/HeldJump.hpp>
#include <harmos/scene/detail/Wording.hpp>

namespace harmos::scene {
namespace {

// Of the size of the mesh: a jump that is none but for places that were written in single precision.
constexpr double noJump = 3e-7;

/// A jump that boundaries prescribe at a pair and its law does not allow.
struct Refused {
  int interface = -1, pair = -1, step = -1;  // positions in their lists
  base::Vector3 direction{};                 // unit vector
  double held = 0.0, asked = 0.0;            // jump along it, and the nearest that the law allows [length]
  std::vector<int> holders;                  // positions of boundaries
};

double sizeOf(const mesh::Mesh& mesh) {
  if (mesh.nodes.empty()) return 0.0;
  base::Vector3 low = mesh.nodes[0], high = low;
  for (const base::Vector3& place : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], place[d]);
      high[d] = std::max(high[d], place[d]);
    }
  }
  return distance(low, high);
}

/// Affine at every place.
bool isAffine(const assembly::Interface& interface) {
  return laws::roleOf<laws::InterfaceLaw>(*interface.law)->isAffine();
}

class PairChecker {
 public:
  PairChecker(const Scene& scene, const LawPlaces& places, const HeldNodes& held)
      : scene_(scene), places_(places), held_(held), size_(sizeOf(places.mesh)) {}

  /// Those of an interface, one at most for every pair.
  std::vector<Refused> refusedOf(int interfaceIndex) const {
    const assembly::Interface& interface = places_.interfaces[interfaceIndex];
    std::vector<Refused> all;
    if (!isAsked(interface)) return all;
    for (int p = 0; p < interface.pairs(); ++p) {
      const HeldJump jump(held_, interface, p, places_.components);
      if (jump.free().isSpace()) continue;
      auto refused = isAffine(interface) ? bondAgainst(interface, p, jump) : normalAgainst(interface, p, jump);
      if (!refused) continue;
      refused->interface = interfaceIndex;
      refused->pair = p;
      all.push_back(std::move(*refused));
    }
    return all;
  }

  void report(const std::vector<Refused>& all, input::ErrorList& errors) const {
    const Refused& first = all[0];
    const assembly::Interface& interface = places_.interfaces[first.interface];
    const bool isBoundary = interface.sides() == 1;
    const double sign = isBoundary ? -1.0 : 1.0;
    std::string holders;
    for (const int holder : first.holders) {
      const input::Parameters& list = listOf(places_.interfaces[holder].name);
      holders += (holders.empty() ? "" : " and ") + base::quoted(list.name()) + " at " + list.location();
    }
    const bool isMore = sign * (first.asked - first.held) > 0.0;
    const std::string limit = isAffine(interface) ? "" : isMore ? "at least " : "at most ";
    errors.add(listOf(interface.name).where(),
               "at " + counted(all.size(), "point") + ", the first at " + text(interface.position[first.pair]) +
                   ", the law asks for " + limit + rounded(sign * first.asked) + " as the " +
                   (isBoundary ? "displacement" : "jump") + " along " + text(first.direction) + " at load step " +
                   std::to_string(first.step + 1) + ", but " + holders +
                   (first.holders.size() == 1 ? " holds " : " hold ") + (isBoundary ? "the part" : "both sides") +
                   " at " + rounded(sign * first.held) + ".",
               "Keep a boundary off these nodes or free along this direction, leave the faces there out of this law, "
               "or prescribe what it allows.");
  }

  /// Of an interface or a boundary of the input.
  const input::Parameters& listOf(const std::string& name) const {
    for (const char* kind : {"Interfaces", "Boundaries"}) {
      for (const input::Parameters& list : scene_.input.lists(kind)) {
        if (list.name() == nameOfList(name)) return list;
      }
    }
    return scene_.input.list("Interfaces");
  }

 private:
  static bool isAsked(const assembly::Interface& interface) {
    const laws::InterfaceLaw& law = *interface.law;
    if (law.prescribesTraction() || laws::isCoupled(law) || dynamic_cast<const laws::FaceLaw*>(&law) != nullptr) {
      return false;
    }
    if (!isAffine(interface)) return law.frame() == laws::Frame::interface;
    if (interface.sides() == 1) return false;
    // Nodes that count as one have no jump.
    return !law.bonds() || !interface.trace1.isSelection() || !interface.trace2.isSelection();
  }

  /// The first load step at which a held jump is not the one asked for.
  std::optional<Refused> compare(const HeldJump& jump, const base::Vector3& direction, const std::vector<double>& held,
                                 const std::vector<double>& asked) const {
    const std::vector<double> uncertainty = jump.uncertainty(direction);
    for (std::size_t t = 0; t < held.size(); ++t) {
      if (std::abs(held[t] - asked[t]) <= uncertainty[t] + noJump * size_) continue;
      Refused refused;
      refused.step = static_cast<int>(t);
      refused.direction = direction;
      refused.held = held[t];
      refused.asked = asked[t];
      refused.holders = jump.holders(direction);
      return refused;
    }
    return std::nullopt;
  }

  std::optional<Refused> normalAgainst(const assembly::Interface& interface, int pair, const HeldJump& jump) const {
    const base::Vector3& normal = interface.frame[pair][0];
    if (!jump.free().excludes(normal)) return std::nullopt;
    const std::vector<double> held = jump.along(normal);
    return compare(jump, normal, held, nearestNormalJumps(interface, pair, scene_.times, held, size_));
  }

  std::optional<Refused> bondAgainst(const assembly::Interface& interface, int pair, const HeldJump& jump) const {
    constexpr base::Frame global{{{{{1.0, 0.0, 0.0}}}, {{{0.0, 1.0, 0.0}}}, {{{0.0, 0.0, 1.0}}}}};
    const base::Frame& axes = interface.law->frame() == laws::Frame::interface ? interface.frame[pair] : global;
    std::vector<base::Vector3> fixed;  // what the law prescribes of the jump, per load step
    Span free = jump.free();
    for (std::size_t t = 0; t < scene_.times.size(); ++t) {
      fixed.push_back({});
      const auto components = fixedJump(*interface.law, static_cast<int>(t), interface.position[pair]);
      for (std::size_t c = 0; c < 3; ++c) {
        if (!components[c]) {
          free.add(axes[c]);
        } else {
          fixed.back() = fixed.back() + *components[c] * axes[c];
        }
      }
    }
    for (const base::Vector3& direction : free.complement(axes)) {
      std::vector<double> asked;
      for (const base::Vector3& one : fixed) asked.push_back(dot(one, direction));
      auto refused = compare(jump, direction, jump.along(direction), asked);
      if (refused) return refused;
    }
    return std::nullopt;
  }

  const Scene& scene_;
  const LawPlaces& places_;
  const HeldNodes& held_;
  double size_;  // of the mesh [length]
};

}  // namespace

void checkHeldPairs(const Scene& scene, const LawPlaces& places, const HeldNodes& held, input::ErrorList& errors) {
  const PairChecker checker(scene, places, held);
  std::map<std::string, std::vector<Refused>> found;  // by interfaces of the input
  std::vector<std::string> names;                     // of these, in the order in which they are met
  for (std::size_t i = 0; i < places.interfaces.size(); ++i) {
    for (Refused& refused : checker.refusedOf(static_cast<int>(i))) {
      std::vector<Refused>& ofName = found[places.interfaces[i].name];
      if (ofName.empty()) names.push_back(places.interfaces[i].name);
      ofName.push_back(std::move(refused));
    }
  }
  for (const std::string& name : names) checker.report(found.at(name), errors);
}

}  // namespace harmos::scene
