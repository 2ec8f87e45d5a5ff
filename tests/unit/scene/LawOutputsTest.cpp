#include <algorithm>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/laws/PointwiseLaw.hpp>
#include <harmos/scene/detail/LawOutputs.hpp>

namespace harmos::scene {
namespace {

/// A law that adds numbers of these names, all in one unit.
struct Writing {
  static constexpr const char* name = "Writing";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::any;
  laws::LocalState solve(const laws::LocalLine&, const laws::NodeContext&, const double*, double*) const { return {}; }
  std::vector<laws::OutputField> outputs() const {
    std::vector<laws::OutputField> fields;
    for (const std::string& each : names) fields.push_back({each, unit, "a number"});
    return fields;
  }
  void output(const laws::PairStep&, double* values) const { std::fill_n(values, names.size(), 0.0); }
  std::vector<std::string> names;
  std::string unit;
};

laws::PointwiseLaw<Writing> law(std::vector<std::string> names, std::string unit) {
  return laws::PointwiseLaw<Writing>(Writing{std::move(names), std::move(unit)});
}

using Places = std::vector<std::size_t>;

TEST(LawOutputs, AreOneVariableForOneName) {
  LawOutputs outputs;
  EXPECT_EQ(outputs.add(law({"wear", "damage"}, "-")), (Places{0, 1}));
  EXPECT_EQ(outputs.add(law({"damage", "heat"}, "-")), (Places{1, 2}));
  EXPECT_EQ(outputs.add(law({}, "-")), Places{});
  EXPECT_EQ(outputs.legend(), "wear [-]: a number\ndamage [-]: a number\nheat [-]: a number\n");
}

TEST(LawOutputs, TakeNoNameForTwoThings) {
  LawOutputs outputs;
  outputs.add(law({"wear"}, "length"));
  EXPECT_THROW(outputs.add(law({"wear"}, "-")), base::Error);
  EXPECT_THROW(outputs.add(law({"slip_x"}, "length")), base::Error);
}

}  // namespace
}  // namespace harmos::scene
