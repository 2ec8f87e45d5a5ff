#pragma once

#include <array>
#include <optional>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Schedule.hpp>
#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/laws/TurnedLaw.hpp>

namespace harmos::laws {

/// A rigid body of given shape that a boundary may touch: unilateral contact with Coulomb friction.
///
/// At a place x of the undeformed surface the tool has the distance g(x) >= 0 along the unit normal n(x) from the part
/// to the tool. It moves by m(t), without turning. Small sliding: n and g stay those of the place. With the
/// displacement w of the part the distance left is g + (m - w).n, at points between nodes with the mean of theirs for
/// g, and the tangential jump (m - w)_t; see frictionalContact. The traction acts on the part. History: tangential jump
/// at the end of the previous load step [length].
class RigidTool : public InterfaceLaw, public TurnedLaw {
 public:
  int historySize() const override { return 2; }
  Frame frame() const override { return Frame::interface; }
  Sides sides() const override { return Sides::one; }
  bool prescribesTraction() const override { return false; }
  bool dissipates() const override { return true; }
  /// What pressure does where a gap closes, and what friction takes from the motion of the tool instead of the part.
  double keptWork(const PairStep& step) const override;
  std::vector<OutputField> outputs() const override;
  void output(const PairStep& step, double* values) const override;
  Creases creases() const override { return Creases::ignore; }
  std::optional<AdmissibleTractions> admissibleTractions(int step) const override {
    return AdmissibleTractions::pressure(friction_[step]);
  }
  void solve(int step, const NodeArrays& nodes) const override;

  base::Frame axesAt(const base::Vector3& place) const override;
  bool isOutside() const override { return true; }
  void demandPlaces(const std::vector<base::Vector3>& places, int steps) const override;

 protected:
  /// The tool as seen from a place.
  struct Side {
    base::Vector3 normal{};  ///< n [-]; 0: no direction leads to the tool
    double gap = 0.0;        ///< g [length], negative inside of the tool
  };

  /// Declares what all shapes have.
  static void describeTool(input::ParameterSpec& p);
  /// Of what describeTool() declares.
  explicit RigidTool(const input::Parameters& p);
  /// Of the undeformed place [length].
  virtual Side sideAt(const base::Vector3& place) const = 0;

 private:
  /// m at a load step counted from 0 [length]; before the first: 0.
  base::Vector3 motion(int step) const;

  input::Schedule friction_;
  std::array<input::Schedule, 3> motion_;
  double interference_;
};

/// A vector of up to three numbers, the others 0.
base::Vector3 vectorOf(const input::Parameters& p, const char* entry);

/// The same as a direction of length 1. Throws base::Error(input) when all numbers are 0.
base::Vector3 directionOf(const input::Parameters& p, const char* entry);

}  // namespace harmos::laws
