#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <harmos/laws/LawRegistry.hpp>

namespace harmos::laws {

/// A built-in law with the given numbers, multiplied at every load step by the given histories, with the given lists,
/// and else its defaults.
inline std::unique_ptr<InterfaceLaw> makeLaw(const std::string& law, const std::map<std::string, double>& values = {},
                                             const std::map<std::string, std::vector<double>>& histories = {},
                                             const std::map<std::string, std::vector<double>>& lists = {}) {
  const LawRegistry laws = builtInLaws();
  input::Parameters parameters("law");
  parameters.set("Type", law);
  for (const input::ParameterSpec& form : laws.forms()) {
    if (form.name() != law) continue;
    for (const auto& entry : form.entries()) {
      if (!entry->defaultText) continue;
      if (entry->type == input::ParameterType::text) {
        parameters.set(entry->name, *entry->defaultText);
      } else if (entry->type == input::ParameterType::flag) {
        parameters.set(entry->name, *entry->defaultText == "true");
      } else {
        parameters.set(entry->name, std::stod(*entry->defaultText));
      }
    }
  }
  for (const auto& [name, value] : values) parameters.set(name, value);
  for (const auto& [name, list] : lists) parameters.set(name, list);
  auto known = std::make_shared<input::Histories>();
  for (const auto& [name, perStep] : histories) {
    known->add(name, perStep);
    parameters.set(name + " History", name);
  }
  parameters.attach(known);
  return laws.create(parameters);
}

}  // namespace harmos::laws
