#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Schedule.hpp>

namespace harmos::input {

/// A number that varies over the load steps and, by a formula, over space and time: number times history times
/// formula(x, y, z, t), in the unit of the number; t is the time at the end of the load step.
class Field {
 public:
  /// Declares the companion text "<name> Formula" of a number or a list of numbers.
  static void describe(ParameterSpec& spec, const std::string& name);

  /// The same value everywhere and always.
  Field(double constant = 0.0) : schedule_(constant) {}
  /// Reads the number of this name, its history and its formula. Throws base::Error (input) as Parameters::schedule(),
  /// and for a text that is no formula in x, y, z and t.
  Field(const Parameters& parameters, const std::string& name);
  /// What multiplies a list of numbers of this name: its formula, 1 without one. Throws as the constructor does.
  static Field factor(const Parameters& parameters, const std::string& name);

  /// Whether a formula is given for the number of this name.
  static bool isGiven(const Parameters& parameters, const std::string& name);
  /// Whether its formula uses "x", "y", "z" or "t".
  bool looksAt(const std::string& variable) const;
  /// Value at a load step, counted from 0, and a place [length]. Safe to use from several threads. Throws base::Error
  /// (input) with the place of the entry where the formula has no finite value.
  double operator()(int step, const base::Vector3& place) const;

 private:
  Field(Schedule schedule, const Parameters& parameters, const std::string& name);

  struct Distribution;
  Schedule schedule_;
  std::vector<double> times_;  // of the load steps
  std::shared_ptr<Distribution> formula_;
};

}  // namespace harmos::input
