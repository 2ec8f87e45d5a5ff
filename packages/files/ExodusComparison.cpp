#include <harmos/files/ExodusComparison.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <tuple>

#include <harmos/files/detail/EntityMatch.hpp>
#include <harmos/files/detail/ExodusResults.hpp>
#include <harmos/files/detail/ForeignReading.hpp>

namespace harmos::files {

namespace {

const char* const kindNames[] = {"global", "nodal", "element"};

double extent(const ResultMesh& mesh) {
  if (mesh.nodes.empty()) return 0.0;
  base::Vector3 low = mesh.nodes[0], high = mesh.nodes[0];
  for (const auto& point : mesh.nodes)
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], point[d]);
      high[d] = std::max(high[d], point[d]);
    }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

const std::vector<std::string>& namesOf(const ResultVariables& variables, VariableKind kind) {
  return kind == VariableKind::global  ? variables.global
         : kind == VariableKind::nodal ? variables.nodal
                                       : variables.element;
}

std::vector<double> valuesOf(const ExodusResults& file, VariableKind kind, int step, int variable) {
  if (kind == VariableKind::global) return {file.global(step, variable)};
  return kind == VariableKind::nodal ? file.nodal(step, variable) : file.element(step, variable);
}

bool sameIgnoringCase(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

int positionOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return sameIgnoringCase(n, name); });
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::string place(const ResultMesh& mesh, VariableKind kind, int entity) {
  std::ostringstream text;
  if (kind == VariableKind::nodal) {
    const auto& point = mesh.nodes[entity];
    text << "(" << point[0] << ", " << point[1] << ", " << point[2] << ")";
  } else {
    int first = 0;
    for (const auto& block : mesh.blocks) {
      if (entity < first + block.elements()) {
        text << "block " << block.name;
        break;
      }
      first += block.elements();
    }
  }
  return text.str();
}

/// Compares one variable over all steps of both files.
VariableDifference compareVariable(const ExodusResults& a, const ExodusResults& b, VariableKind kind, int indexA,
                                   int indexB, const std::vector<int>& partner, const Tolerance& tolerance) {
  VariableDifference result;
  result.kind = kind;
  result.name = namesOf(a.variables(), kind)[indexA];
  result.tolerance = tolerance;
  int worst = -1;
  for (int step = 0; step < static_cast<int>(a.times().size()); ++step) {
    const auto valuesA = valuesOf(a, kind, step, indexA), valuesB = valuesOf(b, kind, step, indexB);
    for (std::size_t i = 0; i < valuesA.size(); ++i) {
      const int j = kind == VariableKind::global ? 0 : partner[i];
      if (j < 0) continue;  // a node of no element
      const double valueB = valuesB[j];
      const double difference = tolerance.difference(valuesA[i], valueB);
      if (difference > result.difference) {
        result.difference = difference;
        result.first = valuesA[i];
        result.second = valueB;
        result.step = step + 1;
        worst = static_cast<int>(i);
      }
    }
  }
  if (worst >= 0 && kind != VariableKind::global) {
    result.entity = worst + 1;
    result.where = place(a.mesh(), kind, worst);
  }
  return result;
}

void compareTimes(const ExodusResults& a, const ExodusResults& b, const Tolerance& tolerance,
                  std::vector<std::string>& mismatch) {
  if (a.times().size() != b.times().size()) {
    mismatch.push_back(std::to_string(a.times().size()) + " time steps in the first file, " +
                       std::to_string(b.times().size()) + " in the second");
    return;
  }
  for (std::size_t i = 0; i < a.times().size(); ++i) {
    if (tolerance.accepts(a.times()[i], b.times()[i])) continue;
    std::ostringstream text;
    text << std::setprecision(10) << "time of step " << i + 1 << ": " << a.times()[i] << " in the first file, "
         << b.times()[i] << " in the second";
    mismatch.push_back(text.str());
    return;
  }
}

}  // namespace

bool ExodusComparison::equal() const {
  return mismatch.empty() &&
         std::all_of(variables.begin(), variables.end(), [](const VariableDifference& v) { return v.equal(); });
}

namespace {

ExodusComparison compare(const ExodusResults& a, const ExodusResults& b, const Tolerances& tolerances) {
  ExodusComparison result;
  const EntityMatch match = matchEntities(a.mesh(), b.mesh(), tolerances.distance(extent(a.mesh())));
  result.mismatch = match.mismatch;
  compareTimes(a, b, tolerances.times(), result.mismatch);

  struct Pair {
    VariableKind kind;
    int a, b;
    Tolerance tolerance;
  };
  std::vector<Pair> pairs;
  for (const auto kind : {VariableKind::global, VariableKind::nodal, VariableKind::element}) {
    const auto& namesA = namesOf(a.variables(), kind);
    const auto& namesB = namesOf(b.variables(), kind);
    const auto missing = [&](const std::string& name, const char* where) {
      result.mismatch.push_back(std::string("the ") + where + " file has no " + kindNames[static_cast<int>(kind)] +
                                " variable " + name);
    };
    for (std::size_t i = 0; i < namesA.size(); ++i) {
      const auto tolerance = tolerances.find(kind, namesA[i]);
      if (!tolerance) continue;
      const int j = positionOf(namesA[i], namesB);
      if (j < 0)
        missing(namesA[i], "second");
      else
        pairs.push_back({kind, static_cast<int>(i), j, *tolerance});
    }
    for (const auto& name : namesB)
      if (tolerances.find(kind, name) && positionOf(name, namesA) < 0) missing(name, "first");
    for (const auto& name : tolerances.requested(kind))
      if (positionOf(name, namesA) < 0 && positionOf(name, namesB) < 0) missing(name, "first");
  }
  // Values of meshes or times that do not correspond say nothing.
  if (!match.mismatch.empty() || a.times().size() != b.times().size()) return result;
  for (const auto& pair : pairs)
    result.variables.push_back(compareVariable(a, b, pair.kind, pair.a, pair.b,
                                               pair.kind == VariableKind::element ? match.element : match.node,
                                               pair.tolerance));
  return result;
}

void put(ByteWriter& writer, const ExodusComparison& comparison) {
  writer.put(comparison.mismatch);
  writer.put(comparison.variables.size());
  for (const auto& v : comparison.variables) {
    writer.put(v.name);
    writer.put(v.where);
    writer.put(v.kind);
    writer.put(v.tolerance);
    writer.put(std::array<double, 3>{v.difference, v.first, v.second});
    writer.put(std::array<int, 2>{v.step, v.entity});
  }
}

ExodusComparison takeComparison(ByteReader& reader) {
  ExodusComparison comparison;
  reader.get(comparison.mismatch);
  for (auto left = reader.get<std::size_t>(); left > 0; --left) {
    auto& v = comparison.variables.emplace_back();
    reader.get(v.name);
    reader.get(v.where);
    reader.get(v.kind);
    reader.get(v.tolerance);
    std::array<double, 3> values{};
    reader.get(values);
    std::array<int, 2> place{};
    reader.get(place);
    std::tie(v.difference, v.first, v.second) = std::make_tuple(values[0], values[1], values[2]);
    std::tie(v.step, v.entity) = std::make_tuple(place[0], place[1]);
  }
  return comparison;
}

}  // namespace

ExodusComparison compareExodus(const std::string& first, const std::string& second, const Tolerances& tolerances) {
  ExodusComparison comparison;
  readForeign(
      {first, second},
      [&](ByteWriter& writer) { put(writer, compare(ExodusResults(first), ExodusResults(second), tolerances)); },
      [&](ByteReader& reader) { comparison = takeComparison(reader); });
  return comparison;
}

void print(std::ostream& stream, const ExodusComparison& comparison, bool onlyDifferences) {
  for (const auto& sentence : comparison.mismatch) stream << "different: " << sentence << ".\n";
  for (const auto& v : comparison.variables) {
    if (v.equal() && onlyDifferences) continue;
    std::ostringstream line;
    line << (v.equal() ? "same:      " : "different: ") << kindNames[static_cast<int>(v.kind)] << " " << v.name;
    if (v.step == 0) {
      line << " agrees everywhere";
    } else {
      line << std::setprecision(3) << ", worst difference " << v.difference << " (" << v.tolerance.text()
           << ") at step " << v.step;
      if (v.entity > 0)
        line << ", " << (v.kind == VariableKind::nodal ? "node " : "element ") << v.entity << " in " << v.where;
      line << std::setprecision(10) << ": " << v.first << " and " << v.second;
    }
    stream << line.str() << "\n";
  }
  stream << (comparison.equal() ? "The files are the same within the tolerances.\n" : "The files are different.\n");
}

}  // namespace harmos::files
