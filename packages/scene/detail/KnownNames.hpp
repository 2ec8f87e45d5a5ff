#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// User-named lists of a scene by their names: in their order, and found at once however many they are.
class KnownNames {
 public:
  /// Those of `lists`, which must stay where they are, as those of add() must.
  explicit KnownNames(const std::vector<input::Parameters>& lists);

  /// Adds those of `lists` behind the others; of one name the first counts.
  void add(const std::vector<input::Parameters>& lists);
  /// Whether there is a list of this name.
  bool has(const std::string& name) const { return find(name) != nullptr; }
  /// The list of this name; null when there is none.
  const input::Parameters* find(const std::string& name) const;
  /// All names, for messages.
  const std::vector<std::string>& inOrder() const { return inOrder_; }

 private:
  std::vector<std::string> inOrder_;
  std::unordered_map<std::string, const input::Parameters*> lists_;
};

}  // namespace harmos::scene
