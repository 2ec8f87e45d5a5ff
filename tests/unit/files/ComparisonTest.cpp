#include <filesystem>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/ExodusComparison.hpp>
#include <harmos/files/ExodusWriter.hpp>

#include "TwoBoxes.hpp"

using namespace harmos::files;

namespace {

std::string report(const ExodusComparison& comparison) {
  std::ostringstream text;
  print(text, comparison);
  return text.str();
}

const VariableDifference& find(const ExodusComparison& comparison, const std::string& name) {
  for (const auto& v : comparison.variables)
    if (v.name == name) return v;
  throw std::runtime_error("no variable " + name);
}

}  // namespace

TEST(Comparison, NumberingDoesNotMatter) {
  const auto a = temporaryFile("a.e"), b = temporaryFile("b.e");
  writeBoxes(a, false);
  writeBoxes(b, true);
  const auto comparison = compareExodus(a, b, Tolerances());
  EXPECT_TRUE(comparison.equal()) << report(comparison);
  EXPECT_EQ(comparison.variables.size(), 5u);
}

TEST(Comparison, FindsWhereOneValueDiffers) {
  const auto a = temporaryFile("a.e"), b = temporaryFile("b.e");
  writeBoxes(a, false);
  writeBoxes(b, false, [](ResultStep& step, int i) {
    if (i == 2) step.nodal[0][35] *= 1.0 + 1e-5;
  });
  const auto comparison = compareExodus(a, b, Tolerances());
  EXPECT_FALSE(comparison.equal());
  const auto& difference = find(comparison, "disp_x");
  EXPECT_EQ(difference.step, 3);
  EXPECT_EQ(difference.entity, 36);
  EXPECT_NEAR(difference.difference, 1e-5, 1e-9);  // relative to the larger of both
  EXPECT_TRUE(find(comparison, "disp_z").equal());
  EXPECT_TRUE(compareExodus(a, b, Tolerances::parse("NODAL VARIABLES relative 1e-4", "t")).equal());
}

TEST(Comparison, NotANumberIsNeverEqual) {
  const auto a = temporaryFile("a.e");
  writeBoxes(a, false, [](ResultStep& step, int i) {
    if (i == 1) step.element[0][3] = std::numeric_limits<double>::quiet_NaN();
  });
  const auto comparison = compareExodus(a, a, Tolerances::parse("ELEMENT VARIABLES relative 1 floor 1e9", "t"));
  EXPECT_FALSE(comparison.equal());
  EXPECT_EQ(find(comparison, "von_mises").entity, 4);
}

TEST(Comparison, NamesWhatTheOtherFileLacks) {
  const auto a = temporaryFile("a.e"), b = temporaryFile("b.e");
  writeBoxes(a, false);
  {
    ExodusWriter writer(b, "", twoBoxes(), {{"disp_x", "disp_y", "temperature"}, {"von_mises"}, {"u_load"}});
    for (int i = 0; i < 3; ++i) writer.write(boxStep(writer.mesh(), i));
    writer.commit();
  }
  const auto text = report(compareExodus(a, b, Tolerances()));
  EXPECT_NE(text.find("the second file has no nodal variable disp_z"), std::string::npos) << text;
  EXPECT_NE(text.find("the first file has no nodal variable temperature"), std::string::npos) << text;
  EXPECT_TRUE(compareExodus(a, b, Tolerances::parse("NODAL VARIABLES\n  disp_x\n", "t")).equal());
  EXPECT_FALSE(compareExodus(a, a, Tolerances::parse("NODAL VARIABLES\n  misspelt\n", "t")).equal());
}

TEST(Comparison, SeesAnotherMeshTimeOrSet) {
  const auto a = temporaryFile("a.e"), b = temporaryFile("b.e");
  writeBoxes(a, false);
  const auto differs = [&](auto change, double lastTime = 2.0) {
    auto mesh = twoBoxes();
    change(mesh);
    {
      ExodusWriter writer(b, "", mesh, boxVariables());
      for (double time : {0.0, 1.0, lastTime}) writer.write(zeroStep(mesh, boxVariables(), time));
      writer.commit();
    }
    return report(compareExodus(a, b, Tolerances::parse("TIME STEPS relative 1e-9", "t")));
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(contains(differs([](ResultMesh&) {}), "are the same"));
  EXPECT_TRUE(contains(differs([](ResultMesh&) {}, 2.1), "time of step 3"));
  EXPECT_TRUE(contains(differs([](ResultMesh& m) { m.nodes[4][2] += 1e-3; }), "block lower: no element"));
  EXPECT_TRUE(contains(differs([](ResultMesh& m) { m.blocks[1].name = "top"; }), "no block upper"));
  EXPECT_TRUE(contains(differs([](ResultMesh& m) {
                         m.sideSets[0].element.pop_back();
                         m.sideSets[0].side.pop_back();
                       }),
                       "4 members of side set contact_1 in the first file, 3"));
  EXPECT_TRUE(contains(differs([](ResultMesh& m) { m.sideSets[0].side[2] = 0; }),
                       "side set contact_1 of the second file lacks side 6 of element 3 of the first"));
  EXPECT_TRUE(contains(differs([](ResultMesh& m) { m.sideSets[0].element[2] = 1; }),
                       "side set contact_1 of the second file lacks side 6 of element 3 of the first"));
  EXPECT_TRUE(
      contains(differs([](ResultMesh& m) { std::swap(m.blocks[0].connectivity[8], m.blocks[0].connectivity[9]); }),
               "block lower: no element of the second file fits element 2 of the first"));
  const auto mirrored = [](ResultMesh& m) {
    std::swap(m.blocks[0].connectivity[1], m.blocks[0].connectivity[3]);
    std::swap(m.blocks[0].connectivity[5], m.blocks[0].connectivity[7]);
  };
  EXPECT_TRUE(contains(differs(mirrored), "block lower: no element of the second file fits element 1 of the first"));
}

TEST(Comparison, SeesOtherNodesOfASet) {
  const auto a = temporaryFile("a.e"), b = temporaryFile("b.e");
  for (const auto& [path, last] : {std::pair(a, 8), std::pair(b, 7)}) {
    auto mesh = twoBoxes();
    mesh.nodeSets = {{"corners", 0, {0, 2, last}}};
    ExodusWriter writer(path, "", mesh, boxVariables());
    writer.write(zeroStep(mesh, boxVariables(), 0.0));
    writer.commit();
  }
  const auto text = report(compareExodus(a, b, Tolerances()));
  EXPECT_NE(text.find("node set corners of the second file lacks node 9 of the first"), std::string::npos) << text;
}

TEST(Comparison, RefusesTruncatedFiles) {
  const auto a = temporaryFile("a.e"), b = temporaryFile("b.e");
  writeBoxes(a, false);
  const auto size = std::filesystem::file_size(a);
  for (const std::uintmax_t missing : {std::uintmax_t(8), size / 4, size / 2, size - 100}) {
    std::filesystem::copy_file(a, b, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(b, size - missing);
    try {
      compareExodus(a, b, Tolerances());
      ADD_FAILURE() << missing << " bytes of " << size << " are missing";
    } catch (const harmos::base::Error& error) {
      EXPECT_EQ(error.code(), harmos::base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find("it is truncated: "), std::string::npos) << error.what();
    }
  }
}
