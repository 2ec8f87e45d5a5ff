#pragma once

#include <functional>
#include <string>
#include <vector>

/// What is read, and sound files of that kind to begin with.
struct Target {
  std::vector<std::string> seeds;  // contents of files
  bool isText;
  /// Reads a file of this content; throws what the reader throws.
  std::function<void(const std::string&)> read;
};

/// Of the kind "xml" (scenes and studies of `sources`, a folder), "exodus" or "study"; `folder` is for files.
Target makeTarget(const std::string& kind, const std::string& sources, const std::string& folder);
