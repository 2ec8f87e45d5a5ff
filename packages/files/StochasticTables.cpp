#include <harmos/files/StochasticTables.hpp>

#include <cmath>
#include <filesystem>
#include <system_error>

#include <harmos/base/Numerals.hpp>
#include <harmos/files/AtomicFile.hpp>

namespace harmos::files {

namespace {

std::string cell(double value, const char* otherwise) {
  return "," + (std::isnan(value) ? otherwise : base::toText(value));
}

std::string moments(const results::StochasticSummary& summary) {
  std::string text =
      "response,mean,std,skewness,kurtosis,mean_error,std_error,iteration_error,truncation,hold_out_error\n";
  for (const results::ResponseStatistics& response : summary.responses) {
    text += response.name;
    for (const double value : {response.mean, response.standardDeviation, response.skewness, response.kurtosis}) {
      text += cell(value, "n/a");
    }
    for (const double value : {response.meanError, response.deviationError, response.iterationError,
                               response.truncation, response.holdOutError}) {
      text += cell(value, "");
    }
    text += "\n";
  }
  return text;
}

std::string sobol(const results::StochasticSummary& summary) {
  std::string text = "response,variables,main,total\n";
  for (const results::ResponseStatistics& response : summary.responses) {
    for (const probability::SobolIndex& index : response.sobol) {
      text += response.name + ",";
      for (std::size_t g = 0; g < index.germs.size(); ++g) {
        text += (g == 0 ? "" : "*") + summary.germName(index.germs[g]);
      }
      text += cell(index.main, "n/a") + cell(index.total, "n/a") + "\n";
    }
  }
  return text;
}

std::string coefficients(const results::StochasticSummary& summary) {
  std::string text = "response";
  for (std::size_t g = 0; g < summary.variables.size(); ++g) text += "," + summary.germName(static_cast<int>(g));
  text += ",coefficient\n";
  for (const results::ResponseStatistics& response : summary.responses) {
    if (!response.expansion) continue;
    const auto& indices = response.expansion->basis().indices();
    for (std::size_t a = 0; a < indices.size(); ++a) {
      text += response.name;
      for (const int degree : indices[a]) text += "," + std::to_string(degree);
      text += cell(response.expansion->coefficients()[a], "n/a") + "\n";
    }
  }
  return text;
}

std::string sweep(const results::StochasticSummary& summary) {
  std::string text;
  for (const std::string& name : summary.sweepNames) text += name + ",";
  for (const results::ResponseStatistics& response : summary.responses) {
    text += response.name + "_mean," + response.name + "_std,";
  }
  text.back() = '\n';
  for (const auto& point : summary.sweep) {
    for (const double coefficient : point.coefficients) text += base::toText(coefficient) + ",";
    for (std::size_t r = 0; r < point.means.size(); ++r) {
      text += base::toText(point.means[r]) + "," + base::toText(point.deviations[r]) + ",";
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace

StochasticFiles::StochasticFiles(const std::string& base)
    : moments(base + "_moments.csv"),
      sobol(base + "_sobol.csv"),
      coefficients(base + "_coefficients.csv"),
      sweep(base + "_sweep.csv"),
      parts(base + ".e"),
      interfaces(base + "_interfaces.e") {}

std::vector<std::string> StochasticFiles::written() const {
  std::vector<std::string> files;
  std::error_code ignored;
  for (const std::string& path : all()) {
    if (std::filesystem::exists(path, ignored)) files.push_back(path);
  }
  return files;
}

void writeStochasticTables(const StochasticFiles& files, const results::StochasticSummary& summary) {
  replaceFile(files.moments, moments(summary));
  replaceFile(files.sobol, sobol(summary));
  replaceFile(files.coefficients, coefficients(summary));
  if (!summary.sweep.empty()) replaceFile(files.sweep, sweep(summary));
}

}  // namespace harmos::files
