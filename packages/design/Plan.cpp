#include <harmos/design/Plan.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::design {

namespace {

/// Runs `action`; what it throws begins with the place of the parameter or condition.
template <class Action>
auto placing(const std::string& where, Action action) {
  try {
    return action();
  } catch (const base::Error& error) {
    throw base::Error(where + ": " + error.what(), error.code());
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
    placing(parameters_[p].where, [&] { waiting.push_back({p, input::Formula(parameters_[p].formula, names)}); });
  }
  for (const Condition& condition : conditions) {
    placing(condition.where, [&] {
      conditions_.push_back({condition.where, input::Formula(condition.formula, names)});
    });
    leftOut_.emplace_back(condition.name, 0);
  }
  while (!waiting.empty()) {
    const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](const Derived& derived) {
      const auto needed = derived.formula.variables();
      return std::all_of(needed.begin(), needed.end(), [&](const std::string& name) {
        return isKnown[std::find(names.begin(), names.end(), name) - names.begin()];
      });
    });
    if (ready == waiting.end()) {
      std::vector<std::string> circle;
      for (const Derived& derived : waiting) circle.push_back(names[derived.parameter]);
      throw base::Error(parameters_[waiting.front().parameter].where +
                            ": the formulas refer to each other in a circle: " + base::joinNames(circle) + ".",
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
    placing(parameters_[derived.parameter].where,
            [&] { values[derived.parameter] = derived.formula.evaluate(values); });
  }
  for (std::size_t c = 0; c < conditions_.size(); ++c) {
    if (placing(conditions_[c].where, [&] { return conditions_[c].formula.evaluate(values) != 0.0; })) continue;
    ++leftOut_[c].second;
    return std::nullopt;
  }
  return values;
}

std::vector<Configuration> Plan::configurations(const Design& design) {
  for (auto& count : leftOut_) count.second = 0;
  std::vector<Configuration> result;
  const auto points = design.points(axes());
  for (const auto& point : points) {
    if (auto values = complete(point)) result.push_back({static_cast<int>(result.size()) + 1, std::move(*values)});
  }
  if (result.empty()) throw base::Error(whyNoneIsLeft(points.size()), base::ExitCode::input);
  return result;
}

std::string Plan::whyNoneIsLeft(std::size_t points) const {
  if (points == 0) return "the study has no configuration.";
  std::vector<std::string> causes;
  std::size_t strictest = 0;
  for (std::size_t c = 0; c < conditions_.size(); ++c) {
    const auto& [name, count] = leftOut_[c];
    if (count > 0) causes.push_back(base::quoted(name) + " leaves out " + std::to_string(count));
    if (count > leftOut_[strictest].second) strictest = c;
  }
  return conditions_[strictest].where + ": the study has no configuration: of the " + std::to_string(points) +
         " points of its design " + base::joinNames(causes) + ".";
}

}  // namespace harmos::design
