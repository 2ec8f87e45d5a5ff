#include <array>
#include <cassert>

#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/RemotePoint.hpp>

namespace harmos::laws {
namespace {

constexpr std::array<const char*, 3> forces = {"X", "Y", "Z"};
constexpr std::array<const char*, 3> moments = {"Moment X", "Moment Y", "Moment Z"};

/// A force and a moment in a point, spread over a face which stays free to deform: f = a + b x (x - c), with a and b
/// such that the resultant is what is asked for. They do the work of force and moment on the mean motion of the face.
class RemoteForce final : public InterfaceLaw, public FaceLaw {
 public:
  static constexpr const char* lawName = "Remote Force";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Force and moment in a point, spread over a face which stays free to deform (a distributing coupling): "
        "tractions that vary linearly over the face.");
    p.equation("t = a + b x (x - c), with the force and the moment in the point as resultants");
    describeRemotePoint(p);
    for (const char* component : forces) {
      p.number(component).example("100").unit("force").defaultValue(0.0).varying().doc(
          "Force in the point along this axis.");
    }
    for (const char* component : moments) {
      p.number(component)
          .example("100")
          .unit("force length")
          .defaultValue(0.0)
          .varying()
          .doc("Moment about the point, right-handed.");
    }
  }

  explicit RemoteForce(const input::Parameters& p) : point_(remotePointOf(p)) {
    for (std::size_t i = 0; i < 3; ++i) {
      value_[i] = p.schedule(forces[i]);
      value_[i + 3] = p.schedule(moments[i]);
    }
  }

  const char* name() const override { return lawName; }
  int historySize() const override { return 0; }
  Frame frame() const override { return Frame::global; }
  Sides sides() const override { return Sides::one; }
  bool prescribesTraction() const override { return true; }
  bool dissipates() const override { return false; }
  bool isAffine() const override { return true; }

  std::shared_ptr<const InterfaceLaw> on(std::shared_ptr<const FaceMotions> face) const override {
    auto bound = std::make_shared<RemoteForce>(*this);
    bound->face_ = std::move(face);
    return bound;
  }
  const std::shared_ptr<const FaceMotions>& face() const override { return face_; }

  void solve(int step, const NodeArrays& nodes) const override {
    assert(face_ && nodes.position != nullptr && "the law is bound to its face before it is asked");
    FaceMotions::Six resultant{};
    for (std::size_t i = 0; i < 6; ++i) resultant[i] = value_[i][step];
    const FaceMotions::Six motion = face_->divided(face_->fromPoint(point_.value_or(face_->centre()), resultant));
    for (int p = 0; p < nodes.count; ++p) nodes.state[p] = {face_->at(motion, nodes.position[p]), Status::bonded};
  }

 private:
  std::optional<base::Vector3> point_;
  std::array<input::Schedule, 6> value_;
  std::shared_ptr<const FaceMotions> face_;
};

}  // namespace

HARMOS_WHOLE_LAW(RemoteForce)

}  // namespace harmos::laws
