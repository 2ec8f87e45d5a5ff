#include <harmos/files/OutputGuard.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <system_error>

#include <unistd.h>

#include <harmos/base/Error.hpp>

namespace harmos::files {

namespace {

namespace fs = std::filesystem;

// What files are called until they are complete.
constexpr const char* longestEnding = ".partial.1234567";
constexpr const char* repair = "  Write into another folder or under another name (--output). Nothing was written.";

bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

fs::path nearestExisting(const fs::path& folder) {
  fs::path existing = folder.empty() ? fs::path(".") : folder;
  while (!isThere(existing) && existing.has_relative_path()) {
    existing = existing.parent_path().empty() ? fs::path(".") : existing.parent_path();
  }
  return existing;
}

bool isRefused(const fs::path& path) {
  return ::access(path.c_str(), F_OK) != 0 && errno == ENAMETOOLONG;
}

bool isTooLong(const fs::path& path) {
  if (isRefused(path)) return true;
  // What is wrong with a name is not said where the folder before it is not there.
  const fs::path existing = nearestExisting(path.parent_path());
  return std::any_of(path.begin(), path.end(), [&](const fs::path& name) { return isRefused(existing / name); });
}

/// Why no files can be written into a folder, which need not exist; empty: nothing is known.
std::string faultOfFolder(const fs::path& folder) {
  const fs::path existing = nearestExisting(folder);
  const auto because = [&](const std::string& reason) {
    return "No result can be written into " + (folder.empty() ? "the present folder" : folder.string()) + ": " +
           reason + ".\n";
  };
  std::error_code error;
  const fs::file_status status = fs::status(existing, error);
  if (isTooLong(folder)) return because("its name is too long");
  if (!fs::exists(status)) return because(existing.string() + " is a link to what is not there");
  if (!fs::is_directory(status)) return because(existing.string() + " is no folder");
  if (::access(existing.c_str(), W_OK | X_OK) != 0) {
    const std::string reason = std::strerror(errno);
    return because(existing == folder || folder.empty() ? reason : existing.string() + ": " + reason);
  }
  return "";
}

std::string faultOfFile(const fs::path& file) {
  const auto because = [&](const std::string& reason) {
    return "The result " + file.string() + " cannot be written: " + reason + ".\n";
  };
  if (!file.has_filename()) return because("it names a folder");
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) return because("it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return because("it is no file, but a device or the like");
  if (isTooLong(file.string() + longestEnding)) return because("its name is too long");
  return faultOfFolder(file.parent_path());
}

/// Each fault is told once.
void refuse(const std::vector<std::string>& faults) {
  std::set<std::string> told;
  std::string text;
  for (const std::string& fault : faults) {
    if (told.insert(fault).second) text += fault;
  }
  if (!text.empty()) throw base::Error(text + repair, base::ExitCode::input);
}

}  // namespace

void demandWritable(const std::vector<std::string>& outputs) {
  std::vector<std::string> faults;
  for (const std::string& output : outputs) faults.push_back(faultOfFile(output));
  refuse(faults);
}

void demandFolder(const std::string& output) {
  refuse({faultOfFolder(output)});
}

void demandDistinct(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  std::string text;
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code isMissing;
      if (!fs::equivalent(output, input, isMissing)) continue;
      text += "The result " + output + " would replace the input " + input +
              (output == input ? ".\n" : ", which is the same file.\n");
      break;
    }
  }
  if (text.empty()) return;
  throw base::Error(text + repair, base::ExitCode::input);
}

}  // namespace harmos::files
