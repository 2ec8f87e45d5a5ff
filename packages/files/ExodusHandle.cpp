#include <harmos/files/detail/ExodusHandle.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>

#include <exodusII.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/CompleteSize.hpp>

namespace harmos::files {

namespace {

std::string lastMessage() {
  const char* message = nullptr;
  const char* function = nullptr;
  int code = 0;
  ex_get_err(&message, &function, &code);
  return message ? message : "";
}

}  // namespace

ExodusHandle ExodusHandle::open(const std::string& path) {
  if (!std::filesystem::is_regular_file(path))
    throw base::Error("Cannot read " + path + ": there is no such file.", base::ExitCode::input);
  std::ifstream bytes(path, std::ios::binary);
  if (std::filesystem::file_size(path) < completeSize(bytes))
    throw base::Error("Cannot read " + path + ": it is truncated: its end is missing.", base::ExitCode::input);
  int computeWordSize = sizeof(double), fileWordSize = 0;
  float version = 0;
  const int id = ex_open(path.c_str(), EX_READ, &computeWordSize, &fileWordSize, &version);
  if (id < 0) throw base::Error("Cannot read " + path + ": it is not an Exodus file.", base::ExitCode::input);
  ex_set_max_name_length(id, static_cast<int>(ex_inquire_int(id, EX_INQ_DB_MAX_USED_NAME_LENGTH)));
  return ExodusHandle(path, id, base::ExitCode::input);
}

ExodusHandle ExodusHandle::create(const std::string& path, int nameLength) {
  int computeWordSize = sizeof(double), fileWordSize = sizeof(double);
  const int id = ex_create(path.c_str(), EX_CLOBBER | EX_LARGE_MODEL, &computeWordSize, &fileWordSize);
  if (id < 0) throw base::Error("Cannot write " + path + ": " + lastMessage() + ".");
  if (nameLength > 32) ex_set_option(id, EX_OPT_MAX_NAME_LENGTH, nameLength);
  return ExodusHandle(path, id, base::ExitCode::failure);
}

ExodusHandle::ExodusHandle(ExodusHandle&& other) noexcept
    : path_(std::move(other.path_)), id_(std::exchange(other.id_, -1)), code_(other.code_) {}

ExodusHandle::~ExodusHandle() {
  if (id_ >= 0) ex_close(id_);
}

void ExodusHandle::check(int status, const std::string& what) const {
  if (status >= 0) return;
  const bool isWritten = code_ == base::ExitCode::failure;
  throw base::Error(
      path_ + ": cannot " + what + ": " + lastMessage() + "." +
          (isWritten ? "\n  If the disk is full, make room, or write into another folder (--output)." : ""),
      code_);
}

void ExodusHandle::close() {
  if (id_ < 0) return;
  const int status = ex_close(std::exchange(id_, -1));
  check(status, "complete the file");
}

std::vector<char*> pointers(const std::vector<std::string>& names) {
  std::vector<char*> result;
  // Exodus takes char** even where it only reads.
  for (const auto& name : names) result.push_back(const_cast<char*>(name.c_str()));
  return result;
}

}  // namespace harmos::files
