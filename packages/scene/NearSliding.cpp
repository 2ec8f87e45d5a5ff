#include <harmos/scene/detail/NearSliding.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <harmos/base/Names.hpp>
#include <harmos/latin/PairFields.hpp>
#include <harmos/results/MeshErrorRecord.hpp>

namespace harmos::scene {
namespace {

// Share of its friction that an interface uses when it is looked at, and how many are.
constexpr double muchUsed = 0.8;
constexpr std::size_t interfacesAtMost = 2;
// Of its friction: less is nothing to a user.
constexpr double nothing = 1e-3;

/// What friction does in all of an interface.
struct Use {
  std::vector<int> positions;
  double shear = 0.0, limit = 0.0, clamping = 0.0;  // [force]
};

void add(const latin::Iterate& state, int position, int step, double friction, Use& use) {
  const assembly::Interface& interface = state.assembly().interfaces[position];
  const latin::PairFields fields = latin::pairFields(state, position);
  use.positions.push_back(position);
  for (int pair = 0; pair < fields.pairs; ++pair) {
    const base::Vector3& t = fields.traction[fields.at(step, pair)];
    const double normal = interface.area[pair] * std::abs(t[0]);
    use.shear += interface.area[pair] * base::tangentialNorm(t);
    use.limit += friction * normal;
    use.clamping += normal;
  }
}

latin::ResponseGradient clampingGradient(const assembly::Assembly& assembly, const std::vector<int>& positions) {
  latin::ResponseGradient gradient;
  for (const int position : positions) {
    const assembly::Interface& interface = assembly.interfaces[position];
    // Tractions on side 1 press against its normal.
    for (int pair = 0; pair < interface.pairs(); ++pair) {
      gradient.pairs.push_back({position, pair, -1.0 * interface.frame[pair][0]});
    }
  }
  return gradient;
}

}  // namespace

std::vector<NearSliding> findNearSliding(const latin::Iterate& state, int step) {
  const assembly::Assembly& assembly = state.assembly();
  std::map<std::string, Use> uses;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const auto admissible = assembly.interfaces[i].law->admissibleTractions(step);
    if (!admissible || admissible->friction <= 0.0) continue;
    add(state, static_cast<int>(i), step, admissible->friction, uses[assembly.interfaces[i].name]);
  }
  std::vector<std::pair<double, NearSliding>> found;
  for (auto& [name, use] : uses) {
    if (use.limit <= 0.0 || use.shear < muchUsed * use.limit) continue;
    const double reserve = std::max(0.0, 1.0 - use.shear / use.limit);
    found.push_back({use.shear, {name, reserve, use.clamping, clampingGradient(assembly, use.positions)}});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  found.resize(std::min(found.size(), interfacesAtMost));
  std::vector<NearSliding> result;
  for (auto& [shear, interface] : found) {
    result.push_back(std::move(interface));
  }
  return result;
}

std::string describe(const NearSliding& interface, double uncertainty) {
  const std::string left = interface.reserve > nothing ? results::percentage(interface.reserve) : "nothing";
  return "interface " + base::quoted(interface.name) + " has " + left + " left to sliding, its clamping is " +
         results::percentage(uncertainty) + " uncertain";
}

}  // namespace harmos::scene
