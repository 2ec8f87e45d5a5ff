#include <harmos/input/Field.hpp>

#include <algorithm>
#include <mutex>

#include <harmos/base/Error.hpp>
#include <harmos/input/Formula.hpp>

namespace harmos::input {

struct Field::Distribution {
  Formula formula;
  std::string where;
  std::mutex mutex;  // a formula is no matter of several threads
};

namespace {

std::string companionOf(const std::string& name) {
  return name + " Formula";
}

/// Gives errors of formulas their place.
template <class Action>
auto placed(const std::string& where, const Action& action) {
  try {
    return action();
  } catch (const base::Error& error) {
    throw base::Error(where + ": " + error.what(), error.code());
  }
}

}  // namespace

void Field::describe(ParameterSpec& spec, const std::string& name) {
  spec.text(companionOf(name))
      .optional()
      .doc("Formula in x, y, z [length] and t [time] that multiplies " + name +
           ", such as \"1 - y / 10\" or \"sin(2 * _pi * x / 40) * (t > 1 ? 1 : t)\"; absent: 1.");
}

bool Field::isGiven(const Parameters& parameters, const std::string& name) {
  return parameters.has(companionOf(name));
}

Field::Field(const Parameters& parameters, const std::string& name)
    : Field(parameters.schedule(name), parameters, name) {}

Field Field::factor(const Parameters& parameters, const std::string& name) {
  return Field(Schedule(1.0), parameters, name);
}

Field::Field(Schedule schedule, const Parameters& parameters, const std::string& name)
    : schedule_(std::move(schedule)), times_(parameters.times()) {
  const std::string companion = companionOf(name);
  if (!parameters.has(companion)) return;
  const std::string where = parameters.where(companion);
  const Formula::Words words{"place or time", "Known are", "\"1 - y / 10\" or \"sqrt(x^2 + y^2) * t\""};
  formula_ = placed(where, [&] {
    return std::shared_ptr<Distribution>(
        new Distribution{Formula(parameters.text(companion), {"x", "y", "z", "t"}, words), where, {}});
  });
}

bool Field::looksAt(const std::string& variable) const {
  if (!formula_) return false;
  const std::vector<std::string> used = formula_->formula.variables();
  return std::find(used.begin(), used.end(), variable) != used.end();
}

double Field::operator()(int step, const base::Vector3& place) const {
  const double value = schedule_[step];
  if (!formula_) return value;
  const double time = times_.empty() ? 0.0 : times_[step];
  return placed(formula_->where, [&] {
    const std::lock_guard<std::mutex> lock(formula_->mutex);
    return value * formula_->formula.evaluate({place[0], place[1], place[2], time});
  });
}

}  // namespace harmos::input
