#include <harmos/input/Documentation.hpp>

#include <map>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::input {

namespace {

std::string necessity(const ParameterEntry& entry) {
  if (entry.isRequired()) return "required";
  if (!entry.defaultText) return "optional";
  return entry.defaultText->empty() ? "default: empty" : "default: " + *entry.defaultText;
}

/// One line per parameter; the companion of a varying number is mentioned, not listed.
std::string describe(const ParameterEntry& entry) {
  std::string text = "- `" + entry.name + "` (" + xmlType(entry.type);
  if (!entry.unitName.empty()) text += ", [" + entry.unitName + "]";
  text += ", " + necessity(entry) + ")";
  if (!entry.range().empty()) text += ", " + entry.range();
  if (!entry.choices.empty()) text += ", one of: " + base::joinNames(entry.choices, entry.choices.size());
  text += ". " + entry.description;
  if (entry.varies) text += " May follow a history: `" + entry.name + " History`.";
  return text + "\n";
}

std::string parameterXml(const std::string& name, ParameterType type, const std::string& value) {
  return "      <Parameter name=\"" + name + "\" type=\"" + xmlType(type) + "\" value=\"" + value + "\"/>\n";
}

std::string listXml(const std::string& name, const std::string& inside) {
  return "\n    <ParameterList name=\"" + name + "\">\n" + inside + "    </ParameterList>\n";
}

/// What must be given and what has an example, else with values to be replaced; empty when there is nothing.
std::string snippet(const ParameterSpec& spec, const ParameterSpec* form, const std::string& name) {
  std::string text;
  for (const ParameterEntry& entry : spec.entriesWith(form)) {
    if (!entry.isRequired() && entry.exampleText.empty()) continue;
    std::string value = entry.choices.empty() ? "..." : entry.choices.front();
    if (!entry.exampleText.empty()) value = entry.exampleText;
    if (form && entry.name == "Type") value = form->name();
    text += parameterXml(entry.name, entry.type, value);
  }
  for (const auto& sublist : spec.sublistsWith(form)) {
    if (sublist.required) text += "      <ParameterList name=\"" + sublist.name + "\"> ... </ParameterList>\n";
  }
  return text.empty() ? "" : listXml(name, text);
}

class Writer {
 public:
  explicit Writer(std::string topic) : topic_(std::move(topic)) {}

  /// `isChosen`: a list above is the topic. `form` is null for the list itself.
  void list(const ParameterSpec& spec, const ParameterSpec* form, const std::string& path, const std::string& name,
            bool isChosen) {
    const ParameterSpec& shown = form ? *form : spec;
    const bool isShown = isChosen || shown.name() == topic_;
    topics_.push_back(shown.name());
    if (isShown) {
      const std::string heading = path + (form ? ", Type = " + form->name() : "");
      const std::string body = bodyOf(spec, form, name);
      const auto [first, isNew] = headings_.emplace(body, heading);
      text_ += "## " + heading + "\n\n" + (form && !isNew ? "As for " + first->second + ".\n" : body) + "\n";
    }
    for (const auto& sublist : shown.sublists()) {
      const std::string below = path + " / " + sublist.name;
      if (sublist.kind == ParameterSpec::ListKind::numbers) {
        numbers(*sublist.spec, below, isShown);
      } else if (sublist.kind == ParameterSpec::ListKind::named) {
        list(*sublist.spec, nullptr, below + " / (your name)", "your name", isShown);
      } else {
        list(*sublist.spec, nullptr, below, sublist.name, isShown);
      }
    }
    if (form) return;
    for (const ParameterSpec& f : spec.forms()) list(spec, &f, path, name, isShown);
  }

  /// A page that no list has.
  void page(const Page& page) {
    topics_.push_back(page.name);
    if (topic_.empty() || page.name == topic_) text_ += "## " + page.name + "\n\n" + page.text + "\n";
  }

  std::string text() const {
    if (text_.empty()) {
      throw base::Error(
          "There is nothing called \"" + topic_ + "\" in the input.\n  " + base::suggestName(topic_, topics_, "Topics"),
          base::ExitCode::input);
    }
    return text_;
  }

 private:
  static std::string bodyOf(const ParameterSpec& spec, const ParameterSpec* form, const std::string& name) {
    const ParameterSpec& shown = form ? *form : spec;
    std::string text, facts;
    if (!shown.summary().empty()) text += shown.summary() + "\n";
    if (!shown.equation().empty()) text += "\nEquation: `" + shown.equation() + "`\n";
    if (!shown.source().empty()) text += "\nSource: " + shown.source() + ".\n";
    for (const auto& entry : shown.entries()) facts += describe(*entry);
    if (!form && !spec.forms().empty()) {
      std::vector<std::string> types;
      for (const ParameterSpec& f : spec.forms()) types.push_back(f.name());
      facts += "- `Type` (string, required), one of: " + base::joinNames(types, types.size()) + ".\n";
    }
    for (const auto& sublist : shown.sublists()) {
      facts += "- list `" + sublist.name + "` (" + (sublist.required ? "required" : "optional") + ").\n";
    }
    for (const auto& field : shown.outputs()) {
      facts += "- adds `" + field.name + "` [" + field.unit + "] to the results: " + field.doc + ".\n";
    }
    if (!facts.empty()) text += (shown.summary().empty() ? "" : "\n") + facts;
    if (form || spec.forms().empty()) text += snippet(spec, form, name);
    return text;
  }

  void numbers(const ParameterSpec& spec, const std::string& path, bool isChosen) {
    topics_.push_back(spec.name());
    if (!isChosen && spec.name() != topic_) return;
    text_ += "## " + path + "\n\n" + spec.summary() + "\n" +
             listXml(spec.name(), parameterXml("your name", ParameterType::number, "...")) + "\n";
  }

  std::string topic_, text_;
  std::vector<std::string> topics_;
  std::map<std::string, std::string> headings_;  // under which each text stands for the first time
};

}  // namespace

std::string documentation(const ParameterSpec& spec, const std::string& topic) {
  return documentation(std::vector<ParameterSpec>{spec}, topic);
}

std::string documentation(const std::vector<ParameterSpec>& specs, const std::string& topic,
                          const std::vector<Page>& pages) {
  Writer writer(topic);
  for (const ParameterSpec& spec : specs) writer.list(spec, nullptr, spec.name(), spec.name(), topic.empty());
  for (const Page& page : pages) writer.page(page);
  return writer.text();
}

}  // namespace harmos::input
