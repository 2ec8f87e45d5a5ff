#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include <harmos/base/Error.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/FaceJoint.hpp>
#include <harmos/laws/detail/Locking.hpp>
#include <harmos/laws/detail/RemotePoint.hpp>

namespace harmos::laws {
namespace {

/// Which stiffness each motion along and about the axis and across it has.
constexpr std::array<const char*, 6> stiffnessOf = {"Axial Stiffness",   "Shear Stiffness",   "Shear Stiffness",
                                                    "Torsion Stiffness", "Bending Stiffness", "Bending Stiffness"};

/// The axis that is given, and two directions across it, the second along z in the plane.
base::Frame axesAlong(const input::Parameters& p) {
  base::Vector3 axis{};
  const std::vector<double>& given = p.numbers("Axis");
  if (given.size() == 2 || given.size() == 3) std::copy(given.begin(), given.end(), axis.begin());
  const double length = base::norm(axis);
  if (!(length > 0.0)) {
    throw base::Error(
        p.where("Axis") + ": is not a direction.\n  Give 2 numbers in the plane or 3 in space, not all 0.",
        base::ExitCode::input);
  }
  axis = (1.0 / length) * axis;
  constexpr double steep = 0.9;
  const base::Vector3 helper = std::abs(axis[2]) < steep ? base::Vector3{0.0, 0.0, 1.0} : base::Vector3{1.0, 0.0, 0.0};
  base::Vector3 across = base::cross(helper, axis);
  across = (1.0 / base::norm(across)) * across;
  base::Frame axes{};
  axes[0] = axis;
  axes[1] = across;
  axes[2] = base::cross(axis, across);
  return axes;
}

/// A joint between two faces that may be apart: springs between their mean motions in a point, side 2 against side 1,
/// as bolts, hinges and bearings are. Both faces stay free to deform. See FaceJoint.
///
/// Tightened as a bolt it has its force along the axis until it is locked; then the force is that of the lock and of
/// the axial stiffness times the elongation since. History: axial force, and elongation, at the end of the previous
/// load step, the same at all points.
class FaceSpring final : public CoupledLaw, public FaceLaw {
 public:
  static constexpr const char* lawName = "Face Spring";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Springs between the mean motions of two faces in a point: a bolt with preload, a hinge, a bearing. The faces "
        "may "
        "be apart and stay free to deform; they are two side sets.");
    p.equation(
        "F = F_0 + K Delta, with Delta the mean motion of face 2 in the point less that of face 1, F the force and "
        "moment on it");
    p.numbers("Point")
        .example("{25, 5, 10}")
        .unit("length")
        .required()
        .doc("In which both faces are moved against each other.");
    p.numbers("Axis").example("{0, 0, 1}").required().doc("From side 1 to side 2, of any length.");
    const auto stiffness = [&](const char* name, const char* unit, const char* text) {
      p.number(name).unit(unit).optional().atLeast(0.0).doc(text);
    };
    stiffness("Axial Stiffness", "force/length", "Along the axis; 0: free, absent: rigid, as for all of them.");
    stiffness("Shear Stiffness", "force/length", "Across the axis.");
    stiffness("Bending Stiffness", "force length", "Against rotation across the axis, per radian.");
    stiffness("Torsion Stiffness", "force length",
              "Against rotation about the axis, per radian; has no use in the plane.");
    p.number("Force").unit("force").optional().varying().doc(
        "Preload: the force along the axis until it is locked, positive in tension; absent: none.");
    describeLocking(p);
  }

  explicit FaceSpring(const input::Parameters& p) : point_(*remotePointOf(p)), axes_(axesAlong(p)), locking_(p) {
    for (std::size_t i = 0; i < 6; ++i) {
      stiffness_[i] = p.has(stiffnessOf[i]) ? p.number(stiffnessOf[i]) : std::numeric_limits<double>::infinity();
    }
    if (p.has("Force")) force_ = p.schedule("Force");
    if (force_ || !p.has("Locked From")) return;
    throw base::Error(
        p.where("Locked From") + ": there is no \"Force\" that is locked.\n  Give it, or remove this entry.",
        base::ExitCode::input);
  }

  const char* name() const override { return lawName; }
  int historySize() const override { return 2; }
  Frame frame() const override { return Frame::global; }
  Sides sides() const override { return Sides::two; }
  bool dissipates() const override { return false; }
  int sums() const override { return FaceJoint::numberOfSums; }
  int keepsJumpSince(int step) const override { return force_ ? locking_.lockedSince(step) : -1; }
  std::optional<double> tighteningForce(int step) const override {
    return force_ && !locking_.isLocked(step) ? std::optional<double>((*force_)[step]) : std::nullopt;
  }
  /// The elongation, that of face 2 less that of face 1; both have the force along the axis.
  KeptShare keptShare(const base::Vector3& place, const base::Vector3&, double) const override {
    return {-1.0 * joint_->vectors(place)[0], (isOther_ ? -0.5 : 0.5) * axes_[0]};
  }

  std::shared_ptr<const InterfaceLaw> on(std::shared_ptr<const FaceMotions> face) const override {
    auto bound = std::make_shared<FaceSpring>(*this);
    bound->joint_.emplace(FaceJoint::Kind::distributing, *face, point_, axes_, isOther_ ? 1.0 : -1.0);
    bound->face_ = std::move(face);
    return bound;
  }
  const std::shared_ptr<const FaceMotions>& face() const override { return face_; }
  std::shared_ptr<const InterfaceLaw> onOtherFace() const override {
    auto other = std::make_shared<FaceSpring>(*this);
    other->isOther_ = true;
    return other;
  }

  /// Its force along the axis is that of tighteningForce(), or that of the lock, which the axial stiffness bears on.
  std::optional<std::array<Resultant, 6>> resultants(int step) const override {
    std::array<Resultant, 6> all;
    for (std::size_t i = 0; i < 6; ++i) {
      all[i].isBorne = stiffness_[i] > 0.0;
      all[i].isHeld = std::isinf(stiffness_[i]);
    }
    if (force_) {
      all[0].isBorne = locking_.isLocked(step);
      all[0].isHeld = all[0].isHeld && all[0].isBorne;
    }
    return all;
  }
  std::array<base::Vector3, 6> unitTractions(const base::Vector3& place) const override {
    return joint_->unitTractions(place);
  }

  void addToSums(int, const NodeArrays& nodes, double* sums) const override {
    assert(joint_ && "the law is bound to its face before it is asked");
    joint_->addToSums(nodes, sums);
  }

  void solvePoints(int step, const NodeArrays& nodes, const double* sums) const override {
    if (nodes.count == 0) return;
    FaceJoint::Components all = linear(step);
    if (force_ && !locking_.isLocked(step)) all[0].force = -(*force_)[step];
    if (force_ && locking_.isLocked(step)) {
      all[0].force = -nodes.oldHistory[0];
      all[0].value = nodes.oldHistory[1];
    }
    const FaceJoint::Six c = joint_->solve(all, sums);
    joint_->meet(nodes, c);
    const double elongation = joint_->motions(sums, c)[0];
    for (std::ptrdiff_t p = 0; p < nodes.count; ++p) {
      nodes.newHistory[2 * p] = -c[0];
      nodes.newHistory[2 * p + 1] = elongation;
    }
  }

  void solveTangent(int step, const NodeArrays& nodes, const double* sums) const override {
    joint_->meet(nodes, joint_->solve(linear(step), sums));
  }

 private:
  FaceJoint::Components linear(int step) const {
    FaceJoint::Components all;
    for (std::size_t i = 0; i < 6; ++i) all[i].stiffness = stiffness_[i];
    if (force_ && !locking_.isLocked(step)) all[0].stiffness = 0.0;
    return all;
  }

  base::Vector3 point_;
  base::Frame axes_;
  Locking locking_;
  std::array<double, 6> stiffness_{};
  std::optional<input::Schedule> force_;
  bool isOther_ = false;
  std::optional<FaceJoint> joint_;
  std::shared_ptr<const FaceMotions> face_;
};

}  // namespace

HARMOS_WHOLE_LAW(FaceSpring)

}  // namespace harmos::laws
