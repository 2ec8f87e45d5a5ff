#include <atomic>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/SoleThread.hpp>
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

/// Linear glue that counts how many threads are at work in it.
struct Counting {
  static constexpr const char* name = "Counting";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  Counting(std::atomic<int>& now, std::atomic<int>& highest) : inside(now), most(highest) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    const int here = ++inside;
    if (here > most) most = here;
    std::this_thread::yield();
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) state.traction[c] = line.freeJump[c] / (1.0 + line.compliance);
    --inside;
    return state;
  }
  std::atomic<int>&inside, &most;
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

// Ranks whose threads wait for each other in another order would wait for ever.
TEST(Host, RefusesASecondThreadOnSeveralRanks) {
  const base::SoleThread inside;
  const std::string message = toldElsewhere([] { const base::SoleThread other(2); });
  EXPECT_NE(message.find("second thread asks a solver of Harmos on several ranks while another one is inside"),
            std::string::npos);
  EXPECT_NE(message.find("take turns"), std::string::npos);
  const base::SoleThread again(2);  // the same thread
}

// Trilinos counts references without locks: threads that know nothing of each other wait for their turn.
TEST(Host, ThreadsWaitForTheirTurn) {
  const assembly::Assembly assembly = sample();
  const double expected = displacement(assembly, self());
  std::atomic<int> inside{0}, most{0}, right{0};
  assembly::Assembly counting = sample();
  counting.interfaces[1].law = std::make_shared<laws::PointwiseLaw<Counting>>(inside, most);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int run = 0; run < 5; ++run) {
        const auto comm = [] {
          const base::SoleThread meanwhile;
          return self();
        }();
        base::Timers timers;
        LatinSolver(counting, {}, comm, timers).solve();
        if (displacement(assembly, comm) == expected) ++right;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 20);
  EXPECT_EQ(most, 1);
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
