#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <harmos/latin/Safety.hpp>
#include <harmos/latin/SafetyResponse.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

#include "../laws/MakeLaw.hpp"

namespace harmos::latin {
namespace {

/// Contact with a friction of a half.
struct Rough {
  static constexpr const char* name = "Rough";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::any;
  laws::AdmissibleTractions admissibleTractions(int) const { return laws::AdmissibleTractions::pressure(0.5); }
  laws::LocalState solve(const laws::LocalLine&, const laws::NodeContext&, const double*, double*) const { return {}; }
};

/// Two pairs at two load steps, of areas 1 and 3.
class Pairs : public testing::Test {
 protected:
  Pairs() {
    interface_.law = std::make_shared<laws::PointwiseLaw<Rough>>();
    interface_.area = {1.0, 3.0};
    interface_.gap = {0.0, 0.0};
    for (const int node : {0, 1}) interface_.trace1.append({{node, 1.0}});
    fields_.pairs = 2;
    fields_.steps = 2;
    fields_.times = {1.0, 2.0};
    fields_.traction = {{-8.0, 0.0, 0.0}, {-4.0, 0.6, 0.8}, {-6.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};
    fields_.jump.resize(4);
    fields_.status.resize(4);
  }

  std::vector<double> valuesOf(SafetyResponse::Against against, SafetyResponse::Where where) const {
    const SafetyResponse response("s", {0}, against, where);
    std::vector<double> values = response.begin(2);
    response.include(interface_, fields_, values);
    return response.finish(std::move(values));
  }

  assembly::Interface interface_;
  PairFields fields_;
};

TEST_F(Pairs, HaveTheirSafetiesOneByOne) {
  const Safety result = safety(interface_, fields_);
  // Unloaded: as safe as can be said. 0.5 * 4 / 1, 0.5 * 6 / 1; the last one bears nothing.
  EXPECT_EQ(result.slip, (std::vector<double>{1000.0, 2.0, 3.0, 1000.0}));
  // 8 / (8 - 6); gaping after it was pressed: 1.
  EXPECT_EQ(result.gaping, (std::vector<double>{1000.0, 1000.0, 4.0, 1.0}));
}

TEST_F(Pairs, HaveTheLeastOfThemAndSumsOverTheArea) {
  using Response = SafetyResponse;
  EXPECT_EQ(valuesOf(Response::Against::slip, Response::Where::point), (std::vector<double>{2.0, 3.0}));
  EXPECT_EQ(valuesOf(Response::Against::gaping, Response::Where::point), (std::vector<double>{1000.0, 1.0}));
  // 0.5 (8 + 3 * 4) / (3 * 1), 0.5 * 6 / 1.
  EXPECT_EQ(valuesOf(Response::Against::slip, Response::Where::whole), (std::vector<double>{10.0 / 3.0, 3.0}));
  // 20 / (20 - 6).
  EXPECT_EQ(valuesOf(Response::Against::gaping, Response::Where::whole), (std::vector<double>{1000.0, 20.0 / 14.0}));
}

TEST_F(Pairs, DoNotCountWhereTheyTouchByAccident) {
  fields_.traction[1] = {-1e-3, 5e-4, 0.0};
  fields_.traction[3] = {-2e-3, 1e-3, 0.0};
  const Safety result = safety(interface_, fields_);
  EXPECT_EQ(result.slip[3], 1.0);
  EXPECT_FALSE(result.counts[3]);
  EXPECT_EQ(valuesOf(SafetyResponse::Against::slip, SafetyResponse::Where::point), (std::vector<double>{1000.0, 3.0}));
}

// Directions, velocities and limits tell what is left: the two pairs bear 1, sheared by 0.1 along y and along z.
TEST_F(Pairs, KnowWhatOtherLawsBear) {
  fields_.steps = 1;
  fields_.times = {1.0};
  fields_.traction = {{-1.0, 0.1, 0.0}, {-1.0, 0.0, 0.1}};
  fields_.status = {laws::Status::stick, laws::Status::stick};
  const auto slips = [this](const std::string& type, const std::map<std::string, double>& numbers,
                            const std::map<std::string, std::vector<double>>& lists = {}) {
    interface_.law = laws::makeLaw(type, numbers, {}, lists);
    return safety(interface_, fields_).slip;
  };
  const auto expectNear = [](const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
  };
  expectNear(slips("Tresca Friction", {{"Shear Limit", 0.2}}), {2.0, 2.0});
  expectNear(
      slips("Compliant Contact", {{"Normal Stiffness", 1.0}, {"Friction Coefficient", 0.5}, {"Shear Limit", 0.3}}),
      {3.0, 3.0});
  const std::map<std::string, double> falling{
      {"Static Coefficient", 0.5}, {"Kinetic Coefficient", 0.1}, {"Velocity", 1.0}};
  expectNear(slips("Rate-Dependent Friction", falling), {5.0, 5.0});
  expectNear(slips("Orthotropic Friction", {{"Friction Coefficient 1", 0.1}, {"Friction Coefficient 2", 0.5}},
                   {{"Axis", {0.0, 1.0, 0.0}}}),
             {1.0, 5.0});
  fields_.status = {laws::Status::slip, laws::Status::slip};
  expectNear(slips("Rate-Dependent Friction", falling), {1.0, 1.0});
}

}  // namespace
}  // namespace harmos::latin
