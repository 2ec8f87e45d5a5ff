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

TEST(Documentation, ShowsEquationsExamplesAndOutputs) {
  ParameterSpec spec("Spring");
  spec.summary("Elastic.").equation("t = k delta").output("stretch", "length", "of the spring");
  spec.number("Stiffness").unit("stress/length").example("500").doc("k.");
  spec.number("Gap").unit("length").optional().example("0.1").doc("At rest.");
  spec.number("Limit").unit("length").optional().doc("Largest stretch.");
  const std::string text = documentation(spec);
  for (const char* part :
       {"\nEquation: `t = k delta`\n", "- adds `stretch` [length] to the results: of the spring.\n",
        "name=\"Stiffness\" type=\"double\" value=\"500\"", "name=\"Gap\" type=\"double\" value=\"0.1\""}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
  EXPECT_EQ(text.find("name=\"Limit\""), std::string::npos) << text;
}

TEST(Documentation, HasPages) {
  const std::vector<Page> pages{{"Codes", "0: done.\n"}};
  EXPECT_EQ(documentation({sampleSpec()}, "Codes", pages), "## Codes\n\n0: done.\n\n");
  EXPECT_NE(documentation({sampleSpec()}, "", pages).find("## Codes\n"), std::string::npos);
  EXPECT_NE(messageOf([&] { documentation({sampleSpec()}, "Cdes", pages); }).find("Did you mean \"Codes\"?"),
            std::string::npos);
}

TEST(Documentation, UnknownTopic) {
  EXPECT_EQ(
      messageOf([] { documentation(sampleSpec(), "Frction"); }),
      "There is nothing called \"Frction\" in the input.\n"
      "  Did you mean \"Friction\"? Topics: Sample, Values, Histories, Solver, Scaling, Joints, Law, Friction, Glue.");
}

}  // namespace
}  // namespace harmos::input
