#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/assembly/AssemblyCheck.hpp>
#include <harmos/base/Error.hpp>

#include "../latin/Chains.hpp"

namespace harmos::assembly {
namespace {

using latin::chain;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two chains between a wall and an end, the second one owned by the last rank.
Assembly valid() {
  Assembly assembly = latin::twoChains(laws::makeLaw("Unilateral Contact"),
                                       laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Y", 0.0}, {"Z", 0.0}}), 2);
  assembly.owner = {0, Tpetra::getDefaultComm()->getSize() - 1};
  return assembly;
}

/// What is said of the valid assembly after a change; empty: nothing.
std::string faultOf(const std::function<void(Assembly&)>& change) {
  Assembly assembly = valid();
  change(assembly);
  try {
    demandValid(assembly, *Tpetra::getDefaultComm());
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "";
}

void expectFault(const std::string& text, const std::function<void(Assembly&)>& change) {
  const std::string fault = faultOf(change);
  EXPECT_NE(fault.find(text), std::string::npos) << "\"" << text << "\" is not in: " << fault;
}

TEST(AssemblyCheck, TakesWhatIsValid) {
  EXPECT_EQ(faultOf([](Assembly&) {}), "");
}

TEST(AssemblyCheck, NamesWhatIsWrongWithTimesAndOwners) {
  expectFault("times: there is no load step", [](Assembly& a) { a.times.clear(); });
  expectFault("times: load step 1 ends at 1; times are finite", [](Assembly& a) { a.times = {1.0, 1.0}; });
  expectFault("times: load step 0 ends at 0", [](Assembly& a) { a.times = {0.0, 1.0}; });
  expectFault("times: load step 1 ends at nan", [](Assembly& a) { a.times[1] = nan; });
  expectFault("owner: it has 1 entries, but there are 2 bodies", [](Assembly& a) { a.owner.pop_back(); });
  expectFault("owner: rank 7 owns body 1", [](Assembly& a) { a.owner[1] = 7; });
  expectFault("bodies: there are none", [](Assembly& a) {
    a.bodies.clear();
    a.interfaces.clear();
    a.owner.clear();
  });
  expectFault("dimension: it is 4", [](Assembly& a) { a.dimension = 4; });
}

TEST(AssemblyCheck, NamesWhatIsWrongWithBodies) {
  expectFault("body 1 \"right\": its dimension is 2, that of the assembly 3",
              [](Assembly& a) { a.bodies[1].dimension = 2; });
  expectFault("body 0 \"left\": the coordinates of node 2 are not finite",
              [](Assembly& a) { a.bodies[0].nodes[2][1] = nan; });
  expectFault("body 0 \"left\": the coordinates of node 3 are not finite, or beyond 1e+100",
              [](Assembly& a) { a.bodies[0].nodes[3][0] = 1e300; });
  expectFault("body 1 \"left\": body 0 has the same name", [](Assembly& a) { a.bodies[1].name = "left"; });
  expectFault("body 0 \"left\": it has no nodes", [](Assembly& a) { a.bodies[0].nodes.clear(); });
  expectFault("body 1 \"right\": it is congruent to body 1, which is none with", [](Assembly& a) {
    auto congruence = std::make_shared<substructure::Congruence>();
    congruence->representative = 1;
    a.bodies[1].congruence = congruence;
  });
  expectFault("body 1 \"right\": its congruence does not name every node once", [](Assembly& a) {
    a.bodies[0] = chain("left", 0.0, 3, 30.0);
    a.interfaces.clear();
    auto congruence = std::make_shared<substructure::Congruence>();
    congruence->representative = 0;
    congruence->node = {0, 0, 2};
    a.bodies[1].congruence = congruence;
  });
}

TEST(AssemblyCheck, NamesWhatTheOwnerAloneKnowsOnAllRanks) {
  const auto body = [](Assembly& a) -> substructure::Substructure& { return a.bodies[1]; };
  expectFault("body 1 \"right\": rank " + std::to_string(valid().owner[1]) + " owns it, but has no stiffness matrix",
              [&](Assembly& a) { body(a).stiffness = Teuchos::null; });
  expectFault("body 1 \"right\": the stiffness matrix has 6 rows, but 3 nodes have 9 degrees of freedom in 3-D",
              [&](Assembly& a) { body(a).stiffness = latin::chainMatrix(2, 40.0); });
  expectFault("body 1 \"right\": its loads are 9 x 1, not 9 degrees of freedom x 2 load steps",
              [&](Assembly& a) { body(a).loads.shape(9, 1); });
  expectFault("body 1 \"right\": its load on component y of node 2 in load step 1 is not finite", [&](Assembly& a) {
    body(a).loads.shape(9, 2);
    body(a).loads[1][7] = nan;
  });
  const auto matrix = [&](const std::vector<double>& values) {
    return [&body, values](Assembly& a) {
      a.interfaces.clear();
      body(a).nodes.resize(1);
      body(a).stiffness = substructure::makeCrsMatrix({0, 2, 4, 5}, {0, 1, 0, 1, 2}, values);
    };
  };
  EXPECT_EQ(faultOf(matrix({2.0, 1.0, 1.0, 2.0, 3.0})), "");
  EXPECT_EQ(faultOf(matrix({2.0, 1.0, 1.0 + 1e-12, 2.0, 3.0})), "");
  expectFault("body 1 \"right\": the stiffness matrix is not symmetric; row and column of component ",
              matrix({2.0, 1.0, 0.5, 2.0, 3.0}));
  expectFault("is not symmetric", matrix({2.0, 1.0, 1.0 + 1e-7, 2.0, 3.0}));
  expectFault("body 1 \"right\": the stiffness matrix has nan in the row of component y of node 0",
              matrix({2.0, 1.0, nan, 2.0, 3.0}));
  expectFault(
      "body 1 \"right\": the stiffness matrix has 1e+300 in the row of component x of node 0; its entries are "
      "finite, and not beyond 1e+100",
      matrix({1e300, 1.0, 1.0, 2.0, 3.0}));
}

TEST(AssemblyCheck, NamesWhatIsWrongWithInterfaces) {
  const auto joint = [](Assembly& a) -> Interface& { return a.interfaces[1]; };
  const std::string where = "interface 1 \"joint\": ";
  expectFault(where + "it has no law", [&](Assembly& a) { joint(a).law.reset(); });
  expectFault(where + "it joins bodies 0 and 2, but there are 2", [&](Assembly& a) { joint(a).body2 = 2; });
  expectFault(where + "it joins body 0 with itself", [&](Assembly& a) { joint(a).body2 = 0; });
  expectFault(where + "the law \"Perfect\" joins two bodies", [&](Assembly& a) {
    joint(a).body2 = -1;
    joint(a).trace2 = {};
    joint(a).law = laws::makeLaw("Perfect");
  });
  expectFault(where + "the law \"Prescribed Traction\" acts on one body, but body2 is 1",
              [&](Assembly& a) { joint(a).law = a.interfaces[2].law; });
  expectFault(where + "trace2 has 0 points instead of 1", [&](Assembly& a) { joint(a).trace2 = {}; });
  expectFault("interface 0 \"wall\": trace2 has 1 points instead of 0",
              [&](Assembly& a) { a.interfaces[0].trace2 = joint(a).trace2; });
  expectFault(where + "trace1 names node 4 at pair 0, but the body has 4",
              [&](Assembly& a) { joint(a).trace1 = mesh::TraceOperator({4}); });
  expectFault(where + "the weights of trace2 at pair 0 have the sum 0.75 instead of 1", [&](Assembly& a) {
    joint(a).trace2 = {};
    joint(a).trace2.append({{0, 0.5}, {1, 0.25}});
  });
  expectFault(where + "position has 0 entries instead of 1", [&](Assembly& a) { joint(a).position.clear(); });
  expectFault(where + "frame has 2 entries instead of 1", [&](Assembly& a) { joint(a).frame.resize(2); });
  expectFault(where + "area has 0 entries instead of 1", [&](Assembly& a) { joint(a).area.clear(); });
  expectFault(where + "gap has 3 entries instead of 1", [&](Assembly& a) { joint(a).gap.resize(3); });
  expectFault(where + "the position of pair 0 is not finite", [&](Assembly& a) { joint(a).position[0][2] = nan; });
  expectFault(where + "the area of pair 0 is 0;", [&](Assembly& a) { joint(a).area[0] = 0.0; });
  for (const double area : {-1.0, 1e-300, 1e300, nan}) {
    expectFault(where + "the area of pair 0 is ", [&](Assembly& a) { joint(a).area[0] = area; });
  }
  expectFault(where + "the gap of pair 0 is -1e+300", [&](Assembly& a) { joint(a).gap[0] = -1e300; });
  expectFault(where + "the gap of pair 0 is nan", [&](Assembly& a) { joint(a).gap[0] = nan; });
  expectFault(where + "the mass has the entry 1 at (0, 1)", [&](Assembly& a) { joint(a).mass = {{0, 1, 1.0}}; });
  for (const double value : {-1.0, 1e300, nan}) {
    expectFault(where + "the mass has the entry ", [&](Assembly& a) { joint(a).mass = {{0, 0, value}}; });
  }
  for (const base::Frame& frame : {base::Frame{{{2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 2.0}}},
                                   base::Frame{{{1.0, 0.0, 0.0}, {0.6, 0.8, 0.0}, {0.0, 0.0, 0.8}}},
                                   base::Frame{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}}},
                                   base::Frame{{{nan, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}}) {
    expectFault(where + "the frame of pair 0 is not made of three unit vectors",
                [&](Assembly& a) { joint(a).frame[0] = frame; });
  }
}

TEST(AssemblyCheck, TakesAreasOfLoadsThatAreNotPositive) {
  EXPECT_EQ(faultOf([](Assembly& a) { a.interfaces[2].area[0] = -0.1; }), "");
}

TEST(AssemblyCheck, ListsAllAtOnceAndCountsMany) {
  const auto fault = faultOf([](Assembly& a) {
    a.times[0] = -1.0;
    a.interfaces[0].area[0] = nan;
    a.interfaces[1].gap.clear();
  });
  for (const char* text : {"times: ", "\"wall\": ", "\"joint\": "}) EXPECT_NE(fault.find(text), std::string::npos);
  expectFault("and 5 more", [](Assembly& a) {
    for (int i = 0; i < 22; ++i) a.interfaces.push_back(a.interfaces[1]);
    for (std::size_t i = 0; i < 25; ++i) a.interfaces[i].gap[0] = nan;
  });
}

TEST(AssemblyCheck, NoticesThatRanksDiffer) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() == 1) return;
  expectFault("ranks: they were given different assemblies",
              [&](Assembly& a) { a.interfaces[1].gap[0] = comm->getRank() == 0 ? 0.1 : 0.2; });
  // One that only one rank sees reaches all.
  expectFault("\"joint\": the gap of pair 0 is nan",
              [&](Assembly& a) { a.interfaces[1].gap[0] = comm->getRank() == 1 ? nan : 0.0; });
}

}  // namespace
}  // namespace harmos::assembly
