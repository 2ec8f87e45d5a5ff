#include <harmos/input/Parameters.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::input {

const std::vector<double>* Histories::find(const std::string& name) const {
  const auto found = perStep_.find(name);
  return found == perStep_.end() ? nullptr : &found->second;
}

const Parameters::Entry* Parameters::find(const std::string& name) const {
  const auto found = places_.find(name);
  return found == places_.end() ? nullptr : &entries_[found->second];
}

const Parameters::Sublist* Parameters::findList(const std::string& name) const {
  for (const Sublist& sublist : sublists_) {
    if (sublist.name == name) return &sublist;
  }
  return nullptr;
}

template <class T>
const T& Parameters::get(const std::string& name, const char* type) const {
  const Entry* entry = find(name);
  const T* value = entry ? std::get_if<T>(&entry->value) : nullptr;
  if (!value) throw base::Error(where() + ": has no " + type + " \"" + name + "\".");
  return *value;
}

double Parameters::number(const std::string& name) const {
  return get<double>(name, "number");
}
int Parameters::integer(const std::string& name) const {
  return get<int>(name, "integer");
}
bool Parameters::flag(const std::string& name) const {
  return get<bool>(name, "flag");
}
const std::string& Parameters::text(const std::string& name) const {
  return get<std::string>(name, "text");
}
const std::vector<double>& Parameters::numbers(const std::string& name) const {
  return get<std::vector<double>>(name, "list of numbers");
}
const std::vector<std::string>& Parameters::texts(const std::string& name) const {
  return get<std::vector<std::string>>(name, "list of texts");
}

Schedule Parameters::schedule(const std::string& name) const {
  const double value = number(name);
  const std::string companion = name + " History";
  if (!has(companion)) return Schedule(value);
  const std::vector<double>* history = histories_ ? histories_->find(text(companion)) : nullptr;
  if (!history)
    throw base::Error(where(companion) + ": there is no history \"" + text(companion) + "\".", base::ExitCode::input);
  std::vector<double> perStep = *history;
  const auto& declaration = find(name)->declaration;
  for (std::size_t step = 0; step < perStep.size(); ++step) {
    perStep[step] *= value;
    if (declaration && !declaration->allows(perStep[step])) {
      throw base::Error(where(companion) + ": the history makes " + name + " = " + base::toText(perStep[step]) +
                            " at time step " + std::to_string(step + 1) + ".\n  Allowed: " + declaration->range() + ".",
                        base::ExitCode::input);
    }
  }
  return Schedule(std::move(perStep));
}

std::string Parameters::where(const std::string& name) const {
  const Entry* entry = find(name);
  const bool isGiven = entry && !entry->location.empty();
  const std::string& location = isGiven ? entry->location : location_;
  return (location.empty() ? "" : location + ": ") + path_ + (isGiven ? " / " + name : "");
}

const Parameters& Parameters::list(const std::string& name) const {
  const Sublist* sublist = findList(name);
  if (!sublist || sublist->isNamed) throw base::Error(where() + ": has no list \"" + name + "\".");
  return sublist->lists.front();
}

const std::vector<Parameters>& Parameters::lists(const std::string& name) const {
  static const std::vector<Parameters> none;
  const Sublist* sublist = findList(name);
  return sublist ? sublist->lists : none;
}

void Parameters::remove(const std::string& name) {
  const auto found = places_.find(name);
  if (found == places_.end()) return;
  const std::size_t place = found->second;
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(place));
  places_.erase(found);
  for (auto& [other, at] : places_) at -= at > place ? 1 : 0;
}

Parameters& Parameters::set(const std::string& name, Value value, std::string location) {
  const auto [found, isNew] = places_.emplace(name, entries_.size());
  if (isNew) {
    entries_.push_back({name, std::move(value), std::move(location)});
  } else {
    entries_[found->second].value = std::move(value);
    entries_[found->second].location = std::move(location);
  }
  return *this;
}

void Parameters::restrict(const std::string& name, std::shared_ptr<const ParameterEntry> declaration) {
  const auto found = places_.find(name);
  if (found != places_.end()) entries_[found->second].declaration = std::move(declaration);
}

Parameters& Parameters::setList(const std::string& name, Parameters list) {
  for (Sublist& sublist : sublists_) {
    if (sublist.name == name) {
      sublist.lists = {std::move(list)};
      return *this;
    }
  }
  sublists_.push_back({name, false, {std::move(list)}});
  return *this;
}

Parameters& Parameters::addNamed(const std::string& listName, Parameters child) {
  for (Sublist& sublist : sublists_) {
    if (sublist.name == listName) {
      sublist.lists.push_back(std::move(child));
      return *this;
    }
  }
  sublists_.push_back({listName, true, {std::move(child)}});
  return *this;
}

Parameters& Parameters::setInNamed(const std::string& listName, const std::string& child, const std::string& name,
                                   Value value) {
  for (Sublist& sublist : sublists_) {
    if (sublist.name != listName || !sublist.isNamed) continue;
    for (Parameters& list : sublist.lists) {
      if (list.name() != child) continue;
      list.set(name, std::move(value));
      return *this;  // names are unique
    }
  }
  return *this;
}

void Parameters::attach(const std::shared_ptr<const Histories>& histories) {
  histories_ = histories;
  for (Sublist& sublist : sublists_) {
    for (Parameters& list : sublist.lists) list.attach(histories);
  }
}

}  // namespace harmos::input
