// Two lattices of springs, glued together and pulled: matrices, node lists and interface laws all belong to this
// application, nothing comes from XML. The glue yields, hardens, and keeps its set when the load is taken away.
//
//   fixed |====A====|glue|====B====| -> traction
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

#include <Teuchos_DefaultSerialComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

namespace {

using namespace harmos;

constexpr int length = 6, width = 3;                                      // nodes along x; along y and z
constexpr double spring = 50.0;                                           // [force/length], between neighbours
constexpr double stiffness = 20.0, strength = 1.0, hardening = 5.0;       // of the glue
const std::vector<double> traction{0.5 * strength, 1.5 * strength, 0.0};  // at the end of each load step

int nodeAt(int i, int j, int k) {
  return (i * width + j) * width + k;
}

/// Glue that yields under tension with linear hardening; history: its plastic opening.
struct PlasticGlue {
  static constexpr const char* name = "Plastic Glue";
  static constexpr int historySize = 1;
  static constexpr laws::Sides sides = laws::Sides::two;

  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double* old, double* now) const {
    laws::LocalState state;
    const double compliance = line.compliance;
    for (std::size_t c = 0; c < 3; ++c)
      state.traction[c] = stiffness * (line.freeJump[c] - (c == 0 ? old[0] : 0.0)) / (1.0 + stiffness * compliance);
    now[0] = old[0];
    if (state.traction[0] > strength + hardening * old[0]) {
      state.traction[0] =
          (strength + hardening * line.freeJump[0]) / (1.0 + hardening * compliance + hardening / stiffness);
      now[0] = (state.traction[0] - strength) / hardening;
    }
    return state;
  }
};

struct Clamp {
  static constexpr const char* name = "Clamp";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::one;
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) state.traction[c] = line.freeJump[c] / line.compliance;
    return state;
  }
};

struct Pull {
  static constexpr const char* name = "Pull";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::one;
  static constexpr laws::Frame frame = laws::Frame::global;
  static constexpr bool prescribesTraction = true;
  laws::LocalState solve(const laws::LocalLine&, const laws::NodeContext& at, const double*, double*) const {
    laws::LocalState state;
    state.traction = {traction[at.step], 0.0, 0.0};
    return state;
  }
};

/// The application's own stiffness matrix: neighbours are joined by equal springs in every direction.
Teuchos::RCP<base::CrsMatrix> latticeMatrix() {
  using Map = base::CrsMatrix::map_type;
  const int nodes = length * width * width;
  const auto self = Teuchos::rcp(new Teuchos::SerialComm<int>());
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(3 * nodes), 0, self));
  const auto matrix = Teuchos::rcp(new base::CrsMatrix(map, 7));
  const auto couple = [&](int a, int b) {
    for (int c = 0; c < 3; ++c) {
      const base::GlobalOrdinal rows[] = {3 * a + c, 3 * b + c};
      const double diagonal = spring, coupling = -spring;
      for (int side = 0; side < 2; ++side) {
        matrix->insertGlobalValues(rows[side], 1, &diagonal, &rows[side]);
        matrix->insertGlobalValues(rows[side], 1, &coupling, &rows[1 - side]);
      }
    }
  };
  for (int i = 0; i < length; ++i)
    for (int j = 0; j < width; ++j)
      for (int k = 0; k < width; ++k) {
        if (i + 1 < length) couple(nodeAt(i, j, k), nodeAt(i + 1, j, k));
        if (j + 1 < width) couple(nodeAt(i, j, k), nodeAt(i, j + 1, k));
        if (k + 1 < width) couple(nodeAt(i, j, k), nodeAt(i, j, k + 1));
      }
  matrix->fillComplete();
  return matrix;
}

substructure::Substructure lattice(const std::string& name, double start, bool isOwned) {
  substructure::Substructure body;
  body.name = name;
  for (int i = 0; i < length; ++i)
    for (int j = 0; j < width; ++j)
      for (int k = 0; k < width; ++k) body.nodes.push_back({start + i, 1.0 * j, 1.0 * k});
  if (isOwned) body.stiffness = latticeMatrix();
  return body;
}

/// An interface over a whole cross-section of unit areas, at x = place.
assembly::Interface section(const std::string& name, std::shared_ptr<const laws::InterfaceLaw> law, int body1,
                            bool atEnd, double place, int body2 = -1) {
  assembly::Interface joint;
  joint.name = name;
  joint.law = std::move(law);
  joint.body1 = body1;
  joint.body2 = body2;
  for (int j = 0; j < width; ++j)
    for (int k = 0; k < width; ++k) {
      joint.trace1.append({{nodeAt(atEnd ? length - 1 : 0, j, k), 1.0}});
      if (body2 >= 0) joint.trace2.append({{nodeAt(0, j, k), 1.0}});
      joint.position.push_back({place, 1.0 * j, 1.0 * k});
      const double outward = atEnd ? 1.0 : -1.0;
      joint.frame.push_back({{{outward, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, outward}}});
      joint.area.push_back(1.0);
      joint.gap.push_back(0.0);
    }
  return joint;
}

/// Displacement of the loaded end at every load step.
std::vector<double> exactEnd() {
  std::vector<double> result;
  double plastic = 0.0;
  for (double force : traction) {
    plastic = std::max(plastic, (force - strength) / hardening);
    result.push_back(2.0 * force * (length - 1) / spring + force / stiffness + plastic);
  }
  return result;
}

bool solve(const Teuchos::RCP<const Teuchos::Comm<int>>& communicator) {
  const int rank = communicator->getRank(), second = communicator->getSize() - 1;
  assembly::Assembly assembly;
  assembly.owner = {0, second};
  assembly.bodies = {lattice("A", 0.0, rank == 0), lattice("B", length - 1.0, rank == second)};
  assembly.interfaces = {section("clamp", std::make_shared<laws::PointwiseLaw<Clamp>>(), 0, false, 0.0),
                         section("glue", std::make_shared<laws::PointwiseLaw<PlasticGlue>>(), 0, true, length - 1.0, 1),
                         section("pull", std::make_shared<laws::PointwiseLaw<Pull>>(), 1, true, 2.0 * (length - 1))};
  assembly.times = {1.0, 2.0, 3.0};

  latin::LatinOptions options;
  options.accuracy = 1e-6;
  base::Timers timers;
  latin::LatinSolver solver(assembly, options, communicator, timers);
  std::vector<latin::DisplacementResponse::Node> end;
  const mesh::TraceOperator& trace = assembly.interfaces[2].trace1;
  for (int p = 0; p < trace.points(); ++p) end.push_back({1, trace.node(p), 1.0 / (width * width)});
  solver.addResponse(std::make_shared<latin::DisplacementResponse>("end", end, base::Vector3{1.0, 0.0, 0.0}));
  const latin::LatinResult result = solver.solve();

  bool isRight = result.outcome == latin::Outcome::certified;
  const std::vector<double> exact = exactEnd();
  for (std::size_t step = 0; step < exact.size(); ++step) {
    const double found = result.responses[0].values[step];
    if (rank == 0) std::cout << "step " << step + 1 << ": " << found << ", exact " << exact[step] << "\n";
    // The accuracy asked for is relative to the largest value over the steps.
    isRight = isRight && std::abs(found - exact[step]) <= 1e-6 * exact[1];
  }
  if (rank == 0) std::cout << result.reason << ", " << result.linearStages << " linear stages\n";
  return isRight;
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard scope(&argc, &argv);
  const auto communicator = Tpetra::getDefaultComm();
  return base::runOnAllRanks(
      *communicator, [&] { return solve(communicator) ? 0 : 1; }, std::cerr);
}
