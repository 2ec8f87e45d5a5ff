#include <harmos/files/detail/Hdf5Source.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/ForeignReading.hpp>
#include <harmos/files/detail/Hdf5Node.hpp>
#include <harmos/files/detail/StudySeal.hpp>

namespace harmos::files {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error("Cannot read " + what + " of the study file.", base::ExitCode::input);
}

const Hdf5Values& attributeOf(const Hdf5Node& node, const std::string& name, bool isText) {
  const auto found = node.attributes.find(name);
  if (found == node.attributes.end() || found->second.isText != isText) refuse(name);
  return found->second;
}

}  // namespace

Hdf5Source Hdf5Source::open(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw base::Error("Cannot read " + path + ": " + std::strerror(errno) + ".", base::ExitCode::input);
  std::ostringstream content;
  content << stream.rdbuf();
  const std::string bytes = content.str();
  const std::string end = bytes.substr(bytes.size() - std::min(bytes.size(), studySeal("").size()));
  if (end != studySeal(bytes.substr(0, bytes.size() - end.size()))) {
    throw base::Error(
        path + " is no file of a study, or was damaged or changed since. Run the study again to restore it.",
        base::ExitCode::input);
  }
  std::shared_ptr<const Hdf5Node> root;
  readForeign(
      {path}, [&](ByteWriter& writer) { put(writer, readHdf5(path)); },
      [&](ByteReader& reader) { root = std::make_shared<const Hdf5Node>(takeHdf5(reader)); });
  return Hdf5Source(root);
}

Hdf5Source Hdf5Source::group(const std::string& name) const {
  const auto found = node_->members.find(name);
  if (found == node_->members.end()) refuse(name);
  return Hdf5Source(found->second);
}

std::vector<std::string> Hdf5Source::names() const {
  std::vector<std::string> names;
  for (const auto& member : node_->members) names.push_back(member.first);
  if (names.empty()) throw base::Error("The study file is empty.", base::ExitCode::input);
  return names;
}

bool Hdf5Source::has(const std::string& name) const {
  return node_->members.count(name) > 0;
}

bool Hdf5Source::hasAttribute(const std::string& name) const {
  return node_->attributes.count(name) > 0;
}

std::string Hdf5Source::text(const std::string& attribute) const {
  const std::vector<std::string> all = texts(attribute);
  if (all.empty()) refuse(attribute);
  return all.front();
}

double Hdf5Source::number(const std::string& attribute) const {
  const Hdf5Values& values = attributeOf(*node_, attribute, false);
  if (values.numbers.empty()) refuse(attribute);
  return values.numbers.front();
}

int Hdf5Source::integer(const std::string& attribute) const {
  const double value = number(attribute);
  if (!(std::abs(value) <= std::numeric_limits<int>::max())) refuse(attribute);
  return static_cast<int>(value);
}

std::vector<std::string> Hdf5Source::texts(const std::string& attribute) const {
  return attributeOf(*node_, attribute, true).texts;
}

std::vector<double> Hdf5Source::values() const {
  if (node_->values.isText) refuse("an array");
  return node_->values.numbers;
}

std::vector<std::string> Hdf5Source::textValues() const {
  if (!node_->values.isText) refuse("an array");
  return node_->values.texts;
}

}  // namespace harmos::files
