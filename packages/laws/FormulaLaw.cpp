#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include <boost/math/tools/toms748_solve.hpp>

#include <harmos/laws/FieldFollower.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/laws/NewtonOnLine.hpp>
#include <harmos/laws/NoIntersection.hpp>
#include <harmos/laws/detail/FormulaGraph.hpp>

namespace harmos::laws {
namespace {

constexpr double roundOff = std::numeric_limits<double>::epsilon();

/// Traction and history by formulas of the jump. Where every component stands for itself, a monotone graph is bracketed
/// on the line: of g(delta) = delta + H t(delta) - delta_free, whose slope is 1 at least, the root lies between 0 and
/// -g(0). Else Newton's method with differences, and where that comes to no end the components in turn, bracketed
/// alike.
class FormulaLaw final : public InterfaceLaw, public FieldFollower {
 public:
  static constexpr const char* lawName = "Formula";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "A law by formulas: the traction as a function of the jump, of time, of place and of numbers that it keeps.");
    p.equation("t_i = formula(jump, gap, place, time, history)");
    FormulaGraph::describe(p);
    p.number("Lowest Slope")
        .unit("stress/length")
        .defaultValue(0.0)
        .atMost(0.0)
        .doc("The steepest fall of the traction over the jump; 0: it never falls.");
    p.flag("Dissipates").defaultValue(false).doc("Whether work that is done on the interface counts as dissipation.");
  }

  explicit FormulaLaw(const input::Parameters& p)
      : whereFields_(p.where("Fields")),
        graph_(std::make_unique<FormulaGraph>(p)),
        lowestSlope_(p.number("Lowest Slope")),
        dissipates_(p.flag("Dissipates")) {}

  const char* name() const override { return lawName; }
  int historySize() const override { return static_cast<int>(graph_->histories().size()); }
  Frame frame() const override { return Frame::interface; }
  Sides sides() const override { return Sides::any; }
  bool prescribesTraction() const override { return false; }
  bool dissipates() const override { return dissipates_; }
  double lowestSlope() const override { return lowestSlope_; }
  std::array<bool, 3> givesNothing() const override { return graph_->areZero(); }
  std::vector<OutputField> outputs() const override { return graph_->outputs(); }
  void output(const PairStep& step, double* values) const override { std::copy_n(step.history, historySize(), values); }

  void tell(std::vector<input::Parameters> lists) override { followed_.tell(std::move(lists)); }
  void bind(std::shared_ptr<const SpatialFields> fields) const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    followed_.bind(std::move(fields), graph_->fields());
  }
  std::shared_ptr<const SpatialFields> fields() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return followed_.shared();
  }
  void prepare(const std::vector<base::Vector3>& places) const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (graph_->fields().empty()) return;
    for (const base::Vector3& place : places) readFields(0, place);
    places_.insert(places_.end(), places.begin(), places.end());
  }
  std::vector<base::Vector3> places() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return places_;
  }

  void solve(int step, const NodeArrays& nodes) const override {
    const std::lock_guard<std::mutex> lock(mutex_);  // formulas are no matter of several threads
    const int size = historySize();
    for (int i = 0; i < nodes.count; ++i) {
      const NodeContext at(step, nodes, i);
      const LocalLine& line = nodes.line[i];
      readFields(step, at.position());
      graph_->goTo(at, nodes.oldHistory + static_cast<std::ptrdiff_t>(i) * size, values_);
      nodes.state[i] = {graph_->isUncoupled() ? byComponents(line, at) : together(line, at), Status::bonded};
      if (size > 0) {
        graph_->update(line.jump(nodes.state[i].traction), nodes.newHistory + static_cast<std::ptrdiff_t>(i) * size);
      }
    }
  }

 private:
  /// The values of the fields that the formulas see.
  void readFields(int step, const base::Vector3& place) const {
    values_.clear();
    for (const std::string& name : graph_->fields()) {
      const SpatialField& field = followed_.find(name, whereFields_);
      try {
        values_.push_back(field.at(step, place));
      } catch (const base::Error& error) {
        throw base::Error(whereFields_ + ": " + error.what(), error.code());
      }
    }
  }

  base::Vector3 byComponents(const LocalLine& line, const NodeContext& at) const {
    base::Vector3 traction{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto found =
          bracketed(line.freeJump[c], line.compliance, 0.0, [&](double jump) { return graph_->component(c, jump); });
      if (!found) throw NoIntersection(line, at, "the formula of the traction has no value there, or falls");
      traction[c] = *found;
    }
    return traction;
  }

  /// The traction t of a function t(delta) that falls no more than the law says, at which delta + H t = delta_free; the
  /// search begins at `from`. Nothing: it falls more, or has no value.
  template <class Traction>
  std::optional<double> bracketed(double freeJump, double compliance, double from, const Traction& tractionAt) const {
    if (!std::isfinite(freeJump)) return freeJump;
    const double leastSlope = 1.0 + compliance * lowestSlope_;  // of delta + H t
    if (!(leastSlope > 0.0)) return std::nullopt;
    double scale = std::abs(freeJump) + std::abs(from);
    double traction = 0.0;
    const auto residual = [&](double jump) {
      traction = tractionAt(jump);
      return jump + compliance * traction - freeJump;
    };
    double a = from, atA = residual(a);
    scale += std::abs(compliance * traction);
    if (!std::isfinite(atA)) return std::nullopt;
    const double small = 4.0 * roundOff * scale;
    if (std::abs(atA) <= small) return traction;
    double b = a - atA / leastSlope, atB = residual(b);
    if (std::abs(atB) <= small) return traction;
    const auto isRoundOff = [&](double jump, double left) {
      const auto alone = [&](const base::Vector3& one) { return base::Vector3{tractionAt(one[0]), 0.0, 0.0}; };
      return std::abs(left) <= 16.0 * compliance * roundOffOf(alone, {jump, 0.0, 0.0}, scale);
    };
    // The chord meets straight lines at once; from its nearer end for the digits.
    const double slope = (atB - atA) / (b - a);
    if (!(slope > 0.0)) return isRoundOff(a, atA) ? std::optional((freeJump - a) / compliance) : std::nullopt;
    const double chord = std::abs(atA) < std::abs(atB) ? a - atA / slope : b - atB / slope;
    if (std::abs(residual(chord)) <= small) return traction;
    if (!((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0))) {
      return isRoundOff(b, atB) ? std::optional((freeJump - b) / compliance) : std::nullopt;
    }
    if (a > b) {
      std::swap(a, b);
      std::swap(atA, atB);
    }
    boost::uintmax_t limit = 200;
    const auto width = [&](double left, double right) {
      return right - left <= roundOff * (std::abs(left) + std::abs(right));
    };
    const auto ends = boost::math::tools::toms748_solve(residual, a, b, atA, atB, width, limit);
    const double middle = 0.5 * (ends.first + ends.second);
    // Also where the graph is vertical: any traction between.
    const double found = (freeJump - middle) / compliance;
    const double left = tractionAt(ends.first), right = tractionAt(ends.second);
    return std::clamp(found, std::min(left, right), std::max(left, right));
  }

  base::Vector3 together(const LocalLine& line, const NodeContext& at) const {
    const auto tractionAt = [&](const base::Vector3& jump) { return graph_->traction(jump); };
    const auto newton =
        newtonOnLine(line, tractionAt, [&](const base::Vector3& jump) { return differenced(line, jump); });
    if (newton) return *newton;
    const auto inTurn = oneAfterTheOther(line);
    if (!inTurn) throw NoIntersection(line, at, "neither Newton's method nor the components in turn come to an end");
    return *inTurn;
  }

  /// Central differences; what they leave of the error is seen by the residual, which must fall.
  GraphPoint differenced(const LocalLine& line, const base::Vector3& jump) const {
    GraphPoint point;
    point.traction = graph_->traction(jump);
    const double scale = norm(jump) + norm(line.freeJump) + line.compliance * norm(point.traction);
    const double h = std::cbrt(roundOff) * (scale > 0.0 ? scale : 1.0);
    for (std::size_t d = 0; d < 3; ++d) {
      base::Vector3 before = jump, after = jump;
      before[d] -= h;
      after[d] += h;
      const base::Vector3 change = graph_->traction(after) - graph_->traction(before);
      for (std::size_t c = 0; c < 3; ++c) point.slope[c][d] = change[c] / (after[d] - before[d]);
    }
    return point;
  }

  std::optional<base::Vector3> oneAfterTheOther(const LocalLine& line) const {
    constexpr int rounds = 1000;
    constexpr double gained = 0.25;  // of the square of a residual
    const auto tractionAt = [&](const base::Vector3& all) { return graph_->traction(all); };
    double before = 0.0;
    base::Vector3 jump{};
    for (int r = 0; r < rounds; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto found = bracketed(line.freeJump[c], line.compliance, jump[c], [&](double one) {
          base::Vector3 all = jump;
          all[c] = one;
          return graph_->traction(all)[c];
        });
        if (!found) return std::nullopt;
        jump[c] = line.freeJump[c] - line.compliance * *found;
      }
      const base::Vector3 traction = graph_->traction(jump);
      const LineResidual residual(line, jump, traction);
      if (residual.isSmall()) return traction;
      // Round-off of terms that cancel is looked for where nothing is gained any more.
      if (residual.square > gained * before && residual.isRoundOffOf(tractionAt, line, jump)) {
        return (1.0 / line.compliance) * (line.freeJump - jump);
      }
      before = residual.square;
    }
    return std::nullopt;
  }

  std::string whereFields_;
  // Locked by mutex_, as all that is mutable.
  std::unique_ptr<FormulaGraph> graph_;
  mutable FollowedFields followed_;
  mutable std::vector<base::Vector3> places_;  // for which it was prepared
  mutable std::vector<double> values_;         // of the fields where it is asked
  mutable std::mutex mutex_;
  double lowestSlope_;
  bool dissipates_;
};

}  // namespace

void addFormulaLaw(LawRegistry& laws) {
  input::ParameterSpec spec(FormulaLaw::lawName);
  FormulaLaw::describe(spec);
  laws.add(std::move(spec),
           [](const input::Parameters& p) -> std::unique_ptr<InterfaceLaw> { return std::make_unique<FormulaLaw>(p); });
}

}  // namespace harmos::laws
