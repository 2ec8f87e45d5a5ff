#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include "Sample.hpp"

namespace harmos::input {
namespace {

const std::string joint =
    R"(<ParameterList name="Joints"><ParameterList name="seal"><ParameterList name="Law">
<Parameter name="Type" type="string" value="Glue"/><Parameter name="Stiffness" type="int" value="3"/>
</ParameterList></ParameterList></ParameterList>)";

/// The message for a list "Solver" on line 5 that holds `inside`.
std::string solverError(const std::string& inside) {
  return messageOf([&] {
    check(sampleTree(joint + "\n<ParameterList name=\"Solver\">" + inside + "</ParameterList>"), sampleSpec());
  });
}

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

TEST(Check, FillsDefaultsAndResolvesNamedValues) {
  const Parameters p = check(InputTree::fromText(sampleText(), "s.xml"), sampleSpec());
  EXPECT_EQ(p.list("Solver").number("Accuracy"), 1e-3);
  EXPECT_EQ(p.list("Solver").integer("Iterations"), 100);
  EXPECT_FALSE(p.list("Solver").flag("Verbose"));
  EXPECT_EQ(p.list("Solver").list("Scaling").number("Factor"), 1.0);
  const Parameters& seal = p.lists("Joints").at(0);
  EXPECT_EQ(seal.name(), "seal");
  EXPECT_EQ(seal.numbers("Axis"), (std::vector<double>{0, 0, 0.3}));
  EXPECT_EQ(seal.list("Law").number("Coefficient"), 0.3);
  EXPECT_FALSE(seal.has("Sides"));
  EXPECT_EQ(seal.where("Axis"), "s.xml:10: Joints / seal / Axis");
  EXPECT_EQ(seal.where("Sides"), "s.xml:9: Joints / seal");
}

TEST(Check, AcceptsTheListOfAHost) {
  Teuchos::ParameterList list;
  list.sublist("Solver").set("Accuracy", 0.1).set("Iterations", 7).set("Verbose", true);
  auto& seal = list.sublist("Joints").sublist("seal");
  seal.set("Axis", Teuchos::Array<double>(Teuchos::tuple(0.1, 0.0, 1.0)));
  seal.sublist("Law").set("Type", std::string("Glue")).set("Stiffness", 2.0);
  const Parameters p = check(InputTree::fromTeuchos(list, "host"), sampleSpec());
  EXPECT_EQ(p.list("Solver").integer("Iterations"), 7);
  EXPECT_EQ(p.lists("Joints").at(0).numbers("Axis")[0], 0.1);

  list.sublist("Solver").set("Accuracy", 1.0f);
  EXPECT_EQ(messageOf([&] { check(InputTree::fromTeuchos(list, "host"), sampleSpec()); }),
            "host: Solver / Accuracy: type \"float\" is given, but the type is \"double\".\n"
            "  Write <Parameter name=\"Accuracy\" type=\"double\" value=\"...\"/>.\n"
            "1 error; nothing was run.");
}

TEST(Check, ShowsSomeOfManyErrorsAndNoEntryWithoutEnd) {
  std::string many;
  for (int i = 0; i < 250; ++i) many += parameter("x" + std::to_string(i), "double", "1");
  const std::string text = solverError(many);
  EXPECT_NE(text.find("unknown parameter \"x99\""), std::string::npos);
  EXPECT_EQ(text.find("unknown parameter \"x100\""), std::string::npos);
  EXPECT_NE(text.find("\n250 errors; nothing was run. The first 100 are shown."), std::string::npos);
  // Cut between letters, of which each of these takes two bytes.
  std::string longValue;
  for (int i = 0; i < 100000; ++i) longValue += "\u00e4";
  const std::string cut = solverError(parameter("Accuracy", "double", longValue));
  EXPECT_LT(cut.size(), 5000U);
  EXPECT_NE(cut.find("\u00e4 ...\n"), std::string::npos) << cut;
}

TEST(Check, UnknownParameterNamesTheNearest) {
  EXPECT_EQ(solverError(parameter("Acuracy", "double", "0.1")),
            "s.xml:5: Solver: unknown parameter \"Acuracy\".\n"
            "  Did you mean \"Accuracy\"? Allowed here: Accuracy, Iterations, Verbose, Method.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError(parameter("Factor", "double", "0.1")),
            "s.xml:5: Solver: unknown parameter \"Factor\".\n"
            "  It belongs at Solver / Scaling / Factor. Allowed here: Accuracy, Iterations, Verbose, Method.\n"
            "1 error; nothing was run.");
}

TEST(Check, UnknownListNamesTheNearest) {
  EXPECT_EQ(solverError("<ParameterList name=\"scalling\"/>"),
            "s.xml:5: Solver: unknown list \"scalling\".\n"
            "  Did you mean \"Scaling\"? Allowed here: Scaling.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError("<ParameterList name=\"Joints\"/>"),
            "s.xml:5: Solver: unknown list \"Joints\".\n"
            "  It belongs at Sample / Joints. Allowed here: Scaling.\n"
            "1 error; nothing was run.");
}

TEST(Check, MisspeltIsNotMissingToo) {
  EXPECT_EQ(messageOf([] { check(sampleTree("<ParameterList name=\"Jonts\"/>"), sampleSpec()); }),
            "s.xml:2: Sample: unknown list \"Jonts\".\n"
            "  Did you mean \"Joints\"? Allowed here: Values, Histories, Solver, Joints.\n"
            "1 error; nothing was run.");
}

TEST(Check, WrongTypes) {
  EXPECT_EQ(solverError(parameter("Accuracy", "string", "0.1")),
            "s.xml:5: Solver / Accuracy: type \"string\" is given, but the type is \"double\".\n"
            "  Write <Parameter name=\"Accuracy\" type=\"double\" value=\"...\"/>.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError("<ParameterList name=\"Accuracy\"/>"),
            "s.xml:5: Solver / Accuracy: is a parameter, but a list is given.\n"
            "  Write <Parameter name=\"Accuracy\" type=\"double\" value=\"...\"/>.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError(parameter("Scaling", "double", "0.1")),
            "s.xml:5: Solver / Scaling: is a list, but a parameter is given.\n"
            "  Write <ParameterList name=\"Scaling\"> ... </ParameterList>.\n"
            "1 error; nothing was run.");
}

TEST(Check, WhatIsNotANumber) {
  for (const std::string text : {"abc", "1e3x", "", "nan", "inf", "-inf", "1,5", "1e999", "0x10", "1 2"}) {
    EXPECT_EQ(solverError(parameter("Accuracy", "double", text)),
              "s.xml:5: Solver / Accuracy: \"" + text +
                  "\" is not a finite number.\n"
                  "  Write a number such as 0.5 or 2e5, or \"$name\" for an entry of the list Values.\n"
                  "1 error; nothing was run.");
  }
  EXPECT_EQ(solverError(parameter("Accuracy", "int", "0.5")),
            "s.xml:5: Solver / Accuracy: \"0.5\" is not an integer, but the type is \"int\".\n"
            "  Write type=\"double\".\n"
            "1 error; nothing was run.");
}

TEST(Check, WhatIsNotAnInteger) {
  for (const std::string text : {"10.5", "1e3", "99999999999", "", "$n"}) {
    EXPECT_EQ(solverError(parameter("Iterations", "int", text)),
              "s.xml:5: Solver / Iterations: \"" + text +
                  "\" is not an integer.\n"
                  "  Write a whole number between -2147483648 and 2147483647, without point or exponent.\n"
                  "1 error; nothing was run.");
  }
}

TEST(Check, WhatIsNotAFlag) {
  EXPECT_EQ(solverError(parameter("Verbose", "bool", "yes")),
            "s.xml:5: Solver / Verbose: \"yes\" is not allowed.\n"
            "  Allowed: true, false.\n"
            "1 error; nothing was run.");
}

TEST(Check, Ranges) {
  EXPECT_EQ(solverError(parameter("Accuracy", "double", "0")),
            "s.xml:5: Solver / Accuracy: 0 is out of range.\n"
            "  Allowed: above 0 and below 1.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError(parameter("Accuracy", "double", "1")),
            "s.xml:5: Solver / Accuracy: 1 is out of range.\n"
            "  Allowed: above 0 and below 1.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError(parameter("Iterations", "int", "0")),
            "s.xml:5: Solver / Iterations: 0 is out of range.\n"
            "  Allowed: at least 1 [count].\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError(parameter("Iterations", "int", "1")), "no error");
}

TEST(Check, Choices) {
  EXPECT_EQ(solverError(parameter("Method", "string", "relaxd")),
            "s.xml:5: Solver / Method: \"relaxd\" is not allowed.\n"
            "  Did you mean \"Relaxed\"? Allowed: Plain, Relaxed.\n"
            "1 error; nothing was run.");
}

TEST(Check, Duplicates) {
  EXPECT_EQ(solverError(parameter("Verbose", "bool", "true") + "\n" + parameter("Verbose", "bool", "false")),
            "s.xml:6: Solver / Verbose: is given twice, first at s.xml:5.\n"
            "  Remove or rename one of them.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(messageOf([] {
              check(sampleTree(joint + "\n<ParameterList name=\"Solver\"/>\n\n<ParameterList name=\"Solver\"/>"),
                    sampleSpec());
            }),
            "s.xml:7: Solver: is given twice, first at s.xml:5.\n"
            "  Remove or rename one of them.\n"
            "1 error; nothing was run.");
}

TEST(Check, StrayElementsAndText) {
  EXPECT_EQ(solverError("<Paramter name=\"Verbose\" type=\"bool\" value=\"true\"/>"),
            "s.xml:5: Solver: unknown element <Paramter>.\n"
            "  Did you mean \"Parameter\"? Allowed: ParameterList, Parameter.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError("\n hello\n"),
            "s.xml:6: Solver: text \"hello\" stands between the tags.\n"
            "  Remove it, or make it a comment <!-- -->.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError("<Parameter name=\"Verbose\" type=\"bool\" value=\"true\"><Parameter/></Parameter>"),
            "s.xml:5: Solver / Verbose: a <Parameter> holds nothing, but <Parameter> stands in it.\n"
            "  Close it with \"/>\", or make it a <ParameterList>.\n"
            "1 error; nothing was run.");
}

TEST(Check, Attributes) {
  EXPECT_EQ(solverError("<Parameter name=\"Verbose\" value=\"true\"/>"),
            "s.xml:5: Solver / Verbose: <Parameter> has no type.\n"
            "  Write <Parameter name=\"...\" type=\"...\" value=\"...\"/>.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(solverError("<Parameter name=\"Verbose\" type=\"bool\" valu=\"true\"/>"),
            "s.xml:5: Solver / Verbose: unknown attribute \"valu\" of <Parameter>.\n"
            "  Did you mean \"value\"? Allowed: name, type, value, id, docString, isDefault, isUsed, validatorId.\n"
            "s.xml:5: Solver / Verbose: <Parameter> has no value.\n"
            "  Write <Parameter name=\"...\" type=\"...\" value=\"...\"/>.\n"
            "2 errors; nothing was run.");
  EXPECT_EQ(solverError("<ParameterList/>"),
            "s.xml:5: Solver: <ParameterList> has no name.\n"
            "  Write <ParameterList name=\"...\">.\n"
            "1 error; nothing was run.");
}

TEST(Check, Missing) {
  EXPECT_EQ(messageOf([] { check(sampleTree(""), sampleSpec()); }),
            "s.xml:1: Sample: required list \"Joints\" is missing.\n"
            "  The joints. Add <ParameterList name=\"Joints\"> ... </ParameterList>.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(messageOf([] { check(sampleTree("<ParameterList name=\"Joints\"/>"), sampleSpec()); }),
            "s.xml:2: Joints: the list is empty, but must hold at least one list.\n"
            "  Add <ParameterList name=\"...\"> ... </ParameterList>, with a name of your choice.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(
      messageOf([] {
        check(sampleTree("<ParameterList name=\"Joints\">\n<ParameterList name=\"a\">\n<ParameterList "
                         "name=\"Law\">" +
                         parameter("Type", "string", "Friction") +
                         "</ParameterList></ParameterList>\n<ParameterList name=\"b\">\n<ParameterList "
                         "name=\"Law\">" +
                         parameter("Stiffness", "double", "1") + "</ParameterList></ParameterList></ParameterList>"),
              sampleSpec());
      }),
      "s.xml:4: Joints / a / Law: required parameter \"Coefficient\" is missing.\n"
      "  Coefficient [-]: Ratio of tractions.\n"
      "  Add <Parameter name=\"Coefficient\" type=\"double\" value=\"...\"/>.\n"
      "s.xml:6: Joints / b / Law: required parameter \"Type\" is missing.\n"
      "  Type: Which form this list has. Allowed: Friction, Glue.\n"
      "  Add <Parameter name=\"Type\" type=\"string\" value=\"...\"/>.\n"
      "2 errors; nothing was run.");
}

TEST(Check, NamedListsHoldLists) {
  EXPECT_EQ(
      messageOf([] {
        check(sampleTree("<ParameterList name=\"Joints\">" + parameter("seal", "string", "Glue") + "</ParameterList>"),
              sampleSpec());
      }),
      "s.xml:2: Joints / seal: is a parameter, but a list is expected.\n"
      "  Joints holds lists: <ParameterList name=\"seal\"> ... </ParameterList>.\n"
      "1 error; nothing was run.");
}

TEST(Check, NamedValues) {
  EXPECT_EQ(messageOf([] {
              check(sampleTree("<ParameterList name=\"Values\">\n" + parameter("mu", "double", "0.3") + "\n" +
                               parameter("big", "double", "7") + "\n" + parameter("bad", "double", "x") + "\n" +
                               parameter("copy", "double", "$mu") + "</ParameterList>" + joint +
                               "<ParameterList name=\"Solver\">\n" + parameter("Accuracy", "double", "$big") +
                               "<ParameterList name=\"Scaling\">\n" + parameter("Factor", "double", "$mi") +
                               "</ParameterList></ParameterList>"),
                    sampleSpec());
            }),
            "s.xml:5: Values / bad: \"x\" is not a finite number.\n"
            "  Write a number such as 0.5 or 2e5, or \"$name\" for an entry of the list Values.\n"
            "s.xml:6: Values / copy: \"$mu\" refers to another value.\n"
            "  Write a number here.\n"
            "s.xml:9: Solver / Accuracy: $big = 7 is out of range.\n"
            "  Allowed: above 0 and below 1.\n"
            "s.xml:10: Solver / Scaling / Factor: \"$mi\" names no entry of the list Values.\n"
            "  Did you mean \"mu\"? Values has: bad, big, copy, mu.\n"
            "4 errors; nothing was run.");
}

TEST(Check, HistoriesMustExist) {
  const auto joints = [](const std::string& inside) {
    return "<ParameterList name=\"Joints\"><ParameterList name=\"a\"><ParameterList name=\"Law\">" + inside +
           "</ParameterList></ParameterList></ParameterList>";
  };
  EXPECT_EQ(messageOf([&] {
              check(
                  sampleTree(joints(parameter("Type", "string", "Friction") + parameter("Coefficient", "double", "1") +
                                    "\n" + parameter("Coefficient History", "string", "ramp"))),
                  sampleSpec());
            }),
            "s.xml:3: Joints / a / Law / Coefficient History: \"ramp\" names no history.\n"
            "  Histories has: none.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(messageOf([&] {
              check(sampleTree("<ParameterList name=\"Histories\"><ParameterList name=\"ramp\">" +
                               parameter("Times", "Array(int)", "{0, 1}") + "</ParameterList></ParameterList>" +
                               joints(parameter("Type", "string", "Glue") + parameter("Stiffness", "double", "1") +
                                      "\n" + parameter("Gap History", "string", "ramp"))),
                    sampleSpec());
            }),
            "s.xml:3: Joints / a / Law: \"Gap History\" is given without \"Gap\".\n"
            "  Add <Parameter name=\"Gap\" type=\"double\" value=\"...\"/>, which the history multiplies.\n"
            "1 error; nothing was run.");
}

TEST(Check, WrongRoot) {
  EXPECT_EQ(messageOf([] { check(InputTree::fromText("<Harmos/>", "s.xml"), sampleSpec()); }),
            "s.xml:1: the root element is <Harmos>.\n"
            "  It must be <ParameterList name=\"Sample\">.\n"
            "1 error; nothing was run.");
  EXPECT_EQ(messageOf([] {
              check(InputTree::fromText("<ParameterList name=\"Other\">" + joint + "</ParameterList>", "s.xml"),
                    sampleSpec());
            }),
            "s.xml:1: the root element is <ParameterList name=\"Other\">.\n"
            "  It must be <ParameterList name=\"Sample\">.\n"
            "1 error; nothing was run.");
}

TEST(Check, Arrays) {
  const auto axis = [](const std::string& value) {
    return messageOf([&] {
      check(sampleTree("<ParameterList name=\"Joints\"><ParameterList name=\"a\">\n" +
                       parameter("Axis", "Array(double)", value) + "<ParameterList name=\"Law\">" +
                       parameter("Type", "string", "Glue") + parameter("Stiffness", "double", "1") +
                       "</ParameterList></ParameterList></ParameterList>"),
            sampleSpec());
    });
  };
  EXPECT_EQ(axis("{1, 2,3 }"), "no error");
  EXPECT_EQ(axis("{}"), "no error");
  for (const std::string text : {"1, 2", "{1, , 2}", "{1, 2", ""}) {
    EXPECT_EQ(axis(text), "s.xml:3: Joints / a / Axis: \"" + text +
                              "\" is not a list of values.\n"
                              "  Write value=\"{a, b, c}\".\n"
                              "1 error; nothing was run.");
  }
  EXPECT_EQ(axis("{1, x}"),
            "s.xml:3: Joints / a / Axis: \"x\" is not a finite number.\n"
            "  Write a number such as 0.5 or 2e5 [length], or \"$name\" for an entry of the list Values.\n"
            "1 error; nothing was run.");
}

TEST(Check, ErrorsAreInputErrors) {
  try {
    check(sampleTree(""), sampleSpec());
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
  }
}

}  // namespace
}  // namespace harmos::input
