#include <harmos/cli/Arguments.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>

namespace harmos::cli {

Arguments::Arguments(const std::string& command, const std::vector<std::string>& words,
                     const std::vector<CommandOption>& options)
    : command_(command) {
  const auto fail = [&](const std::string& what) {
    throw base::Error(command + ": " + what + " Try \"" + command + " --help\".", base::ExitCode::input);
  };
  std::vector<std::string> names;
  for (const auto& option : options) names.push_back(option.name);

  bool onlyOperands = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (onlyOperands || word.size() < 2 || word[0] != '-') {
      operands_.push_back(word);
      continue;
    }
    if (word == "--") {
      onlyOperands = true;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto option = std::find_if(options.begin(), options.end(), [&](const auto& o) { return o.name == name; });
    if (option == options.end()) fail("unknown option \"" + name + "\". " + base::suggestName(name, names, "Options"));
    if (has(name) && !option->repeatable) fail("the option " + name + " is given twice.");
    std::string value;
    if (option->value.empty()) {
      if (equals != std::string::npos) fail("the option " + name + " takes no value.");
    } else if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else {
      if (i + 1 == words.size()) fail("the option " + name + " wants " + option->value + " after it.");
      value = words[++i];
    }
    // An empty word is a variable of the shell that was not set, hardly ever the wish for a default.
    if (!option->value.empty() && value.empty()) fail("the option " + name + " wants " + option->value + ", not \"\".");
    given_.push_back({name, value});
  }
}

std::vector<std::string> Arguments::values(const std::string& option) const {
  std::vector<std::string> result;
  for (const auto& given : given_)
    if (given.option == option) result.push_back(given.value);
  return result;
}

std::string Arguments::value(const std::string& option, const std::string& otherwise) const {
  const auto all = values(option);
  return all.empty() ? otherwise : all.back();
}

void Arguments::requireOperands(const std::vector<std::string>& names) const {
  if (operands_.size() == names.size()) return;
  std::string wanted;
  for (const auto& name : names) wanted += " " + name;
  throw base::Error(command_ + " wants" + wanted + "; " + std::to_string(operands_.size()) + " given. Try \"" +
                        command_ + " --help\".",
                    base::ExitCode::input);
}

}  // namespace harmos::cli
