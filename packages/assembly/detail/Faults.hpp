#pragma once

#include <string>

namespace harmos::assembly {

/// What is wrong with an assembly: the first faults as sentences, of the others how many there are.
class Faults {
 public:
  /// `where`: body or interface, as messages name it; `what`: a sentence without a full stop.
  void add(const std::string& where, const std::string& what);
  /// How many there are.
  int count() const { return count_; }
  /// A line for each of the first ones, and one for the others.
  std::string text() const;

 private:
  std::string lines_;
  int count_ = 0;
};

}  // namespace harmos::assembly
