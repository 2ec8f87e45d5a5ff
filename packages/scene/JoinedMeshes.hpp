#pragma once

#include <string>
#include <vector>

#include <harmos/mortar/JoinedSurface.hpp>

namespace harmos::scene {

/// What is to be said of an interface whose meshes do not match.
struct JoinedMeshes {
  std::string interface;      // its name
  int pointsOn = 0;           // 0 or 1: the side whose corner nodes are the points
  int points = 0;             // how many there are
  mortar::JoinReport report;  // of both sides
  bool isOfSideSets = false;  // rather than of all faces of two parts
  bool hasGaps = false;       // its law asks for gaps

  /// The same as lines for a user, each indented by two blanks and ended.
  std::string text() const;
  /// What is most likely not meant, a sentence each: faces of side sets that are left out although others lie opposite
  /// them, and parts that overlap.
  std::vector<std::string> warnings() const;
};

}  // namespace harmos::scene
