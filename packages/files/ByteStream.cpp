#include <harmos/files/detail/ByteStream.hpp>

#include <cerrno>
#include <cstring>

#include <unistd.h>

#include <harmos/base/Error.hpp>

namespace harmos::files {

namespace {

constexpr std::size_t bufferSize = 1 << 20;  // [byte]: few system calls, little memory

void writeAll(int descriptor, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ::ssize_t written = ::write(descriptor, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw base::Error(std::string("Cannot hand on what was read: ") + std::strerror(errno) + ".");
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

}  // namespace

void ByteWriter::putBytes(const void* bytes, std::size_t size) {
  if (buffer_.size() + size > bufferSize) flush();
  if (size > bufferSize) {
    writeAll(descriptor_, static_cast<const char*>(bytes), size);
  } else {
    buffer_.append(static_cast<const char*>(bytes), size);
  }
}

void ByteWriter::flush() {
  writeAll(descriptor_, buffer_.data(), buffer_.size());
  buffer_.clear();
}

std::size_t ByteReader::length(std::size_t bytes) {
  const auto count = get<std::size_t>();
  if (count > left_ / bytes) throw base::Error("What was read is not complete.");
  return count;
}

const char* ByteReader::take(std::size_t bytes) {
  if (bytes > left_) throw base::Error("What was read is not complete.");
  const char* begin = at_;
  at_ += bytes;
  left_ -= bytes;
  return begin;
}

void ByteReader::copy(void* to, std::size_t bytes) {
  const char* from = take(bytes);
  if (bytes > 0) std::memcpy(to, from, bytes);
}

}  // namespace harmos::files
