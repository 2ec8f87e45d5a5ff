#pragma once

#include <string>

namespace harmos::files {

/// Creates the folder that `path` lies in, and those above it. Throws base::Error when it cannot.
void createFolderOf(const std::string& path);

/// A file or folder that is to be removed again unless it is finished: by the destructor, or by removeUnfinished().
class Unfinished {
 public:
  /// From now on; need not exist yet.
  explicit Unfinished(std::string path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  /// As given.
  const std::string& path() const { return path_; }
  /// It stays, or was moved away.
  void finish();

 private:
  std::string path_;
};

/// What a file is to say when the process is ended amid anything; forgotten by the destructor.
class LastWords {
 public:
  /// From now on: `path` is to hold `content`, whatever it holds then.
  LastWords(std::string path, const std::string& content);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

 private:
  std::string path_;
};

/// Removes everything that this process has not finished and writes all LastWords, for a process that is ended amid
/// anything. May be called from any thread.
void removeUnfinished();

/// A file that appears under its name only when it is complete.
///
/// The writer works on temporaryPath() in the same directory; commit() renames it, which replaces an older file of that
/// name in one step. Without commit() the destructor removes the temporary file and the older file stays.
class AtomicFile {
 public:
  /// The folder of `path` must exist: one that was removed while results were computed is missed, not made anew.
  explicit AtomicFile(std::string path);

  /// As given.
  const std::string& path() const { return path_; }
  /// PATH.partial.PID; the writer creates it.
  const std::string& temporaryPath() const { return temporary_.path(); }
  /// The writer must have closed the file. Throws base::Error when it cannot be renamed.
  void commit();

 private:
  std::string path_;
  Unfinished temporary_;
};

/// Replaces the file `path` by `content` in one step, in a folder that exists; throws base::Error naming the file and
/// the cause.
void replaceFile(const std::string& path, const std::string& content);

}  // namespace harmos::files
