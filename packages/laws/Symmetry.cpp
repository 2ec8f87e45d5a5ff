#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

/// Symmetry plane of an outer boundary: w_n = 0, f_t = 0.
struct Symmetry {
  static constexpr const char* name = "Symmetry";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::one;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Symmetry plane (rollers): no normal displacement, no tangential traction.");
    p.equation("delta_n = 0, t_t = 0");
  }

  explicit Symmetry(const input::Parameters&) {}

  AdmissibleTractions admissibleTractions(int) const { return AdmissibleTractions::components(true, false, false); }

  LocalState solve(const LocalLine& line, const NodeContext&, const double*, double*) const {
    return {{line.freeJump[0] / line.compliance, 0.0, 0.0}, Status::bonded};
  }
};

}  // namespace

HARMOS_INTERFACE_LAW(Symmetry)

}  // namespace harmos::laws
