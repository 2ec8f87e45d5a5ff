#include <harmos/study/PointsFile.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/input/ErrorList.hpp>

namespace harmos::study {

namespace {

/// The cells of a line, without quotes and surrounding blanks.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  bool isQuoted = false;
  for (const char c : line) {
    if (c == '"') {
      isQuoted = !isQuoted;
    } else if (c == ',' && !isQuoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) {
    const auto first = cell.find_first_not_of(" \t");
    cell = first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
  }
  return cells;
}

/// The next line that holds anything, and its number; false at the end.
bool nextLine(std::istream& stream, std::string& line, int& number) {
  while (std::getline(stream, line)) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::string mark = "\xEF\xBB\xBF";  // some spreadsheets begin UTF-8 with it
    if (number == 1 && line.compare(0, mark.size(), mark) == 0) line.erase(0, mark.size());
    if (line.find_first_not_of(" \t") != std::string::npos) return true;
  }
  return false;
}

}  // namespace

std::vector<std::vector<double>> readPoints(const std::string& path, const std::vector<std::string>& parameters) {
  std::ifstream stream(path);
  if (!stream) throw base::Error("Cannot read " + path + ": " + std::strerror(errno) + ".", base::ExitCode::input);
  input::ErrorList errors;
  std::string line;
  int number = 0;
  const auto where = [&] { return path + ":" + std::to_string(number); };
  if (!nextLine(stream, line, number)) {
    errors.add(path, "the file is empty.", "Its first line names the parameters: " + base::joinNames(parameters) + ".");
    errors.throwIfAny();
  }
  const std::vector<std::string> header = cellsOf(line);
  std::vector<std::size_t> columns;  // of the parameters
  for (const std::string& name : parameters) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      errors.add(where(), "there is no column \"" + name + "\".", base::suggestName(name, header, "The header has"));
    }
    columns.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  for (std::size_t c = 0; c < header.size(); ++c) {
    if (std::find(parameters.begin(), parameters.end(), header[c]) == parameters.end()) {
      errors.add(where(), "column " + std::to_string(c + 1) + " is \"" + header[c] + "\", which is no free parameter.",
                 base::suggestName(header[c], parameters, "Free parameters"));
    } else if (std::find(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(c), header[c]) !=
               header.begin() + static_cast<std::ptrdiff_t>(c)) {
      errors.add(where(), "the column \"" + header[c] + "\" is there twice.", "Remove one of them.");
    }
  }
  errors.throwIfAny();

  std::vector<std::vector<double>> points;
  while (nextLine(stream, line, number)) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() != header.size()) {
      errors.add(where(),
                 std::to_string(cells.size()) + " cells, but the header has " + std::to_string(header.size()) + ".");
      continue;
    }
    std::vector<double>& point = points.emplace_back();
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const auto value = base::parseNumber(cells[columns[p]]);
      if (!value) errors.add(where(), parameters[p] + ": \"" + cells[columns[p]] + "\" is not a finite number.");
      point.push_back(value.value_or(0.0));
    }
  }
  if (points.empty() && errors.count() == 0) errors.add(path, "there is no row after the header.");
  errors.throwIfAny();
  return points;
}

}  // namespace harmos::study
