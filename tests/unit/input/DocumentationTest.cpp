#include <gtest/gtest.h>

#include <harmos/input/Documentation.hpp>

#include "Sample.hpp"

namespace harmos::input {
namespace {

TEST(Documentation, OfOneType) {
  EXPECT_EQ(documentation(sampleSpec(), "Friction"), R"(## Sample / Joints / (your name) / Law, Type = Friction

Sliding.

Source: Coulomb (1785).

- `Coefficient` (double, [-], required), at least 0 [-]. Ratio of tractions. May follow a history: `Coefficient History`.

    <ParameterList name="Law">
      <Parameter name="Type" type="string" value="Friction"/>
      <Parameter name="Coefficient" type="double" value="..."/>
    </ParameterList>

)");
}

TEST(Documentation, HoldsEveryList) {
  const std::string text = documentation(sampleSpec());
  for (const char* part : {"## Sample / Solver\n", "## Sample / Solver / Scaling\n", "Type = Glue",
                           "`Accuracy` (double, default: 0.001), above 0 and below 1. Relative error asked for.",
                           "one of: Plain, Relaxed"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST(Documentation, DescribesATypeOfSeveralListsOnce) {
  ParameterSpec form("Friction");
  form.summary("Sliding.");
  ParameterSpec spec("Sample");
  spec.list("First").alternatives("Law", {form});
  spec.list("Second").alternatives("Law", {form});
  const std::string text = documentation(spec, "Friction");
  EXPECT_EQ(text.find("Sliding."), text.rfind("Sliding."));
  EXPECT_NE(text.find("## Sample / Second / Law, Type = Friction\n\nAs for Sample / First / Law, Type = Friction.\n"),
            std::string::npos)
      << text;
}

TEST(Documentation, UnknownTopic) {
  EXPECT_EQ(
      messageOf([] { documentation(sampleSpec(), "Frction"); }),
      "There is nothing called \"Frction\" in the input.\n"
      "  Did you mean \"Friction\"? Topics: Sample, Values, Histories, Solver, Scaling, Joints, Law, Friction, Glue.");
}

}  // namespace
}  // namespace harmos::input
