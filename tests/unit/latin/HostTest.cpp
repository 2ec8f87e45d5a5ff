#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

assembly::Assembly sample() {
  return twoChains(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
                   laws::makeLaw("Prescribed Traction", {{"X", -2.0}, {"Y", 0.3}, {"Z", 0.0}}), 3);
}

double displacement(const assembly::Assembly& assembly, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  base::Timers timers;
  LatinSolver solver(assembly, {}, comm, timers);
  solver.addResponse(std::make_shared<DisplacementResponse>("end", std::vector<DisplacementResponse::Node>{{1, 2, 1.0}},
                                                            base::Vector3{1, 0, 0}));
  return solver.solve().responses[0].values.back();
}

/// A law that gives up in the middle of a solution.
struct Broken {
  static constexpr const char* name = "Broken";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext& at, const double*, double*) const {
    if (at.step == 2) throw std::out_of_range("no third step");
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) state.traction[c] = line.freeJump[c] / (1.0 + line.compliance);
    return state;
  }
};

/// Memory of this process in pages.
long residentPages() {
  std::ifstream file("/proc/self/statm");
  long size = 0, resident = 0;
  file >> size >> resident;
  return resident;
}

// A host may make and drop solvers for days.
TEST(Host, KeepsNothingOfTwoHundredSolvers) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer keeps what was freed";
#endif
  const assembly::Assembly assembly = sample();
  const double first = displacement(assembly, self());
  for (int run = 0; run < 20; ++run) displacement(assembly, self());
  const long before = residentPages();
  for (int run = 0; run < 200; ++run) ASSERT_EQ(displacement(assembly, self()), first);
  const double grown = static_cast<double>((residentPages() - before) * ::sysconf(_SC_PAGESIZE));
  EXPECT_LE(grown / 200.0, 1024.0) << "bytes per solver";  // an operator alone is larger
}

// Nor of those that fail in the middle.
TEST(Host, CanGoOnAfterErrors) {
  const double first = displacement(sample(), self());
  assembly::Assembly broken = sample();
  broken.interfaces[1].law = std::make_shared<laws::PointwiseLaw<Broken>>();
  assembly::Assembly wrong = sample();
  wrong.interfaces[0].area.clear();
  for (int run = 0; run < 5; ++run) {
    EXPECT_THROW(displacement(wrong, self()), base::Error);
    EXPECT_THROW(displacement(broken, self()), std::out_of_range);
    EXPECT_EQ(displacement(sample(), self()), first);
  }
}

// Two solvers at work by turns share nothing.
TEST(Host, CanUseSolversByTurns) {
  const assembly::Assembly assembly = sample();
  base::Timers timers;
  LatinSolver one(assembly, {}, self(), timers), other(assembly, {}, self(), timers);
  const LatinResult first = one.solve();
  const base::Matrix state(Teuchos::Copy, one.alpha(), one.alpha().numRows(), one.alpha().numCols());
  other.solve();
  base::Matrix difference(Teuchos::Copy, one.alpha(), one.alpha().numRows(), one.alpha().numCols());
  difference -= state;
  EXPECT_EQ(difference.normInf(), 0.0);
  EXPECT_EQ(one.solve().outcome, first.outcome);
}

/// A law during which others may be asked.
struct Waiting {
  static constexpr const char* name = "Waiting";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  explicit Waiting(const std::function<void()>& action) : meanwhile(action) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    meanwhile();
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) state.traction[c] = line.freeJump[c] / (1.0 + line.compliance);
    return state;
  }
  std::function<void()> meanwhile;
};

/// What another thread is told that does this; empty: nothing.
std::string toldElsewhere(const std::function<void()>& action) {
  std::string message;
  std::thread([&] {
    try {
      action();
    } catch (const base::Error& error) {
      message = error.what();
    }
  }).join();
  return message;
}

// Trilinos counts references without locks.
TEST(Host, RefusesASecondThreadWhileOneIsInside) {
  const assembly::Assembly assembly = sample();
  base::Timers timers;
  LatinSolver idle(assembly, {}, self(), timers);
  std::set<std::string> told;
  assembly::Assembly waits = sample();
  waits.interfaces[1].law = std::make_shared<laws::PointwiseLaw<Waiting>>([&] {
    if (told.size() > 1) return;
    told.insert(toldElsewhere([&] { idle.solve(); }));
    told.insert("and " + toldElsewhere([&] { LatinSolver(assembly, {}, self(), timers); }));
  });
  LatinSolver working(waits, {}, self(), timers);
  working.solve();
  ASSERT_EQ(told.size(), 2U);
  for (const std::string& message : told) {
    EXPECT_NE(message.find("second thread asks a solver of Harmos while another one is inside"), std::string::npos);
    EXPECT_NE(message.find("take turns"), std::string::npos);
  }
}

// Taking turns is no harm; nor is a thread that has failed inside.
TEST(Host, LetsThreadsTakeTurns) {
  const assembly::Assembly assembly = sample();
  const double first = displacement(assembly, self());
  assembly::Assembly broken = sample();
  broken.interfaces[1].law = std::make_shared<laws::PointwiseLaw<Broken>>();
  double found = 0.0;
  EXPECT_EQ(toldElsewhere([&] { EXPECT_THROW(displacement(broken, self()), std::out_of_range); }), "");
  EXPECT_EQ(toldElsewhere([&] { found = displacement(assembly, self()); }), "");
  EXPECT_EQ(found, first);
  EXPECT_EQ(displacement(assembly, self()), first);
}

}  // namespace
}  // namespace harmos::latin
