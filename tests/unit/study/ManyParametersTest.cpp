#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <string>

#include <harmos/study/StudyReader.hpp>

#include "../scene/Sample.hpp"

namespace harmos::study {
namespace {

/// The sample with values, each of which is that of a material of its own.
std::string sceneWith(int count) {
  std::string values, materials;
  for (int i = 0; i < count; ++i) {
    const std::string name = "v" + std::to_string(i);
    values += "<Parameter name=\"" + name + "\" type=\"double\" value=\"1000\"/>\n";
    materials += "<ParameterList name=\"" + name + "\"><Parameter name=\"Type\" type=\"string\" value=\"Isotropic\"/>" +
                 "<Parameter name=\"Young's Modulus\" type=\"double\" value=\"$" + name + "\"/>" +
                 "<Parameter name=\"Poisson's Ratio\" type=\"double\" value=\"0\"/></ParameterList>\n";
  }
  std::string scene = scene::sampleScene();
  scene.insert(scene.find("    <ParameterList name=\"steel\">"), materials);
  scene.insert(scene.find("  <ParameterList name=\"Mesh\">"),
               "<ParameterList name=\"Values\">" + values + "</ParameterList>\n");
  return scene;
}

std::string studyWith(int count) {
  std::string parameters;
  for (int i = 0; i < count; ++i) {
    const std::string name = "v" + std::to_string(i);
    parameters += "<ParameterList name=\"" + name + "\"><Parameter name=\"Entry\" type=\"string\" value=\"Values/" +
                  name + "\"/><Parameter name=\"Values\" type=\"Array(double)\" value=\"{2000}\"/></ParameterList>\n";
  }
  return "<ParameterList name=\"Harmos Study\"><Parameter name=\"Scene\" type=\"string\" value=\"scene.xml\"/>"
         "<ParameterList name=\"Parameters\">" +
         parameters + "</ParameterList></ParameterList>";
}

/// CPU seconds.
double secondsToRead(int count) {
  const auto scene = input::InputTree::fromText(sceneWith(count), "scene.xml");
  const auto study = input::InputTree::fromText(studyWith(count), "study.xml");
  const std::clock_t begin = std::clock();
  makeStudy(study, &scene, "study.xml", {}, "", laws::builtInLaws());
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// The median of some pairs: the machine may have changed its speed between the two of one, hardly in most of them.
TEST(ManyParameters, AreReadInATimeThatGrowsAsTheirNumber) {
  constexpr int few = 500, times = 8;
  std::array<double, 5> growths{};
  for (double& growth : growths) {
    const double before = secondsToRead(few);
    growth = secondsToRead(times * few) / before;
  }
  std::sort(growths.begin(), growths.end());
  EXPECT_LT(growths[growths.size() / 2], 3 * times) << "quadratic growth would be " << times * times;
}

}  // namespace
}  // namespace harmos::study
