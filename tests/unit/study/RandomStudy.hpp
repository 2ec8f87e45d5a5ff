#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include <harmos/study/StudyReader.hpp>

#include "../scene/Sample.hpp"

namespace harmos::study {

/// A study of two random parameters and one that follows from them, in a folder of its own.
class RandomStudy : public ::testing::Test {
 protected:
  RandomStudy() {
    std::filesystem::create_directories(directory);
    std::ofstream(directory + "/scene.xml") << scene::sampleScene();
    std::ofstream(directory + "/study.xml") << R"xml(<ParameterList name="Harmos Study">
  <Parameter name="Scene" type="string" value="scene.xml"/>
  <ParameterList name="Parameters">
    <ParameterList name="mu">
      <Parameter name="Entry" type="string" value="Interfaces/seal/Law/Friction Coefficient"/>
      <ParameterList name="Distribution">
        <Parameter name="Type" type="string" value="Lognormal"/>
        <Parameter name="Mean" type="double" value="0.3"/>
        <Parameter name="Coefficient of Variation" type="double" value="0.2"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="double_mu">
      <Parameter name="Formula" type="string" value="2 * mu"/>
    </ParameterList>
    <ParameterList name="pressure">
      <Parameter name="Entry" type="string" value="Boundaries/pressed/Law/Pressure"/>
      <ParameterList name="Distribution">
        <Parameter name="Type" type="string" value="Normal"/>
        <Parameter name="Mean" type="double" value="5"/>
        <Parameter name="Standard Deviation" type="double" value="1"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Design">
    <Parameter name="Type" type="string" value="Collocation"/>
  </ParameterList>
</ParameterList>
)xml";
  }
  ~RandomStudy() override { std::filesystem::remove_all(directory); }

  Study study(const std::vector<std::string>& overrides = {}, const std::string& points = "") const {
    return readStudy(directory + "/study.xml", overrides, points, laws);
  }

  const std::string directory = "random_study_test." + std::to_string(::getpid());
  const laws::LawRegistry laws = laws::builtInLaws();
};

}  // namespace harmos::study
