#include <harmos/laws/FieldLaw.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::laws {

namespace {

using Values = std::vector<std::vector<double>>;  // of every entry at every load step, or one for all of them

/// Where the entries stand that make a number vary.
std::string whereOf(const input::Parameters& parameters, const std::string& number) {
  const std::string formula = number + " Formula";
  return parameters.where(parameters.has(formula) ? formula : fieldEntryOf(number));
}

/// Where an entry was given, as Parameters::set() takes it.
std::string locationOf(const input::Parameters& parameters, const std::string& name) {
  for (const auto& entry : parameters.entries()) {
    if (entry.name == name) return entry.location;
  }
  return "";
}

std::string textOf(const base::Vector3& v) {
  return "(" + base::toText(v[0]) + ", " + base::toText(v[1]) + ", " + base::toText(v[2]) + ")";
}

bool haveSameBox(const AdmissibleTractions& a, const AdmissibleTractions& b) {
  return a.lower == b.lower && a.upper == b.upper;
}

/// The pairs from `first` on.
NodeArrays from(const NodeArrays& nodes, int first, int historySize, int count, std::vector<int>& numbers) {
  NodeArrays part = nodes;
  part.count = count;
  part.line += first;
  part.gap += first;
  if (historySize > 0) {
    part.oldHistory += static_cast<std::ptrdiff_t>(first) * historySize;
    part.newHistory += static_cast<std::ptrdiff_t>(first) * historySize;
  }
  part.state += first;
  part.position += first;
  if (part.frame != nullptr) part.frame += first;
  if (part.area != nullptr) part.area += first;
  if (part.number != nullptr) {
    part.number += first;
  } else {
    numbers.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) numbers[static_cast<std::size_t>(i)] = first + i;
    part.number = numbers.data();
  }
  return part;
}

}  // namespace

void FieldLaw::describe(input::ParameterSpec& law) {
  std::vector<std::string> varying;
  for (const auto& entry : law.entries()) {
    if (entry->variesOverSurface) varying.push_back(entry->name);
  }
  for (const std::string& name : varying) {
    input::Field::describe(law, name);
    law.text(fieldEntryOf(name))
        .optional()
        .doc("Name of the entry of Fields that multiplies " + name + "; absent: none.");
  }
}

bool FieldLaw::isAskedFor(const input::Parameters& parameters) {
  return std::any_of(parameters.entries().begin(), parameters.entries().end(), [&](const auto& entry) {
    return input::Field::isGiven(parameters, entry.name) || parameters.has(fieldEntryOf(entry.name));
  });
}

void FieldLaw::check(const input::ParameterSpec& law, const input::Parameters& parameters, input::ErrorList& errors) {
  for (const auto& entry : law.entries()) {
    if (!entry->variesOverSurface || parameters.has(entry->name)) continue;
    for (const std::string& companion : {entry->name + " Formula", fieldEntryOf(entry->name)}) {
      if (!parameters.has(companion)) continue;
      errors.add(parameters.where(companion), "there is no \"" + entry->name + "\" that it multiplies.",
                 "Give it, or remove this entry.");
    }
  }
}

FieldLaw::FieldLaw(const input::ParameterSpec& declared, const input::Parameters& parameters, Factory make, Check check)
    : parameters_(parameters),
      make_(std::move(make)),
      check_(std::move(check)),
      law_(make_(parameters)),
      steps_(std::max(1, static_cast<int>(parameters.times().size()))) {
  for (const auto& entry : declared.entries()) {
    if (!entry->variesOverSurface || !parameters.has(entry->name)) continue;
    const std::string spatial =
        parameters.has(fieldEntryOf(entry->name)) ? parameters.text(fieldEntryOf(entry->name)) : "";
    if (spatial.empty() && !input::Field::isGiven(parameters, entry->name)) continue;
    const bool isList = entry->type == input::ParameterType::numbers;
    input::Field field = isList ? input::Field::factor(parameters, entry->name) : input::Field(parameters, entry->name);
    if (!entry->varies && field.looksAt("t")) {
      throw base::Error(parameters.where(entry->name + " Formula") + ": \"" + entry->name +
                            "\" does not vary over the load steps.\n  Take a formula in x, y and z.",
                        base::ExitCode::input);
    }
    entries_.push_back({entry, std::move(field), spatial});
    const std::string history = entry->name + " History";
    if (parameters.has(history)) {
      const input::Histories histories = parameters.histories();
      const std::vector<double>* perStep = histories.find(parameters.text(history));
      if (perStep != nullptr) steps_ = std::max(steps_, static_cast<int>(perStep->size()));
    }
  }
}

void FieldLaw::bind(std::shared_ptr<const SpatialFields> fields) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> names;
  for (const Entry& entry : entries_) {
    if (!entry.spatial.empty()) names.push_back(entry.spatial);
  }
  fields_.bind(std::move(fields), names);
  for (const Entry& entry : entries_) {
    const std::string& name = entry.declaration->name;
    if (entry.spatial.empty() || entry.declaration->varies || !spatialOf(entry).varies()) continue;
    throw base::Error(parameters_.where(fieldEntryOf(name)) + ": \"" + name +
                          "\" does not vary over the load steps, and the field \"" + entry.spatial +
                          "\" does.\n  Take one time step of it.",
                      base::ExitCode::input);
  }
}

std::shared_ptr<const SpatialFields> FieldLaw::fields() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return fields_.shared();
}

const SpatialField& FieldLaw::spatialOf(const Entry& entry) const {
  return fields_.find(entry.spatial, parameters_.where(fieldEntryOf(entry.declaration->name)));
}

double FieldLaw::valueOf(const Entry& entry, int step, const base::Vector3& place) const {
  const double value = entry.field(step, place);
  if (entry.spatial.empty()) return value;
  try {
    return value * spatialOf(entry).at(step, place);
  } catch (const base::Error& error) {
    throw base::Error(parameters_.where(fieldEntryOf(entry.declaration->name)) + ": " + error.what(), error.code());
  }
}

std::size_t FieldLaw::PlaceHash::operator()(const base::Vector3& place) const {
  std::size_t hash = 0;
  for (const double c : place) hash = 31 * hash + std::hash<double>()(c);
  return hash;
}

void FieldLaw::prepare(const std::vector<base::Vector3>& places) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const base::Vector3& place : places) lawAt(place);
}

std::vector<base::Vector3> FieldLaw::places() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<base::Vector3> result;
  for (const auto& known : byPlace_) result.push_back(known.first);
  return result;
}

const InterfaceLaw& FieldLaw::at(const base::Vector3& place) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return lawAt(place);
}

const InterfaceLaw& FieldLaw::lawAt(const base::Vector3& place) const {
  const auto known = byPlace_.find(place);
  if (known != byPlace_.end()) return *known->second;
  Values values;
  for (const Entry& entry : entries_) {
    std::vector<double> perStep;
    for (int step = 0; step < (entry.declaration->varies ? steps_ : 1); ++step) {
      perStep.push_back(valueOf(entry, step, place));
      demandRange(entry, perStep.back(), place);
    }
    if (std::count(perStep.begin(), perStep.end(), perStep[0]) == static_cast<std::ptrdiff_t>(perStep.size())) {
      perStep.resize(1);
    }
    values.push_back(std::move(perStep));
  }
  auto& law = byValues_[values];
  if (!law) {
    const input::Parameters here = with(values);
    demandTogether(here, place);
    law = make_(here);
  }
  byPlace_[place] = law.get();
  return *law;
}

void FieldLaw::demandRange(const Entry& entry, double value, const base::Vector3& place) const {
  const std::string& name = entry.declaration->name;
  const std::string which = whereOf(parameters_, name) + ": the " + (entry.spatial.empty() ? "formula" : "field");
  const auto demand = [&](double number, const std::string& what) {
    if (entry.declaration->allows(number)) return;
    throw base::Error(which + " makes " + what + " = " + base::toText(number) + " at " + textOf(place) +
                          ".\n  Allowed: " + entry.declaration->range() + ".",
                      base::ExitCode::input);
  };
  if (!entry.isList()) return demand(value, name);
  const std::vector<double>& numbers = parameters_.numbers(name);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    demand(value * numbers[i], "number " + std::to_string(i + 1) + " of " + name);
  }
}

/// A number that varies over the load steps becomes 1 with a history of its own.
input::Parameters FieldLaw::with(const Values& values) const {
  input::Parameters here = parameters_;
  auto histories = std::make_shared<input::Histories>(parameters_.histories());
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const std::string& name = entries_[e].declaration->name;
    if (entries_[e].isList()) {
      std::vector<double> scaled = parameters_.numbers(name);
      for (double& number : scaled) number *= values[e][0];
      here.set(name, std::move(scaled), locationOf(parameters_, name));
    } else if (values[e].size() == 1) {
      here.set(name, values[e][0], locationOf(parameters_, name));
      if (entries_[e].declaration->varies) here.remove(name + " History");
    } else {
      const std::string own = name + " at a place";
      histories->add(own, values[e]);
      here.set(name, 1.0, locationOf(parameters_, name)).set(name + " History", own);
    }
  }
  here.attach(histories);
  return here;
}

void FieldLaw::demandTogether(const input::Parameters& here, const base::Vector3& place) const {
  input::ErrorList errors;
  if (check_) check_(here, errors);
  try {
    errors.throwIfAny();
  } catch (const input::InputErrors& error) {
    throw base::Error(error.list() + "\n  So formulas and fields make it at " + textOf(place) + ".",
                      base::ExitCode::input);
  }
}

std::vector<const InterfaceLaw*> FieldLaw::all() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<const InterfaceLaw*> laws;
  for (const auto& known : byValues_) laws.push_back(known.second.get());
  if (laws.empty()) laws.push_back(law_.get());
  return laws;
}

double FieldLaw::lowestSlope() const {
  double lowest = 0.0;
  for (const InterfaceLaw* law : all()) lowest = std::min(lowest, law->lowestSlope());
  return lowest;
}

std::optional<AdmissibleTractions> FieldLaw::admissibleTractions(int step) const {
  const std::vector<const InterfaceLaw*> laws = all();
  auto result = laws.front()->admissibleTractions(step);
  for (const InterfaceLaw* law : laws) {
    const auto other = law->admissibleTractions(step);
    if (!result || !other || !haveSameBox(*result, *other)) return std::nullopt;
    result->isCone = result->isCone && other->isCone && result->friction == other->friction;
    result->friction = std::max(result->friction, other->friction);
  }
  return result;
}

void FieldLaw::solve(int step, const NodeArrays& nodes) const {
  if (nodes.count == 0) return;
  if (nodes.position == nullptr) {
    law_->solve(step, nodes);  // at no place in particular
    return;
  }
  std::vector<const InterfaceLaw*> laws;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (int i = 0; i < nodes.count; ++i) laws.push_back(&lawAt(nodes.position[i]));
  }
  std::vector<int> numbers;
  const int size = historySize();
  for (int i = 0, end = 0; i < nodes.count; i = end) {
    while (end < nodes.count && laws[static_cast<std::size_t>(end)] == laws[static_cast<std::size_t>(i)]) ++end;
    laws[static_cast<std::size_t>(i)]->solve(step, from(nodes, i, size, end - i, numbers));
  }
}

}  // namespace harmos::laws
