// Which rigid motions the matrix of a body resists.
#include <gtest/gtest.h>

#include <Teuchos_DefaultSerialComm.hpp>

#include <harmos/latin/ResistedMotions.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

constexpr double root = 0.70710678118654752;

/// Four nodes around the y axis, each on a spring to the ground along a direction of its own.
substructure::Substructure onSprings(const std::vector<base::Vector3>& directions) {
  substructure::Substructure body;
  body.name = "body";
  body.nodes = {{1.0, 0.0, 1.0}, {1.0, 2.0, -1.0}, {-1.0, 0.0, -1.0}, {-1.0, 3.0, 1.0}};
  std::vector<std::size_t> pointers{0};
  std::vector<int> columns;
  std::vector<double> values;
  for (int node = 0; node < 4; ++node) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        columns.push_back(3 * node + j);
        values.push_back(directions[node][i] * directions[node][j]);
      }
      pointers.push_back(columns.size());
    }
  }
  body.stiffness = substructure::makeCrsMatrix(pointers, columns, values);
  return body;
}

ResistedMotions resisted(const substructure::Substructure& body) {
  assembly::Assembly assembly;
  assembly.bodies = {body};
  return resistedMotions(assembly, Teuchos::SerialComm<int>()).front();
}

TEST(ResistedMotions, OfSpringsAlongOneDirectionAreThatAndAllTurns) {
  const base::Vector3 none{}, x{1.0, 0.0, 0.0};
  EXPECT_EQ(resisted(onSprings({none, none, none, none})), (ResistedMotions{}));
  EXPECT_EQ(resisted(onSprings({x, x, x, x})), (ResistedMotions{true, false, false, true, true, true}));
}

TEST(ResistedMotions, OfSpringsThatPointAtAnAxisLeaveTheTurnAboutIt) {
  const base::Vector3 a{root, 0.0, root}, b{root, 0.0, -root};
  EXPECT_EQ(resisted(onSprings({a, b, a, b})), (ResistedMotions{true, false, true, true, false, true}));
  // One that points past it resists the turn as well.
  EXPECT_EQ(resisted(onSprings({a, b, a, a})), (ResistedMotions{true, false, true, true, true, true}));
}

TEST(ResistedMotions, OfBodiesThatShareAMatrixAreToldWhereItIsTheirOwn) {
  assembly::Assembly assembly;
  assembly.bodies = {onSprings({{1.0, 0.0, 0.0}, {}, {}, {}}), onSprings({{}, {}, {}, {}}), {}};
  assembly.bodies[2].nodes = assembly.bodies[0].nodes;
  auto congruence = std::make_shared<substructure::Congruence>();
  congruence->representative = 0;
  assembly.bodies[2].congruence = congruence;
  const std::vector<ResistedMotions> found = resistedMotions(assembly, Teuchos::SerialComm<int>());
  EXPECT_EQ(found[0], (ResistedMotions{true, false, false, true, true, true}));
  EXPECT_EQ(found[1], (ResistedMotions{}));
  EXPECT_EQ(found[2], (ResistedMotions{true, true, true, true, true, true}));  // its axes may be others
}

}  // namespace
}  // namespace harmos::latin
