#include <harmos/latin/detail/LikeLoads.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <harmos/latin/detail/TighteningForces.hpp>

namespace harmos::latin {
namespace {

// Difference of loads, over their size, that are the same but for a factor.
constexpr double proportional = 1e-12;

double extentOf(const std::vector<base::Vector3>& nodes) {
  double extent = 0.0;
  for (const base::Vector3& x : nodes) extent = std::max(extent, base::distance(x, nodes.front()));
  return extent;
}

/// What all laws can carry at a load step.
std::vector<double> carriedAt(const assembly::Assembly& assembly, int step) {
  std::vector<double> carried;
  for (const assembly::Interface& one : assembly.interfaces) {
    if (one.law->prescribesTraction()) continue;
    const auto tractions = one.law->admissibleTractions(step);
    carried.push_back(isTightened(one, step) ? 1.0 : 0.0);
    carried.push_back(tractions ? 1.0 : 0.0);
    if (!tractions) continue;
    carried.insert(carried.end(), tractions->lower.begin(), tractions->lower.end());
    carried.insert(carried.end(), tractions->upper.begin(), tractions->upper.end());
    carried.push_back(tractions->friction);
  }
  return carried;
}

/// The loads of all load steps, and which of them are the same but for a factor.
class Loads {
 public:
  Loads(const assembly::Assembly& assembly, const std::vector<double>& sums)
      : sums_(sums), steps_(static_cast<std::size_t>(assembly.steps())), sizes_(sizesOfLoads(assembly, sums)) {
    for (const auto& body : assembly.bodies) {
      const double extent = extentOf(body.nodes);
      lengths_.insert(lengths_.end(), {1.0, 1.0, 1.0, extent, extent, extent, 1.0});
    }
  }

  double size(std::size_t step) const { return sizes_[step]; }

  bool areProportional(std::size_t step, std::size_t other) const {
    const double share = size(step) / size(other);
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      // What is not a number is not proportional.
      if (!(std::abs(at(step, i) - share * at(other, i)) <= proportional * size(step) * lengths_[i])) return false;
    }
    return true;
  }

  /// Where loads point: the same, but for `tolerance`, at all load steps whose loads are proportional.
  double direction(std::size_t step) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      if (lengths_[i] > 0.0) sum += weight(i) * (at(step, i) / lengths_[i] / size(step));
    }
    return std::isfinite(sum) ? sum : 0.0;
  }

  double tolerance() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) sum += weight(i);
    return 2.0 * proportional * sum;  // what is below it, and as much for round-off
  }

 private:
  double at(std::size_t step, std::size_t i) const {
    return sums_[(i / sumsPerStep * steps_ + step) * sumsPerStep + i % sumsPerStep];
  }
  /// Different ones, lest loads that change places cancel.
  double weight(std::size_t i) const { return static_cast<double>(i + 1) / static_cast<double>(lengths_.size()); }

  const std::vector<double>& sums_;
  std::size_t steps_;
  std::vector<double> sizes_;
  std::vector<double> lengths_;  // per sum of a load step: what it is counted in beside forces
};

}  // namespace

std::vector<double> sizesOfLoads(const assembly::Assembly& assembly, const std::vector<double>& sums) {
  const auto steps = static_cast<std::size_t>(assembly.steps());
  std::vector<double> sizes(steps, 0.0);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    for (std::size_t t = 0; t < steps; ++t) sizes[t] += sums[(b * steps + t) * sumsPerStep + sumsPerStep - 1];
  }
  return sizes;
}

std::vector<int> sameLaws(const assembly::Assembly& assembly) {
  std::map<std::vector<double>, int> known;
  std::vector<int> laws;
  for (int t = 0; t < assembly.steps(); ++t) {
    laws.push_back(known.try_emplace(carriedAt(assembly, t), static_cast<int>(known.size())).first->second);
  }
  return laws;
}

std::vector<int> largestLike(const assembly::Assembly& assembly, const std::vector<int>& laws,
                             const std::vector<double>& sums) {
  struct Step {
    int number, laws;
    double direction;
  };
  const Loads loads(assembly, sums);
  std::vector<Step> steps;
  std::vector<int> largest(laws.size(), -1);
  for (int t = 0; t < assembly.steps(); ++t) {
    const auto step = static_cast<std::size_t>(t);
    if (loads.size(step) == 0.0) continue;
    largest[step] = t;
    if (std::isfinite(loads.size(step))) steps.push_back({t, laws[step], loads.direction(step)});
  }
  std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
    return std::tie(a.laws, a.direction, a.number) < std::tie(b.laws, b.direction, b.number);
  });
  const double tolerance = loads.tolerance();
  for (auto first = steps.begin(); first != steps.end();) {
    // Those that point in the same way follow each other, and most often are all proportional.
    auto last = first + 1;
    while (last != steps.end() && last->laws == first->laws && last->direction - (last - 1)->direction <= tolerance)
      ++last;
    std::sort(first, last, [&](const Step& a, const Step& b) {
      const double sizeOfA = loads.size(static_cast<std::size_t>(a.number));
      const double sizeOfB = loads.size(static_cast<std::size_t>(b.number));
      return sizeOfA != sizeOfB ? sizeOfA > sizeOfB : a.number < b.number;
    });
    for (auto step = first; step != last; ++step) {
      const auto number = static_cast<std::size_t>(step->number);
      const auto like = std::find_if(first, step, [&](const Step& other) {
        return loads.areProportional(number, static_cast<std::size_t>(other.number));
      });
      largest[number] = like->number;
    }
    first = last;
  }
  return largest;
}

}  // namespace harmos::latin
