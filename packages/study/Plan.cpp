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

std::vector<Axis> Plan::axes() const {
  std::vector<Axis> axes;
  for (const PlannedParameter& parameter : parameters_) {
    if (parameter.formula.empty()) axes.push_back(parameter.axis);
  }
  return axes;
}

std::optional<std::vector<double>> Plan::complete(const std::vector<double>& point) {
  std::vector<double> values(parameters_.size());
  auto next = point.begin();
  for (std::size_t p = 0; p < parameters_.size(); ++p) {
    if (parameters_[p].formula.empty()) values[p] = *next++;
  }
  for (const Derived& derived : derived_) {
    naming(parameters_[derived.parameter].axis.name,
           [&] { values[derived.parameter] = derived.formula.evaluate(values); });
  }
  for (std::size_t c = 0; c < conditions_.size(); ++c) {
    if (naming(leftOut_[c].first, [&] { return conditions_[c].evaluate(values) != 0.0; })) continue;
    ++leftOut_[c].second;
    return std::nullopt;
  }
  return values;
}

std::vector<Configuration> Plan::configurations(const Design& design) {
  for (auto& count : leftOut_) count.second = 0;
  std::vector<Configuration> result;
  for (const auto& point : design.points(axes())) {
    if (auto values = complete(point)) result.push_back({static_cast<int>(result.size()) + 1, std::move(*values)});
  }
  if (result.empty()) throw base::Error("the study has no configuration.", base::ExitCode::input);
  return result;
}

}  // namespace harmos::study
