#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <harmos/base/Error.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

using Text = std::function<std::string(int)>;

/// A scene with `count` of each of what `lists` says for the i-th entry, by the name of the list.
struct Kind {
  std::string name;
  std::vector<std::pair<std::string, Text>> lists;
};

std::string number(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + value + "\"/>";
}

std::string word(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>";
}

std::string words(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"Array(string)\" value=\"{" + value + "}\"/>";
}

std::string vector(const std::string& name) {
  return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"{0, 0, 1}\"/>";
}

std::string list(const std::string& name, const std::string& inside) {
  return "<ParameterList name=\"" + name + "\">" + inside + "</ParameterList>";
}

std::string nth(const std::string& name, int i) {
  return name + "_" + std::to_string(i);
}

std::string material(int i, const std::string& modulus) {
  return list(nth("material", i), word("Type", "Isotropic") + number("Young's Modulus", modulus) +
                                      number("Poisson's Ratio", "0.3") + number("Density", "1") +
                                      number("Thermal Expansion", "1e-5"));
}

std::string part(int i) {
  return list(nth("part", i), word("Material", nth("material", i)));
}

std::string interface(int i) {
  return list(nth("joint", i), word("Part 1", nth("part", i)) + word("Part 2", nth("part", i > 0 ? i - 1 : 1)) +
                                   list("Law", word("Type", "Perfect")));
}

const Text materials = [](int i) { return material(i, "1000"); };

std::vector<Kind> kinds() {
  const Text sections = [](int i) {
    return list(nth("cut", i), word("Part", nth("part", i)) + vector("Point") + vector("Normal") +
                                   list("Law", word("Type", "Perfect")));
  };
  const Text pressures = [](int i) {
    return list(nth("face", i),
                word("Side Set", nth("set", i)) + list("Law", word("Type", "Pressure") + number("Pressure", "1") +
                                                                  word("Pressure History", nth("history", i))));
  };
  const Text histories = [](int i) { return list(nth("history", i), word("Type", "Ramp") + number("End", "1")); };
  const Text responses = [](int i) {
    return list(nth("response", i), word("Type", "Bolt Force") + word("Interface", nth("joint", i)));
  };
  const Text temperatures = [](int i) {
    return list(nth("heat", i),
                word("Type", "Prescribed") + words("Parts", nth("part", i)) + number("Temperature", "1"));
  };
  const Text loads = [](int i) {
    return list(nth("load", i), word("Type", "Gravity") + words("Parts", nth("part", i)) + number("Z", "-1"));
  };
  return {
      {"Values", {{"Values", [](int i) { return number(nth("value", i), "1"); }}}},
      {"ValuesInUse",
       {{"Values", [](int i) { return number(nth("value", i), "1"); }},
        {"Materials", [](int i) { return material(i, "$" + nth("value", i)); }}}},
      {"Parts", {{"Materials", materials}, {"Parts", part}}},
      {"Interfaces", {{"Materials", materials}, {"Parts", part}, {"Interfaces", interface}}},
      {"Sections", {{"Materials", materials}, {"Parts", part}, {"Interfaces", sections}}},
      {"Boundaries", {{"Boundaries", pressures}, {"Histories", histories}}},
      {"Responses", {{"Materials", materials}, {"Parts", part}, {"Interfaces", interface}, {"Responses", responses}}},
      {"Temperatures", {{"Materials", materials}, {"Parts", part}, {"Temperatures", temperatures}}},
      {"Loads", {{"Materials", materials}, {"Parts", part}, {"Loads", loads}}},
      {"Steps", {{"Steps", [](int i) { return list(nth("step", i), ""); }}}},
  };
}

/// With what a scene needs besides.
std::string sceneWith(const Kind& kind, int count) {
  std::string text = "<ParameterList name=\"Harmos\">";
  text += list("Mesh", word("Type", "Exodus") + word("File", "none.e"));
  const auto has = [&](const std::string& name) {
    return std::any_of(kind.lists.begin(), kind.lists.end(), [&](const auto& each) { return each.first == name; });
  };
  if (!has("Materials")) text += list("Materials", material(0, "1000"));
  if (!has("Parts")) text += list("Parts", part(0));
  if (!has("Steps")) text += list("Steps", list("only", ""));
  for (const auto& [name, entry] : kind.lists) {
    std::string inside;
    for (int i = 0; i < count; ++i) inside += entry(i) + "\n";
    text += list(name, inside);
  }
  return text + "</ParameterList>";
}

/// CPU seconds, the least of some times, so that what else the machine does hardly counts.
double secondsOf(const std::function<void()>& action) {
  double least = std::numeric_limits<double>::infinity();
  for (int time = 0; time < 2; ++time) {
    const std::clock_t begin = std::clock();
    action();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

double secondsToRead(const Kind& kind, int count) {
  const input::InputTree tree = input::InputTree::fromText(sceneWith(kind, count), "many.xml");
  return secondsOf([&] { makeScene(tree, "many.xml", {}, laws::builtInLaws()); });
}

class ManyEntries : public ::testing::TestWithParam<Kind> {};

TEST_P(ManyEntries, AreReadInATimeThatGrowsAsTheirNumber) {
  constexpr int few = 1000, times = 8;
  const double before = secondsToRead(GetParam(), few), after = secondsToRead(GetParam(), times * few);
  EXPECT_LT(after / before, 3 * times) << "quadratic growth would be " << times * times << ": " << before << " s and "
                                       << after << " s";
}

INSTANTIATE_TEST_SUITE_P(Kinds, ManyEntries, ::testing::ValuesIn(kinds()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace harmos::scene
