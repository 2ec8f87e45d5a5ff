#include <harmos/files/detail/Hdf5.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/StudySeal.hpp>

namespace harmos::files {

namespace {

constexpr hsize_t chunkRows = 512;

void demand(herr_t status, const std::string& what) {
  if (status < 0) throw base::Error("Cannot write " + what + " of the study file.");
}

Hdf5Handle textType() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a type");
  demand(H5Tset_size(type, H5T_VARIABLE), "a type");
  demand(H5Tset_cset(type, H5T_CSET_UTF8), "a type");
  return type;
}

std::vector<const char*> pointers(const std::vector<std::string>& texts) {
  std::vector<const char*> result;
  for (const std::string& text : texts) result.push_back(text.c_str());
  if (result.empty()) result.push_back(nullptr);  // HDF5 wants an address also of nothing
  return result;
}

void writeAttribute(hid_t object, const std::string& name, hid_t type, const Hdf5Handle& space, const void* value) {
  const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  demand(H5Awrite(attribute, type, value), name);
}

Hdf5Handle scalar() {
  return {H5Screate(H5S_SCALAR), H5Sclose, "a space"};
}

}  // namespace

QuietHdf5::QuietHdf5() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() {
  H5Eset_auto2(H5E_DEFAULT, print_, data_);
}

Hdf5Handle::Hdf5Handle(hid_t id, Close closing, const std::string& what) : id_(id), close_(closing) {
  if (id < 0) throw base::Error("Cannot write " + what + " of the study file.");
}

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) {
  other.id_ = -1;
}

Hdf5Handle::~Hdf5Handle() {
  if (id_ >= 0) close_(id_);
}

Hdf5Group Hdf5Group::create() {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "the beginning");
  demand(H5Pset_fapl_core(access, 1 << 20, false), "the beginning");
  return Hdf5Group({H5Fcreate("study", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "the beginning"});
}

Hdf5Group Hdf5Group::group(const std::string& name) const {
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, name);
  demand(H5Pset_obj_track_times(properties, false), name);
  return Hdf5Group({H5Gcreate2(handle_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose, name});
}

void Hdf5Group::attribute(const std::string& name, const std::string& value) const {
  const char* text = value.c_str();
  writeAttribute(handle_, name, textType(), scalar(), &text);
}

void Hdf5Group::attribute(const std::string& name, double value) const {
  writeAttribute(handle_, name, H5T_NATIVE_DOUBLE, scalar(), &value);
}

void Hdf5Group::attribute(const std::string& name, int value) const {
  writeAttribute(handle_, name, H5T_NATIVE_INT, scalar(), &value);
}

void Hdf5Group::attribute(const std::string& name, const std::vector<std::string>& values) const {
  const hsize_t size = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, name);
  writeAttribute(handle_, name, textType(), space, pointers(values).data());
}

Hdf5Group Hdf5Group::array(const std::string& name, const std::vector<double>& values, std::size_t columns) const {
  return write(name, H5T_NATIVE_DOUBLE, values.data(), values.size(), columns);
}

Hdf5Group Hdf5Group::array(const std::string& name, const std::vector<int>& values, std::size_t columns) const {
  return write(name, H5T_NATIVE_INT, values.data(), values.size(), columns);
}

Hdf5Group Hdf5Group::array(const std::string& name, const std::vector<std::string>& values) const {
  return write(name, textType(), pointers(values).data(), values.size(), 0);
}

std::string Hdf5Group::image() const {
  demand(H5Fflush(handle_, H5F_SCOPE_LOCAL), "the end");
  const ::ssize_t size = H5Fget_file_image(handle_, nullptr, 0);
  std::string bytes(static_cast<std::size_t>(std::max<::ssize_t>(size, 0)), '\0');
  demand(H5Fget_file_image(handle_, bytes.data(), bytes.size()) > 0 ? 0 : -1, "the end");
  return bytes + studySeal(bytes);
}

Hdf5Group Hdf5Group::write(const std::string& name, hid_t type, const void* values, std::size_t count,
                           std::size_t columns) const {
  const hsize_t size[2] = {columns == 0 ? count : count / columns, columns};
  const int dimensions = columns == 0 ? 1 : 2;
  const Hdf5Handle space(H5Screate_simple(dimensions, size, nullptr), H5Sclose, name);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  demand(H5Pset_obj_track_times(properties, false), name);
  if (count > 0) {
    const hsize_t chunk[2] = {std::min(size[0], chunkRows), columns};
    demand(H5Pset_chunk(properties, dimensions, chunk), name);
  }
  Hdf5Handle array(H5Dcreate2(handle_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
                   name);
  if (count > 0) demand(H5Dwrite(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
  return Hdf5Group(std::move(array));
}

}  // namespace harmos::files
