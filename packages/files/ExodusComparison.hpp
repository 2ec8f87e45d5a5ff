#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <harmos/files/Tolerances.hpp>

namespace harmos::files {

/// The worst difference of one variable over all steps, nodes or elements.
struct VariableDifference {
  VariableKind kind = VariableKind::global;  // of the variable
  std::string name;                          // as in the first file
  Tolerance tolerance;                       // that it is held to
  double difference = 0.0;                   // as Tolerance::difference() measures it
  /// Value in the first file, in the unit of the variable.
  double first = 0.0, second = 0.0;  // value in the second file
  int step = 0;                      // from 1, as ParaView and ncdump count; 0 when nothing differs
  int entity = 0;                    // node or element of the first file, from 1; 0 for global variables
  std::string where;                 // block of the element, position of the node; empty for global variables
  /// Whether the difference is not above the tolerance.
  bool equal() const { return !(difference > tolerance.value); }
};

/// In what two result files differ.
struct ExodusComparison {
  std::vector<std::string> mismatch;  // of meshes, times and names; one sentence each
  /// Of all variables that are compared; empty when the meshes or the numbers of times do not correspond.
  std::vector<VariableDifference> variables;
  /// Whether there is no mismatch and all variables are equal.
  bool equal() const;
};

/// Compares two Exodus result files. Nodes and elements are matched by position, so that numbering and the number of
/// ranks that wrote the files do not matter; names of variables in upper or lower case. Throws
/// base::Error(ExitCode::input) when a file cannot be read.
ExodusComparison compareExodus(const std::string& first, const std::string& second, const Tolerances& tolerances);

/// One line per variable with its worst difference, then whether the files are the same; `onlyDifferences` leaves out
/// the variables that agree.
void print(std::ostream& stream, const ExodusComparison& comparison, bool onlyDifferences = false);

}  // namespace harmos::files
