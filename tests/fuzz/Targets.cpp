#include "Targets.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <exodusII.h>

#include <harmos/files/ExodusComparison.hpp>
#include <harmos/files/ExodusMesh.hpp>
#include <harmos/files/ExodusWriter.hpp>
#include <harmos/files/StoredExpansions.hpp>
#include <harmos/files/StoredInterpolant.hpp>
#include <harmos/files/StoredSurfaceData.hpp>
#include <harmos/files/StudyJournal.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/files/detail/StudySeal.hpp>
#include <harmos/mesh/GluedAssembly.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/study/StudyReader.hpp>

namespace fs = std::filesystem;
using namespace harmos;

namespace {

std::string contentOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

Target xmlTarget(const fs::path& sources, const std::string& folder) {
  Target target{{}, true, {}};
  for (const auto& entry : fs::directory_iterator(sources)) {
    if (entry.path().extension() != ".xml") continue;
    target.seeds.push_back(contentOf(entry.path()));
    fs::copy_file(entry.path(), fs::path(folder) / entry.path().filename(), fs::copy_options::overwrite_existing);
  }
  const std::string path = folder + "/damaged.xml";
  target.read = [path](const std::string& content) {
    write(path, content);
    const laws::LawRegistry laws = laws::builtInLaws();
    if (study::isStudyFile(path)) {
      study::readStudy(path, {}, "", laws);
    } else {
      scene::readScene(path, {}, laws);
    }
  };
  return target;
}

/// Two bodies with sets and a time step.
void writeResult(const std::string& path) {
  const mesh::Mesh mesh = mesh::gluedAssembly(1.0);
  const files::ResultMesh sound = files::resultMesh(mesh);
  const files::ResultVariables variables{{"u_load"}, {"disp_x", "disp_y"}, {"von_mises"}};
  files::ExodusWriter writer(path, "two parts", sound, variables, {"a line"});
  files::ResultStep step = files::zeroStep(sound, variables);
  writer.write(step);
  step.time = 1.0;
  writer.write(step);
  writer.commit();
}

/// The same in the HDF5 format.
void convert(const std::string& from, const std::string& to) {
  int word = 8, fileWord = 0;
  float version = 0.0F;
  const int in = ex_open(from.c_str(), EX_READ, &word, &fileWord, &version);
  const int out = ex_create(to.c_str(), EX_CLOBBER | EX_NETCDF4, &word, &word);
  if (in < 0 || out < 0 || ex_copy(in, out) < 0) throw std::runtime_error("cannot make " + to);
  ex_close(in);
  ex_close(out);
}

Target exodusTarget(const std::string& folder) {
  const std::string sound = folder + "/sound.e", hdf5 = folder + "/sound_hdf5.e", path = folder + "/damaged.e";
  writeResult(sound);
  convert(sound, hdf5);
  return {{contentOf(sound), contentOf(hdf5)}, false, [sound, path](const std::string& content) {
            write(path, content);
            std::unique_ptr<base::Error> refusal;
            try {
              files::readExodus(path);
            } catch (const base::Error& error) {
              refusal = std::make_unique<base::Error>(error);
            }
            files::compareExodus(sound, path, files::Tolerances());
            if (refusal) throw base::Error(*refusal);
          }};
}

/// Of a study with two parameters and, if asked for, expansions.
std::string studyFile(const std::string& path, bool hasExpansions) {
  results::StudyDescription description;
  description.name = "joint";
  description.accuracy = 0.01;
  description.parameters = {{"k", "N/mm", "", {"Values/k"}, "local stage"}, {"mu", "-", "", {"Values/mu"}, "loads"}};
  for (int id = 1; id <= 9; ++id) {
    description.configurations.push_back({id, {400.0 + 30.0 * id, 0.2 + 0.02 * ((id * 5) % 9)}});
  }
  description.curves = {"reaction"};
  description.times = {1.0, 2.0};
  results::ScalarResponse largest;
  largest.name = "F_max";
  description.responses = {largest};
  results::StudyResults all(description);
  for (int id = 1; id <= 9; ++id) {
    results::ConfigurationResult result;
    result.id = id;
    result.status = results::Status::certified;
    result.curves = {{0.1 * id, std::sqrt(id)}};
    result.curveErrors = {1e-3};
    result.errorEstimate = 1e-3;
    result.starts = {id - 1};
    all.set(result);
  }
  if (hasExpansions) {
    const std::vector<probability::Variable> variables = {{"k", std::make_shared<probability::Normal>(500.0, 100.0)},
                                                          {"mu", std::make_shared<probability::Lognormal>(0.3, 0.06)}};
    const auto basis = std::make_shared<probability::Basis>(std::make_shared<probability::RandomVector>(variables), 2);
    auto summary = std::make_shared<results::StochasticSummary>();
    summary->variables = {"k", "mu"};
    summary->distributions = {"", ""};
    summary->responses.resize(1);
    summary->responses[0].name = "F_max";
    summary->responses[0].expansion =
        std::make_shared<probability::Expansion>(basis, std::vector<double>(basis->size(), 0.5));
    summary->responses[0].standardDeviation = 2.0;
    summary->responses[0].holdOutError = 0.25;
    all.setStatistics(summary);
  }
  files::writeStudyFile(path, all, "complete");
  return contentOf(path);
}

const results::Identity identity = {{"Scene / Values / mu", "0.3"}, {"Study / Title", "Title"}};

std::string journal(const std::string& path) {
  fs::remove(path);
  {
    files::StudyJournal journal(path, identity, false);
    for (int id = 1; id <= 3; ++id) {
      results::ConfigurationResult result;
      result.id = id;
      result.status = results::Status::certified;
      result.curves = {{0.5, 1e-300}};
      result.curveErrors = {std::numeric_limits<double>::quiet_NaN()};
      journal.append(result);
    }
    journal.appendNote("calibration", {"1.5"});
  }
  return contentOf(path);
}

/// HDF5 must stand damages also where the seal is made anew: of the files that are refused by their seal nothing is
/// read.
Target studyTarget(const std::string& folder) {
  const std::string path = folder + "/damaged.h5", log = folder + "/damaged.journal";
  Target target{{}, false, {}};
  for (const bool hasExpansions : {false, true}) {
    const std::string sealed = studyFile(path, hasExpansions);
    target.seeds.push_back(sealed.substr(0, sealed.size() - files::studySeal("").size()));
  }
  target.seeds.push_back(journal(log));
  target.read = [path, log](const std::string& content) {
    if (content.size() < 4 || content.compare(1, 3, "HDF") != 0) {
      write(log, content);
      const files::StudyJournal opened(log, identity, false);
      return;
    }
    write(path, content + files::studySeal(content));
    files::readSurfaceData(path);
    if (const auto expansions = files::StoredExpansions::read(path)) {
      std::vector<double> point(expansions->parameters().size(), 0.3);
      expansions->evaluate(point);
      expansions->isInside(point);
    }
    if (const auto interpolant = files::StoredInterpolant::read(path)) {
      interpolant->evaluate(std::vector<double>(interpolant->parameters().size(), 0.3));
    }
  };
  return target;
}

}  // namespace

Target makeTarget(const std::string& kind, const std::string& sources, const std::string& folder) {
  if (kind == "xml") return xmlTarget(sources, folder);
  if (kind == "exodus") return exodusTarget(folder);
  if (kind == "study") return studyTarget(folder);
  throw std::runtime_error("unknown kind " + kind);
}
