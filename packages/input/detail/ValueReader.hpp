#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::input {

/// Reads the values of parameters as their declarations want them; part of check().
///
/// Knows the entries of the root's lists "Values" and "Histories", which values may refer to.
class ValueReader {
 public:
  /// `errors` must outlive the reader.
  ValueReader(const InputNode& root, ErrorList& errors);

  /// Nothing when the value is not what `entry` declares, which is then reported. `path` is that of the parameter.
  std::optional<Parameters::Value> read(const InputNode& node, const ParameterEntry& entry, const std::string& path);

 private:
  std::optional<double> number(const std::string& text, const ParameterEntry& entry, const std::string& where);
  std::optional<int> integer(const std::string& text, const ParameterEntry& entry, const std::string& where);
  std::optional<std::string> text(const std::string& text, const ParameterEntry& entry, const std::string& where);
  bool inRange(double number, const std::string& text, const ParameterEntry& entry, const std::string& where);

  ErrorList& errors_;
  std::map<std::string, std::optional<double>> values_;  // nothing: given but not a number
  std::vector<std::string> histories_;                   // in their order
  std::unordered_set<std::string> isHistory_;
};

/// What to write in XML: <Parameter name="..." type="..." value="..."/>.
std::string parameterExample(const ParameterEntry& entry);

}  // namespace harmos::input
