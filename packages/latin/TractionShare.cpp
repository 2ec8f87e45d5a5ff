#include <harmos/latin/detail/TractionShare.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/latin/detail/AdmittedTractions.hpp>

namespace harmos::latin {

/// Of all pairs at all load steps, step by step, complete on every rank, global components.
struct TractionShare::Fields {
  std::size_t count;
  std::vector<base::Vector3> traction, jump;
  std::vector<double> distance;  // of the jumps of both stages [length]
  std::vector<double> mean;      // per load step: root mean square of all tractions of the local stage [stress]
  std::size_t at(int step, std::size_t place) const { return static_cast<std::size_t>(step) * count + place; }
};

namespace {

/// TractionShare::Finding::pressures of a group whose pairs admit `sets`, which hold `tractions`.
SelfStress ofPressures(const assembly::Assembly& assembly, const RedundantGroup& group, std::vector<TractionSet> sets,
                       const std::vector<bool>& slides, std::vector<base::Vector3> tractions) {
  for (std::size_t j = 0; j < sets.size(); ++j) {
    if (!slides[j]) continue;
    const RedundantGroup::Pair& pair = group.pairs[j];
    const base::Vector3& n = assembly.interfaces[pair.interface].frame[pair.pair][0];
    sets[j] = TractionSet::ray(-1.0 * n);
    tractions[j] = base::dot(tractions[j], n) * n;
  }
  return {group, std::move(sets), tractions};
}

}  // namespace

TractionShare::TractionShare(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                             const EliminatedBoundaries& eliminated)
    : assembly_(assembly),
      groups_(findRedundantGroups(assembly, eliminated)),
      places_(assembly.interfaces.size()),
      pairs_(assembly.interfaces.size()),
      reactions_(assembly, searchDirection, eliminated) {
  for (const RedundantGroup& group : groups_) {
    first_.push_back(count_);
    for (const RedundantGroup::Pair& pair : group.pairs) {
      places_[pair.interface].push_back(count_++);
      pairs_[pair.interface].push_back(pair.pair);
    }
  }
}

TractionShare::Fields TractionShare::gather(const Iterate& iterate) const {
  constexpr std::size_t width = 9;  // traction, jumps of the local and of the linear stage
  const TraceLayout& layout = iterate.layout();
  const int steps = assembly_.steps(), dimension = layout.dimension();
  Fields fields{count_, {}, {}, {}, {}};
  const std::size_t ofPairs = width * count_ * static_cast<std::size_t>(steps);
  std::vector<double> values(ofPairs + 2 * static_cast<std::size_t>(steps), 0.0);
  for (int t = 0; t < steps; ++t) {
    double* sums = values.data() + ofPairs + 2 * static_cast<std::size_t>(t);
    for (int row = 0; row < layout.rows(); ++row)
      sums[0] += iterate.hattedTraction()[t][row] * iterate.hattedTraction()[t][row];
    sums[1] = layout.rows();
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].empty()) continue;
    for (int side = 0; side < assembly_.interfaces[i].sides(); ++side) {
      const int begin = layout.begin(static_cast<int>(i), side);
      if (begin < 0) continue;
      const double sign = side == 0 ? -1.0 : 1.0;
      for (int t = 0; t < steps; ++t) {
        for (std::size_t j = 0; j < pairs_[i].size(); ++j) {
          double* value = values.data() + width * fields.at(t, places_[i][j]);
          const int row = begin + dimension * pairs_[i][j];
          for (int c = 0; c < dimension; ++c) {
            if (side == 0) value[c] = iterate.hattedTraction()[t][row + c];
            value[3 + c] += sign * iterate.hattedTrace()[t][row + c];
            value[6 + c] += sign * iterate.trace()[t][row + c];
          }
        }
      }
    }
  }
  iterate.metric().sum(values);
  for (std::size_t at = ofPairs; at < values.size(); at += 2)
    fields.mean.push_back(std::sqrt(values[at] / values[at + 1]));
  for (std::size_t at = 0; at < ofPairs; at += width) {
    const double* v = values.data() + at;
    fields.traction.push_back({v[0], v[1], v[2]});
    fields.jump.push_back({v[3], v[4], v[5]});
    fields.distance.push_back(base::distance(fields.jump.back(), {v[6], v[7], v[8]}));
  }
  return fields;
}

std::vector<TractionShare::Finding> TractionShare::find(const Iterate& iterate, double tolerance) const {
  std::vector<Finding> findings;
  if (isEmpty()) return findings;
  Fields fields = gather(iterate);
  // Where joints carry nothing at all, what boundaries carry tells a touch from a gap.
  if (std::count(fields.mean.begin(), fields.mean.end(), 0.0) > 0) {
    const base::Matrix& reactions = iterate.boundaryFields().traction;
    std::vector<double> sums(fields.mean.size(), 0.0);
    for (int t = 0; t < reactions.numCols(); ++t) {
      for (int row = 0; row < reactions.numRows(); ++row) sums[t] += reactions(row, t) * reactions(row, t);
    }
    iterate.metric().sum(sums);
    for (std::size_t t = 0; t < sums.size(); ++t) fields.mean[t] = std::max(fields.mean[t], std::sqrt(sums[t]));
  }
  std::vector<AdmittedTractions> laws;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].empty()) continue;
    const std::vector<double>& k = iterate.searchDirection().of(static_cast<int>(i));
    std::vector<double> compliances;
    const double scale = iterate.searchDirectionScale() * assembly_.interfaces[i].sides();
    for (const int p : pairs_[i]) compliances.push_back(scale / k[p]);
    laws.emplace_back(assembly_, static_cast<int>(i), pairs_[i], std::move(compliances));
  }
  std::vector<double> size(count_);  // of the tractions of the group of a pair
  std::vector<TractionSet> sets(count_, TractionSet::point({}));
  std::vector<bool> slides(count_, false);
  for (int t = 0; t < assembly_.steps(); ++t) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      double largest = 0.0;  // where a group carries nothing, what is carried elsewhere tells a touch from a gap
      for (std::size_t j = 0; j < groups_[g].pairs.size(); ++j)
        largest = std::max(largest, base::norm(fields.traction[fields.at(t, first_[g] + j)]));
      if (largest == 0.0) largest = fields.mean[t];
      std::fill_n(size.begin() + static_cast<std::ptrdiff_t>(first_[g]), groups_[g].pairs.size(), largest);
    }
    auto law = laws.begin();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (pairs_[i].empty()) continue;
      std::vector<AdmittedTractions::At> states;
      for (const std::size_t place : places_[i]) {
        const std::size_t at = fields.at(t, place);
        states.push_back({fields.traction[at], fields.jump[at], size[place], 2.0 * fields.distance[at]});
      }
      const std::vector<AdmittedTractions::Set> found = (law++)->next(t, states, tolerance);
      for (std::size_t j = 0; j < found.size(); ++j) {
        sets[places_[i][j]] = found[j].tractions;
        slides[places_[i][j]] = found[j].slides;
      }
    }
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (size[first_[g]] == 0.0) continue;
      const auto part = [&](const auto& list, std::size_t begin) {
        const auto from = list.begin() + static_cast<std::ptrdiff_t>(begin);
        return std::decay_t<decltype(list)>(from, from + static_cast<std::ptrdiff_t>(groups_[g].pairs.size()));
      };
      const auto tractions = part(fields.traction, fields.at(t, first_[g]));
      SelfStress stress(groups_[g], part(sets, first_[g]), tractions);
      SelfStress pressures =
          ofPressures(assembly_, groups_[g], part(sets, first_[g]), part(slides, first_[g]), tractions);
      if (!stress.exists() && !pressures.exists()) continue;
      Finding finding{
          g, t, std::move(stress), std::move(pressures), tractions, part(fields.jump, fields.at(t, first_[g])), {}};
      finding.oldJumps = t == 0 ? std::vector<base::Vector3>(tractions.size(), base::Vector3{})
                                : part(fields.jump, fields.at(t - 1, first_[g]));
      findings.push_back(std::move(finding));
    }
  }
  return findings;
}

void TractionShare::addDifference(const Finding& finding, const std::vector<base::Vector3>& tractions,
                                  const TraceLayout& layout, base::Matrix& field) const {
  const auto& pairs = groups_[finding.group].pairs;
  const int dimension = layout.dimension();
  for (std::size_t j = 0; j < pairs.size(); ++j) {
    const base::Vector3 difference = tractions[j] - finding.tractions[j];
    for (int side = 0; side < assembly_.interfaces[pairs[j].interface].sides(); ++side) {
      const int begin = layout.begin(pairs[j].interface, side);
      if (begin < 0) continue;
      double* row = field[finding.step] + begin + dimension * pairs[j].pair;
      for (int c = 0; c < dimension; ++c) row[c] += side == 0 ? difference[c] : -difference[c];
    }
  }
}

}  // namespace harmos::latin
