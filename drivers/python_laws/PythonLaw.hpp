#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::python_laws {

/// An object derived from harmos.laws.Law as a law of Harmos: every function takes Python's lock, and hands over
/// copies.
///
/// What Python raises becomes a base::Error; in solve() a laws::LawFailure, or a laws::NoIntersection where it says so.
class PythonLaw final : public laws::InterfaceLaw {
 public:
  /// `object`: what harmos.laws.bridge.made() has made. `file`: where its class stands, for messages. To be called with
  /// Python's lock.
  PythonLaw(const pybind11::object& object, std::string file);

  const char* name() const override { return name_.c_str(); }
  int historySize() const override { return historySize_; }
  laws::Frame frame() const override { return frame_; }
  laws::Sides sides() const override { return sides_; }
  bool prescribesTraction() const override { return false; }
  bool dissipates() const override { return dissipates_; }
  double keptWork(const laws::PairStep& step) const override;
  double storedEnergy(const laws::PairStep& step) const override;
  std::vector<laws::OutputField> outputs() const override { return outputs_; }
  void output(const laws::PairStep& step, double* values) const override;
  bool isAffine() const override { return isAffine_; }
  double lowestSlope() const override { return lowestSlope_; }
  bool isSmooth() const override { return isSmooth_ || isAffine_; }
  std::optional<laws::AdmissibleTractions> admissibleTractions(int step) const override;
  void solve(int step, const laws::NodeArrays& nodes) const override;

 private:
  /// What harmos.laws.bridge.stepped() gives for one pair.
  std::vector<double> stepped(const char* what, const laws::PairStep& step, std::size_t count) const;

  std::shared_ptr<const pybind11::object> object_;
  std::string file_, name_;
  int historySize_;
  laws::Frame frame_;
  laws::Sides sides_;
  bool dissipates_, isAffine_, isSmooth_, keepsWork_, storesEnergy_;
  double lowestSlope_;
  std::vector<laws::OutputField> outputs_;
};

}  // namespace harmos::python_laws
