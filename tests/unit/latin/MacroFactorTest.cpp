#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <Teuchos_DefaultComm.hpp>

#include <harmos/latin/detail/MacroFactor.hpp>

namespace harmos::latin {
namespace {

/// Two unknowns that the first rank's body couples: eigenvalues of about 2 and `smallest`.
MacroFactor factorOf(double smallest, int sharedFrom, bool isKnownRegular = false) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  base::Matrix values(2, 2);
  values(0, 0) = values(1, 1) = 1.0 + smallest;
  values(0, 1) = values(1, 0) = -1.0;
  std::vector<MacroFactor::Share> shares;
  if (comm->getRank() == 0) shares.push_back({{0, 1}, values});
  substructure::SolverOptions options;
  options.sharedFrom = sharedFrom;
  return MacroFactor(2, {{0, 1}}, shares, options, comm, isKnownRegular);
}

TEST(MacroFactor, TellsHowSoftItIs) {
  for (const int sharedFrom : {1, 10}) {
    for (const double smallest : {0.5, 1e-6, 1e-12}) {
      const MacroFactor factor = factorOf(smallest, sharedFrom);
      // 1e-12 has four digits where the entries are 1.
      EXPECT_NEAR(factor.softness() * smallest, smallest == 0.5 ? 2.0 * smallest : 1.0, 1e-3);
    }
  }
}

TEST(MacroFactor, TakesWhatIsKnownToBeRegularHoweverSoft) {
  constexpr double soft = 8.0 * std::numeric_limits<double>::epsilon();
  EXPECT_THROW(factorOf(soft, 10), MacroFactor::NotPositiveDefinite);
  EXPECT_NEAR(factorOf(soft, 10, true).softness() * soft, 1.0, 0.5);
}

// Whatever the sign of a rough guess: many unknowns, of which the softest is lost among others.
TEST(MacroFactor, KnowsThatItIsIndefinite) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  constexpr int count = 100;
  std::vector<int> all(count);
  base::Matrix values(count, count);
  for (int i = 0; i < count; ++i) {
    all[i] = i;
    values(i, i) = i == count / 2 ? -1e-4 : 1e-3 + 0.01 * i;
  }
  std::vector<MacroFactor::Share> shares;
  if (comm->getRank() == 0) shares.push_back({all, values});
  for (const int sharedFrom : {1, 2 * count}) {
    substructure::SolverOptions options;
    options.sharedFrom = sharedFrom;
    try {
      const MacroFactor factor(count, {all}, shares, options, comm);
      ADD_FAILURE();
    } catch (const MacroFactor::NotPositiveDefinite& failure) {
      EXPECT_LE(failure.eigenvalue, -1e-5);
      EXPECT_GE(failure.eigenvalue, -1e-3);
      EXPECT_GT(std::abs(failure.motion[count / 2]), 0.9);
    }
  }
}

// Also where a factor exists by luck.
TEST(MacroFactor, TakesRoundOffForNoStiffnessWhateverItsSign) {
  for (const int sharedFrom : {1, 10}) {
    for (const double smallest : {2e-15, 0.0, -2e-15, -1e-3}) {
      try {
        factorOf(smallest, sharedFrom);
        ADD_FAILURE() << smallest;
      } catch (const MacroFactor::NotPositiveDefinite& failure) {
        EXPECT_NEAR(failure.eigenvalue, smallest, 1e-14 + 0.1 * std::abs(smallest));
        ASSERT_EQ(failure.motion.size(), 2u);
        EXPECT_NEAR(failure.motion[0] * failure.motion[1], 0.5, 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace harmos::latin
