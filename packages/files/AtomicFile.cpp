#include <harmos/files/AtomicFile.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <unistd.h>

#include <harmos/base/Error.hpp>

namespace harmos::files {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  // The process number keeps two runs into one directory from writing the same temporary file.
  temporary_ = path_ + ".partial." + std::to_string(::getpid());
  const fs::path directory = fs::path(path_).parent_path();
  std::error_code error;
  if (!directory.empty()) fs::create_directories(directory, error);
  if (error) throw base::Error("Cannot create the directory " + directory.string() + ": " + error.message() + ".");
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) throw base::Error("Cannot write " + path_ + ": " + error.message() + ".");
  committed_ = true;
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
