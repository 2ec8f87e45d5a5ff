// What laws cost in the local stage: the closed form of springs, the same as a smooth law with automatic derivatives
// and as formulas in XML; then built-in laws one by one. Without arguments; fails where a smooth law is more than 3
// times, or formulas are more than 30 times slower than the closed form.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Tpetra_Core.hpp>

#include <harmos/latin/PointwiseLocalStage.hpp>
#include <harmos/laws/SmoothLaw.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace {

using namespace harmos;

constexpr int cells = 40, steps = 10, repetitions = 40;
constexpr double normal = 300.0, tangential = 120.0;
constexpr double mostOfSmooth = 3.0, mostOfFormula = 30.0;

struct Springs {
  static constexpr const char* name = "Smooth Springs";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  template <class Scalar>
  std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const laws::NodeContext&, const double*) const {
    return {Scalar(normal * jump[0]), Scalar(tangential * jump[1]), Scalar(tangential * jump[2])};
  }
};

std::shared_ptr<const laws::InterfaceLaw> formula() {
  const laws::LawRegistry laws = laws::builtInLaws();
  input::Parameters constants("Constants"), law("law");
  constants.set("k_n", normal).set("k_t", tangential);
  law.set("Type", std::string("Formula")).set("Lowest Slope", 0.0).set("Dissipates", false);
  law.set("Normal Traction", std::string("k_n * jump_n"));
  law.set("Tangential Traction 1", std::string("k_t * jump_1"));
  law.set("Tangential Traction 2", std::string("k_t * jump_2"));
  law.setList("Constants", constants);
  return laws.create(law);
}

using Numbers = std::map<std::string, double>;

/// Laws with numbers under which their pairs open, stick, slide or fail; lines are random, of the order of one.
std::vector<std::pair<std::string, Numbers>> builtIn() {
  const Numbers friction{{"Friction Coefficient", 0.3}},
      sliding{{"Tangential Stiffness", tangential}, {"Slip Limit", 2.0}};
  const Numbers glue{{"Normal Stiffness", normal},
                     {"Normal Viscosity", 5.0},
                     {"Tangential Stiffness", tangential},
                     {"Tangential Viscosity", 5.0}};
  return {{"Perfect", {}},
          {"Unilateral Contact", {}},
          {"Coulomb Friction", friction},
          {"Compliant Contact", {{"Friction Coefficient", 0.3}, {"Normal Stiffness", normal}}},
          {"Tresca Friction", {{"Shear Limit", 1.0}}},
          {"Adhesive Friction", {{"Adhesion", 0.1}, {"Range", 0.5}}},
          {"Rate-Dependent Friction", {{"Static Coefficient", 0.2}, {"Kinetic Coefficient", 0.4}, {"Velocity", 1.0}}},
          {"Archard Wear", {{"Friction Coefficient", 0.3}, {"Wear Coefficient", 1e-3}}},
          {"Jenkins", sliding},
          {"Tangential Plasticity", {{"Tangential Stiffness", tangential}, {"Yield Stress", 2.0}}},
          {"Bouc-Wen", sliding},
          {"Maxwell Glue", glue},
          {"Kelvin Glue", glue},
          {"Cohesive Zone",
           {{"Stiffness", 10.0},
            {"Normal Strength", 0.5},
            {"Shear Strength", 0.5},
            {"Mode I Fracture Energy", 0.1},
            {"Mode II Fracture Energy", 0.2}}}};
}

/// CPU time of a pair at a load step [s]: the least of many, as others use the machine, too.
double timeOf(const std::shared_ptr<const laws::InterfaceLaw>& law) {
  latin::BoxAssembly boxes(
      {{"lower", {0, 0, 0}, {1, 1, 0.1}, {cells, cells, 1}}, {"upper", {0, 0, 0.1}, {1, 1, 0.2}, {cells, cells, 1}}},
      steps);
  boxes.join("joint", "lower_zmax", "upper_zmin", law);
  boxes.hold("base", "lower_zmin", laws::makeLaw("Perfect"));
  const assembly::Assembly& assembly = boxes.assembly();
  const auto comm = latin::self();
  const assembly::SearchDirection k(assembly, 1.0, *comm);
  const latin::EliminatedBoundaries eliminated(assembly, k, latin::Elimination::none, {});
  const latin::TraceLayout layout(assembly, k, eliminated, comm);
  latin::PointwiseLocalStage local(assembly, k, layout, latin::Formulation::displacement);
  base::Matrix beta(layout.rows(), steps), traction(layout.rows(), steps);
  latin::randomize(beta);
  local.select(latin::allSteps(steps));
  double least = 1e9;
  for (int r = 0; r < repetitions; ++r) {
    const std::clock_t start = std::clock();
    local.solve(beta, traction);
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least / (static_cast<double>(assembly.interfaces[0].pairs()) * steps);
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard scope(&argc, &argv);
  const double closed =
      timeOf(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", normal}, {"Tangential Stiffness", tangential}}));
  const double smooth = timeOf(std::make_shared<laws::PointwiseLaw<laws::SmoothLaw<Springs>>>());
  const double text = timeOf(formula());
  std::printf("law                     ns per pair and step   million/s   ratio\n");
  const auto print = [&](const char* name, double seconds) {
    std::printf("%-24s %10.1f %19.1f %7.2f\n", name, 1e9 * seconds, 1e-6 / seconds, seconds / closed);
  };
  print("closed form", closed);
  print("smooth, compiled", smooth);
  print("formula", text);
  for (const auto& [name, numbers] : builtIn()) print(name.c_str(), timeOf(laws::makeLaw(name, numbers)));
  return smooth <= mostOfSmooth * closed && text <= mostOfFormula * closed ? 0 : 1;
}
