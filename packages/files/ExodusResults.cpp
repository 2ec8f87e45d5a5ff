#include <harmos/files/detail/ExodusResults.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <exodusII.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/files/detail/CompleteSize.hpp>
#include <harmos/files/detail/ExodusCoordinates.hpp>

namespace harmos::files {

namespace {

std::string nameOf(int id, ex_entity_type kind, ex_entity_id entity, const std::string& unnamed) {
  std::vector<char> buffer(static_cast<std::size_t>(ex_inquire_int(id, EX_INQ_MAX_READ_NAME_LENGTH)) + 1, '\0');
  ex_get_name(id, kind, entity, buffer.data());
  const std::string name = base::trimmed(buffer.data());
  return name.empty() ? unnamed + "_" + std::to_string(entity) : name;
}

std::vector<std::string> variableNames(const ExodusHandle& file, ex_entity_type kind) {
  int count = 0;
  file.check(ex_get_variable_param(file.id(), kind, &count), "read the number of variables");
  if (count == 0) return {};
  std::vector<std::string> names(
      static_cast<std::size_t>(count),
      std::string(static_cast<std::size_t>(ex_inquire_int(file.id(), EX_INQ_MAX_READ_NAME_LENGTH)) + 1, '\0'));
  file.check(ex_get_variable_names(file.id(), kind, count, pointers(names).data()), "read the names of variables");
  for (auto& name : names) name.erase(name.find('\0'));
  return names;
}

std::vector<int> fromZero(const std::vector<int>& numbers, std::size_t limit, const std::string& where) {
  std::vector<int> result;
  for (int number : numbers) {
    if (number < 1 || static_cast<std::size_t>(number) > limit)
      throw base::Error(
          where + " refers to number " + std::to_string(number) + ", the file has 1 to " + std::to_string(limit) + ".",
          base::ExitCode::input);
    result.push_back(number - 1);
  }
  return result;
}

}  // namespace

ExodusResults::ExodusResults(const std::string& path) : path_(path), file_(ExodusHandle::open(path)) {
  ex_set_int64_status(file_.id(), EX_IDS_INT64_API);
  ex_init_params sizes{};
  file_.check(ex_get_init_ext(file_.id(), &sizes), "read the sizes");
  mesh_.dimension = static_cast<int>(sizes.num_dim);
  const auto nodes = static_cast<std::size_t>(sizes.num_nodes);
  const auto [status, axis] = readCoordinates(file_.id(), nodes);
  file_.check(status, "read the coordinates");
  for (std::size_t i = 0; i < nodes; ++i) mesh_.nodes.push_back({axis[0][i], axis[1][i], axis[2][i]});
  readBlocks();
  readSets();

  variables_.global = variableNames(file_, EX_GLOBAL);
  variables_.nodal = variableNames(file_, EX_NODAL);
  variables_.element = variableNames(file_, EX_ELEM_BLOCK);
  truth_.assign(blockIds_.size() * variables_.element.size(), 0);
  if (!truth_.empty())
    file_.check(ex_get_truth_table(file_.id(), EX_ELEM_BLOCK, static_cast<int>(blockIds_.size()),
                                   static_cast<int>(variables_.element.size()), truth_.data()),
                "read the truth table");
  times_.resize(ex_inquire_int(file_.id(), EX_INQ_TIME));
  if (!times_.empty()) file_.check(ex_get_all_times(file_.id(), times_.data()), "read the times");
  checkSize();
}

/// The missing values of a truncated classic file would be read as zeros.
void ExodusResults::checkSize() const {
  std::ifstream bytes(path_, std::ios::binary);
  std::string start(3, '\0');
  bytes.read(start.data(), 3);
  if (start != "CDF") return;  // HDF5 knows the size of the whole file
  std::uint64_t numbers = 1 + variables_.global.size() + variables_.nodal.size() * mesh_.nodes.size();
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    if (truth_[i] == 0) continue;
    numbers += static_cast<std::uint64_t>(mesh_.blocks[i / variables_.element.size()].elements());
  }
  const auto bytesPerNumber = static_cast<std::uint64_t>(ex_inquire_int(file_.id(), EX_INQ_DB_FLOAT_SIZE));
  const std::uint64_t wanted = completeSize(bytes) + times_.size() * numbers * bytesPerNumber;
  if (std::filesystem::file_size(path_) >= wanted) return;
  throw base::Error("Cannot read " + path_ + ": it is truncated: time steps are missing.", base::ExitCode::input);
}

void ExodusResults::readBlocks() {
  const int id = file_.id();
  const auto count = static_cast<std::size_t>(ex_inquire_int(id, EX_INQ_ELEM_BLK));
  std::vector<std::int64_t> ids(count);
  if (count > 0) file_.check(ex_get_ids(id, EX_ELEM_BLOCK, ids.data()), "read the block numbers");
  for (const std::int64_t number : ids) {
    ex_block parameters{};
    parameters.id = number;
    parameters.type = EX_ELEM_BLOCK;
    file_.check(ex_get_block_param(id, &parameters), "read block " + std::to_string(number));
    ResultMesh::Block block;
    block.name = nameOf(id, EX_ELEM_BLOCK, number, "block");
    block.type = parameters.topology;
    block.nodesPerElement = static_cast<int>(std::max<int64_t>(parameters.num_nodes_per_entry, 1));
    std::vector<int> connectivity(parameters.num_entry * parameters.num_nodes_per_entry);
    if (!connectivity.empty())
      file_.check(ex_get_conn(id, EX_ELEM_BLOCK, number, connectivity.data(), nullptr, nullptr),
                  "read block " + block.name);
    block.connectivity = fromZero(connectivity, mesh_.nodes.size(), path_ + ": block " + block.name);
    mesh_.blocks.push_back(std::move(block));
    blockIds_.push_back(number);
  }
}

void ExodusResults::readSets() {
  const int id = file_.id();
  for (const auto kind : {EX_SIDE_SET, EX_NODE_SET}) {
    const bool sides = kind == EX_SIDE_SET;
    const auto count = static_cast<std::size_t>(ex_inquire_int(id, sides ? EX_INQ_SIDE_SETS : EX_INQ_NODE_SETS));
    std::vector<std::int64_t> ids(count);
    if (count > 0) file_.check(ex_get_ids(id, kind, ids.data()), "read the set numbers");
    for (const std::int64_t number : ids) {
      const std::string name = nameOf(id, kind, number, sides ? "side_set" : "node_set");
      int size = 0, factors = 0;
      file_.check(ex_get_set_param(id, kind, number, &size, &factors), "read set " + name);
      std::vector<int> entries(size), extra(sides ? entries.size() : 0);
      if (size > 0)
        file_.check(ex_get_set(id, kind, number, entries.data(), sides ? extra.data() : nullptr), "read set " + name);
      const std::string where = path_ + ": set " + name;
      if (sides) {
        for (int& side : extra) --side;
        mesh_.sideSets.push_back(
            {name, number, fromZero(entries, static_cast<std::size_t>(mesh_.elements()), where), extra});
      } else {
        mesh_.nodeSets.push_back({name, number, fromZero(entries, mesh_.nodes.size(), where)});
      }
    }
  }
}

std::vector<std::string> ExodusResults::information() const {
  const auto count = static_cast<std::size_t>(ex_inquire_int(file_.id(), EX_INQ_INFO));
  std::vector<std::string> records(count, std::string(MAX_LINE_LENGTH + 1, '\0'));
  if (count > 0) file_.check(ex_get_info(file_.id(), pointers(records).data()), "read the information records");
  std::vector<std::string> lines;
  bool continues = false;
  for (const auto& record : records) {
    std::string text = record.substr(0, record.find('\0'));
    const bool more = text.size() == MAX_LINE_LENGTH && text.back() == '\\';
    if (more) text.pop_back();
    if (continues)
      lines.back() += text;
    else
      lines.push_back(text);
    continues = more;
  }
  return lines;
}

double ExodusResults::global(int step, int variable) const {
  std::vector<double> values(variables_.global.size());
  file_.check(ex_get_var(file_.id(), step + 1, EX_GLOBAL, 1, 0, static_cast<int64_t>(values.size()), values.data()),
              "read the global variables");
  return values[variable];
}

std::vector<double> ExodusResults::nodal(int step, int variable) const {
  std::vector<double> values(mesh_.nodes.size());
  if (!values.empty())
    file_.check(
        ex_get_var(file_.id(), step + 1, EX_NODAL, variable + 1, 1, static_cast<int64_t>(values.size()), values.data()),
        "read " + variables_.nodal[variable]);
  return values;
}

std::vector<double> ExodusResults::element(int step, int variable) const {
  std::vector<double> values(mesh_.elements(), 0.0);
  double* begin = values.data();
  for (std::size_t b = 0; b < blockIds_.size(); ++b) {
    const int elements = mesh_.blocks[b].elements();
    if (elements > 0 && truth_[b * variables_.element.size() + static_cast<std::size_t>(variable)] != 0)
      file_.check(ex_get_var(file_.id(), step + 1, EX_ELEM_BLOCK, variable + 1, blockIds_[b], elements, begin),
                  "read " + variables_.element[variable]);
    begin += elements;
  }
  return values;
}

}  // namespace harmos::files
