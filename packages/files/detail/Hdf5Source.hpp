#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace harmos::files {

struct Hdf5Node;

/// A group or array of an HDF5 file, and what is in it, in memory. All members throw base::Error (input) when it is not
/// there or of another kind. Copies share what was read.
class Hdf5Source {
 public:
  /// Reads all of a file that Hdf5Group::image() made and nothing has changed since.
  static Hdf5Source open(const std::string& path);
  /// Of a group or an array.
  Hdf5Source group(const std::string& name) const;
  /// What a group holds, in alphabetical order.
  std::vector<std::string> names() const;
  /// Whether names() has this one.
  bool has(const std::string& name) const;

  bool hasAttribute(const std::string& name) const;
  std::string text(const std::string& attribute) const;
  double number(const std::string& attribute) const;
  int integer(const std::string& attribute) const;
  std::vector<std::string> texts(const std::string& attribute) const;
  /// Of an array, by rows.
  std::vector<double> values() const;
  std::vector<std::string> textValues() const;

 private:
  explicit Hdf5Source(std::shared_ptr<const Hdf5Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Hdf5Node> node_;
};

}  // namespace harmos::files
