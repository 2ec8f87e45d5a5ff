#pragma once

#include <string>
#include <utility>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace harmos::input {

/// One element of a parameter list in XML, as it was written and where.
struct InputNode {
  static constexpr const char* listTag = "ParameterList";
  static constexpr const char* parameterTag = "Parameter";

  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string location;  // "file:line", or "--set"
  std::vector<InputNode> children;
  std::string strayText, strayLocation;  // the first text between tags, which a parameter list cannot hold

  bool isList() const { return tag == listTag; }
  bool isParameter() const { return tag == parameterTag; }
  /// Null when absent.
  const std::string* attribute(const std::string& name) const;
  void setAttribute(const std::string& name, const std::string& value);
  /// The attribute "name", empty when absent.
  std::string name() const;
  /// The first child of this name, list or parameter; null when absent.
  InputNode* child(const std::string& name);
  const InputNode* child(const std::string& name) const;
};

/// A parameter list in the XML of Teuchos, read but not checked: every element with its file and line.
class InputTree {
 public:
  /// Throws base::Error (input) when the file cannot be read, is not well-formed XML or refers to other files.
  static InputTree fromFile(const std::string& path);
  /// `source` stands for the file name in messages.
  static InputTree fromText(const std::string& xml, const std::string& source);
  /// For a host that configures Harmos from its own list; messages then say `source` and no line.
  static InputTree fromTeuchos(const Teuchos::ParameterList& list, const std::string& source);

  InputNode root;
};

}  // namespace harmos::input
