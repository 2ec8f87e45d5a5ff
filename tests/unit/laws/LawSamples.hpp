#pragma once

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <harmos/laws/LawRegistry.hpp>

#include "MakeLaw.hpp"

namespace harmos::laws {

/// Every run of a test draws the same numbers.
using Random = std::mt19937;

double uniform(Random& random, double lower, double upper);
/// Positive and of the order of one: 10^-1.5 .. 10^1.5.
double magnitude(Random& random);
base::Vector3 randomVector(Random& random);
LocalLine randomLine(Random& random);
/// One that the law meets once: where it softens, of a compliance below the limit.
LocalLine randomLine(Random& random, const InterfaceLaw& law);
/// The compliance below which a law meets every line once; infinite where it is monotone.
double complianceLimit(const InterfaceLaw& law);

/// What a law declares, as parameters for it: random within the declared ranges, of the order of one. Parameters that
/// need not be given are given, but for texts of any kind. Lists have three numbers each, which ascend, from 0 where
/// that is the least.
input::Parameters randomParameters(const input::ParameterSpec& spec, Random& random);
/// The same values with every number, and all of a list, multiplied by factor(its declaration).
input::Parameters scaled(const input::ParameterSpec& spec, const input::Parameters& parameters,
                         const std::function<double(const input::ParameterEntry&)>& factor);

/// One node of an interface, led from load step to load step.
class Node {
 public:
  static constexpr base::Frame axes{{{{{1.0, 0.0, 0.0}}}, {{{0.0, 1.0, 0.0}}}, {{{0.0, 0.0, 1.0}}}}};

  static constexpr base::Vector3 somewhere{{1.0, 2.0, 3.0}};

  explicit Node(const InterfaceLaw& law, double gap = 0.0, const base::Frame& frame = axes, double area = 1.0,
                const base::Vector3& place = somewhere);
  /// Meets a line; the load step goes on, so that other lines may follow. `duration` of the load step.
  LocalState solve(const LocalLine& line, int step = 0, double duration = 1.0);
  /// The load step up to the line that was met last; valid until the next call.
  PairStep step();
  /// Ends the load step at the line that was met last.
  void accept();
  const std::vector<double>& oldHistory() const { return old_; }
  const std::vector<double>& newHistory() const { return new_; }

 private:
  NodeArrays arrays();

  const InterfaceLaw& law_;
  double gap_;
  double area_;
  base::Frame frame_;
  base::Vector3 place_;
  std::vector<double> old_, new_;
  int step_ = 0;
  double duration_ = 0.0;
  LocalLine line_{};
  LocalState state_;
  base::Vector3 oldJump_{};
  NodeArrays asked_;
};

}  // namespace harmos::laws
