#include <harmos/scene/detail/ResponseRegistry.hpp>

#include <algorithm>

#include <harmos/elasticity/Stress.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/scene/detail/PartStress.hpp>

namespace harmos::scene {
namespace {

/// Largest von Mises stress at the nodes of parts.
class LargestVonMises : public latin::Response {
 public:
  LargestVonMises(std::string name, std::vector<PartStress> parts)
      : latin::Response(std::move(name), latin::Quantity::stress), parts_(std::move(parts)) {}

  bool isLinear() const override { return false; }

  latin::ResponseWork work(const assembly::Assembly& /*assembly*/) const override {
    latin::ResponseWork work;
    for (const PartStress& part : parts_) work += part.work();
    return work;
  }

  std::vector<double> evaluate(const latin::Iterate& state) const override {
    const int steps = state.assembly().steps();
    std::vector<double> largest(steps, 0.0);
    for (const PartStress& part : parts_) {
      std::vector<double> mine(steps, 0.0);
      for (int first = 0; first < steps; first += latin::stepsAtOnce) {
        const base::Matrix stress = part.recover(state, first, std::min(latin::stepsAtOnce, steps - first));
        for (int j = 0; j < stress.numCols(); ++j) {
          for (int row = 0; row < stress.numRows(); row += 6) {
            mine[first + j] = std::max(mine[first + j], elasticity::vonMises(stress[j] + row));
          }
        }
      }
      state.metric().sum(mine);
      for (int t = 0; t < steps; ++t) largest[t] = std::max(largest[t], mine[t]);
    }
    return largest;
  }

 private:
  std::vector<PartStress> parts_;
};

/// The response of the scene.
struct VonMisesStress {
  static constexpr const char* name = "Von Mises Stress";

  static void describe(input::ParameterSpec& p) {
    p.summary(
        "Largest von Mises stress [stress] at the nodes of a part, recovered from its elements. Takes time with every "
        "error estimate.");
    p.text("Part").optional().doc("Name of the part; absent: all.");
  }

  static std::unique_ptr<latin::Response> make(const input::Parameters& p, const ResponseContext& context) {
    std::vector<PartStress> parts =
        PartStress::ofAll(context.mesh, context.bodies, context.model, context.temperatures);
    const auto isOther = [&](const PartStress& part) { return p.has("Part") && part.name() != p.text("Part"); };
    parts.erase(std::remove_if(parts.begin(), parts.end(), isOther), parts.end());
    return std::make_unique<LargestVonMises>(p.name(), std::move(parts));
  }
};

}  // namespace

HARMOS_RESPONSE(VonMisesStress)

}  // namespace harmos::scene
