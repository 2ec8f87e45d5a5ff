#pragma once

#include <string>
#include <vector>

#include <hdf5.h>

namespace harmos::files {

/// While it lives HDF5 prints no messages of its own; errors end up as base::Error.
class QuietHdf5 {
 public:
  QuietHdf5();
  ~QuietHdf5();
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Owns one identifier of the HDF5 library.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// Throws base::Error saying that `what` cannot be written when the identifier is invalid.
  Hdf5Handle(hid_t id, Close closing, const std::string& what);
  ~Hdf5Handle();
  Hdf5Handle(Hdf5Handle&& other) noexcept;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// A group of a new HDF5 file, and what is put into it. Arrays are stored by rows, in chunks. Without time stamps, so
/// that equal content gives equal files. The file is made in memory, because HDF5 does not survive a full disk. All
/// members throw base::Error when something cannot be written.
class Hdf5Group {
 public:
  /// The root of a new file.
  static Hdf5Group create();
  Hdf5Group group(const std::string& name) const;

  void attribute(const std::string& name, const std::string& value) const;
  void attribute(const std::string& name, double value) const;
  void attribute(const std::string& name, int value) const;
  void attribute(const std::string& name, const std::vector<std::string>& values) const;

  /// `columns` = 0: one-dimensional. Returns the array, to which attributes can be given.
  Hdf5Group array(const std::string& name, const std::vector<double>& values, std::size_t columns = 0) const;
  Hdf5Group array(const std::string& name, const std::vector<int>& values, std::size_t columns = 0) const;
  Hdf5Group array(const std::string& name, const std::vector<std::string>& values) const;
  /// Of the root, when all other groups and arrays are gone: the bytes of the file. Behind what HDF5 reads stands a
  /// checksum of it, because HDF5 crashes on some damages and returns others as values.
  std::string image() const;

 private:
  explicit Hdf5Group(Hdf5Handle handle) : handle_(std::move(handle)) {}
  Hdf5Group write(const std::string& name, hid_t type, const void* values, std::size_t count,
                  std::size_t columns) const;

  Hdf5Handle handle_;
};

}  // namespace harmos::files
