#include <harmos/files/PendingResults.hpp>

#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/AtomicFile.hpp>

namespace harmos::files {

namespace fs = std::filesystem;

namespace {

constexpr const char* ending = ".partial.";

std::string folderAside(const ResultFiles& files) {
  return fs::path(files.parts).replace_extension(ending + std::to_string(::getpid())).string();
}

/// A descriptor of a folder that nobody else has locked, or -1.
int lockFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  if (descriptor >= 0) ::close(descriptor);
  return -1;
}

/// Of processes that were killed: those that live hold a lock.
void removeLeftOver(const ResultFiles& files) {
  const fs::path parts(files.parts);
  const std::string beginning = parts.stem().string() + ending;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parts.has_parent_path() ? parts.parent_path() : ".", error)) {
    if (entry.path().filename().string().rfind(beginning, 0) != 0) continue;
    const int descriptor = lockFolder(entry.path());
    if (descriptor < 0) continue;
    fs::remove_all(entry.path(), error);
    ::close(descriptor);
  }
}

}  // namespace

PendingResults::PendingResults(ResultFiles final)
    : final_(std::move(final)), folder_(folderAside(final_)), aside_(folder_.path(), final_.parts) {
  createFolderOf(final_.parts);
  removeLeftOver(final_);
  createFolderOf(aside_.parts);
  lock_ = lockFolder(folder_.path());
}

PendingResults::~PendingResults() {
  if (lock_ >= 0) ::close(lock_);
}

void PendingResults::commit(bool hasFields) const {
  const auto move = [](const std::string& from, const std::string& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) throw base::Error("Cannot write " + to + ": " + error.message() + ".");
  };
  const auto remove = [](const std::string& path) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw base::Error("Cannot remove " + path + ": " + error.message() + ".");
  };
  for (const auto path : {&ResultFiles::parts, &ResultFiles::interfaces}) {
    if (hasFields) {
      move(aside_.*path, final_.*path);
    } else {
      remove(final_.*path);
    }
  }
  move(aside_.history, final_.history);
  move(aside_.effectiveInput, final_.effectiveInput);
}

}  // namespace harmos::files
