// The same assembly on 1, 2 and 4 ranks: bodies apart, ranks without a body, an owner that is not the first.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/PairFields.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 5;

/// Glue that gives up at a load step, on some ranks.
struct GivingUp {
  static constexpr const char* name = "Giving Up";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  explicit GivingUp(bool givesUp) : isTired(givesUp) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext& at, const double*, double*) const {
    if (isTired && at.step == 3) throw std::runtime_error("the glue gives up");
    laws::LocalState state;
    state.traction = (30.0 / (1.0 + 30.0 * line.compliance)) * line.freeJump;
    return state;
  }
  bool isTired;
};

/// Five chains in a row, joined by everything there is.
assembly::Assembly fiveChains() {
  assembly::Assembly assembly;
  for (int b = 0; b < 5; ++b)
    assembly.bodies.push_back(chain("chain " + std::to_string(b), 3.0 * b, 4, 10.0 * (b + 1)));
  for (int t = 0; t < steps; ++t) assembly.times.push_back(t + 1.0);
  assembly.interfaces = {
      pointInterface("wall", clamp(), 0, 0, -1, 0, 1.0, 0.0, -1.0),
      pointInterface("perfect", laws::makeLaw("Perfect"), 0, 3, 1, 0),
      pointInterface("friction", laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}), 1, 3, 2, 0, 0.5,
                     0.01),
      pointInterface("glue",
                     laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 30.0}, {"Tangential Stiffness", 20.0}}), 2,
                     3, 3, 0),
      pointInterface("bolt", laws::makeLaw("Preload Jump", {{"Jump", 0.05}}), 3, 3, 4, 0),
      pointInterface("end",
                     laws::makeLaw("Prescribed Displacement", {{"X", -0.3}, {"Y", 0.1}, {"Z", 0.05}},
                                   {{"Y", {0, 0.2, 0.5, 1, -1}}, {"Z", {0, 0, 1, 1, 1}}}),
                     4, 3),
      pointInterface("pull", laws::makeLaw("Prescribed Traction", {{"Y", 0.1}}), 2, 1)};
  return assembly;
}

/// The same with two joints between means of nodes.
assembly::Assembly fiveChainsInTheMean() {
  assembly::Assembly assembly = fiveChains();
  for (const int i : {2, 3}) {
    assembly.interfaces[i].trace1 = assembly.interfaces[i].trace2 = {};
    assembly.interfaces[i].trace1.append({{3, 0.75}, {2, 0.25}});
    assembly.interfaces[i].trace2.append({{0, 1.2}, {1, -0.2}});
  }
  return assembly;
}

struct Answer {
  LatinResult result;
  std::vector<PairFields> fields;
};

Answer solve(assembly::Assembly assembly, const std::vector<int>& owner,
             const Teuchos::RCP<const Teuchos::Comm<int>>& comm, Formulation formulation,
             int sharedFrom = substructure::SolverOptions().sharedFrom) {
  assembly.owner = owner;
  for (std::size_t b = 0; b < owner.size(); ++b) {
    if (owner[b] != comm->getRank()) assembly.bodies[b].stiffness = Teuchos::null;
  }
  LatinOptions options;
  options.accuracy = 1e-9;
  options.stages.formulation = formulation;
  options.stages.solver.sharedFrom = sharedFrom;
  base::Timers timers;
  LatinSolver solver(assembly, options, comm, timers);
  solver.addResponse(std::make_shared<DisplacementResponse>(
      "middle", std::vector<DisplacementResponse::Node>{{2, 1, 1.0}}, base::Vector3{0.0, 1.0, 0.0}));
  solver.addResponse(std::make_shared<ResultantResponse>("bolt", std::vector<int>{4}, std::vector<base::Vector3>{}));
  solver.addResponse(
      std::make_shared<ResultantResponse>("pull", std::vector<int>{6}, std::vector<base::Vector3>{{0.0, 1.0, 0.0}}));
  solver.addResponse(std::make_shared<DissipationResponse>("loss", std::vector<int>{2}));
  solver.addResponse(
      std::make_shared<MaximumResponse>("pressure", std::vector<int>{2}, MaximumResponse::Field::contactPressure));
  Answer answer{solver.solve(), {}};
  for (int i = 0; i < 7; ++i) answer.fields.push_back(pairFields(solver.state(), i));
  return answer;
}

class Ranks : public testing::TestWithParam<Formulation> {};

void expectTheSame(const assembly::Assembly& chains, Formulation formulation,
                   int sharedFrom = substructure::SolverOptions().sharedFrom) {
  const auto comm = Tpetra::getDefaultComm();
  const int size = comm->getSize();
  const Answer exact = solve(chains, {0, 0, 0, 0, 0}, self(), formulation);
  ASSERT_EQ(exact.result.outcome, Outcome::certified) << exact.result.reason;
  for (const std::vector<int>& owner :
       {std::vector<int>{0, 1 % size, 2 % size, 3 % size, 0}, std::vector<int>{size - 1, size - 1, 0, size - 1, 0},
        std::vector<int>{size - 1, size - 1, size - 1, size - 1, size - 1}}) {
    const Answer found = solve(chains, owner, comm, formulation, sharedFrom);
    EXPECT_EQ(found.result.outcome, Outcome::certified) << found.result.reason;
    // Sums in another order change the last digits, and Anderson acceleration amplifies them: not the iterations, but
    // the answer within the accuracy agrees.
    for (std::size_t i = 0; i < exact.result.responses.size(); ++i) {
      for (std::size_t t = 0; t < steps; ++t)
        EXPECT_NEAR(found.result.responses[i].values[t], exact.result.responses[i].values[t], 1e-8);
    }
    for (std::size_t i = 0; i < exact.fields.size(); ++i) {
      EXPECT_EQ(found.fields[i].status, exact.fields[i].status);
      for (std::size_t n = 0; n < exact.fields[i].traction.size(); ++n) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(found.fields[i].traction[n][c], exact.fields[i].traction[n][c], 1e-7);
          EXPECT_NEAR(found.fields[i].jump[n][c], exact.fields[i].jump[n][c], 1e-8);
        }
      }
    }
  }
}

TEST_P(Ranks, FindTheSame) {
  expectTheSame(fiveChains(), GetParam());
}

TEST_P(Ranks, FindTheSameBetweenMeansOfNodes) {
  expectTheSame(fiveChainsInTheMean(), GetParam());
}

TEST_P(Ranks, FindTheSameWithTheMacroProblemShared) {
  expectTheSame(fiveChains(), GetParam(), 1);
}

/// Three chains that meet in one place, joined there in a ring with areas 1, 2 and 3.
assembly::Assembly ringOfChains() {
  assembly::Assembly assembly;
  for (const double first : {0.0, 3.0, 3.0})
    assembly.bodies.push_back(chain("from " + std::to_string(assembly.bodies.size()), first, 4, 10.0));
  assembly.times = {1.0, 2.0};
  const std::shared_ptr<const laws::InterfaceLaw> perfect = laws::makeLaw("Perfect");
  assembly.interfaces = {
      pointInterface("wall", clamp(), 0, 0, -1, 0, 1.0, 0.0, -1.0),
      pointInterface("01", perfect, 0, 3, 1, 0, 1.0),
      pointInterface("12", perfect, 1, 0, 2, 0, 2.0),
      pointInterface("20", perfect, 2, 0, 0, 3, 3.0),
      pointInterface("held", clamp(), 2, 3),
      pointInterface("pull", laws::makeLaw("Prescribed Traction", {{"X", 0.2}, {"Y", 0.1}}, {{"Y", {1, -1}}}), 1, 3)};
  return assembly;
}

// The least sum of h t^2 around a ring is where the tractions add up to nothing.
TEST_P(Ranks, ShareAroundARingAlike) {
  const auto comm = Tpetra::getDefaultComm();
  const int size = comm->getSize();
  for (const std::vector<int>& owner : {std::vector<int>{0, 0, 0}, std::vector<int>{0, 1 % size, 2 % size}}) {
    assembly::Assembly assembly = ringOfChains();
    assembly.owner = owner;
    for (std::size_t b = 0; b < owner.size(); ++b) {
      if (owner[b] != comm->getRank()) assembly.bodies[b].stiffness = Teuchos::null;
    }
    LatinOptions options;
    options.accuracy = 1e-9;
    options.stages.formulation = GetParam();
    base::Timers timers;
    LatinSolver solver(assembly, options, comm, timers);
    const std::vector<base::Vector3> along{{0.0, 1.0, 0.0}};
    for (const int i : {1, 2, 3})
      solver.addResponse(std::make_shared<ResultantResponse>(std::to_string(i), std::vector<int>{i}, along));
    solver.addResponse(std::make_shared<ResultantResponse>("wall", std::vector<int>{0}, along));
    const LatinResult result = solver.solve();
    ASSERT_EQ(result.outcome, Outcome::certified) << result.reason;
    for (int t = 0; t < 2; ++t) {
      double sum = 0.0, largest = 0.0;
      for (int i = 0; i < 3; ++i) {
        sum += result.responses[i].values[t] / (i + 1.0);
        largest = std::max(largest, std::abs(result.responses[i].values[t]));
      }
      EXPECT_GT(largest, 1e-3);
      EXPECT_NEAR(sum, 0.0, 1e-8 * largest);
    }
    EXPECT_FALSE(result.isUnique());
    EXPECT_LT(result.responses[3].range.widest(), 0) << "the wall feels nothing of it";
    EXPECT_TRUE(std::isinf(result.responses[0].range.width()));
    EXPECT_EQ(std::count_if(result.remarks.begin(), result.remarks.end(),
                            [](const std::string& text) { return text.find("\" is not determined") != text.npos; }),
              3);
  }
}

INSTANTIATE_TEST_SUITE_P(Formulations, Ranks, testing::Values(Formulation::displacement, Formulation::velocity),
                         [](const auto& test) {
                           return test.param == Formulation::displacement ? "Displacement" : "Velocity";
                         });

// Whichever rank sees it, all know of it.
TEST(RanksTogether, SayThatNothingCarriesTheLoad) {
  const auto comm = Tpetra::getDefaultComm();
  assembly::Assembly assembly =
      twoChains(laws::makeLaw("Unilateral Contact"), laws::makeLaw("Prescribed Traction", {{"X", 3.0}}), 1);
  assembly.owner = {0, comm->getSize() - 1};
  base::Timers timers;
  LatinSolver solver(assembly, {}, comm, timers);
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::noEquilibrium) << result.reason;
  EXPECT_NE(result.reason.find("\"right\""), std::string::npos) << result.reason;
}

// All ranks throw its message, and can go on afterwards.
TEST(RanksTogether, ThrowWhatALawThrowsOnOne) {
  const auto comm = Tpetra::getDefaultComm();
  const int last = comm->getSize() - 1;
  for (const Formulation formulation : {Formulation::displacement, Formulation::velocity}) {
    assembly::Assembly assembly = fiveChains();
    assembly.interfaces[3].law = std::make_shared<laws::PointwiseLaw<GivingUp>>(comm->getRank() == last);
    assembly.owner = {0, 0, 0, last, last};
    LatinOptions options;
    options.stages.formulation = formulation;
    base::Timers timers;
    LatinSolver solver(assembly, options, comm, timers);
    std::string message;
    try {
      solver.solve();
    } catch (const base::Error& error) {
      EXPECT_GT(comm->getSize(), 1);
      message = error.what();
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(comm->getSize(), 1);
      message = error.what();
    }
    EXPECT_EQ(message, "the glue gives up");
    assembly.interfaces[3].law = std::make_shared<laws::PointwiseLaw<GivingUp>>(false);
    LatinSolver next(assembly, options, comm, timers);
    EXPECT_EQ(next.solve().outcome, Outcome::certified);
  }
}

// The same words on all ranks, whether each has the factor or all share it.
TEST(RanksTogether, NameWhatFloatsInASharedMacroProblem) {
  const auto comm = Tpetra::getDefaultComm();
  for (const int sharedFrom : {1, 1000}) {
    assembly::Assembly assembly = fiveChains();
    for (const int end : {0, 5}) assembly.interfaces[end].law = laws::makeLaw("Prescribed Traction", {{"X", 3.0}});
    assembly.owner = {0, 0, 0, 0, comm->getSize() - 1};
    StageOptions options;
    options.solver.sharedFrom = sharedFrom;
    base::Timers timers;
    try {
      const FixedPoint fixedPoint(assembly, options, comm, timers);
      ADD_FAILURE() << "nothing holds the chains";
    } catch (const base::Error& error) {
      EXPECT_NE(std::string(error.what()).find("nothing holds part(s) \"chain 0\", \"chain 1\""), std::string::npos)
          << error.what();
    }
  }
}

TEST(RanksTogether, StopWhenOneAsks) {
  const auto comm = Tpetra::getDefaultComm();
  assembly::Assembly assembly =
      twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", 3.0}}), 1);
  base::Timers timers;
  LatinSolver solver(assembly, {}, comm, timers);
  int calls = 0;
  solver.setInterrupt([&] { return ++calls >= 2 && comm->getRank() == comm->getSize() - 1; });
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::interrupted);
  EXPECT_LE(result.iterations, 3);
}

}  // namespace
}  // namespace harmos::latin
