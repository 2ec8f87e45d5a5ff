#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/cli/Arguments.hpp>

using harmos::cli::Arguments;

namespace {

Arguments parse(const std::vector<std::string>& words) {
  return Arguments("harmos run", words,
                   {{"--output", "DIR", "", false}, {"--set", "ENTRY", "", true}, {"--quiet", "", "", false}});
}

std::string messageOf(const std::vector<std::string>& words) {
  try {
    parse(words).requireOperands({"SCENE.xml"});
  } catch (const harmos::base::Error& error) {
    EXPECT_EQ(error.code(), harmos::base::ExitCode::input);
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST(Arguments, SplitsOptionsAndOperands) {
  const auto arguments = parse({"a.xml", "--set", "A/B=1", "--output=x=y", "--set=C=-2", "--quiet", "--", "--odd"});
  EXPECT_EQ(arguments.operands(), (std::vector<std::string>{"a.xml", "--odd"}));
  EXPECT_EQ(arguments.values("--set"), (std::vector<std::string>{"A/B=1", "C=-2"}));
  EXPECT_EQ(arguments.value("--output", "results"), "x=y");
  EXPECT_TRUE(arguments.has("--quiet"));
  EXPECT_EQ(parse({}).value("--output", "results"), "results");
}

TEST(Arguments, SaysWhatIsWrong) {
  EXPECT_EQ(messageOf({"--ouput", "x"}),
            "harmos run: unknown option \"--ouput\". Did you mean \"--output\"? Options: --output, --set, --quiet. Try "
            "\"harmos run --help\".");
  EXPECT_EQ(messageOf({"a.xml", "--output"}),
            "harmos run: the option --output wants DIR after it. Try \"harmos run --help\".");
  for (const std::vector<std::string>& empty : {std::vector<std::string>{"--output", ""}, {"--output="}}) {
    EXPECT_EQ(messageOf(empty), "harmos run: the option --output wants DIR, not \"\". Try \"harmos run --help\".");
  }
  EXPECT_EQ(messageOf({"--quiet=yes"}), "harmos run: the option --quiet takes no value. Try \"harmos run --help\".");
  EXPECT_EQ(messageOf({"--output", "a", "--output", "b"}),
            "harmos run: the option --output is given twice. Try \"harmos run --help\".");
  EXPECT_EQ(messageOf({"a.xml", "b.xml"}), "harmos run wants SCENE.xml; 2 given. Try \"harmos run --help\".");
}
