#pragma once

#include <string>
#include <vector>

#include <harmos/base/Error.hpp>

namespace harmos::files {

/// An open Exodus file, closed by the destructor; not copyable.
class ExodusHandle {
 public:
  /// Opens for reading; throws base::Error(ExitCode::input) when that is not an Exodus file or a truncated one.
  /// What is missing of time steps is not noticed.
  static ExodusHandle open(const std::string& path);
  /// Creates a file in 64-bit offset format (EX_LARGE_MODEL) for names up to `nameLength` characters.
  static ExodusHandle create(const std::string& path, int nameLength);
  ~ExodusHandle();
  ExodusHandle(ExodusHandle&& other) noexcept;
  ExodusHandle(const ExodusHandle&) = delete;
  ExodusHandle& operator=(const ExodusHandle&) = delete;

  int id() const { return id_; }
  /// Throws base::Error naming the file, `what` failed and Exodus' own message when `status` is negative; (input) for a
  /// file that is read.
  void check(int status, const std::string& what) const;
  /// Writes what is buffered; errors of the file system show up here. The handle is unusable afterwards.
  void close();

 private:
  ExodusHandle(std::string path, int id, base::ExitCode code) : path_(std::move(path)), id_(id), code_(code) {}

  std::string path_;
  int id_;
  base::ExitCode code_;  // of errors
};

/// Array of C strings as Exodus wants it, pointing into `names`, which must outlive it.
std::vector<char*> pointers(const std::vector<std::string>& names);

}  // namespace harmos::files
