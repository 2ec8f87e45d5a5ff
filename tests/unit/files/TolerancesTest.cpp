#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/Tolerances.hpp>

using namespace harmos::files;

namespace {

std::string messageOf(const std::string& text) {
  try {
    Tolerances::parse(text, "case.cmp");
  } catch (const harmos::base::Error& error) {
    EXPECT_EQ(error.code(), harmos::base::ExitCode::input);
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST(Tolerances, ReadsACommandFile) {
  const auto t = Tolerances::parse(
      "# a comment\n"
      "DEFAULT TOLERANCE relative 1.E-8 floor 1.E-14\n"
      "COORDINATES absolute 1.E-12\n"
      "TIME STEPS absolute 1.E-10\n"
      "GLOBAL VARIABLES relative 1.E-4 floor 1.E-12   # all of them\n"
      "NODAL VARIABLES absolute 1.E-8\n"
      "\tDISP_X\n"
      "\tdisp_y absolute 1.E-6\n"
      "ELEMENT VARIABLES\n"
      "\t!stress_xy\n",
      "case.cmp");
  EXPECT_EQ(t.distance(100.0), 1e-12);
  EXPECT_EQ(t.times().value, 1e-10);
  EXPECT_EQ(t.find(VariableKind::global, "anything")->value, 1e-4);
  EXPECT_EQ(t.find(VariableKind::nodal, "disp_x")->value, 1e-8);
  EXPECT_EQ(t.find(VariableKind::nodal, "disp_x")->kind, Tolerance::Kind::absolute);
  EXPECT_EQ(t.find(VariableKind::nodal, "disp_y")->value, 1e-6);
  EXPECT_FALSE(t.find(VariableKind::nodal, "disp_z"));
  EXPECT_FALSE(t.find(VariableKind::element, "stress_xy"));
  EXPECT_EQ(t.find(VariableKind::element, "von_mises")->value, 1e-8);
  EXPECT_EQ(t.find(VariableKind::element, "von_mises")->floor, 1e-14);
}

TEST(Tolerances, AllTakesTheUnnamedToo) {
  const auto t = Tolerances::parse("NODAL VARIABLES (all) absolute 1e-8\n  a relative 1e-3\n  !b\n", "case.cmp");
  EXPECT_EQ(t.find(VariableKind::nodal, "a")->kind, Tolerance::Kind::relative);
  EXPECT_FALSE(t.find(VariableKind::nodal, "b"));
  EXPECT_EQ(t.find(VariableKind::nodal, "c")->value, 1e-8);
  EXPECT_FALSE(t.find(VariableKind::global, "c"));  // no section of this kind
}

TEST(Tolerances, DefaultIsRelativeOneMillionth) {
  EXPECT_EQ(Tolerances().find(VariableKind::element, "a")->value, 1e-6);
  EXPECT_DOUBLE_EQ(Tolerances().distance(100.0), 1e-4);
}

TEST(Tolerances, RefusesToCompareNothing) {
  for (const std::string text : {"", "# only a comment\n", "DEFAULT TOLERANCE relative 1e-3\n"}) {
    EXPECT_EQ(messageOf(text),
              "case.cmp names nothing to compare.\n  Write for example NODAL VARIABLES relative 1e-6.");
  }
  EXPECT_EQ(messageOf("COORDINATES absolute 1e-8"), "accepted");
}

TEST(Tolerances, MeasuresDifferences) {
  Tolerance t;
  t.floor = 1e-3;
  EXPECT_DOUBLE_EQ(t.difference(1.0, 0.5), 0.5);
  EXPECT_EQ(t.difference(1e-3, -1e-3), 0.0);
  EXPECT_GT(t.difference(2e-3, -1e-3), 1.0);
  EXPECT_EQ(t.difference(0.0, 0.0), 0.0);
  t.kind = Tolerance::Kind::absolute;
  EXPECT_DOUBLE_EQ(t.difference(7.0, 4.0), 3.0);
  t.kind = Tolerance::Kind::combined;
  EXPECT_DOUBLE_EQ(t.difference(0.5, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(t.difference(8.0, 4.0), 0.5);
  t.kind = Tolerance::Kind::ignore;
  EXPECT_EQ(t.difference(7.0, 4.0), 0.0);
}

TEST(Tolerances, SaysWhereAndWhatIsWrong) {
  EXPECT_EQ(messageOf("NODAL VARIABLES\n  disp_x relativ 1e-6\n"),
            "case.cmp, line 2: unknown word \"relativ\". Did you mean \"relative\"? A tolerance may hold: relative, "
            "absolute, combined, ignore, floor.");
  EXPECT_EQ(messageOf("NODAL VARIABLES relative -1e-6\n"),
            "case.cmp, line 1: \"-1e-6\" is not a number of at least 0.");
  EXPECT_EQ(messageOf("NODAL VARIABLES relative 1 floor\n"), "case.cmp, line 1: \"floor\" wants a number after it.");
  EXPECT_NE(messageOf("\tdisp_x\n").find("must follow a line"), std::string::npos);
  EXPECT_NE(messageOf("\nNODEL VARIABLES\n").find("line 2: unknown command \"NODEL VARIABLES\""), std::string::npos);
}
