#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/design/GridDesign.hpp>
#include <harmos/design/Plan.hpp>

namespace harmos::design {
namespace {

PlannedParameter free(const std::string& name, std::vector<double> levels) {
  PlannedParameter parameter;
  parameter.axis.name = name;
  parameter.axis.levels = std::move(levels);
  return parameter;
}

PlannedParameter derived(const std::string& name, const std::string& formula) {
  PlannedParameter parameter;
  parameter.axis.name = name;
  parameter.formula = formula;
  parameter.where = "s.xml:7: " + name;
  return parameter;
}

std::string messageOf(std::vector<PlannedParameter> parameters, const std::vector<Condition>& conditions) {
  try {
    Plan(std::move(parameters), conditions).configurations(GridDesign());
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "accepted";
}

TEST(Plan, CompletesAndSifts) {
  Plan plan({derived("c", "b + 1"), free("a", {1, 2}), derived("b", "10 * a"), free("d", {0, 5})},
            {{"small", "c < 20 || d > 0", ""}, {"never hit", "a > 0", ""}});
  const auto configurations = plan.configurations(GridDesign());
  ASSERT_EQ(configurations.size(), 3u);
  EXPECT_EQ(configurations[0].id, 1);
  EXPECT_EQ(configurations[0].values, (std::vector<double>{11, 1, 10, 0}));
  EXPECT_EQ(configurations[2].id, 3);
  EXPECT_EQ(configurations[2].values, (std::vector<double>{21, 2, 20, 5}));
  EXPECT_EQ(plan.leftOut(), (std::vector<std::pair<std::string, int>>{{"small", 1}, {"never hit", 0}}));
}

TEST(Plan, SaysWhatIsWrong) {
  EXPECT_EQ(messageOf({free("a", {1}), derived("b", "c"), derived("c", "2 * b")}, {}),
            "s.xml:7: b: the formulas refer to each other in a circle: b, c.");
  EXPECT_EQ(messageOf({free("a", {0}), derived("b", "1 / a")}, {}),
            "s.xml:7: b: the formula \"1 / a\" has no finite value at a = 0.");
  EXPECT_EQ(messageOf({free("a", {0})}, {{"odd", "x > 1", "s.xml:9: odd"}}),
            "s.xml:9: odd: the formula \"x > 1\" uses \"x\", which is no parameter.\n  Parameters: a.");
}

TEST(Plan, SaysWhichConditionsLeaveNothing) {
  EXPECT_EQ(messageOf({free("a", {1, 2, 3})}, {{"two", "a == 2", "s.xml:8: two"}, {"big", "a > 5", "s.xml:9: big"}}),
            "s.xml:8: two: the study has no configuration: of the 3 points of its design \"two\" leaves out 2, \"big\" "
            "leaves out 1.");
}

TEST(Plan, RefusesConditionsWithoutAValue) {
  EXPECT_EQ(messageOf({free("a", {2, 0.5})}, {{"root", "sqrt(a - 1) > 0", "s.xml:8: root"}}).substr(0, 70),
            "s.xml:8: root: the formula \"sqrt(a - 1) > 0\" has no value at a = 0.5: ");
  EXPECT_EQ(messageOf({free("a", {2, 0.5})}, {{"root", "a > 1 ? sqrt(a - 1) > 0 : 0", ""}}), "accepted");
}

}  // namespace
}  // namespace harmos::design
