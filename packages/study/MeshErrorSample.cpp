#include <harmos/study/MeshErrorSample.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace harmos::study {
namespace {

constexpr std::size_t estimatesAtMost = 5;
constexpr std::size_t configurationsPerEstimate = 5;
// Of the range of a parameter.
constexpr double farApart = 0.5;

/// What all estimates say of one response.
struct Spread {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  std::map<std::string, int> words;  // but "estimated"
};

}  // namespace

MeshErrorSample::MeshErrorSample(const results::StudyResults& results) : results_(results) {
  const results::StudyDescription& description = results.description();
  std::set<std::size_t> curves;
  for (const results::ScalarResponse& response : description.responses) curves.insert(response.curve);
  curves_.assign(curves.begin(), curves.end());
  if (curves_.empty()) {
    curves_.resize(description.curves.size());
    std::iota(curves_.begin(), curves_.end(), std::size_t{0});
  }
  for (std::size_t p = 0; p < description.parameters.size(); ++p) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const design::Configuration& configuration : description.configurations) {
      least = std::min(least, configuration.values[p]);
      most = std::max(most, configuration.values[p]);
    }
    ranges_.push_back(most - least);
  }
  for (const design::Configuration& configuration : results.configurations()) {
    const results::ConfigurationResult* result = results.find(configuration.id);
    if (result && !result->meshErrors.empty()) add(configuration, result->meshErrors);
  }
}

std::size_t MeshErrorSample::mostOf(std::size_t configurations) {
  return std::min((configurations + configurationsPerEstimate - 1) / configurationsPerEstimate, estimatesAtMost);
}

bool MeshErrorSample::wants(const design::Configuration& configuration) const {
  const bool isOfTheStudy = configuration.id >= 1;  // others are only passed on a way
  if (!isOfTheStudy || estimates_.count(configuration.id) > 0) return false;
  if (estimates_.size() >= mostOf(results_.configurations().size())) return false;
  return std::all_of(estimates_.begin(), estimates_.end(), [&](const auto& known) {
    for (std::size_t p = 0; p < ranges_.size(); ++p) {
      if (std::abs(known.second.values[p] - configuration.values[p]) >= farApart * ranges_[p] && ranges_[p] > 0.0) {
        return true;
      }
    }
    return false;
  });
}

void MeshErrorSample::add(const design::Configuration& configuration, std::vector<results::MeshErrorRecord> errors) {
  estimates_[configuration.id] = {configuration.values, std::move(errors)};
}

std::vector<results::MeshErrorRecord> MeshErrorSample::errorsOf(int id) const {
  const auto found = estimates_.find(id);
  return found == estimates_.end() ? std::vector<results::MeshErrorRecord>{} : found->second.errors;
}

void MeshErrorSample::report(results::ResultSink& sink) const {
  std::ostringstream text;
  const char* separator = ": ";
  std::set<std::string> parts;
  text << "at " << estimates_.size() << " of " << results_.configurations().size() << " configurations";
  for (const std::size_t curve : curves_) {
    const std::string& name = results_.description().curves[curve];
    Spread spread;
    for (const auto& [id, estimate] : estimates_) {
      for (const results::MeshErrorRecord& error : estimate.errors) {
        if (error.response != name) continue;
        spread.least = std::min(spread.least, error.relative);
        spread.most = std::max(spread.most, error.relative);
        if (error.relative < results::negligibleMeshError) continue;
        if (error.word != "estimated") ++spread.words[error.word];
        parts.insert(error.parts.begin(), error.parts.end());
      }
    }
    if (spread.least > spread.most) continue;
    text << separator << name << " " << results::meshErrorInWords(spread.least, spread.most);
    separator = ", ";
    for (const auto& [word, count] : spread.words) text << " (" << word << " at " << count << ")";
  }
  if (*separator == ':') return;
  separator = "; refine ";
  for (const std::string& part : parts) {
    text << separator << part;
    separator = ", ";
  }
  sink.note("error of the mesh", {text.str()});
}

}  // namespace harmos::study
