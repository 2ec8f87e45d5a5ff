#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <harmos/base/Names.hpp>
#include <harmos/latin/Snapshot.hpp>
#include <harmos/latin/detail/ResultRemarks.hpp>

namespace harmos::latin {
namespace {

// Interfaces that a remark names.
constexpr std::size_t mostNames = 6;

std::string nameAll(const assembly::Assembly& assembly, const std::vector<int>& interfaces) {
  std::vector<std::string> names;
  for (const int i : interfaces) {
    std::string name = base::quoted(assembly.interfaces[i].name);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return base::joinNames(names, mostNames);
}

}  // namespace

std::string namesOfSoftening(const assembly::Assembly& assembly) {
  std::vector<int> soft;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    if (assembly.interfaces[i].law->lowestSlope() < 0.0) soft.push_back(static_cast<int>(i));
  }
  return nameAll(assembly, soft);
}

void addResponses(const Iterate& state, const std::vector<std::shared_ptr<const Response>>& responses,
                  const std::vector<double>& estimates, LatinResult& result) {
  const Snapshot last(state, responses);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < responses.size(); ++i) {
    result.responses.push_back({responses[i]->name(),
                                last.responses()[i],
                                estimates.empty() ? unknown : estimates[i],
                                last.size(i),
                                last.isSmall(i),
                                {}});
  }
  result.forceErrorEstimate = estimates.empty() ? unknown : estimates[estimates.size() - 2];
  result.displacementErrorEstimate = estimates.empty() ? unknown : estimates.back();
  result.errorEstimate = estimates.empty() ? unknown : *std::max_element(estimates.begin(), estimates.end());
}

void addIndeterminacy(const Indeterminacy& found, double accuracy, LatinResult& result) {
  for (std::size_t i = 0; i < found.responses.size(); ++i) {
    const ResponseRange& range = found.responses[i];
    ResponseResult& response = result.responses[i];
    if (!(range.width() > accuracy * response.size)) continue;
    response.range = range;
    result.remarks.push_back(describe(response.name, range, response.values));
  }
  result.freePressures = found.pressures;
  if (!found.pressures.empty()) result.remarks.push_back(describePressures(found.pressures));
}

void addSoftening(const FixedPoint& fixedPoint, bool isSofter, LatinResult& result) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  if (!assembly.softens()) return;
  if (result.outcome == Outcome::certified) {
    result.remarks.push_back("the laws of " + namesOfSoftening(assembly) +
                             " soften, so that there may be other solutions: this is the one that the load history "
                             "has led to, load step after load step");
  }
  std::vector<std::string> steps;
  for (std::size_t t = 0; t < result.parts.size(); ++t) {
    if (result.parts[t] > 1) steps.push_back(std::to_string(t + 1) + " in " + std::to_string(result.parts[t]));
  }
  if (!steps.empty())
    result.remarks.push_back("load steps were followed in parts: " + base::joinNames(steps, mostNames));
  std::vector<std::string> snaps;
  for (std::size_t t = 0; t < result.snaps.size(); ++t) {
    if (result.snaps[t]) snaps.push_back(std::to_string(t + 1));
  }
  if (!snaps.empty()) {
    result.remarks.push_back("a joint snaps in load steps " + base::joinNames(snaps, mostNames) +
                             ": the branch of solutions ends there, and they are states at which it comes to rest" +
                             (assembly.path ? "" : "; Path Following may follow it"));
  }
  const std::vector<int>& held = fixedPoint.searchDirection().heldBySoftening();
  if (!isSofter || held.empty()) return;
  result.remarks.push_back("the search direction went down to a tenth, but on " + nameAll(assembly, held) +
                           " no further than the softening of the law allows");
}

}  // namespace harmos::latin
