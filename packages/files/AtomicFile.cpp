#include <harmos/files/AtomicFile.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <system_error>

#include <unistd.h>

#include <harmos/base/Error.hpp>

namespace harmos::files {

namespace fs = std::filesystem;

void createFolderOf(const std::string& path) {
  const fs::path directory = fs::path(path).parent_path();
  std::error_code error;
  if (!directory.empty()) fs::create_directories(directory, error);
  if (error) throw base::Error("Cannot create the directory " + directory.string() + ": " + error.message() + ".");
}

namespace {

std::mutex guard;

/// Paths; behind `guard`. Never destroyed, because a thread may ask for them while the process ends.
std::set<std::string>& unfinished() {
  static auto& paths = *new std::set<std::string>;
  return paths;
}

/// Contents by path; behind `guard`, and as lasting.
std::map<std::string, std::string>& lastWords() {
  static auto& words = *new std::map<std::string, std::string>;
  return words;
}

}  // namespace

LastWords::LastWords(std::string path, const std::string& content) : path_(std::move(path)) {
  const std::lock_guard<std::mutex> lock(guard);
  lastWords()[path_] = content;
}

LastWords::~LastWords() {
  const std::lock_guard<std::mutex> lock(guard);
  lastWords().erase(path_);
}

Unfinished::Unfinished(std::string path) : path_(std::move(path)) {
  const std::lock_guard<std::mutex> lock(guard);
  unfinished().insert(path_);
}

Unfinished::~Unfinished() {
  const std::lock_guard<std::mutex> lock(guard);
  if (unfinished().erase(path_) == 0) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void Unfinished::finish() {
  const std::lock_guard<std::mutex> lock(guard);
  unfinished().erase(path_);
}

void removeUnfinished() {
  const std::lock_guard<std::mutex> lock(guard);
  std::error_code ignored;
  for (const std::string& path : unfinished()) fs::remove_all(path, ignored);
  for (const auto& [path, content] : lastWords()) {
    const std::string aside = path + ".partial." + std::to_string(::getpid());
    std::ofstream(aside, std::ios::binary) << content;
    fs::rename(aside, path, ignored);
  }
}

// The process number keeps two runs into one directory from writing the same temporary file.
AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), temporary_(path_ + ".partial." + std::to_string(::getpid())) {}

void AtomicFile::commit() {
  std::error_code error;
  fs::rename(temporary_.path(), path_, error);
  if (error) throw base::Error("Cannot write " + path_ + ": " + error.message() + ".");
  temporary_.finish();
}

void replaceFile(const std::string& path, const std::string& content) {
  AtomicFile file(path);
  std::ofstream stream(file.temporaryPath(), std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) throw base::Error("Cannot write " + path + ": " + std::strerror(errno) + ".");
  file.commit();
}

}  // namespace harmos::files
