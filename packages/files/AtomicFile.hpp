#pragma once

#include <string>

namespace harmos::files {

/// A file that appears under its name only when it is complete.
///
/// The writer works on temporaryPath() in the same directory; commit() renames it, which replaces an older file of that
/// name in one step. Without commit() the destructor removes the temporary file and the older file stays.
class AtomicFile {
 public:
  /// Creates the directory of `path` if needed; throws base::Error when that fails.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// As given.
  const std::string& path() const { return path_; }
  /// PATH.partial.PID; the writer creates it.
  const std::string& temporaryPath() const { return temporary_; }
  /// The writer must have closed the file. Throws base::Error when it cannot be renamed.
  void commit();

 private:
  std::string path_, temporary_;
  bool committed_ = false;
};

/// Replaces the file `path` by `content` in one step; throws base::Error naming the file and the cause.
void replaceFile(const std::string& path, const std::string& content);

}  // namespace harmos::files
