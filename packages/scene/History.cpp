#include <harmos/scene/detail/History.hpp>

#include <algorithm>
#include <functional>

#include <harmos/base/Error.hpp>
#include <harmos/input/Formula.hpp>

namespace harmos::scene {

namespace {

/// Piecewise linear through (times, values), constant outside.
double interpolate(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return values.front();
  if (after == times.end()) return values.back();
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double fraction = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return values[i - 1] + fraction * (values[i] - values[i - 1]);
}

/// A formula in t at every time; 0 at those after an error.
std::vector<double> valuesOf(const input::Parameters& history, const std::vector<double>& times,
                             input::ErrorList& errors) {
  std::vector<double> values;
  errors.collect(history.where("Formula"), [&] {
    const input::Formula formula(history.text("Formula"), {"t"},
                                 {"time", "Known is", "\"sin(2 * _pi * t)\" or \"t < 1 ? t : 1\""});
    for (const double time : times) values.push_back(formula.evaluate({time}));
  });
  values.resize(times.size(), 0.0);
  return values;
}

}  // namespace

std::vector<input::ParameterSpec> historyForms() {
  input::ParameterSpec table("Table"), ramp("Ramp"), formula("Formula");
  table.summary("Piecewise linear in time, constant before the first and after the last point.");
  table.numbers("Times").unit("time").doc("Increasing.");
  table.numbers("Values").unit("-").doc("Factor at each of the times.");
  ramp.summary("0 until Start, then linear to 1 at End, 1 afterwards.");
  ramp.number("Start").unit("time").defaultValue(0.0).doc("Where the factor begins to grow.");
  ramp.number("End").unit("time").required().doc("Where the factor reaches 1; after Start.");
  formula.summary("A formula in the time at the end of every time step.");
  formula.text("Formula").example("sin(2 * _pi * t)").required().doc("Of t [time], in the syntax of muParser.");
  return {table, ramp, formula};
}

std::vector<double> historyFactors(const input::Parameters& history, const std::vector<double>& times,
                                   input::ErrorList& errors) {
  if (history.type() == "Formula") return valuesOf(history, times, errors);
  std::vector<double> at, values;
  if (history.type() == "Ramp") {
    at = {history.number("Start"), history.number("End")};
    values = {0.0, 1.0};
    if (at[1] <= at[0]) errors.add(history.where("End"), "End is not after Start.");
  } else {
    at = history.numbers("Times");
    values = history.numbers("Values");
    if (at.empty() || at.size() != values.size()) {
      errors.add(history.where("Times"),
                 std::to_string(at.size()) + " times and " + std::to_string(values.size()) + " values are given.",
                 "Give one value per time, and at least one.");
      return std::vector<double>(times.size(), 0.0);
    }
    if (std::adjacent_find(at.begin(), at.end(), std::greater_equal<>()) != at.end()) {
      errors.add(history.where("Times"), "the times do not increase.", "Sort them and remove equal ones.");
    }
  }
  std::vector<double> factors;
  for (const double time : times) factors.push_back(interpolate(at, values, time));
  return factors;
}

}  // namespace harmos::scene
