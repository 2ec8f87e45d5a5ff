#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

/// What a change that must not matter may change at most: twice the accuracy that the scene asks for.
constexpr double tolerance = 2e-6;

SceneInput slidingBlock() {
  return SceneInput::fromFile("sliding_block/sliding_block.xml");
}

const SolvedScene& reference() {
  static const SolvedScene run(slidingBlock());
  return run;
}

/// Every response at every step, relative to its largest value.
void expectEqual(const SolvedScene& run, const SolvedScene& expected,
                 const std::function<double(const std::string&)>& factor = {}) {
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (const auto& response : expected.result.responses) {
    const double unit = factor ? factor(response.name) : 1.0;
    const auto& values = run.values(response.name);
    double size = 0.0;
    for (const double value : response.values) size = std::max(size, std::abs(unit * value));
    for (std::size_t t = 0; t < values.size(); ++t) {
      EXPECT_NEAR(values[t], unit * response.values[t], tolerance * size) << response.name << ", step " << t + 1;
    }
  }
}

TEST(SlidingBlock, RatioOfTheResultants) {
  ASSERT_TRUE(reference().isCertified()) << reference().result.reason;
  // Every node slides at the end of either way.
  for (const int step : {2, 6}) {
    const double ratio = std::abs(reference().value("friction", step)) / reference().value("normal", step);
    EXPECT_NEAR(ratio, 0.2, 1e-4 * 0.2) << "step " << step + 1;
  }
  for (int step = 0; step < reference().steps(); ++step) {
    EXPECT_NEAR(reference().value("normal", step), 7680.0, 1e-5 * 7680.0);  // 20 MPa on 24 x 16
    EXPECT_NEAR(reference().value("reaction", step), reference().value("friction", step), 1e-5 * 1536.0);
  }
}

TEST(SlidingBlock, ObeysCoulombAtEveryNode) {
  int sliding = 0, sticking = 0;
  for (int step = 0; step < reference().steps(); ++step) {
    for (const PairValue& pair : reference().pairs("contact", step)) {
      const double shear = std::hypot(pair.traction[1], pair.traction[2]);
      EXPECT_LE(pair.traction[0], 0.0);
      EXPECT_LE(shear, -0.2 * pair.traction[0] * (1.0 + 1e-12));
      EXPECT_GE(pair.jump[0], -1e-8);
      sliding += pair.status == laws::Status::slip ? 1 : 0;
      sticking += pair.status == laws::Status::stick ? 1 : 0;
    }
  }
  EXPECT_GT(sliding, 0);
  EXPECT_GT(sticking, 0);
}

TEST(SlidingBlock, DoesNotDependOnTheOrderOfItsSides) {
  SceneInput scene = slidingBlock();
  scene.set("Interfaces/contact/Part 1=upper").set("Interfaces/contact/Part 2=lower");
  // Forces are those on side 1.
  expectEqual(SolvedScene(scene), reference(),
              [](const std::string& name) { return name == "friction" || name == "normal" ? -1.0 : 1.0; });
}

TEST(SlidingBlock, DoesNotDependOnTheNumbering) {
  SceneInput scene = slidingBlock();
  scene.changeMesh([](mesh::Mesh& mesh) {
    std::mt19937 random(7);
    std::vector<int> newNumber(mesh.nodes.size());
    std::iota(newNumber.begin(), newNumber.end(), 0);
    std::shuffle(newNumber.begin(), newNumber.end(), random);
    std::vector<base::Vector3> nodes(mesh.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[newNumber[i]] = mesh.nodes[i];
    mesh.nodes = nodes;
    std::vector<int> newElement;
    for (auto& block : mesh.blocks) {
      const auto count = static_cast<std::size_t>(block.elements());
      const std::size_t first = newElement.size();
      std::vector<int> order(count);
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), random);
      const std::vector<int> old = block.connectivity;
      newElement.resize(first + count);
      for (std::size_t e = 0; e < count; ++e) {
        const auto to = static_cast<std::size_t>(order[e]);
        newElement[first + e] = static_cast<int>(first + to);
        for (std::size_t n = 0; n < 8; ++n) {
          block.connectivity[8 * to + n] = newNumber[old[8 * e + n]];
        }
      }
    }
    for (auto& set : mesh.sideSets) {
      for (int& element : set.element) element = newElement[element];
    }
    std::reverse(mesh.sideSets.begin(), mesh.sideSets.end());
  });
  expectEqual(SolvedScene(scene), reference());
}

TEST(SlidingBlock, DoesNotDependOnTheUnits) {
  // From mm, N, MPa to m, N, Pa.
  SceneInput scene = slidingBlock();
  scene.set("Values/pressure=20e6").set("Values/push=0.02e-3").set("Materials/steel/Young's Modulus=2.1e11");
  scene.set("Mesh/Boxes/lower/Upper Corner={0.04, 0.016, 0.01}");
  scene.set("Mesh/Boxes/upper/Lower Corner={0.008, 0, 0.01}").set("Mesh/Boxes/upper/Upper Corner={0.032, 0.016, 0.02}");
  const SolvedScene run(scene);
  expectEqual(run, reference(), [](const std::string& name) {
    if (name == "u_top" || name == "settlement" || name == "dissipation") return 1e-3;
    return name == "pressure" ? 1e6 : 1.0;
  });
  // Round-off decides at kinks, so the way may differ a little.
  EXPECT_NEAR(run.result.linearStages, reference().result.linearStages, 0.2 * reference().result.linearStages);
}

TEST(SlidingBlock, DoesNotDependOnThePartition) {
  for (const char* pieces : {"2", "5", "11"}) {
    SceneInput scene = slidingBlock();
    scene.set("Parts/lower/Pieces=" + std::string(pieces)).set("Parts/upper/Pieces=3");
    expectEqual(SolvedScene(scene), reference());
  }
}

TEST(SlidingBlock, DoesNotDependOnTheSearchDirection) {
  for (const char* scale : {"0.1", "0.3", "3", "10"}) {
    SceneInput scene = slidingBlock();
    expectEqual(SolvedScene(scene.set("Solver/Search Direction/Scale=" + std::string(scale))), reference());
  }
}

TEST(SlidingBlock, DoesNotDependOnTheFormulation) {
  SceneInput scene = slidingBlock();
  expectEqual(SolvedScene(scene.set("Solver/Formulation=Velocity")), reference());
}

TEST(SlidingBlock, DoesNotDependOnTheAlgorithm) {
  SceneInput relaxed = slidingBlock(), plain = slidingBlock();
  expectEqual(SolvedScene(relaxed.set("Solver/Algorithm=Relaxed")), reference());
  // Nothing damps the plain iteration: it may jump to and fro for ever, and then it must not claim.
  const SolvedScene run(plain.set("Solver/Algorithm=Plain"));
  if (run.isCertified()) expectEqual(run, reference());
}

TEST(SlidingBlock, DoesNotDependOnTheLinearSolver) {
  for (const char* solver : {"tacho", "klu2"}) {
    SceneInput scene = slidingBlock();
    expectEqual(SolvedScene(scene.set("Solver/Linear Solver/Name=" + std::string(solver))), reference());
  }
}

TEST(SlidingBlock, WithoutFrictionIsFrictionless) {
  SceneInput none = slidingBlock(), frictionless = slidingBlock();
  // Without friction only the driven face holds the block along x.
  const SolvedScene zero(none.set("Values/mu=0"));
  const SolvedScene law(frictionless.set("Interfaces/contact/Law/Type=Unilateral Contact")
                            .remove("Interfaces/contact/Law/Friction Coefficient"));
  ASSERT_TRUE(zero.isCertified()) << zero.result.reason;
  ASSERT_TRUE(law.isCertified()) << law.result.reason;
  for (int step = 0; step < zero.steps(); ++step) {
    for (const char* name : {"normal", "u_top", "settlement", "pressure"}) {
      EXPECT_DOUBLE_EQ(zero.value(name, step), law.value(name, step)) << name;
    }
  }
  EXPECT_EQ(zero.result.linearStages, law.result.linearStages);
}

TEST(SlidingBlock, DoublingTheLoadDoublesAFrictionlessResponse) {
  const auto frictionless = [](double factor) {
    SceneInput scene = slidingBlock();
    scene.set("Values/mu=0").set(assignment("Values/pressure", 20.0 * factor));
    scene.set(assignment("Values/push", 0.02 * factor));
    return SolvedScene(scene);
  };
  const SolvedScene once = frictionless(1.0), twice = frictionless(2.0);
  ASSERT_TRUE(once.isCertified()) << once.result.reason;
  ASSERT_TRUE(twice.isCertified()) << twice.result.reason;
  for (int step = 0; step < once.steps(); ++step) {
    for (const char* name : {"normal", "u_top", "settlement", "pressure"}) {
      const double value = 2.0 * once.value(name, step);
      EXPECT_NEAR(twice.value(name, step), value, tolerance * std::abs(value)) << name;
    }
  }
}

TEST(Ranks, AgreeWithOneRank) {
  SceneInput scene = slidingBlock();
  scene.set("Parts/lower/Pieces=3").set("Parts/upper/Pieces=2");
  const SolvedScene together(scene);
  const SolvedScene alone(scene, Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF)));
  expectEqual(together, alone);
  EXPECT_LE(displacementDifference(together, alone), tolerance);
  // The same iteration: only sums are added up in another order.
  EXPECT_EQ(together.result.linearStages, alone.result.linearStages);
}

TEST(Ranks, MayBeMoreThanParts) {
  const SceneInput scene = slidingBlock();
  const SolvedScene together(scene);
  const SolvedScene alone(scene, Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF)));
  expectEqual(together, alone);
}

}  // namespace
}  // namespace harmos::verification
