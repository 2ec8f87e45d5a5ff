#include <harmos/laws/detail/StickingFriction.hpp>

namespace harmos::laws {
namespace {

/// Pressure by overclosure as a table: linear between its points, 0 before the first, and as steep as the last piece
/// beyond the last.
class PressureTable {
 public:
  PressureTable(std::vector<double> overclosures, std::vector<double> pressures)
      : x_(std::move(overclosures)), p_(std::move(pressures)) {}

  /// p where x + H p = `free`, a function that grows: found in the piece between whose ends `free` lies.
  double onLine(double free, double compliance) const {
    std::size_t i = 1;
    while (i + 1 < x_.size() && x_[i] + compliance * p_[i] < free) ++i;
    const double dx = x_[i] - x_[i - 1], dp = p_[i] - p_[i - 1];
    return p_[i - 1] + dp * ((free - x_[i - 1]) - compliance * p_[i - 1]) / (dx + compliance * dp);
  }
  /// Overclosure from which on there is pressure [length].
  double touch() const { return x_.front(); }
  /// Integral of p dx up to a pressure [stress length].
  double energy(double pressure) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < x_.size(); ++i) {
      const bool isLast = i + 1 == x_.size() || pressure <= p_[i];
      const double dx = x_[i] - x_[i - 1], dp = p_[i] - p_[i - 1];
      const double share = !isLast ? 1.0 : dp > 0.0 ? (pressure - p_[i - 1]) / dp : 0.0;
      sum += share * dx * (p_[i - 1] + 0.5 * share * dp);
      if (isLast) break;
    }
    return sum;
  }

 private:
  std::vector<double> x_, p_;
};

/// Contact whose pressure is a table of the overclosure, and Coulomb friction, see StickingFriction.
struct TabulatedContact : StickingFriction {
  static constexpr const char* name = "Tabulated Contact";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact with a table of pressures by overclosures, as measured on rough surfaces or gaskets, with Coulomb "
         "friction and a stiffness along the surface while it sticks.")
        .source("known as tabular pressure-overclosure");
    p.equation("p = table(-opening); t_t = k_t (delta_t - s), |t_t| <= min(mu p, tau)");
    p.numbers("Overclosures")
        .example("{0, 0.01, 0.02}")
        .unit("length")
        .required()
        .overSurface()
        .doc(
            "Ascending; negative ones are openings at which there is pressure already. Beyond the last the last slope "
            "goes "
            "on.");
    p.numbers("Pressures")
        .example("{0, 20, 100}")
        .unit("stress")
        .required()
        .atLeast(0.0)
        .overSurface()
        .doc("One for every overclosure: 0, then none below the one before.");
    StickingFriction::describe(p);
  }

  static void check(const input::Parameters& p, input::ErrorList& errors) {
    const std::vector<double>& x = p.numbers("Overclosures");
    const std::vector<double>& pressures = p.numbers("Pressures");
    if (x.size() < 2 || x.size() != pressures.size()) {
      errors.add(p.where("Pressures"),
                 "the table has " + std::to_string(x.size()) + " overclosures and " + std::to_string(pressures.size()) +
                     " pressures.",
                 "Give two or more of each, as many of one as of the other.");
      return;
    }
    if (pressures[0] != 0.0) {
      errors.add(p.where("Pressures"), "the first pressure is not 0: the surfaces would touch with a blow.",
                 "Begin with the overclosure at which they touch.");
    }
    for (std::size_t i = 1; i < x.size(); ++i) {
      const std::string which = " " + std::to_string(i + 1) + " ";
      if (x[i] <= x[i - 1]) {
        errors.add(p.where("Overclosures"), "number" + which + "is not above the one before.",
                   "Sort the table by overclosures.");
      }
      if (pressures[i] < pressures[i - 1]) {
        errors.add(p.where("Pressures"), "number" + which + "is below the one before: such a contact is not stable.");
      }
    }
    if (pressures.back() == pressures[pressures.size() - 2]) {
      errors.add(p.where("Pressures"), "the last two are equal, so that it could not be pressed harder.",
                 "Add a point with a larger pressure.");
    }
  }

  explicit TabulatedContact(const input::Parameters& p)
      : StickingFriction(p), table(p.numbers("Overclosures"), p.numbers("Pressures")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double overclosure = -freeOpening(line, at);
    return slideUnder(line, at, overclosure <= table.touch(), table.onLine(overclosure, line.compliance), old, now);
  }

  double storedEnergy(const PairStep& step) const {
    return table.energy(-step.traction[0]) + shearEnergy(step.traction);
  }

  PressureTable table;
};

}  // namespace

HARMOS_INTERFACE_LAW(TabulatedContact)

}  // namespace harmos::laws
