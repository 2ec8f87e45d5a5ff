#include <harmos/input/InputTree.hpp>

#include <expat.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::input {

namespace {

constexpr std::size_t deepestList = 100;  // guards the recursions over the tree
constexpr int pieceSize = 1 << 20;        // characters that are read at once

/// State of expat's callbacks: the elements that are open, the innermost last.
struct Reader {
  XML_Parser parser;
  std::string source;
  InputNode root;
  std::vector<InputNode*> open;
  std::string problem;

  std::string location() const { return source + ":" + std::to_string(XML_GetCurrentLineNumber(parser)); }

  void start(const char* tag, const char** attributes) {
    InputNode node;
    node.tag = tag;
    node.location = location();
    for (; *attributes; attributes += 2) node.attributes.emplace_back(attributes[0], attributes[1]);
    if (open.size() == deepestList) {
      problem = location() + ": lists are nested more than " + std::to_string(deepestList) + " deep.";
      XML_StopParser(parser, XML_FALSE);
      return;
    }
    if (open.empty()) {
      root = std::move(node);
      open.push_back(&root);
    } else {
      // Only the innermost open element grows, so the addresses of the open ones stay.
      open.push_back(&open.back()->children.emplace_back(std::move(node)));
    }
  }

  void text(const char* characters, int length) {
    std::string given(characters, static_cast<std::size_t>(length));
    const char* blanks = " \t\r\n";
    const auto first = given.find_first_not_of(blanks);
    if (first == std::string::npos || open.empty() || !open.back()->strayText.empty()) return;
    open.back()->strayText = given.substr(first, given.find_last_not_of(blanks) - first + 1);
    open.back()->strayLocation = location();
  }

  /// The handler that calls this then returns XML_STATUS_ERROR.
  void refuse(const std::string& what, const std::string& repair) {
    problem = location() + ": " + what + "\n  " + repair;
  }
};

InputTree treeOf(std::istream& stream, const std::string& source) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr), &XML_ParserFree);
  Reader reader;
  reader.parser = parser.get();
  reader.source = source;
  XML_SetUserData(parser.get(), &reader);
  XML_SetElementHandler(
      parser.get(),
      [](void* data, const char* tag, const char** attributes) { static_cast<Reader*>(data)->start(tag, attributes); },
      [](void* data, const char*) { static_cast<Reader*>(data)->open.pop_back(); });
  XML_SetCharacterDataHandler(parser.get(), [](void* data, const char* characters, int length) {
    static_cast<Reader*>(data)->text(characters, length);
  });
  // What stands in other files is never read, and expat would pass over it in silence.
  XML_SetExternalEntityRefHandler(
      parser.get(), [](XML_Parser parsing, const char*, const char*, const char* file, const char*) -> int {
        static_cast<Reader*>(XML_GetUserData(parsing))
            ->refuse("the external entity \"" + std::string(file ? file : "") + "\" is not read.",
                     "Write its content into the file.");
        return XML_STATUS_ERROR;
      });
  XML_SetNotStandaloneHandler(parser.get(), [](void* data) -> int {
    static_cast<Reader*>(data)->refuse("the declarations of the DOCTYPE that stand elsewhere are not read.",
                                       "Remove the DOCTYPE and write what its entities stand for.");
    return XML_STATUS_ERROR;
  });
  // Piece by piece: what is no XML may be without end, such as /dev/zero.
  std::vector<char> piece(pieceSize);
  XML_Status status = XML_STATUS_OK;
  while (status != XML_STATUS_ERROR && stream) {
    stream.read(piece.data(), pieceSize);
    status = XML_Parse(parser.get(), piece.data(), static_cast<int>(stream.gcount()), stream ? XML_FALSE : XML_TRUE);
  }
  if (status == XML_STATUS_ERROR) {
    if (reader.problem.empty()) {
      reader.problem =
          reader.location() + ": not well-formed XML: " + XML_ErrorString(XML_GetErrorCode(parser.get())) +
          (reader.open.empty() ? "" : ", inside <" + reader.open.back()->tag + "> of " + reader.open.back()->location) +
          ".";
    }
    throw base::Error(reader.problem + "\n1 error; nothing was run.", base::ExitCode::input);
  }
  InputTree tree;
  tree.root = std::move(reader.root);
  return tree;
}

template <class T>
std::string arrayText(const Teuchos::Array<T>& values) {
  std::ostringstream text;
  text << "{";
  for (int i = 0; i < values.size(); ++i) {
    if (i > 0) text << ", ";
    if constexpr (std::is_same_v<T, double>) {
      text << base::toText(values[i]);
    } else {
      text << values[i];
    }
  }
  text << "}";
  return text.str();
}

std::pair<std::string, std::string> typeAndValue(const Teuchos::ParameterEntry& entry) {
  const Teuchos::any& any = entry.getAny(false);
  if (entry.isType<double>()) return {"double", base::toText(Teuchos::any_cast<double>(any))};
  if (entry.isType<int>()) return {"int", std::to_string(Teuchos::any_cast<int>(any))};
  if (entry.isType<bool>()) return {"bool", Teuchos::any_cast<bool>(any) ? "true" : "false"};
  if (entry.isType<std::string>()) return {"string", Teuchos::any_cast<std::string>(any)};
  if (entry.isType<Teuchos::Array<double>>()) {
    return {"Array(double)", arrayText(Teuchos::any_cast<Teuchos::Array<double>>(any))};
  }
  if (entry.isType<Teuchos::Array<int>>()) {
    return {"Array(int)", arrayText(Teuchos::any_cast<Teuchos::Array<int>>(any))};
  }
  if (entry.isType<Teuchos::Array<std::string>>()) {
    return {"Array(string)", arrayText(Teuchos::any_cast<Teuchos::Array<std::string>>(any))};
  }
  return {any.typeName(), ""};
}

InputNode listNode(const Teuchos::ParameterList& list, const std::string& name, const std::string& source) {
  InputNode node;
  node.tag = InputNode::listTag;
  node.location = source;
  if (!name.empty()) node.setAttribute("name", name);
  for (auto i = list.begin(); i != list.end(); ++i) {
    const std::string& key = list.name(i);
    if (list.entry(i).isList()) {
      node.children.push_back(listNode(list.sublist(key), key, source));
      continue;
    }
    const auto [type, value] = typeAndValue(list.entry(i));
    InputNode parameter;
    parameter.tag = InputNode::parameterTag;
    parameter.location = source;
    parameter.attributes = {{"name", key}, {"type", type}, {"value", value}};
    node.children.push_back(std::move(parameter));
  }
  return node;
}

}  // namespace

const std::string* InputNode::attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes) {
    if (key == name) return &value;
  }
  return nullptr;
}

void InputNode::setAttribute(const std::string& name, const std::string& value) {
  for (auto& [key, old] : attributes) {
    if (key == name) {
      old = value;
      return;
    }
  }
  attributes.emplace_back(name, value);
}

std::string InputNode::name() const {
  const std::string* given = attribute("name");
  return given ? *given : "";
}

const InputNode* InputNode::child(std::string_view name) const {
  for (const InputNode& node : children) {
    const std::string* given = node.attribute("name");
    if ((given ? *given == name : name.empty()) && (node.isList() || node.isParameter())) return &node;
  }
  return nullptr;
}

InputNode* InputNode::child(std::string_view name) {
  return const_cast<InputNode*>(static_cast<const InputNode*>(this)->child(name));
}

InputTree InputTree::fromFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  // Reading a directory opens it but fails at the first character.
  if (!file || file.peek() == std::ifstream::traits_type::eof()) {
    throw base::Error(
        path + ": cannot be read (" + (file.is_open() ? "empty or not a file" : std::strerror(errno)) + ").",
        base::ExitCode::input);
  }
  return treeOf(file, path);
}

InputTree InputTree::fromText(const std::string& xml, const std::string& source) {
  std::istringstream stream(xml);
  return treeOf(stream, source);
}

InputTree InputTree::fromTeuchos(const Teuchos::ParameterList& list, const std::string& source) {
  InputTree tree;
  tree.root = listNode(list, "", source);
  return tree;
}

}  // namespace harmos::input
