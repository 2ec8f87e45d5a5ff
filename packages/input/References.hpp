#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include <harmos/input/InputTree.hpp>

namespace harmos::input {

/// Which entries of an input refer to which of its Values.
class References {
 public:
  /// Walks the input once.
  explicit References(const InputTree& input);

  /// The paths "List/Sublist/Name" of all entries whose value is `reference`, such as "$mu", or a list with it, in the
  /// order of the input; owned by this object.
  const std::vector<std::string>& to(const std::string& reference) const;

 private:
  std::unordered_map<std::string, std::vector<std::string>> entries_;
};

}  // namespace harmos::input
