// The same study on 1, 2 and 4 ranks: the bodies apart, ranks without a body.
#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/parametric/ParametricStudy.hpp>

#include "../latin/Chains.hpp"

namespace harmos::parametric {
namespace {

class Results : public results::ResultSink {
 public:
  void record(const results::ConfigurationResult& result) override { last[result.id] = result; }
  std::map<int, results::ConfigurationResult> last;
};

std::shared_ptr<const laws::InterfaceLaw> friction(double coefficient) {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", coefficient}});
}

std::map<int, results::ConfigurationResult> run(const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  assembly::Assembly assembly = latin::twoChains(
      friction(0.3),
      laws::makeLaw("Prescribed Displacement", {{"X", -0.15}, {"Y", 0.1}, {"Z", 0.02}}, {{"Y", {0.2, 1.0, 0.8, -1.0}}}),
      4);
  assembly.owner = {comm->getSize() - 1, 0};
  latin::LatinOptions options;
  options.accuracy = 1e-3;
  base::Timers timers;
  const auto shear = std::make_shared<latin::ResultantResponse>("shear", std::vector<int>{1},
                                                                std::vector<base::Vector3>{{0.0, 1.0, 0.0}});
  ParametricStudy study(
      assembly, [&](const auto& values) { assembly.interfaces[1].law = friction(values[0]); }, {shear}, options, comm,
      timers);
  std::vector<design::Configuration> configurations;
  for (int i = 1; i <= 20; ++i) configurations.push_back({i, {0.02 * i}});
  Results results;
  study.run(configurations, results);
  return results.last;
}

TEST(ParametricStudyRanks, DoNotChangeTheResults) {
  const auto alone = run(latin::self());
  const auto together = run(Tpetra::getDefaultComm());
  ASSERT_EQ(alone.size(), 20u);
  ASSERT_EQ(together.size(), 20u);
  for (const auto& [id, expected] : alone) {
    const results::ConfigurationResult& result = together.at(id);
    EXPECT_EQ(result.status, expected.status);
    // Of states that depend on each other all but for round-off, which other ranks round otherwise, any may be left
    // out.
    EXPECT_EQ(result.starts.empty(), expected.starts.empty());
    for (std::size_t t = 0; t < 4; ++t) EXPECT_NEAR(result.curves[0][t], expected.curves[0][t], 1e-3);
  }
}

}  // namespace
}  // namespace harmos::parametric
