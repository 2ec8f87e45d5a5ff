#include <harmos/files/detail/Hdf5Node.hpp>

#include <functional>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/Hdf5.hpp>

namespace harmos::files {

namespace {

constexpr int deepest = 20;  // groups in groups; a damaged file may hold itself

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error("Cannot read " + what + " of the study file.", base::ExitCode::input);
}

hid_t demandRead(hid_t id, const std::string& what) {
  if (id < 0) refuse(what);
  return id;
}

/// `read` fills memory with values of a type of memory.
Hdf5Values readValues(hid_t storedType, hid_t storedSpace, const std::string& what,
                      const std::function<herr_t(hid_t, void*)>& read) {
  const Hdf5Handle type(demandRead(storedType, what), H5Tclose, what);
  const Hdf5Handle space(demandRead(storedSpace, what), H5Sclose, what);
  const ::hssize_t extent = H5Sget_simple_extent_npoints(space);
  if (extent < 0) refuse(what);
  const auto count = static_cast<std::size_t>(extent);
  Hdf5Values values;
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_INTEGER || kind == H5T_FLOAT) {
    values.numbers.resize(count);
    if (count > 0) demandRead(read(H5T_NATIVE_DOUBLE, values.numbers.data()), what);
  } else if (kind == H5T_STRING && H5Tis_variable_str(type) > 0) {
    values.isText = true;
    const Hdf5Handle text(H5Tcopy(type), H5Tclose, what);
    std::vector<char*> texts(count + 1, nullptr);  // HDF5 allocates every text
    if (count > 0) demandRead(read(text, texts.data()), what);
    for (std::size_t i = 0; i < count; ++i) values.texts.emplace_back(texts[i] ? texts[i] : "");
    H5Dvlen_reclaim(text, space, H5P_DEFAULT, texts.data());
  } else {
    refuse(what);
  }
  return values;
}

using Names = std::vector<std::string>;

Names attributeNames(hid_t object) {
  Names names;
  const auto add = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<Names*>(list)->emplace_back(name);
    return 0;
  };
  demandRead(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "the attributes");
  return names;
}

Names memberNames(hid_t group) {
  Names names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<Names*>(list)->emplace_back(name);
    return 0;
  };
  demandRead(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "the names");
  return names;
}

Hdf5Node readNode(hid_t object, const std::string& name, int depth) {
  if (depth > deepest) refuse(name);
  Hdf5Node node;
  for (const std::string& attribute : attributeNames(object)) {
    const Hdf5Handle opened(demandRead(H5Aopen(object, attribute.c_str(), H5P_DEFAULT), attribute), H5Aclose,
                            attribute);
    node.attributes[attribute] = readValues(H5Aget_type(opened), H5Aget_space(opened), attribute,
                                            [&](hid_t type, void* values) { return H5Aread(opened, type, values); });
  }
  const H5I_type_t kind = H5Iget_type(object);
  if (kind == H5I_DATASET) {
    node.values = readValues(H5Dget_type(object), H5Dget_space(object), name, [&](hid_t type, void* values) {
      return H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    });
  } else if (kind == H5I_GROUP || kind == H5I_FILE) {
    for (const std::string& member : memberNames(object)) {
      const Hdf5Handle opened(demandRead(H5Oopen(object, member.c_str(), H5P_DEFAULT), member), H5Oclose, member);
      node.members[member] = std::make_shared<const Hdf5Node>(readNode(opened, member, depth + 1));
    }
  } else {
    refuse(name);
  }
  return node;
}

void put(ByteWriter& writer, const Hdf5Values& values) {
  writer.put(values.isText);
  writer.put(values.numbers);
  writer.put(values.texts);
}

Hdf5Values takeValues(ByteReader& reader) {
  Hdf5Values values;
  reader.get(values.isText);
  reader.get(values.numbers);
  reader.get(values.texts);
  return values;
}

}  // namespace

Hdf5Node readHdf5(const std::string& path) {
  const QuietHdf5 quiet;
  const Hdf5Handle file(demandRead(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "the beginning"), H5Fclose,
                        path);
  return readNode(file, path, 0);
}

void put(ByteWriter& writer, const Hdf5Node& node) {
  writer.put(node.attributes.size());
  for (const auto& [name, values] : node.attributes) {
    writer.put(name);
    put(writer, values);
  }
  put(writer, node.values);
  writer.put(node.members.size());
  for (const auto& [name, member] : node.members) {
    writer.put(name);
    put(writer, *member);
  }
}

Hdf5Node takeHdf5(ByteReader& reader) {
  Hdf5Node node;
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    const auto name = reader.get<std::string>();
    node.attributes[name] = takeValues(reader);
  }
  node.values = takeValues(reader);
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    const auto name = reader.get<std::string>();
    node.members[name] = std::make_shared<const Hdf5Node>(takeHdf5(reader));
  }
  return node;
}

}  // namespace harmos::files
