#include <harmos/cli/detail/StudyText.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>

#include <harmos/base/Names.hpp>
#include <harmos/results/StatusName.hpp>
#include <harmos/study/StochasticTails.hpp>
#include <harmos/study/StudyGroup.hpp>

namespace harmos::cli {

namespace {

const char* consequenceOf(study::Effect::Kind effect) {
  switch (effect) {
    case study::Effect::Kind::nothing:
      return "stands in formulas";
    case study::Effect::Kind::localStage:
      return "local stage only, all operators stay";
    case study::Effect::Kind::loads:
      return "loads, all operators stay";
    case study::Effect::Kind::operators:
      return "bodies are assembled and factored anew";
  }
  return "";
}

}  // namespace

void printPlan(std::ostream& out, const study::Study& study) {
  out << study.path << ": " << study.configurations.size()
      << (study.configurations.size() == 1 ? " configuration" : " configurations")
      << (study.isAdaptive() ? " to begin with" : "");
  const auto groups = study::groupByOperators(study.parameters, study.configurations).size();
  if (groups > 1) out << " with " << groups << " different operators";
  out << "\n";
  for (const auto& [condition, count] : study.leftOut) {
    if (count == 0) continue;
    out << "  " << count << " more are left out by the condition \"" << condition << "\"\n";
  }
  for (const study::StudyParameter& parameter : study.parameters) {
    const std::string name = parameter.name + (parameter.unit.empty() ? "" : " [" + parameter.unit + "]");
    out << "  " << std::left << std::setw(20) << name << std::right << consequenceOf(parameter.effect);
    std::vector<std::string> entries;
    for (const study::Effect& effect : parameter.effects) entries.push_back(effect.entry);
    if (!entries.empty()) out << ": " << base::joinNames(entries, 3);
    out << "\n";
  }
  if (!study.stochastic) return;
  for (const std::string& sentence : study::describeTails(study)) out << "  " << sentence << "\n";
  for (const std::string& sentence : study::describeSweeps(study)) out << "  " << sentence << "\n";
  for (const std::string& remark : study.stochastic->remarks) out << "  " << remark << "\n";
}

namespace {

void printStatistics(std::ostream& out, const results::StochasticSummary& summary) {
  out << summary.method << "\n"
      << "  " << std::left << std::setw(20) << "response" << std::right;
  for (const char* head :
       {"mean", "std", "skewness", "kurtosis", "last degree", "hold-out", "mean error", "std error"}) {
    out << std::setw(13) << head;
  }
  out << "\n";
  for (const results::ResponseStatistics& response : summary.responses) {
    out << "  " << std::left << std::setw(20) << response.name << std::right;
    for (const double value :
         {response.mean, response.standardDeviation, response.skewness, response.kurtosis, response.truncation,
          response.holdOutError, response.meanError, response.deviationError}) {
      std::ostringstream cell;
      cell << std::setprecision(6) << value;
      out << std::setw(13) << (std::isnan(value) ? "n/a" : cell.str());
    }
    out << "\n";
  }
  for (const std::string& warning : summary.warnings) out << "  WARNING: " << warning << "\n";
  if (summary.inadmissible > 0) {
    out << "  " << summary.inadmissible << " draws have values that the scene refuses and are left out\n";
  }
}

/// Why configurations have no solution, the most frequent reasons first.
void printReasons(std::ostream& out, const std::vector<results::ConfigurationResult>& all) {
  constexpr std::size_t most = 3;
  struct Reason {
    std::string text;
    int first = 0, count = 0;
  };
  std::vector<Reason> reasons;
  for (const results::ConfigurationResult& result : all) {
    if (results::isSolved(result.status)) continue;
    const std::string text = std::string(results::statusName(result.status)) + ": " + result.reason;
    auto known =
        std::find_if(reasons.begin(), reasons.end(), [&](const Reason& reason) { return reason.text == text; });
    if (known == reasons.end()) known = reasons.insert(reasons.end(), {text, result.id, 0});
    ++known->count;
  }
  std::stable_sort(reasons.begin(), reasons.end(), [](const auto& a, const auto& b) { return a.count > b.count; });
  for (std::size_t i = 0; i < std::min(most, reasons.size()); ++i) {
    out << "  configuration " << reasons[i].first;
    if (reasons[i].count > 1) out << " and " << reasons[i].count - 1 << " more";
    out << " " << reasons[i].text << "\n";
  }
  if (reasons.size() > most) out << "  and " << reasons.size() - most << " more reasons, see the table\n";
}

}  // namespace

void printOutcome(std::ostream& out, const results::StudyResults& results) {
  const results::StudyDescription& description = results.description();
  out << results.count() << " of " << results.configurations().size() << " configurations:";
  const char* separator = " ";
  for (const results::Status status : results::allStatuses()) {
    if (results.count(status) == 0) continue;
    out << separator << results.count(status) << " " << results::statusName(status);
    separator = ", ";
  }
  out << "\n";
  const auto all = results.all();
  printReasons(out, all);
  double seconds = 0.0;
  std::optional<double> largestError;  // of what is solved
  long stages = 0;
  for (const results::ConfigurationResult& result : all) {
    seconds += result.cpuSeconds;
    stages += result.linearStages;
    if (results::isSolved(result.status)) largestError = std::max(largestError.value_or(0.0), result.errorEstimate);
  }
  for (std::size_t r = 0; r < description.responses.size(); ++r) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const results::ConfigurationResult& result : all) {
      const double value = results.responses(result.id)[r];
      if (std::isnan(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (least > most) continue;
    out << "  " << description.responses[r].name << " from " << std::setprecision(7) << least << " to " << most << "\n";
  }
  for (const auto& [name, note] : results.notes()) out << "  " << name << ": " << note.text << "\n";
  if (results.statistics()) printStatistics(out, *results.statistics());
  if (all.empty()) return;
  out << std::setprecision(3);
  if (largestError) {
    out << "largest error estimate " << *largestError;
  } else {
    out << "no error estimate";
  }
  out << " (asked for " << description.accuracy << "), "
      << static_cast<double>(stages) / static_cast<double>(all.size()) << " linear stages and "
      << seconds / static_cast<double>(all.size()) << " CPU seconds per configuration\n";
}

}  // namespace harmos::cli
