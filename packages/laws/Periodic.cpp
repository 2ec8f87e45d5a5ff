#include <array>

#include <harmos/base/Error.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

/// Names of the components of the mean strain, and where they stand in it.
struct StrainComponent {
  const char* name;
  std::size_t row, column;
};
constexpr std::array<StrainComponent, 6> strainComponents{{{"Strain XX", 0, 0},
                                                           {"Strain YY", 1, 1},
                                                           {"Strain ZZ", 2, 2},
                                                           {"Strain XY", 0, 1},
                                                           {"Strain XZ", 0, 2},
                                                           {"Strain YZ", 1, 2}}};

/// Periodic connection of two opposite faces of a cell: w2 - w1 = E (x2 - x1), E the mean strain of the cell, which is
/// given; the fluctuations about it are the same on both faces, the tractions opposite.
///
/// x2 - x1 is the same for all pairs and given, as is E: the law is affine. Faces that are turned against each other,
/// as in cyclic symmetry, are no translation and not meant. Source: Michel, Moulinec, Suquet (1999), section 2.1.
struct Periodic {
  static constexpr const char* name = "Periodic";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  static constexpr Frame frame = Frame::global;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Periodic connection of two opposite faces of a cell: jump = mean strain times offset. Interfaces whose nodes "
         "lie opposite to each other along the Projection Direction.")
        .source("Michel, Moulinec, Suquet (1999), doi:10.1016/S0045-7825(98)00227-8");
    p.equation("delta = E (x2 - x1)");
    p.numbers("Offset")
        .example("{0, 0, 10}")
        .unit("length")
        .required()
        .doc("x2 - x1, from side 1 to side 2: 2 numbers in the plane, 3 in space.");
    for (const StrainComponent& component : strainComponents) {
      const bool isShear = component.row != component.column;
      p.number(component.name)
          .unit("-")
          .defaultValue(0.0)
          .varying()
          .doc(isShear ? "Of the mean strain; half of the angle." : "Of the mean strain.");
    }
  }

  static void check(const input::Parameters& p, input::ErrorList& errors) {
    const std::vector<double>& offset = p.numbers("Offset");
    if (offset.size() == 2 || offset.size() == 3) return;
    errors.add(p.where("Offset"), "is not a place: it has " + std::to_string(offset.size()) + " numbers.",
               "Give 2 numbers in the plane or 3 in space.");
  }

  explicit Periodic(const input::Parameters& p) {
    const std::vector<double>& given = p.numbers("Offset");
    std::copy(given.begin(), given.end(), offset.begin());
    for (std::size_t c = 0; c < strainComponents.size(); ++c) strain[c] = p.schedule(strainComponents[c].name);
  }

  AdmissibleTractions admissibleTractions(int) const { return {}; }

  /// E (x2 - x1) at a load step [length].
  base::Vector3 jump(int step) const {
    base::Vector3 sum{};
    for (std::size_t c = 0; c < strainComponents.size(); ++c) {
      const auto [unused, row, column] = strainComponents[c];
      sum[row] += strain[c][step] * offset[column];
      if (row != column) sum[column] += strain[c][step] * offset[row];
    }
    return sum;
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    return {(1.0 / line.compliance) * (line.freeJump - jump(at.step)), Status::bonded};
  }

  base::Vector3 offset{};
  std::array<input::Schedule, 6> strain;
};

}  // namespace

HARMOS_INTERFACE_LAW(Periodic)

}  // namespace harmos::laws
