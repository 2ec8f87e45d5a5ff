#include <harmos/study/StudyParameters.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/input/Override.hpp>
#include <harmos/scene/FaceNames.hpp>
#include <harmos/study/detail/DistributionSpec.hpp>

namespace harmos::study {

using input::Parameters;
using Names = std::vector<std::string>;

namespace {

/// Coefficients of random fields that are not standard normal, which the mean 1 and the spread of the field rest on.
void checkDraws(const StudyParameter& parameter, const std::string& where, input::ErrorList& errors) {
  const probability::Distribution* given = parameter.distribution.get();
  if (given == nullptr || !parameter.sampleFile.empty()) return;
  const bool isStandard =
      given->name() == std::string("Normal") && given->mean() == 0.0 && given->standardDeviation() == 1.0;
  if (isStandard) return;
  for (const Effect& effect : parameter.effects) {
    const std::size_t end = effect.entry.find("/Coefficients/");
    if (effect.entry.rfind("Fields/", 0) != 0 || end == std::string::npos) continue;
    const std::string field = effect.entry.substr(7, end - 7);
    errors.add(
        where,
        "this is a coefficient of the random field " + base::quoted(field) + ", which is standard normal, not " +
            given->name() + " with mean " + base::toText(given->mean()) + " and standard deviation " +
            base::toText(given->standardDeviation()) + ".",
        "Take Normal with Mean 0 and Standard Deviation 1. The mean of what follows the field stands in its law, "
        "the spread in the Coefficient of Variation of the field; where it must be positive, let the "
        "Distribution of the field be Lognormal.");
    return;
  }
}

}  // namespace

void checkStudyName(const Parameters& list, input::ErrorList& errors) {
  const Names taken = {"id", "status", "iterations", "error_estimate", "start"};
  if (std::find(taken.begin(), taken.end(), list.name()) != taken.end()) {
    errors.add(list.where(), "this name heads another column of the results.", "Take another one.");
  } else if (!input::isFormulaName(list.name())) {
    errors.add(list.where(), "this name can stand neither in formulas nor in tables.",
               "Take letters, digits and underscores, no digit first, and no name of a function.");
  }
}

void StudyParameterReader::read(const Parameters& list) {
  StudyParameter parameter;
  parameter.name = list.name();
  parameter.unit = list.text("Unit");
  parameter.where = list.where();
  checkStudyName(list, errors_);
  if (list.has("Entry") && list.has("Entries")) {
    errors_.add(list.where("Entries"), "\"Entry\" is given too.", "Give one of them.");
  }
  if (list.has("Entry")) parameter.entries = {list.text("Entry")};
  if (list.has("Entries")) parameter.entries = list.texts("Entries");
  if (scene_) readEntries(list, parameter);

  design::PlannedParameter planned;
  planned.axis.name = list.name();
  if (list.has("Formula")) parameter.formula = planned.formula = list.text("Formula");
  planned.where = list.where("Formula");
  readLevels(list, planned.axis);
  if (list.hasList("Distribution")) {
    const Parameters& distribution = list.list("Distribution");
    parameter.isRandom = true;
    parameter.sampleFile = sampleFileOf(distribution, directory_);
    parameter.distribution = readDistribution(distribution, list.name(), directory_, errors_);
    checkDraws(parameter, distribution.where(), errors_);
  }
  planned_.push_back(std::move(planned));
  parameters_.push_back(std::move(parameter));
}

bool StudyParameterReader::demandOneSetter(const std::string& entry, const std::string& parameter,
                                           const std::string& where) {
  const std::string& setter = setters_.emplace(entry, parameter).first->second;
  if (setter == parameter) return true;
  errors_.add(where, "\"" + entry + "\" is set by \"" + setter + "\" already.");
  return false;
}

void StudyParameterReader::readEntries(const Parameters& list, StudyParameter& parameter) {
  const std::string where = list.where(list.has("Entry") ? "Entry" : "Entries");
  for (const std::string& entry : parameter.entries) {
    if (demandOneSetter(entry, list.name(), where)) {
      for (const std::string& naming : entriesThatName(entry, references_)) demandOneSetter(naming, list.name(), where);
    }
    const int before = errors_.count();
    const auto type = input::typeOf(tree_, spec_, entry, where, errors_);
    if (errors_.count() > before) continue;
    if (type != input::ParameterType::number && type != input::ParameterType::integer) {
      errors_.add(where, "\"" + entry + "\" is not a number.", "A study varies numbers.");
      continue;
    }
    if (effectOf(entry, *scene_).target == Effect::Target::step) {
      errors_.add(where, "the load steps are the same for the whole study.",
                  "Vary a history, or make two studies of them.");
      continue;
    }
    const auto effects = effectsOf(entry, references_, *scene_);
    if (effects.empty()) {
      errors_.add(where, "nothing in the scene uses \"" + entry + "\".",
                  "Write \"$" + entry.substr(entry.find('/') + 1) + "\" as the value of a number of the scene.");
    }
    for (const Effect& effect : effects) {
      parameter.effects.push_back(effect);
      parameter.effect = std::max(parameter.effect, effect.kind);
    }
  }
}

void StudyParameterReader::readLevels(const Parameters& list, design::Axis& axis) {
  Names given;
  const auto allOf = [&](const Names& entries) {
    const auto count = std::count_if(entries.begin(), entries.end(), [&](const auto& e) { return list.has(e); });
    if (count == 0) return false;
    given.push_back(base::joinNames(entries));
    if (count == static_cast<std::ptrdiff_t>(entries.size())) return true;
    errors_.add(list.where(), base::joinNames(entries) + " belong together, but not all of them are given.");
    return false;
  };
  if (allOf({"Values"})) axis.levels = list.numbers("Values");
  // Values in between are found from the difference.
  const auto demandDifference = [&](const char* first, const char* last) {
    if (std::isfinite(list.number(last) - list.number(first))) return;
    errors_.add(list.where(last), std::string(first) + " and " + last + " are too far apart to be told by a number.");
  };
  if (allOf({"From", "To", "Count"})) {
    demandDifference("From", "To");
    axis.levels = design::evenLevels(list.number("From"), list.number("To"), list.integer("Count"));
  }
  if (allOf({"Lower", "Upper"})) {
    demandDifference("Lower", "Upper");
    axis.lower = list.number("Lower");
    axis.upper = list.number("Upper");
    if (axis.upper < axis.lower) errors_.add(list.where("Upper"), "Upper is less than Lower.");
  }
  if (list.hasList("Distribution")) given.emplace_back("a Distribution");
  if (allOf({"Formula"}) && given.size() > 1) {
    errors_.add(list.where("Formula"), "a derived parameter takes no values of its own.",
                "Remove " + given.front() + ", or the formula.");
  } else if (given.size() > 1) {
    errors_.add(list.where(), "its values are given twice: " + given[0] + " and " + given[1] + ".",
                "Give one of them.");
  }
  if (given.empty() && !isListed_) {
    errors_.add(list.where(), "it has no values.",
                "Give Values; or From, To, Count; or Lower, Upper; or a Distribution; or a Formula.");
  }
  if (list.has("Values") && axis.levels.empty()) errors_.add(list.where("Values"), "there is no value.");
}

bool changeLawOf(const std::vector<StudyParameter>& parameters, const std::string& interface) {
  const std::string list = scene::nameOfList(interface);
  return std::any_of(parameters.begin(), parameters.end(), [&](const StudyParameter& parameter) {
    return std::any_of(parameter.effects.begin(), parameter.effects.end(),
                       [&](const Effect& effect) { return effect.changesLawOf(list); });
  });
}

}  // namespace harmos::study
