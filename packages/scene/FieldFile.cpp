#include <harmos/scene/FieldFile.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::scene {

namespace {

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

void demandNumbers(const std::vector<std::vector<double>>& fields, const std::vector<std::string>& names, int step) {
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const auto isFinite = [](double value) { return std::isfinite(value); };
    if (std::all_of(fields[f].begin(), fields[f].end(), isFinite)) continue;
    throw base::Error("field " + base::quoted(names[f]) + ", load step " + std::to_string(step + 1) +
                          ": a value is not finite (NaN or infinity); are loads, stiffnesses or lengths too large for "
                          "double precision?",
                      base::ExitCode::notConverged);
  }
}

}  // namespace

void addVector(std::vector<std::string>& names, const std::string& name, int dimension) {
  for (const char* axis : {"_x", "_y", "_z"})
    if (static_cast<int>(axis[1] - 'x') < dimension) names.push_back(name + axis);
}

FieldFile::FieldFile(std::string title, const std::string& input, const std::vector<double>& times,
                     std::vector<GlobalVariable> globals, const Teuchos::Comm<int>& comm)
    : title_(std::move(title)), information_(lines(input)), times_(times), globals_(std::move(globals)), comm_(comm) {}

std::unique_ptr<files::ExodusWriter> FieldFile::open(const std::string& path, const files::ResultMesh& mesh,
                                                     files::ResultVariables variables) const {
  if (comm_.getRank() != 0) return nullptr;
  for (const auto& global : globals_) variables.global.push_back(global.name);
  auto writer = std::make_unique<files::ExodusWriter>(path, title_, mesh, variables, information_);
  writer->write(files::zeroStep(mesh, variables));
  return writer;
}

void FieldFile::write(files::ExodusWriter* writer, files::ResultStep& step, int number) const {
  if (writer == nullptr) return;
  step.global.clear();
  for (const auto& global : globals_) step.global.push_back(global.values[number]);
  demandNumbers(step.nodal, writer->variables().nodal, number);
  demandNumbers(step.element, writer->variables().element, number);
  writer->write(step);
}

void FieldFile::gather(std::vector<double>& values) const {
  std::vector<double> sum(values.size(), 0.0);
  Teuchos::reduce(values.data(), sum.data(), static_cast<int>(values.size()), Teuchos::REDUCE_SUM, 0, comm_);
  values.swap(sum);
}

}  // namespace harmos::scene
