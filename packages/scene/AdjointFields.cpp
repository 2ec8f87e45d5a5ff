#include <harmos/scene/detail/AdjointFields.hpp>

#include <algorithm>
#include <functional>
#include <map>

namespace harmos::scene {
namespace {

// Share of an adjoint that its residual may hide, and directions that all of them may take together.
constexpr double hiddenInAdjoint = 0.02;
constexpr int largestNumberOfDirections = 160;

using Column = AdjointFields::Column;

Column displacementsOf(const std::vector<PartPieces>& parts, const latin::Iterate& state, int step) {
  const assembly::Assembly& assembly = state.assembly();
  Column result(assembly.bodies.size());
  for (const PartPieces& part : parts) {
    for (const int b : part.bodies) {
      if (!state.layout().owns(b)) continue;
      for (std::size_t node = 0; node < assembly.bodies[b].nodes.size(); ++node) {
        const base::Vector3 u = strainingDisplacement(state, part, b, static_cast<int>(node), step);
        result[b].insert(result[b].end(), u.begin(), u.begin() + assembly.dimension);
      }
    }
  }
  return result;
}

void addTo(Column& sum, double factor, const Column& field) {
  sum.resize(field.size());
  for (std::size_t b = 0; b < field.size(); ++b) {
    sum[b].resize(field[b].size(), 0.0);
    for (std::size_t i = 0; i < field[b].size(); ++i) sum[b][i] += factor * field[b][i];
  }
}

/// Adjoint problems of the load steps that the last one depends on, the latest first.
using Problems = std::map<int, latin::AdjointProblem, std::greater<>>;

Problems problemsOf(latin::FixedPoint& fixedPoint, const latin::Iterate& state, int step) {
  Problems problems;
  std::vector<int> found{step};
  while (!found.empty()) {
    const int next = found.back();
    found.pop_back();
    const auto [problem, isNew] = problems.try_emplace(next, fixedPoint, state, next);
    if (!isNew) continue;
    for (const latin::KeptJump& kept : problem->second.kept()) found.push_back(kept.step);
  }
  return problems;
}

/// A jump that was found at a load step, and what the responses depend on it: dJ/dq.
struct Demand {
  const latin::KeptJump* jump;
  std::vector<double> ofResponse;
};

}  // namespace

AdjointFields adjointFields(const std::vector<PartPieces>& parts, latin::FixedPoint& fixedPoint,
                            const latin::Iterate& state, int step,
                            const std::vector<latin::ResponseGradient>& gradients) {
  const std::size_t responses = gradients.size();
  AdjointFields result;
  result.steps = {step};
  result.fields = {displacementsOf(parts, state, step)};
  result.isHidden.assign(responses, false);
  if (gradients.empty()) return result;
  Problems problems = problemsOf(fixedPoint, state, step);
  for (const auto& each : problems) {
    if (each.first == step) continue;
    result.steps.push_back(each.first);
    result.fields.push_back(displacementsOf(parts, state, each.first));
  }

  std::map<int, std::vector<Demand>> demands;  // by load step
  const auto pass = [&](const latin::AdjointProblem& from, const latin::AdjointProblem::Adjoint& adjoint,
                        const std::vector<double>& ofResponse) {
    for (std::size_t k = 0; k < from.kept().size(); ++k) {
      const latin::KeptJump& jump = from.kept()[k];
      std::vector<Demand>& here = demands[jump.step];
      // Of one face there is one jump, whichever later load steps keep it.
      const int face = jump.force.pairs.front().interface;
      auto found = std::find_if(here.begin(), here.end(), [&](const Demand& demand) {
        return demand.jump->force.pairs.front().interface == face;
      });
      if (found == here.end()) found = here.insert(here.end(), {&jump, std::vector<double>(responses, 0.0)});
      for (std::size_t j = 0; j < responses; ++j) found->ofResponse[j] += adjoint.ofKept[k] * ofResponse[j];
    }
  };

  auto adjoints = problems.at(step).solve(gradients, hiddenInAdjoint, largestNumberOfDirections);
  for (std::size_t j = 0; j < responses; ++j) {
    result.isHidden[j] = adjoints[j].hidden > hiddenInAdjoint;
    std::vector<double> only(responses, 0.0);
    only[j] = 1.0;
    pass(problems.at(step), adjoints[j], only);
    result.fields.push_back(std::move(adjoints[j].displacement));
    result.adjoints.push_back({0, static_cast<int>(j)});
  }
  int solution = 0;
  for (auto& [earlier, of] : problems) {
    if (earlier == step) continue;
    ++solution;
    const std::vector<Demand> here = demands[earlier];
    std::vector<latin::ResponseGradient> jumps;
    for (const Demand& demand : here) jumps.push_back(demand.jump->gradient);
    const auto ofJumps = of.solve(jumps, hiddenInAdjoint, largestNumberOfDirections);
    std::vector<Column> sums(responses);
    for (std::size_t k = 0; k < here.size(); ++k) {
      pass(of, ofJumps[k], here[k].ofResponse);
      for (std::size_t j = 0; j < responses; ++j) {
        if (ofJumps[k].hidden > hiddenInAdjoint && here[k].ofResponse[j] != 0.0) result.isHidden[j] = true;
        addTo(sums[j], here[k].ofResponse[j], ofJumps[k].displacement);
      }
    }
    for (std::size_t j = 0; j < responses; ++j) {
      result.fields.push_back(std::move(sums[j]));
      result.adjoints.push_back({solution, static_cast<int>(j)});
    }
  }
  return result;
}

}  // namespace harmos::scene
