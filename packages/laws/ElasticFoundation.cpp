#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SpringTraction.hpp>

namespace harmos::laws {
namespace {

/// Elastic foundation of an outer boundary (Winkler): f_n = -k_n w_n, f_t = -k_t w_t.
struct ElasticFoundation {
  static constexpr const char* name = "Elastic Foundation";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::one;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Springs from an outer boundary to the ground: f_n = -k_n w_n, f_t = -k_t w_t.")
        .source("Winkler's foundation");
    p.equation("f_n = -k_n w_n, f_t = -k_t w_t");
    p.number("Normal Stiffness")
        .example("100")
        .unit("stress/length")
        .required()
        .atLeast(0.0)
        .varying()
        .doc("k_n per area.");
    p.number("Tangential Stiffness")
        .unit("stress/length")
        .defaultValue(0.0)
        .atLeast(0.0)
        .varying()
        .doc("k_t per area.");
  }

  explicit ElasticFoundation(const input::Parameters& p)
      : normal(p.schedule("Normal Stiffness")), tangential(p.schedule("Tangential Stiffness")) {}

  AdmissibleTractions admissibleTractions(int step) const {
    return AdmissibleTractions::components(normal[step] > 0.0, tangential[step] > 0.0, tangential[step] > 0.0);
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    return springTraction(line, normal[at.step], tangential[at.step]);
  }

  double storedEnergy(const PairStep& step) const { return springEnergy(step.jump, step.traction); }

  input::Schedule normal;
  input::Schedule tangential;
};

}  // namespace

HARMOS_INTERFACE_LAW(ElasticFoundation)

}  // namespace harmos::laws
