#include <gtest/gtest.h>

#include <harmos/input/EffectiveInput.hpp>

#include "Sample.hpp"

namespace harmos::input {
namespace {

TEST(EffectiveInput, HoldsDefaultsAndReadsBack) {
  const Parameters p = check(InputTree::fromText(sampleText(), "s.xml"), sampleSpec(),
                             {"Title=a < \"b\" & c", "Solver/Accuracy=0.30000000000000004"});
  const std::string xml = effectiveInput(p);
  EXPECT_NE(xml.find("<Parameter name=\"Iterations\" type=\"int\" value=\"100\"/>"), std::string::npos);
  EXPECT_NE(xml.find("<Parameter name=\"Axis\" type=\"Array(double)\" value=\"{0, 0, 0.3}\"/>"), std::string::npos);
  const Parameters again = check(InputTree::fromText(xml, "effective.xml"), sampleSpec());
  EXPECT_EQ(effectiveInput(again), xml);
  EXPECT_EQ(again.text("Title"), "a < \"b\" & c");
  EXPECT_EQ(again.list("Solver").number("Accuracy"), 0.30000000000000004);
  EXPECT_EQ(again.lists("Joints")[0].list("Law").number("Coefficient"), 0.3);
}

}  // namespace
}  // namespace harmos::input
