#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/scene/detail/SharedOperators.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

/// Two equal boxes, moved onto each other, of which the lower is touched from above and the upper from below.
class EqualBoxes : public ::testing::Test {
 protected:
  EqualBoxes() {
    base::Timers timers;
    const Problem problem = makeProblem(sample(), *Tpetra::getDefaultComm(), timers);
    bodies = problem.assembly.bodies;
    for (const assembly::Interface& interface : problem.assembly.interfaces) {
      if (interface.sides() == 2) interfaces.push_back(interface);
    }
  }

  /// The body whose operator the second one uses.
  std::size_t operatorOfSecond() const {
    SharedOperators operators(interfaces, 3);
    operators.add(0, bodies[0].nodes.size(), bodies[0].congruence.get(), false);
    return operators.add(1, bodies[1].nodes.size(), bodies[1].congruence.get(), false);
  }

  std::vector<substructure::Substructure> bodies;
  std::vector<assembly::Interface> interfaces;
};

TEST_F(EqualBoxes, HaveTwoWhereOtherNodesAreTouchedThoughAsMany) {
  ASSERT_NE(bodies[1].congruence, nullptr);
  EXPECT_EQ(operatorOfSecond(), 1U);
}

TEST_F(EqualBoxes, ShareAnOperatorWhereTheyAreTouchedAlike) {
  std::vector<int> alike;
  for (int p = 0; p < interfaces.at(0).pairs(); ++p) {
    alike.push_back(bodies[1].congruence->node[interfaces[0].trace1.node(p)]);
  }
  interfaces[0].trace2 = mesh::TraceOperator(alike);
  EXPECT_EQ(operatorOfSecond(), 0U);
}

TEST_F(EqualBoxes, HaveTwoWhereOneIsSolvedIteratively) {
  SharedOperators operators(interfaces, 3);
  EXPECT_EQ(operators.add(0, bodies[0].nodes.size(), nullptr, true), 0U);
  EXPECT_EQ(operators.add(1, bodies[1].nodes.size(), bodies[1].congruence.get(), false), 1U);
}

}  // namespace
}  // namespace harmos::scene
