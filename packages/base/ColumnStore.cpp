#include <harmos/base/ColumnStore.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <unistd.h>

#include <harmos/base/Error.hpp>

namespace harmos::base {

class ColumnStore::File {
 public:
  File(const std::string& folder, std::size_t bytes) : folder_(folder) {
    std::string path = folder + "/harmos-XXXXXX";
    descriptor_ = ::mkstemp(path.data());
    if (descriptor_ < 0) fail("make a temporary file in ");
    ::unlink(path.c_str());
    if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) == 0) return;
    ::close(descriptor_);
    fail("make a temporary file in ");
  }
  ~File() { ::close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void write(std::size_t at, const char* from, std::size_t bytes) const {
    while (bytes > 0) {
      const ssize_t done = ::pwrite(descriptor_, from, bytes, static_cast<off_t>(at));
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail("write a temporary file in ");
      at += static_cast<std::size_t>(done);
      from += done;
      bytes -= static_cast<std::size_t>(done);
    }
  }
  void read(std::size_t at, char* to, std::size_t bytes) const {
    while (bytes > 0) {
      const ssize_t done = ::pread(descriptor_, to, bytes, static_cast<off_t>(at));
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail("read a temporary file in ");
      at += static_cast<std::size_t>(done);
      to += done;
      bytes -= static_cast<std::size_t>(done);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error("Cannot " + what + folder_ + ": " + std::strerror(errno) +
                ". Fields of many load steps are kept there while a run lasts.");
  }

  std::string folder_;
  int descriptor_ = -1;
};

ColumnStore::ColumnStore() = default;
ColumnStore::ColumnStore(ColumnStore&& other) noexcept = default;
ColumnStore& ColumnStore::operator=(ColumnStore&& other) noexcept = default;
ColumnStore::~ColumnStore() = default;

ColumnStore::ColumnStore(int rows, int columns, const std::string& folder) : rows_(rows), columns_(columns) {
  const std::size_t all = at(columns);
  if (!folder.empty()) file_ = std::make_unique<File>(folder, sizeof(double) * all);
  values_.resize(file_ ? at(1) : all);
}

void ColumnStore::write(int column, const double* values) {
  if (file_) {
    file_->write(sizeof(double) * at(column), reinterpret_cast<const char*>(values), sizeof(double) * at(1));
  } else {
    std::copy_n(values, rows_, values_.begin() + static_cast<std::ptrdiff_t>(at(column)));
  }
}

const double* ColumnStore::read(int column) const {
  if (!file_) return values_.data() + at(column);
  file_->read(sizeof(double) * at(column), reinterpret_cast<char*>(values_.data()), sizeof(double) * at(1));
  return values_.data();
}

}  // namespace harmos::base
