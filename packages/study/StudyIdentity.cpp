#include <harmos/study/detail/StudyIdentity.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <boost/crc.hpp>

#include <harmos/base/Numerals.hpp>
#include <harmos/input/EffectiveInput.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/Plugins.hpp>

namespace harmos::study {

namespace {

namespace fs = std::filesystem;
using input::Parameters;

struct ToText {
  std::string operator()(double value) const { return base::toText(value); }
  std::string operator()(int value) const { return std::to_string(value); }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(const std::string& value) const { return value; }
  template <class T>
  std::string operator()(const std::vector<T>& values) const {
    std::string text;
    for (const T& value : values) text += (text.empty() ? "" : ", ") + (*this)(value);
    return "{" + text + "}";
  }
};

void flatten(const Parameters& list, const std::string& path, results::Identity& identity) {
  for (const Parameters::Entry& entry : list.entries()) {
    identity.emplace_back(path + " / " + entry.name, std::visit(ToText(), entry.value));
  }
  for (const Parameters::Sublist& sublist : list.sublists()) {
    for (const Parameters& child : sublist.lists) {
      flatten(child, path + " / " + sublist.name + (sublist.isNamed ? " / " + child.name() : ""), identity);
    }
  }
}

std::string checksum(const std::string& path) {
  boost::crc_32_type crc;
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    crc.process_bytes(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  char digits[16];
  std::snprintf(digits, sizeof digits, "%08x", crc.checksum());
  return digits;
}

}  // namespace

results::Identity identityOf(const Study& study) {
  results::Identity all, identity;
  flatten(study.input, "Study", all);
  flatten(study.scene.input, "Scene", all);
  for (auto& entry : all) {
    if (entry.first != "Study / Title" && entry.first != "Scene / Title") identity.push_back(std::move(entry));
  }
  if (const auto file = scene::meshFile(study.scene.input.list("Mesh"), study.scene.path)) {
    identity.emplace_back("Checksum of the mesh", checksum(*file));
  }
  for (const std::string& plugin : scene::pluginFiles(study.scene.input, study.scene.path)) {
    identity.emplace_back("Checksum of " + plugin, checksum(plugin));
  }
  for (const StudyParameter& parameter : study.parameters) {
    if (parameter.sampleFile.empty()) continue;
    identity.emplace_back("Checksum of the sample of " + parameter.name, checksum(parameter.sampleFile));
  }
  if (!study.pointsFile.empty()) identity.emplace_back("Checksum of the points", checksum(study.pointsFile));
  return identity;
}

results::StudyDescription describe(const Study& study) {
  results::StudyDescription description;
  description.name = fs::path(study.path).stem().string();
  description.title = study.title;
  description.scene = study.scene.path;
  description.accuracy = study.scene.solver.accuracy;
  for (const StudyParameter& parameter : study.parameters) {
    description.parameters.push_back(
        {parameter.name, parameter.unit, parameter.formula, parameter.entries, effectName(parameter.effect)});
  }
  description.configurations = study.configurations;
  for (const Parameters& response : study.scene.input.lists("Responses")) {
    description.curves.push_back(response.name());
  }
  description.times = study.scene.times;
  description.responses = study.responses;
  description.recovery = study.policy.values;
  description.leftOut = study.leftOut;
  description.studyInput = input::effectiveInput(study.input);
  description.sceneInput = input::effectiveInput(study.scene.input);
  description.identity = identityOf(study);
  return description;
}

}  // namespace harmos::study
