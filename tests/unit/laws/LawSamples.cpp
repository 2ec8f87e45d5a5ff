#include "LawSamples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace harmos::laws {
namespace {

/// A number of the order of one in the range of a declared parameter.
double draw(const input::ParameterEntry& entry, Random& random) {
  const bool hasMinimum = std::isfinite(entry.minimum), hasMaximum = std::isfinite(entry.maximum);
  if (hasMinimum && hasMaximum) return uniform(random, entry.minimum, entry.maximum);
  if (hasMinimum) return entry.minimum + magnitude(random);
  if (hasMaximum) return entry.maximum - magnitude(random);
  return std::uniform_int_distribution<int>(0, 1)(random) == 0 ? magnitude(random) : -magnitude(random);
}

std::vector<double> ascending(const input::ParameterEntry& entry, Random& random) {
  std::vector<double> numbers;
  for (int i = 0; i < 3; ++i) numbers.push_back(draw(entry, random));
  std::sort(numbers.begin(), numbers.end());
  if (entry.minimum == 0.0 && entry.allows(0.0)) numbers.front() = 0.0;
  return numbers;
}

}  // namespace

double uniform(Random& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

double magnitude(Random& random) {
  return std::pow(10.0, uniform(random, -1.5, 1.5));
}

base::Vector3 randomVector(Random& random) {
  const double size = magnitude(random);
  base::Vector3 v;
  for (double& c : v) c = size * uniform(random, -1.0, 1.0);
  return v;
}

LocalLine randomLine(Random& random) {
  return {randomVector(random), magnitude(random)};
}

LocalLine randomLine(Random& random, const InterfaceLaw& law) {
  LocalLine line = randomLine(random);
  const double limit = complianceLimit(law);
  if (std::isfinite(limit)) line.compliance = uniform(random, 0.01, 0.7) * limit;
  return line;
}

double complianceLimit(const InterfaceLaw& law) {
  const double slope = law.lowestSlope();
  return slope < 0.0 ? -1.0 / slope : std::numeric_limits<double>::infinity();
}

input::Parameters randomParameters(const input::ParameterSpec& spec, Random& random) {
  input::Parameters parameters("law");
  parameters.set("Type", spec.name());
  for (const auto& entry : spec.entries()) {
    switch (entry->type) {
      case input::ParameterType::number:
        parameters.set(entry->name, draw(*entry, random));
        break;
      case input::ParameterType::integer:
        parameters.set(entry->name, static_cast<int>(std::ceil(draw(*entry, random))));
        break;
      case input::ParameterType::flag:
        parameters.set(entry->name, std::uniform_int_distribution<int>(0, 1)(random) == 0);
        break;
      case input::ParameterType::text:
        if (entry->choices.empty()) break;
        parameters.set(entry->name, entry->choices[random() % entry->choices.size()]);
        break;
      case input::ParameterType::numbers:
        parameters.set(entry->name, ascending(*entry, random));
        break;
      case input::ParameterType::texts:
        parameters.set(entry->name, entry->choices);
        break;
    }
  }
  return parameters;
}

input::Parameters scaled(const input::ParameterSpec& spec, const input::Parameters& parameters,
                         const std::function<double(const input::ParameterEntry&)>& factor) {
  input::Parameters result = parameters;
  for (const auto& entry : spec.entries()) {
    if (entry->type == input::ParameterType::number)
      result.set(entry->name, factor(*entry) * parameters.number(entry->name));
    if (entry->type == input::ParameterType::numbers) {
      std::vector<double> numbers = parameters.numbers(entry->name);
      for (double& number : numbers) number *= factor(*entry);
      result.set(entry->name, std::move(numbers));
    }
  }
  return result;
}

Node::Node(const InterfaceLaw& law, double gap, const base::Frame& frame, double area, const base::Vector3& place)
    : law_(law),
      gap_(gap),
      area_(area),
      frame_(frame),
      place_(place),
      old_(static_cast<std::size_t>(law.historySize()), 0.0),
      new_(static_cast<std::size_t>(law.historySize()), std::numeric_limits<double>::quiet_NaN()) {}

NodeArrays Node::arrays() {
  NodeArrays nodes{1, &line_, &gap_, old_.data(), new_.data(), &state_, &place_, &frame_, &area_};
  nodes.duration = duration_;
  nodes.time = (step_ + 1) * duration_;
  return nodes;
}

LocalState Node::solve(const LocalLine& line, int step, double duration) {
  // What the law does not write would be left from the step before last.
  std::fill(new_.begin(), new_.end(), std::numeric_limits<double>::quiet_NaN());
  line_ = line;
  step_ = step;
  duration_ = duration;
  state_ = {};
  law_.solve(step, arrays());
  return state_;
}

PairStep Node::step() {
  asked_ = arrays();
  return {oldJump_,    line_.jump(state_.traction),  state_.traction, old_.data(),
          new_.data(), NodeContext(step_, asked_, 0)};
}

void Node::accept() {
  oldJump_ = line_.jump(state_.traction);
  old_ = new_;
}

}  // namespace harmos::laws
