#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <harmos/study/StudyReader.hpp>
#include <harmos/study/detail/Interpolation.hpp>

#include "../scene/Sample.hpp"

namespace harmos::study {
namespace {

class InterpolationTest : public ::testing::Test {
 protected:
  InterpolationTest() {
    std::filesystem::create_directories(directory);
    std::ofstream(directory + "/scene.xml") << scene::sampleScene();
    std::ofstream(directory + "/study.xml") << R"xml(<ParameterList name="Harmos Study">
  <Parameter name="Scene" type="string" value="scene.xml"/>
  <ParameterList name="Parameters">
    <ParameterList name="mu">
      <Parameter name="Entry" type="string" value="Interfaces/seal/Law/Friction Coefficient"/>
      <ParameterList name="Distribution">
        <Parameter name="Type" type="string" value="Normal"/>
        <Parameter name="Mean" type="double" value="0.3"/>
        <Parameter name="Standard Deviation" type="double" value="0.03"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="pressure">
      <Parameter name="Entry" type="string" value="Boundaries/pressed/Law/Pressure"/>
      <ParameterList name="Distribution">
        <Parameter name="Type" type="string" value="Normal"/>
        <Parameter name="Mean" type="double" value="5"/>
        <Parameter name="Standard Deviation" type="double" value="0.5"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Design">
    <Parameter name="Type" type="string" value="Adaptive Collocation"/>
    <Parameter name="Maximum Count" type="int" value="120"/>
  </ParameterList>
</ParameterList>
)xml";
  }
  ~InterpolationTest() override { std::filesystem::remove_all(directory); }

  /// Alike in both germs, so that many points matter as much as others.
  static double kinked(const design::Configuration& configuration, double error) {
    const double sum = (configuration.values[0] - 0.3) / 0.03 + (configuration.values[1] - 5.0) / 0.5;
    return std::max(0.0, sum - 0.1) + (configuration.id % 3 - 1) * error;
  }

  static void solve(const design::Configuration& configuration, double error, results::StudyResults& results) {
    results::ConfigurationResult result;
    result.id = configuration.id;
    result.status = results::Status::certified;
    result.curves = {{kinked(configuration, error)}};
    results.set(result);
  }

  const std::string directory = "interpolation_test." + std::to_string(::getpid());
  const laws::LawRegistry laws = laws::builtInLaws();
};

// What is found anew, as claims that are taken back, differs within the accuracy: enough to ask in another order.
TEST_F(InterpolationTest, GoesThroughItsPointsWhateverOrderTheyWereSolvedIn) {
  const Study study = readStudy(directory + "/study.xml", {}, "", laws);
  results::StudyDescription description;
  description.configurations = study.configurations;
  description.times = {1.0};
  description.responses = {{"r", 0, results::ScalarResponse::Kind::final}};
  results::StudyResults results(description);
  for (const design::Configuration& configuration : study.configurations) solve(configuration, 0.0, results);
  double error = 1e-6;
  for (;;) {
    const Interpolation interpolation(study, results);
    if (interpolation.wanted().empty()) break;
    for (const std::vector<double>& germs : interpolation.wanted()) {
      const int id = static_cast<int>(results.configurations().size()) + 1;
      results.add({id, study.stochastic->variables->values(germs)});
    }
    error = -error;
    for (const design::Configuration& configuration : results.configurations()) solve(configuration, error, results);
  }
  const Interpolation interpolation(study, results);
  ASSERT_TRUE(interpolation.isComplete());
  ASSERT_GT(interpolation.count(), 100);
  int passed = 0;
  for (const design::Configuration& configuration : results.configurations()) {
    const std::vector<double> germs = {(configuration.values[0] - 0.3) / 0.03, (configuration.values[1] - 5.0) / 0.5};
    const double off = interpolation.function().evaluate(germs)[0] - kinked(configuration, error);
    passed += std::abs(off) < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(passed, interpolation.count());
}

}  // namespace
}  // namespace harmos::study
