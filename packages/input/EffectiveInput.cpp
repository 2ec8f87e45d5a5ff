#include <harmos/input/EffectiveInput.hpp>

#include <harmos/base/Numerals.hpp>
#include <harmos/input/ParameterSpec.hpp>

namespace harmos::input {

namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      // A parser turns bare line breaks and tabs in attributes into blanks.
      case '\n':
        out += "&#10;";
        break;
      case '\r':
        out += "&#13;";
        break;
      case '\t':
        out += "&#9;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

template <class T, class Format>
std::string items(const std::vector<T>& values, Format format) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ", ") + format(value);
  return "{" + text + "}";
}

struct ToText {
  std::string type, value;
  void operator()(double v) { *this = {xmlType(ParameterType::number), base::toText(v)}; }
  void operator()(int v) { *this = {xmlType(ParameterType::integer), std::to_string(v)}; }
  void operator()(bool v) { *this = {xmlType(ParameterType::flag), v ? "true" : "false"}; }
  void operator()(const std::string& v) { *this = {xmlType(ParameterType::text), v}; }
  void operator()(const std::vector<double>& v) { *this = {xmlType(ParameterType::numbers), items(v, base::toText)}; }
  void operator()(const std::vector<std::string>& v) {
    *this = {xmlType(ParameterType::texts), items(v, [](const std::string& s) { return s; })};
  }
};

void write(const Parameters& list, const std::string& indent, std::string& xml) {
  xml += indent + "<ParameterList name=\"" + escaped(list.name()) + "\">\n";
  for (const Parameters::Entry& entry : list.entries()) {
    ToText text;
    std::visit([&text](const auto& value) { text(value); }, entry.value);
    xml += indent + "  <Parameter name=\"" + escaped(entry.name) + "\" type=\"" + text.type + "\" value=\"" +
           escaped(text.value) + "\"/>\n";
  }
  for (const Parameters::Sublist& sublist : list.sublists()) {
    if (sublist.isNamed) xml += indent + "  <ParameterList name=\"" + escaped(sublist.name) + "\">\n";
    for (const Parameters& child : sublist.lists) write(child, indent + (sublist.isNamed ? "    " : "  "), xml);
    if (sublist.isNamed) xml += indent + "  </ParameterList>\n";
  }
  xml += indent + "</ParameterList>\n";
}

}  // namespace

std::string effectiveInput(const Parameters& parameters) {
  std::string xml;
  write(parameters, "", xml);
  return xml;
}

}  // namespace harmos::input
