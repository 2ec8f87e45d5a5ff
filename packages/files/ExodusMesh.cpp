#include <harmos/files/ExodusMesh.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include <exodusII.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/files/detail/CompleteSize.hpp>
#include <harmos/files/detail/ExodusCoordinates.hpp>
#include <harmos/files/detail/ForeignReading.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::files {
namespace {

using Integers = std::vector<std::int64_t>;

/// The sets of one kind and how unnamed ones are called.
struct Kind {
  ex_entity_type type;
  ex_inquiry count;
  const char* words;
  const char* unnamed;
};
constexpr Kind elementBlocks = {EX_ELEM_BLOCK, EX_INQ_ELEM_BLK, "element block", "block_"};
constexpr Kind sideSets = {EX_SIDE_SET, EX_INQ_SIDE_SETS, "side set", "sideset_"};
constexpr Kind nodeSets = {EX_NODE_SET, EX_INQ_NODE_SETS, "node set", "nodeset_"};

// An entry takes at least 4 bytes, which HDF5's deflate makes 1032 times smaller at best.
constexpr std::uint64_t mostPerByte = 1032 / 4;
// Products of three of them are numbers, as areas and volumes are.
constexpr double largestCoordinate = 1e100;

class Reader {
 public:
  Reader(const std::string& path, const std::vector<std::string>& unused)
      : path_(path), unused_(unused.begin(), unused.end()) {
    checkFile();
    int computeWordSize = sizeof(double);
    int fileWordSize = 0;
    float version = 0.0F;
    id_ = ex_open(path.c_str(), EX_READ, &computeWordSize, &fileWordSize, &version);
    if (id_ < 0) refuse("it is damaged or no Exodus file.");
    ex_set_int64_status(id_, EX_ALL_INT64_API);
    nameLength_ = std::max<std::int64_t>(32, ex_inquire_int(id_, EX_INQ_DB_MAX_USED_NAME_LENGTH));
    ex_set_max_name_length(id_, static_cast<int>(nameLength_));
  }
  ~Reader() {
    if (id_ >= 0) ex_close(id_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  mesh::Mesh read() {
    readNodes();
    readBlocks();
    numberElements();
    const mesh::Elements elements(mesh_);
    for (const auto& [id, name] : entities(sideSets)) readSideSet(elements, id, name);
    for (const auto& [id, name] : entities(nodeSets)) {
      const auto [nodes, none] = readSet(nodeSets, id, name, false);
      mesh::NodeSet set{name, id, {}};
      for (const std::int64_t node : nodes)
        set.node.push_back(fromOne(node, mesh_.nodes.size(), "node", nodeSets, name));
      mesh_.nodeSets.push_back(std::move(set));
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw base::Error("Cannot read the mesh file \"" + path_ + "\": " + what, base::ExitCode::input);
  }

  void check(int status, const std::string& what) const {
    if (status >= 0) return;
    const char* message = nullptr;
    const char* function = nullptr;
    int code = 0;
    ex_get_err(&message, &function, &code);
    refuse("reading " + what + " failed; it is damaged or truncated" +
           (message != nullptr && *message != '\0' ? std::string(" (Exodus: ") + message + ")." : "."));
  }

  /// Finds out what Exodus would not say.
  void checkFile() const {
    namespace fs = std::filesystem;
    std::error_code error;
    if (!fs::exists(path_, error)) refuse("there is no such file.");
    if (!fs::is_regular_file(path_, error)) refuse("it is not a file.");
    std::ifstream file(path_, std::ios::binary);
    if (!file) refuse(std::string(std::strerror(errno)) + ".");
    std::array<char, 8> start{};
    file.read(start.data(), start.size());
    const std::string_view begins(start.data(), static_cast<std::size_t>(file.gcount()));
    if (begins.empty()) refuse("it is empty.");
    if (begins.substr(0, 3) != "CDF" && begins != "\x89HDF\r\n\x1a\n") {
      refuse("it is no Exodus file (it is neither in netCDF nor in HDF5 format).");
    }
    const std::uint64_t size = fs::file_size(path_, error);
    if (size < completeSize(file)) refuse("it is truncated: its end is missing.");
  }

  /// Refuses a number of things that no file of this size can hold, before there is memory for them.
  void demandRoom(std::int64_t count, const std::string& what) const {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path_, error);
    if (count >= 0 && static_cast<std::uint64_t>(count) <= size * mostPerByte) return;
    refuse("it claims to hold " + std::to_string(count) + " " + what + " in " + std::to_string(size) +
           " bytes; it is damaged.");
  }

  /// Number, counted from 0, of a node, element or side counted from 1 in the file.
  int fromOne(
      std::int64_t number, std::size_t count, const char* what, const Kind& kind, const std::string& name,
      const std::function<std::string()>& owner = [] { return ""; }) const {
    if (number < 1 || static_cast<std::size_t>(number) > count) {
      refuse(std::string(kind.words) + " \"" + name + "\" refers to " + what + " " + std::to_string(number) + owner() +
             ", there are " + std::to_string(count) + "; it is damaged or truncated.");
    }
    return static_cast<int>(number - 1);
  }

  void readNodes() {
    ex_init_params sizes{};
    check(ex_get_init_ext(id_, &sizes), "its sizes");
    if (sizes.num_dim != 2 && sizes.num_dim != 3) {
      refuse("its mesh has " + std::to_string(sizes.num_dim) + " dimensions; 2 and 3 are supported.");
    }
    if (sizes.num_nodes < 1 || sizes.num_elem < 1) refuse("it has no mesh.");
    if (std::max(sizes.num_nodes, sizes.num_elem) > std::numeric_limits<int>::max() / 8)
      refuse("its mesh is too large.");
    demandRoom(sizes.num_nodes, "nodes");
    demandRoom(sizes.num_elem, "elements");
    mesh_.numbering.file = std::filesystem::path(path_).filename().string();
    mesh_.numbering.node = mesh::unlessPositions(numbers(EX_NODE_MAP, sizes.num_nodes));
    mesh_.dimension = static_cast<int>(sizes.num_dim);
    const auto [status, axis] = readCoordinates(id_, sizes.num_nodes);
    check(status, "its coordinates");
    for (std::size_t i = 0; i < axis[0].size(); ++i) {
      mesh_.nodes.push_back({axis[0][i], axis[1][i], axis[2][i]});
      for (const double x : mesh_.nodes.back()) {
        if (std::abs(x) <= largestCoordinate) continue;
        const std::string node = mesh_.numbering.nameOfNode(static_cast<int>(i));
        refuse(node +
               (std::isfinite(x) ? " has a coordinate beyond 1e100." : " has a coordinate that is not a number."));
      }
    }
  }

  /// By which the file knows its nodes or elements; their positions, from 1, where its numbers do not tell them apart.
  Integers numbers(ex_entity_type kind, std::int64_t count) const {
    Integers result(static_cast<std::size_t>(count));
    // Of a map that is longer than it should be, as damaged files have them, no more is read.
    const int status = ex_get_partial_id_map(id_, kind, 1, count, result.data());
    if (status < 0 || !mesh::areDistinct(result)) std::iota(result.begin(), result.end(), 1);
    return result;
  }

  void numberElements() {
    const Integers ofFile = numbers(EX_ELEM_MAP, static_cast<std::int64_t>(number_.size()));
    Integers read;
    for (std::size_t i = 0; i < ofFile.size(); ++i) {
      if (number_[i] >= 0) read.push_back(ofFile[i]);
    }
    mesh_.numbering.element = mesh::unlessPositions(std::move(read));
  }

  std::vector<std::pair<std::int64_t, std::string>> entities(const Kind& kind) const {
    const std::int64_t count = ex_inquire_int(id_, kind.count);
    demandRoom(count, std::string(kind.words) + "s");
    Integers ids(static_cast<std::size_t>(count));
    if (!ids.empty()) check(ex_get_ids(id_, kind.type, ids.data()), std::string("the ids of its ") + kind.words + "s");
    std::vector<std::pair<std::int64_t, std::string>> result;
    std::set<std::string> names;
    for (const std::int64_t id : ids) {
      std::vector<char> buffer(static_cast<std::size_t>(nameLength_) + 1, '\0');
      check(ex_get_name(id_, kind.type, id, buffer.data()), std::string("the names of its ") + kind.words + "s");
      std::string name = base::trimmed(buffer.data());
      if (name.empty()) name = kind.unnamed + std::to_string(id);
      if (!names.insert(name).second) {
        refuse(std::string("two ") + kind.words + "s are named \"" + name + "\"; rename one.");
      }
      result.emplace_back(id, std::move(name));
    }
    return result;
  }

  void readBlocks() {
    std::string unsupported;
    for (const auto& [id, name] : entities(elementBlocks)) {
      ex_block block{};
      block.id = id;
      block.type = EX_ELEM_BLOCK;
      check(ex_get_block_param(id_, &block), "element block \"" + name + "\"");
      demandRoom(block.num_entry, "elements");
      if (block.num_entry == 0) continue;
      const auto type =
          mesh::elementTypeFromExodus(block.topology, mesh_.dimension, static_cast<int>(block.num_nodes_per_entry));
      if (!type && unused_.count(name) > 0) {
        mesh_.unreadBlocks.push_back(name);
        number_.insert(number_.end(), static_cast<std::size_t>(block.num_entry), -1);
        continue;
      }
      if (!type) {
        unsupported += (unsupported.empty() ? "" : ", ") + ("\"" + name) + "\" " + block.topology + " (" +
                       std::to_string(block.num_nodes_per_entry) + " nodes)";
        continue;
      }
      demandRoom(block.num_entry * block.num_nodes_per_entry, "nodes of elements");
      Integers nodes(static_cast<std::size_t>(block.num_entry * block.num_nodes_per_entry));
      check(ex_get_conn(id_, EX_ELEM_BLOCK, id, nodes.data(), nullptr, nullptr), "element block \"" + name + "\"");
      mesh::ElementBlock result{name, id, *type, {}};
      for (const std::int64_t node : nodes) {
        result.connectivity.push_back(fromOne(node, mesh_.nodes.size(), "node", elementBlocks, name));
      }
      for (int e = 0; e < result.elements(); ++e) number_.push_back(read_++);
      sidesBefore_.push_back(mesh::sidesBeforeEdges(block.topology));
      mesh_.blocks.push_back(std::move(result));
    }
    if (unsupported.empty()) return;
    refuse("these element blocks have elements that are not supported in " + std::to_string(mesh_.dimension) +
           " dimensions: " + unsupported + ". Supported are " +
           (mesh_.dimension == 3 ? "HEX8, WEDGE6, PYRAMID5 and TET4, and the quadratic HEX20, HEX27, WEDGE15 and TET10"
                                 : "QUAD4 and TRI3, and the quadratic QUAD8, QUAD9 and TRI6") +
           "; mesh these blocks anew, or name them in \"Unused Blocks\".");
  }

  std::pair<Integers, Integers> readSet(const Kind& kind, std::int64_t id, const std::string& name,
                                        bool hasSides) const {
    ex_set set{};
    set.id = id;
    set.type = kind.type;
    const std::string what = std::string(kind.words) + " \"" + name + "\"";
    check(ex_get_sets(id_, 1, &set), what);
    demandRoom(set.num_entry, "entries of a set");
    Integers entries(static_cast<std::size_t>(set.num_entry));
    Integers sides(hasSides ? entries.size() : 0);
    if (!entries.empty())
      check(ex_get_set(id_, kind.type, id, entries.data(), hasSides ? sides.data() : nullptr), what);
    return {std::move(entries), std::move(sides)};
  }

  void readSideSet(const mesh::Elements& elements, std::int64_t id, const std::string& name) {
    const auto [entries, sides] = readSet(sideSets, id, name, true);
    mesh::SideSet set{name, id, {}, {}};
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const int element = number_[fromOne(entries[i], number_.size(), "element", sideSets, name)];
      if (element < 0) continue;
      set.element.push_back(element);
      const mesh::ElementType type = elements.type(element);
      const int before = sidesBefore_[elements.block(element)];
      const int sideCount = before + mesh::sidesPerElement(type);
      const int side = fromOne(sides[i], static_cast<std::size_t>(sideCount), "side", sideSets, name, [&] {
        return std::string(" of ") + mesh::exodusName(type) + " " + elementName(mesh_, element);
      });
      if (side < before) {
        refuse("side set \"" + name + "\" refers to side " + std::to_string(side + 1) + " of the shell " +
               elementName(mesh_, element) + ", which is its face; in the plane there are edges only, sides 3 to " +
               std::to_string(sideCount) + ". Write the block as " + mesh::exodusName(type) +
               ", whose edges count from 1, or these edges by their numbers.");
      }
      set.side.push_back(side - before);
    }
    mesh_.sideSets.push_back(std::move(set));
  }

  std::string path_;
  std::set<std::string> unused_;
  std::vector<int> number_;       // of each element of the file in the mesh; -1: not read
  int read_ = 0;                  // elements of the mesh so far
  std::vector<int> sidesBefore_;  // of each block of the mesh, see mesh::sidesBeforeEdges()
  int id_ = -1;
  std::int64_t nameLength_ = 32;
  mesh::Mesh mesh_;
};

void put(ByteWriter& writer, const mesh::Mesh& mesh) {
  writer.put(mesh.dimension);
  writer.put(mesh.numbering.file);
  writer.put(mesh.numbering.element);
  writer.put(mesh.numbering.node);
  writer.put(mesh.nodes);
  writer.put(mesh.blocks.size());
  for (const auto& block : mesh.blocks) {
    writer.put(block.name);
    writer.put(block.id);
    writer.put(block.type);
    writer.put(block.connectivity);
  }
  writer.put(mesh.sideSets.size());
  for (const auto& set : mesh.sideSets) {
    writer.put(set.name);
    writer.put(set.id);
    writer.put(set.element);
    writer.put(set.side);
  }
  writer.put(mesh.nodeSets.size());
  for (const auto& set : mesh.nodeSets) {
    writer.put(set.name);
    writer.put(set.id);
    writer.put(set.node);
  }
  writer.put(mesh.unreadBlocks);
}

mesh::Mesh takeMesh(ByteReader& reader) {
  mesh::Mesh mesh;
  reader.get(mesh.dimension);
  reader.get(mesh.numbering.file);
  reader.get(mesh.numbering.element);
  reader.get(mesh.numbering.node);
  reader.get(mesh.nodes);
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    auto& block = mesh.blocks.emplace_back();
    reader.get(block.name);
    reader.get(block.id);
    reader.get(block.type);
    reader.get(block.connectivity);
  }
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    auto& set = mesh.sideSets.emplace_back();
    reader.get(set.name);
    reader.get(set.id);
    reader.get(set.element);
    reader.get(set.side);
  }
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    auto& set = mesh.nodeSets.emplace_back();
    reader.get(set.name);
    reader.get(set.id);
    reader.get(set.node);
  }
  reader.get(mesh.unreadBlocks);
  return mesh;
}

}  // namespace

mesh::Mesh readExodus(const std::string& path, const std::vector<std::string>& unused) {
  mesh::Mesh mesh;
  readForeign(
      {path}, [&](ByteWriter& writer) { put(writer, Reader(path, unused).read()); },
      [&](ByteReader& reader) { mesh = takeMesh(reader); });
  return mesh;
}

}  // namespace harmos::files
