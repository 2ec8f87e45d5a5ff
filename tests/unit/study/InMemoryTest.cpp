#include <filesystem>

#include <gtest/gtest.h>

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/laws/PointwiseLaw.hpp>
#include <harmos/scene/SceneRun.hpp>
#include <harmos/study/StudyRun.hpp>

#include "../scene/Sample.hpp"

namespace harmos::study {
namespace {

/// A law that only the host knows.
struct HostSpring {
  static constexpr const char* name = "Host Spring";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;

  static void describe(input::ParameterSpec& p) {
    p.summary("Of a host.");
    p.number("Stiffness").unit("stress/length").required().above(0.0).doc("In every direction.");
  }
  explicit HostSpring(const input::Parameters& p) : stiffness(p.number("Stiffness")) {}

  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) {
      state.traction[c] = stiffness * line.freeJump[c] / (1.0 + stiffness * line.compliance);
    }
    return state;
  }

  double stiffness;
};

/// Two columns of modulus 1000 with a spring between them under a pressure of 10, as a list in memory.
class InMemory : public ::testing::Test {
 protected:
  InMemory() {
    laws::addLaw<HostSpring>(laws);
    const auto list = Teuchos::getParametersFromXmlString(scene::sampleScene());
    Teuchos::ParameterList& law = list->sublist("Interfaces").sublist("seal").sublist("Law");
    law = Teuchos::ParameterList();
    law.set("Type", "Host Spring");
    law.set("Stiffness", 50.0);
    list->sublist("Parts").sublist("upper").remove("Body Force");
    list->sublist("Solver").set("Accuracy", 1e-6);
    input = std::make_shared<const input::InputTree>(input::InputTree::fromTeuchos(*list, "host"));
  }
  ~InMemory() override {
    comm->barrier();
    if (comm->getRank() == 0) std::filesystem::remove_all(directory);
  }

  static double sink(double stiffness) { return 10.0 * (2.0 / 1000.0 + 1.0 / stiffness); }

  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Tpetra::getDefaultComm();
  const std::string directory = "in_memory_test_" + std::to_string(comm->getSize());
  laws::LawRegistry laws = laws::builtInLaws();
  std::shared_ptr<const input::InputTree> input;
};

TEST_F(InMemory, ScenesRunWithTheLawsOfTheHost) {
  scene::SceneRunRequest request;
  request.scene = "host.xml";  // which there is not
  request.input = input;
  request.directory = directory;
  const scene::SceneRunResult result = scene::runScene(request, laws, comm);
  EXPECT_EQ(result.solution.outcome, latin::Outcome::certified);
  EXPECT_NEAR(result.solution.responses[1].values.back(), sink(50.0), 1e-5 * sink(50.0));
  EXPECT_EQ(result.record.status, "certified");
  EXPECT_TRUE(std::filesystem::exists(directory + "/host.e"));
}

TEST_F(InMemory, StudiesRunLikewise) {
  Teuchos::ParameterList study("Harmos Study");
  study.set("Scene", "host.xml");
  Teuchos::ParameterList& parameter = study.sublist("Parameters").sublist("k");
  parameter.set("Entry", "Interfaces/seal/Law/Stiffness");
  parameter.set("Values", Teuchos::Array<double>({25.0, 50.0, 100.0}));
  StudyRunRequest request;
  request.study = "host_study.xml";
  request.input = std::make_shared<const input::InputTree>(input::InputTree::fromTeuchos(study, "host study"));
  request.scene = input;
  request.directory = directory;
  request.ranksPerConfiguration = comm->getSize();
  const StudyRunResult run = runStudy(request, laws, comm);
  EXPECT_EQ(run.state, "complete");
  EXPECT_EQ(run.exitCode, 0);
  const auto all = run.results->all();
  ASSERT_EQ(all.size(), 3U);
  for (const auto& result : all) {
    const double stiffness = run.study->configurations[result.id - 1].values[0];
    EXPECT_NEAR(result.curves[1].back(), sink(stiffness), 1e-4 * sink(stiffness));
  }
}

}  // namespace
}  // namespace harmos::study
