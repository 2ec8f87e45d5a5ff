#include <harmos/files/ExodusWriter.hpp>

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <numeric>
#include <set>

#include <exodusII.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/Version.hpp>
#include <harmos/files/detail/ExodusHandle.hpp>

namespace harmos::files {

namespace {

template <typename List>
void collectNames(const List& list, std::vector<std::string>& names) {
  for (const auto& item : list) names.push_back(item.name);
}

std::vector<std::string> setNames(const ResultMesh& mesh) {
  std::vector<std::string> names;
  collectNames(mesh.blocks, names);
  collectNames(mesh.sideSets, names);
  collectNames(mesh.nodeSets, names);
  return names;
}

template <typename List>
void requireUnique(const List& list, const std::string& kind, const std::string& path) {
  std::set<std::string> seen;
  for (const auto& item : list)
    if (!seen.insert(item.name).second)
      throw base::Error(
          path + ": the name \"" + item.name + "\" is used for two of its " + kind +
          ", which readers of Exodus files do not tell apart. Rename a part, an interface or a boundary.");
}

int longestName(const std::vector<std::string>& names, const ResultVariables& variables) {
  std::size_t longest = 0;
  for (const auto* list : {&names, &variables.nodal, &variables.element, &variables.global})
    for (const auto& name : *list) longest = std::max(longest, name.size());
  return static_cast<int>(longest);
}

std::vector<std::string> informationRecords(const std::vector<std::string>& lines) {
  std::vector<std::string> records;
  for (const std::string& line : lines) {
    std::size_t at = 0;
    for (; line.size() - at > MAX_LINE_LENGTH; at += MAX_LINE_LENGTH - 1) {
      records.push_back(line.substr(at, MAX_LINE_LENGTH - 1) + "\\");
    }
    records.push_back(line.substr(at));
  }
  return records;
}

std::vector<int> fromOne(std::vector<int> numbers) {
  for (int& number : numbers) ++number;
  return numbers;
}

void putProvenance(const ExodusHandle& file, const std::vector<std::string>& information) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 16> date{}, time{};
  std::strftime(date.data(), date.size(), "%Y%m%d", &local);
  std::strftime(time.data(), time.size(), "%H:%M:%S", &local);
  std::string code = "Harmos", version = files::version();
  char* record[1][4] = {{code.data(), version.data(), date.data(), time.data()}};
  file.check(ex_put_qa(file.id(), 1, record), "write the QA record");

  const auto records = informationRecords(information);
  if (!records.empty())
    file.check(ex_put_info(file.id(), static_cast<int>(records.size()), pointers(records).data()),
               "write the information records");
}

std::vector<int> idsOf(std::size_t count) {
  std::vector<int> ids(count);
  std::iota(ids.begin(), ids.end(), 1);
  return ids;
}

template <typename List>
void putNames(const ExodusHandle& file, ex_entity_type kind, const List& list, const std::string& what) {
  if (list.empty()) return;
  std::vector<std::string> names;
  collectNames(list, names);
  file.check(ex_put_names(file.id(), kind, pointers(names).data()), "name the " + what);
}

/// Defines all blocks at once: the library copies the file whenever it goes back to defining, and looks through all
/// that is defined.
void defineBlocks(const ExodusHandle& file, const std::vector<ResultMesh::Block>& blocks) {
  if (blocks.empty()) return;
  std::vector<std::string> types;
  std::vector<int> elements, nodes;
  for (const auto& block : blocks) {
    types.push_back(block.type);
    elements.push_back(block.elements());
    nodes.push_back(block.nodesPerElement);
  }
  const std::vector<int> none(blocks.size(), 0);
  file.check(ex_put_concat_elem_block(file.id(), idsOf(blocks.size()).data(), pointers(types).data(), elements.data(),
                                      nodes.data(), none.data(), 0),
             "define the blocks");
  putNames(file, EX_ELEM_BLOCK, blocks, "blocks");
}

/// Defines and fills all sets at once. Side sets have one entry more, the sides.
void putSets(const ExodusHandle& file, const ResultMesh& mesh) {
  std::vector<std::vector<int>> numbers;
  for (const auto& set : mesh.sideSets) {
    numbers.push_back(fromOne(set.element));
    numbers.push_back(fromOne(set.side));
  }
  for (const auto& set : mesh.nodeSets) numbers.push_back(fromOne(set.node));
  std::vector<ex_set> sets;
  auto list = numbers.begin();
  const auto add = [&](ex_entity_type kind, std::size_t id) {
    ex_set set{};
    set.id = static_cast<int64_t>(id);
    set.type = kind;
    set.num_entry = static_cast<int64_t>(list->size());
    set.entry_list = list++->data();
    if (kind == EX_SIDE_SET) set.extra_list = list++->data();
    sets.push_back(set);
  };
  for (std::size_t i = 0; i < mesh.sideSets.size(); ++i) add(EX_SIDE_SET, i + 1);
  for (std::size_t i = 0; i < mesh.nodeSets.size(); ++i) add(EX_NODE_SET, i + 1);
  if (!sets.empty()) file.check(ex_put_sets(file.id(), sets.size(), sets.data()), "write the sets");
  putNames(file, EX_SIDE_SET, mesh.sideSets, "side sets");
  putNames(file, EX_NODE_SET, mesh.nodeSets, "node sets");
}

void putCoordinates(const ExodusHandle& file, const ResultMesh& mesh) {
  std::array<std::vector<double>, 3> coordinates;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const auto& point : mesh.nodes) coordinates[axis].push_back(point[axis]);
  file.check(ex_put_coord(file.id(), coordinates[0].data(), coordinates[1].data(), coordinates[2].data()),
             "write the coordinates");
  const std::vector<std::string> axes{"x", "y", "z"};
  file.check(ex_put_coord_names(file.id(), pointers(axes).data()), "write the names of the axes");
}

/// Numbers by which the user knows elements or nodes; those that the format does not hold are left out.
void putNumbers(const ExodusHandle& file, ex_entity_type kind, const std::vector<std::int64_t>& numbers) {
  if (numbers.empty() || *std::max_element(numbers.begin(), numbers.end()) > std::numeric_limits<int>::max()) return;
  const std::vector<int> map(numbers.begin(), numbers.end());
  file.check(ex_put_id_map(file.id(), kind, map.data()), "write the numbers of elements and nodes");
}

void putConnectivity(const ExodusHandle& file, const std::vector<ResultMesh::Block>& blocks) {
  int64_t number = 0;
  for (const auto& block : blocks) {
    ++number;
    if (block.elements() > 0)
      file.check(ex_put_conn(file.id(), EX_ELEM_BLOCK, number, fromOne(block.connectivity).data(), nullptr, nullptr),
                 "write block " + block.name);
  }
}

void putVariableNames(const ExodusHandle& file, ex_entity_type kind, const std::vector<std::string>& names) {
  if (names.empty()) return;
  file.check(ex_put_variable_names(file.id(), kind, static_cast<int>(names.size()), pointers(names).data()),
             "name variables");
}

void defineVariables(const ExodusHandle& file, std::size_t blocks, const ResultVariables& variables) {
  std::vector<int> truth(blocks * variables.element.size(), 1);
  file.check(ex_put_all_var_param(
                 file.id(), static_cast<int>(variables.global.size()), static_cast<int>(variables.nodal.size()),
                 blocks == 0 ? 0 : static_cast<int>(variables.element.size()), truth.data(), 0, nullptr, 0, nullptr),
             "declare variables");
  putVariableNames(file, EX_GLOBAL, variables.global);
  putVariableNames(file, EX_NODAL, variables.nodal);
  if (blocks > 0) putVariableNames(file, EX_ELEM_BLOCK, variables.element);
}

/// The cheapest order: all that is defined comes before what is written, for defining moves what is there.
void putMesh(const ExodusHandle& file, const std::string& title, const ResultMesh& mesh,
             const ResultVariables& variables, const std::vector<std::string>& information) {
  file.check(
      ex_put_init(file.id(), title.substr(0, MAX_LINE_LENGTH).c_str(), mesh.dimension,
                  static_cast<int64_t>(mesh.nodes.size()), mesh.elements(), static_cast<int64_t>(mesh.blocks.size()),
                  static_cast<int64_t>(mesh.nodeSets.size()), static_cast<int64_t>(mesh.sideSets.size())),
      "write the sizes");
  putProvenance(file, information);
  defineBlocks(file, mesh.blocks);
  defineVariables(file, mesh.blocks.size(), variables);
  putSets(file, mesh);
  putCoordinates(file, mesh);
  putNumbers(file, EX_NODE_MAP, mesh.nodeNumbers);
  putNumbers(file, EX_ELEM_MAP, mesh.elementNumbers);
  putConnectivity(file, mesh.blocks);
}

}  // namespace

struct ExodusWriter::State {
  State(const std::string& path, ResultMesh resultMesh, ResultVariables resultVariables)
      : target(path),
        mesh(std::move(resultMesh)),
        variables(std::move(resultVariables)),
        file(ExodusHandle::create(target.temporaryPath(), longestName(setNames(mesh), variables))) {}

  AtomicFile target;
  ResultMesh mesh;
  ResultVariables variables;
  ExodusHandle file;
  int steps = 0;

  void requireSize(std::size_t given, std::size_t expected, const std::string& what) const {
    if (given != expected)
      throw base::Error(target.path() + ": " + std::to_string(given) + " values were given for " + what + ", " +
                        std::to_string(expected) + " are needed.");
  }
};

ExodusWriter::ExodusWriter(const std::string& path, const std::string& title, ResultMesh mesh,
                           ResultVariables variables, const std::vector<std::string>& information) {
  requireUnique(mesh.blocks, "blocks", path);
  requireUnique(mesh.sideSets, "side sets", path);
  requireUnique(mesh.nodeSets, "node sets", path);
  state_ = std::make_unique<State>(path, std::move(mesh), std::move(variables));
  putMesh(state_->file, title, state_->mesh, state_->variables, information);
}

ExodusWriter::~ExodusWriter() = default;

const ResultMesh& ExodusWriter::mesh() const {
  return state_->mesh;
}
const ResultVariables& ExodusWriter::variables() const {
  return state_->variables;
}

void ExodusWriter::write(const ResultStep& step) {
  State& s = *state_;
  s.requireSize(step.global.size(), s.variables.global.size(), "the global variables");
  s.requireSize(step.nodal.size(), s.variables.nodal.size(), "the list of nodal variables");
  s.requireSize(step.element.size(), s.variables.element.size(), "the list of element variables");
  const int id = s.file.id(), number = ++s.steps;
  s.file.check(ex_put_time(id, number, &step.time), "write the time");
  if (!step.global.empty())
    s.file.check(ex_put_var(id, number, EX_GLOBAL, 1, 0, static_cast<int64_t>(step.global.size()), step.global.data()),
                 "write the global variables");
  for (std::size_t v = 0; v < step.nodal.size(); ++v) {
    s.requireSize(step.nodal[v].size(), s.mesh.nodes.size(), s.variables.nodal[v]);
    if (!s.mesh.nodes.empty())
      s.file.check(ex_put_var(id, number, EX_NODAL, static_cast<int>(v) + 1, 1,
                              static_cast<int64_t>(step.nodal[v].size()), step.nodal[v].data()),
                   "write " + s.variables.nodal[v]);
  }
  for (std::size_t v = 0; v < step.element.size(); ++v) {
    s.requireSize(step.element[v].size(), static_cast<std::size_t>(s.mesh.elements()), s.variables.element[v]);
    const double* values = step.element[v].data();
    for (std::size_t b = 0; b < s.mesh.blocks.size(); ++b) {
      const int elements = s.mesh.blocks[b].elements();
      if (elements > 0)
        s.file.check(ex_put_var(id, number, EX_ELEM_BLOCK, static_cast<int>(v) + 1, static_cast<int64_t>(b) + 1,
                                elements, values),
                     "write " + s.variables.element[v]);
      values += elements;
    }
  }
}

void ExodusWriter::commit() {
  state_->file.close();
  state_->target.commit();
}

}  // namespace harmos::files
