#include <harmos/input/ParameterSpec.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::input {

const char* xmlType(ParameterType type) {
  switch (type) {
    case ParameterType::number:
      return "double";
    case ParameterType::integer:
      return "int";
    case ParameterType::flag:
      return "bool";
    case ParameterType::text:
      return "string";
    case ParameterType::numbers:
      return "Array(double)";
    case ParameterType::texts:
      return "Array(string)";
  }
  return "";
}

ParameterEntry& ParameterEntry::defaultValue(double v) {
  defaultText = base::toText(v);
  return *this;
}

ParameterEntry& ParameterEntry::defaultValue(int v) {
  defaultText = std::to_string(v);
  return *this;
}

ParameterEntry& ParameterEntry::defaultValue(bool v) {
  defaultText = v ? "true" : "false";
  return *this;
}

ParameterEntry& ParameterEntry::defaultValue(const char* v) {
  defaultText = v;
  return *this;
}

bool ParameterEntry::allows(double number) const {
  return (excludesMinimum ? number > minimum : number >= minimum) &&
         (excludesMaximum ? number < maximum : number <= maximum);
}

std::string ParameterEntry::range() const {
  std::string text;
  if (minimum != -std::numeric_limits<double>::infinity()) {
    text = (excludesMinimum ? "above " : "at least ") + base::toText(minimum);
  }
  if (maximum != std::numeric_limits<double>::infinity()) {
    text +=
        (text.empty() ? "" : " and ") + std::string(excludesMaximum ? "below " : "at most ") + base::toText(maximum);
  }
  if (!text.empty() && !unitName.empty()) text += " [" + unitName + "]";
  return text;
}

ParameterEntry& ParameterSpec::add(std::string name, ParameterType type) {
  for (const auto& entry : entries_) {
    if (entry->name == name)
      throw base::Error("ParameterSpec " + name_ + ": parameter \"" + name + "\" declared twice.");
  }
  return *entries_.emplace_back(std::make_shared<ParameterEntry>(std::move(name), type));
}

ParameterSpec& ParameterSpec::addList(Sublist sublist) {
  for (const Sublist& other : sublists_) {
    if (other.name == sublist.name) {
      throw base::Error("ParameterSpec " + name_ + ": list \"" + sublist.name + "\" declared twice.");
    }
  }
  return *sublists_.emplace_back(std::move(sublist)).spec;
}

ParameterSpec& ParameterSpec::list(std::string name, bool required, bool optional) {
  auto spec = std::make_shared<ParameterSpec>(name);
  return addList({std::move(name), ListKind::fixed, required, optional, std::move(spec)});
}

ParameterSpec& ParameterSpec::namedLists(std::string name, bool required) {
  auto spec = std::make_shared<ParameterSpec>(name);
  return addList({std::move(name), ListKind::named, required, false, std::move(spec)});
}

ParameterSpec& ParameterSpec::namedNumbers(std::string name) {
  auto spec = std::make_shared<ParameterSpec>(name);
  return addList({std::move(name), ListKind::numbers, false, false, std::move(spec)});
}

ParameterSpec& ParameterSpec::alternatives(std::string name, std::vector<ParameterSpec> forms, bool required) {
  return list(std::move(name), required, !required).choose(std::move(forms));
}

ParameterSpec& ParameterSpec::choose(std::vector<ParameterSpec> forms) {
  forms_ = std::move(forms);
  return *this;
}

const ParameterSpec* ParameterSpec::findForm(const std::string& type) const {
  for (const ParameterSpec& form : forms_) {
    if (form.name() == type) return &form;
  }
  return nullptr;
}

std::vector<ParameterEntry> ParameterSpec::entriesWith(const ParameterSpec* form) const {
  std::vector<ParameterEntry> all;
  if (!forms_.empty()) {
    std::vector<std::string> types;
    for (const ParameterSpec& f : forms_) types.push_back(f.name());
    all.emplace_back("Type", ParameterType::text).oneOf(std::move(types)).doc("Which form this list has.");
  }
  for (const ParameterSpec* spec : {this, form}) {
    if (!spec) continue;
    for (const auto& entry : spec->entries_) {
      all.push_back(*entry);
      if (entry->varies) {
        ParameterEntry companion(entry->name + " History", ParameterType::text);
        companion.optional().doc("Name of the entry of Histories that multiplies " + entry->name +
                                 "; absent: constant.");
        companion.namesHistory = true;
        all.push_back(std::move(companion));
      }
    }
  }
  return all;
}

std::vector<ParameterSpec::Sublist> ParameterSpec::sublistsWith(const ParameterSpec* form) const {
  std::vector<Sublist> all = sublists_;
  if (form) all.insert(all.end(), form->sublists_.begin(), form->sublists_.end());
  return all;
}

}  // namespace harmos::input
