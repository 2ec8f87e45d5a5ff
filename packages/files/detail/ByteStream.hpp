#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace harmos::files {

/// Writes values into an open file, as they lie in memory: for another process of the same program.
class ByteWriter {
 public:
  explicit ByteWriter(int descriptor) : descriptor_(descriptor) {}

  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    putBytes(&value, sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    if constexpr (std::is_trivially_copyable_v<T>) {
      putBytes(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  void put(const std::string& text) {
    put(text.size());
    putBytes(text.data(), text.size());
  }
  /// Writes what is buffered. Throws base::Error when it cannot, as the others do when the buffer is full.
  void flush();

 private:
  void putBytes(const void* bytes, std::size_t size);

  int descriptor_;
  std::string buffer_;
};

/// Reads in the same order what a ByteWriter wrote; throws base::Error where there is less than asked for.
class ByteReader {
 public:
  /// The bytes must outlive it.
  ByteReader(const char* begin, std::size_t size) : at_(begin), left_(size) {}

  void get(std::string& text) {
    const std::size_t size = length(1);
    text.assign(take(size), size);
  }
  template <class T>
  void get(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    copy(&value, sizeof value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      values.resize(length(sizeof(T)));
      copy(values.data(), values.size() * sizeof(T));
    } else {
      values.resize(length(1));
      for (T& value : values) get(value);
    }
  }
  template <class T>
  T get() {
    T value;
    get(value);
    return value;
  }

 private:
  /// The number of values of so many bytes at least that come next.
  std::size_t length(std::size_t bytes);
  const char* take(std::size_t bytes);
  void copy(void* to, std::size_t bytes);

  const char* at_;
  std::size_t left_;
};

}  // namespace harmos::files
