#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/FaceJoint.hpp>
#include <harmos/laws/detail/RemotePoint.hpp>

namespace harmos::laws {
namespace {

constexpr std::array<const char*, 6> components = {"X", "Y", "Z", "Rotation X", "Rotation Y", "Rotation Z"};
constexpr std::array<const char*, 6> forces = {"Force X", "Force Y", "Force Z", "Moment X", "Moment Y", "Moment Z"};

/// Displacement and rotation of a face in a point, each of the six held, on a spring to the ground, or free under a
/// force. See FaceJoint.
class RemoteDisplacement final : public CoupledLaw, public FaceLaw {
 public:
  static constexpr const char* lawName = "Remote Displacement";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Displacement and small rotation of a face in a point, each of the six held, on a spring, or free under a "
        "force. "
        "The responses Interface Force and Interface Moment are its reactions.");
    p.equation("mean motion of the face in the point: u_i = given, or F_i = K_i (given - u_i), or F_i = given");
    p.text("Kind")
        .defaultValue("Distributing")
        .oneOf({"Distributing", "Rigid"})
        .doc(
            "Distributing: the mean motion of the face counts, which stays free to deform; Rigid: it does not deform.");
    describeRemotePoint(p);
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string name = components[i];
      p.number(name)
          .example(i < 3 ? "0.001" : "")
          .unit(i < 3 ? "length" : "radians")
          .optional()
          .varying()
          .doc(i < 3 ? "Displacement of the point along this axis; absent: free, or at the end of its spring 0."
                     : "Rotation about this axis; absent: free, or at the end of its spring 0.");
      p.number(name + " Stiffness")
          .unit(i < 3 ? "force/length" : "force length")
          .optional()
          .atLeast(0.0)
          .doc(i < 3 ? "Of a spring between the point and the ground, which has the displacement; absent: rigid."
                     : "The same of a spring that resists the rotation, per radian; absent: rigid.");
      p.number(forces[i])
          .unit(i < 3 ? "force" : "force length")
          .optional()
          .varying()
          .doc(i < 3 ? "Acts in the point along this axis, where that is not held."
                     : "Acts about this axis, where that is not held.");
    }
  }

  explicit RemoteDisplacement(const input::Parameters& p)
      : kind_(p.text("Kind") == "Rigid" ? FaceJoint::Kind::rigid : FaceJoint::Kind::distributing),
        point_(remotePointOf(p)) {
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string name = components[i];
      if (p.has(name)) {
        value_[i] = p.schedule(name);
        stiffness_[i] = std::numeric_limits<double>::infinity();
      }
      if (p.has(name + " Stiffness")) stiffness_[i] = p.number(name + " Stiffness");
      if (!p.has(forces[i])) continue;
      force_[i] = p.schedule(forces[i]);
      if (!std::isinf(stiffness_[i])) continue;
      throw base::Error(
          p.where(forces[i]) + ": it has no effect, because \"" + name + "\" is held.\n  Remove one of them.",
          base::ExitCode::input);
    }
  }

  const char* name() const override { return lawName; }
  int historySize() const override { return 0; }
  Frame frame() const override { return Frame::global; }
  Sides sides() const override { return Sides::one; }
  bool dissipates() const override { return false; }
  int sums() const override { return FaceJoint::numberOfSums; }

  std::shared_ptr<const InterfaceLaw> on(std::shared_ptr<const FaceMotions> face) const override {
    auto bound = std::make_shared<RemoteDisplacement>(*this);
    const base::Frame axes{{{{{1.0, 0.0, 0.0}}}, {{{0.0, 1.0, 0.0}}}, {{{0.0, 0.0, 1.0}}}}};
    bound->joint_.emplace(kind_, *face, point_.value_or(face->centre()), axes, 1.0);
    bound->face_ = std::move(face);
    return bound;
  }
  const std::shared_ptr<const FaceMotions>& face() const override { return face_; }
  bool leavesFaceFree() const override { return kind_ == FaceJoint::Kind::distributing; }
  std::vector<HeldMotion> heldMotions() const override {
    std::vector<HeldMotion> held;
    if (!leavesFaceFree()) return held;
    for (const int c : face_->components()) {
      const auto i = static_cast<std::size_t>(c);
      if (!std::isinf(stiffness_[i])) continue;
      FaceMotions::Six unit{};
      unit[i] = 1.0;
      // A force in the point does the work of its displacement.
      held.push_back({components[i], face_->fromPoint(point_.value_or(face_->centre()), unit)});
    }
    return held;
  }

  std::optional<std::array<Resultant, 6>> resultants(int step) const override {
    std::array<Resultant, 6> all;
    for (std::size_t i = 0; i < 6; ++i) all[i] = {stiffness_[i] > 0.0, std::isinf(stiffness_[i]), force_[i][step]};
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
    FaceJoint::Components all;
    for (std::size_t i = 0; i < 6; ++i) all[i] = {stiffness_[i], value_[i][step], force_[i][step]};
    joint_->meet(nodes, joint_->solve(all, sums));
  }

  void solveTangent(int, const NodeArrays& nodes, const double* sums) const override {
    FaceJoint::Components all;
    for (std::size_t i = 0; i < 6; ++i) all[i].stiffness = stiffness_[i];
    joint_->meet(nodes, joint_->solve(all, sums));
  }

 private:
  FaceJoint::Kind kind_;
  std::optional<base::Vector3> point_;
  std::array<input::Schedule, 6> value_, force_;
  std::array<double, 6> stiffness_{};
  std::optional<FaceJoint> joint_;
  std::shared_ptr<const FaceMotions> face_;
};

}  // namespace

HARMOS_WHOLE_LAW(RemoteDisplacement)

}  // namespace harmos::laws
