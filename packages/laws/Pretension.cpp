#include <algorithm>
#include <optional>

#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/Locking.hpp>

namespace harmos::laws {
namespace {

/// Bolt preload by force on a cut through the shank: both faces keep together but for one overlap o along the normal
/// that all points share, delta_n = -o, delta_t = 0, with the resultant sum of h t_n = F. Once it is locked, o stays
/// what it was.
///
/// On the lines delta = delta_free - H t: o = (F - sum of h delta_free_n / H) / (sum of h / H), the two sums of the
/// law. History: o at the end of the previous load step [length], the same at all points.
class Pretension final : public CoupledLaw {
 public:
  static constexpr const char* lawName = "Pretension";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Bolt preload by force on a cut through the shank: joined perfectly but for one overlap of the faces along the "
        "normal, such that the bolt has the force. Locked, it keeps the overlap, and the force follows the loads.");
    p.equation("integral of t_n dS = F(t), delta_n the same everywhere; delta_t = 0; locked: delta_n stays");
    p.number("Force").example("500").unit("force").required().varying().doc(
        "Force of the bolt until it is locked, positive in tension.");
    describeLocking(p);
  }

  explicit Pretension(const input::Parameters& p) : force_(p.schedule("Force")), locking_(p) {}

  const char* name() const override { return lawName; }
  int historySize() const override { return 1; }
  Frame frame() const override { return Frame::interface; }
  Sides sides() const override { return Sides::two; }
  bool dissipates() const override { return false; }
  Creases creases() const override { return Creases::refuse; }
  int sums() const override { return 2; }
  int keepsJumpSince(int step) const override { return locking_.lockedSince(step); }
  std::optional<double> tighteningForce(int step) const override {
    return locking_.isLocked(step) ? std::nullopt : std::optional<double>(force_[step]);
  }

  void addToSums(int, const NodeArrays& nodes, double* sums) const override {
    for (int p = 0; p < nodes.count; ++p) {
      const double k = nodes.area[p] / nodes.line[p].compliance;
      sums[0] += k * nodes.line[p].freeJump[0];
      sums[1] += k;
    }
  }

  void solvePoints(int step, const NodeArrays& nodes, const double* sums) const override {
    if (nodes.count == 0) return;
    const double overlap = locking_.isLocked(step) ? nodes.oldHistory[0] : (force_[step] - sums[0]) / sums[1];
    keepTogether(nodes, overlap);
    std::fill_n(nodes.newHistory, nodes.count, overlap);
  }

  void solveTangent(int step, const NodeArrays& nodes, const double* sums) const override {
    keepTogether(nodes, locking_.isLocked(step) ? 0.0 : -sums[0] / sums[1]);
  }

 private:
  static void keepTogether(const NodeArrays& nodes, double overlap) {
    for (int p = 0; p < nodes.count; ++p) {
      const LocalLine& line = nodes.line[p];
      const double s = 1.0 / line.compliance;
      nodes.state[p] = {{s * (line.freeJump[0] + overlap), s * line.freeJump[1], s * line.freeJump[2]}, Status::bonded};
    }
  }

  input::Schedule force_;
  Locking locking_;
};

}  // namespace

HARMOS_WHOLE_LAW(Pretension)

}  // namespace harmos::laws
