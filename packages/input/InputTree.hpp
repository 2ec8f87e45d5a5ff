#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace harmos::input {

/// One element of a parameter list in XML, as it was written and where.
struct InputNode {
  static constexpr const char* listTag = "ParameterList";   // the tag of a list
  static constexpr const char* parameterTag = "Parameter";  // the tag of an entry

  std::string tag;                                              // as written; others than these two are kept, too
  std::vector<std::pair<std::string, std::string>> attributes;  // names and values, in the order of the file
  /// "file:line", line of the opening tag counted from 1; "--set" for what an override has written; of a
  /// Teuchos::ParameterList its source, without a line.
  std::string location;
  std::vector<InputNode> children;  // in the order of the file
  /// The first text between tags, which a parameter list cannot hold, mostly empty.
  std::string strayText, strayLocation;  // strayLocation: its "file:line"

  /// Whether the tag is listTag.
  bool isList() const { return tag == listTag; }
  /// Whether the tag is parameterTag.
  bool isParameter() const { return tag == parameterTag; }
  /// The value of an attribute, owned by the node; null when absent.
  const std::string* attribute(std::string_view name) const;
  /// Replaces the value of an attribute, or adds it after the others.
  void setAttribute(const std::string& name, const std::string& value);
  /// The attribute "name", empty when absent.
  std::string name() const;
  /// The first child of this name, list or parameter, owned by this node; null when absent.
  InputNode* child(std::string_view name);
  /// The same, to be read only.
  const InputNode* child(std::string_view name) const;
};

/// A parameter list in the XML of Teuchos, read but not checked: every element with its file and line.
class InputTree {
 public:
  /// Reads a file, named in messages as in `path`. Throws base::Error (input) when it cannot be read or is empty, is
  /// not well-formed XML, refers to other files or nests more than 100 lists. Not collective: every rank that calls it
  /// reads the file.
  static InputTree fromFile(const std::string& path);
  /// Reads XML from memory; `source` stands for the file name in messages. Throws base::Error as fromFile() does.
  static InputTree fromText(const std::string& xml, const std::string& source);
  /// For a host that configures Harmos from its own list; messages then say `source` and no line. The list is copied.
  /// Entries of a type that XML has no name for keep the name of their C++ type, which check() refuses.
  static InputTree fromTeuchos(const Teuchos::ParameterList& list, const std::string& source);

  InputNode root;  // the outermost list; without a name when it comes from Teuchos
};

}  // namespace harmos::input
