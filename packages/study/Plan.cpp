#include <harmos/study/Plan.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::study {

namespace {

/// Runs `action`; what it throws begins with the name of the parameter or condition.
template <class Action>
auto naming(const std::string& name, Action action) {
  try {
    return action();
  } catch (const base::Error& error) {
    throw base::Error(name + ": " + error.what(), error.code());
  }
}

}  // namespace

Plan::Plan(std::vector<PlannedParameter> parameters, const std::vector<Condition>& conditions)
    : parameters_(std::move(parameters)) {
  std::vector<std::string> names;
  std::vector<bool> isKnown;
  for (const PlannedParameter& parameter : parameters_) {
    names.push_back(parameter.axis.name);
    isKnown.push_back(parameter.formula.empty());
  }
  std::vector<Derived> waiting;
  for (std::size_t p = 0; p < parameters_.size(); ++p) {
    if (isKnown[p]) continue;
    naming(names[p], [&] { waiting.push_back({p, Formula(parameters_[p].formula, names)}); });
  }
  for (const Condition& condition : conditions) {
    naming(condition.name, [&] { conditions_.emplace_back(condition.formula, names); });
    leftOut_.emplace_back(condition.name, 0);
  }
  const auto remember = [&](const Formula& formula) {
    const auto used = formula.variables();
    namesInFormulas_.insert(namesInFormulas_.end(), used.begin(), used.end());
  };
  for (const Derived& derived : waiting) remember(derived.formula);
  for (const Formula& condition : conditions_) remember(condition);

  while (!waiting.empty()) {
    const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](const Derived& derived) {
      const auto needed = derived.formula.variables();
      return std::all_of(needed.begin(), needed.end(), [&](const std::string& name) {
        return isKnown[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
      });
    });
    if (ready == waiting.end()) {
      std::vector<std::string> circle;
      for (const Derived& derived : waiting) circle.push_back(names[derived.parameter]);
      throw base::Error(
          circle.front() + ": the formulas refer to each other in a circle: " + base::joinNames(circle) + ".",
          base::ExitCode::input);
    }
    isKnown[ready->parameter] = true;
    derived_.push_back(std::move(*ready));
    waiting.erase(ready);
  }
}

std::vector<Configuration> Plan::configurations(const Design& design) {
  std::vector<Axis> axes;
  for (const PlannedParameter& parameter : parameters_) {
    if (parameter.formula.empty()) axes.push_back(parameter.axis);
  }
  for (auto& count : leftOut_) count.second = 0;
  std::vector<Configuration> result;
  for (const auto& point : design.points(axes)) {
    std::vector<double> values(parameters_.size());
    auto next = point.begin();
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
      if (parameters_[p].formula.empty()) values[p] = *next++;
    }
    for (const Derived& derived : derived_) {
      naming(parameters_[derived.parameter].axis.name,
             [&] { values[derived.parameter] = derived.formula.evaluate(values); });
    }
    std::size_t violated = 0;
    while (violated < conditions_.size() &&
           naming(leftOut_[violated].first, [&] { return conditions_[violated].evaluate(values) != 0.0; })) {
      ++violated;
    }
    if (violated < conditions_.size()) {
      ++leftOut_[violated].second;
    } else {
      result.push_back({static_cast<int>(result.size()) + 1, std::move(values)});
    }
  }
  if (result.empty()) throw base::Error("the study has no configuration.", base::ExitCode::input);
  return result;
}

}  // namespace harmos::study
