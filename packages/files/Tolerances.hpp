#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace harmos::files {

/// When two values count as equal.
struct Tolerance {
  /// What the difference is divided by; ignore: it is 0.
  enum class Kind { relative, absolute, combined, ignore };
  Kind kind = Kind::relative;  // how differences are measured
  double value = 1e-6;         // largest difference of equal values; of absolute ones in the unit of the variable
  double floor = 0.0;          // two values that are both not above it in magnitude are equal

  /// |a - b|, divided by max(|a|, |b|) (relative) or by max(|a|, |b|, 1) (combined); 0 below the floor, infinite when
  /// one of them, or both, are not finite. Of ignored ones 0.
  double difference(double a, double b) const;
  /// Whether the difference is not above `value`.
  bool accepts(double a, double b) const { return !(difference(a, b) > value); }
  /// As in a command file: "relative 1e-06 floor 1e-12".
  std::string text() const;
};

/// What a variable has one value of at each time: the whole model, a node or an element.
enum class VariableKind { global, nodal, element };

/// What `harmos compare` compares and how strictly, as in a command file of exodiff, of which this is a subset:
///
///     # comment
///     DEFAULT TOLERANCE relative 1e-6 floor 1e-12
///     COORDINATES absolute 1e-8
///     TIME STEPS relative 1e-9 floor 0
///     NODAL VARIABLES relative 1e-6
///         disp_x absolute 1e-7
///     ELEMENT VARIABLES (all)
///         von_mises relative 1e-4 floor 1e-3
///         !stress_xy
///     GLOBAL VARIABLES
///
/// Variable lines are indented. A section without variables takes all of them; one with names takes only those, unless
/// it says "(all)" or all its names are excluded with "!"; a kind without a section is not compared. The default
/// is that of the sections after it; coordinates and times without a section have relative 1e-6. Names and keywords
/// may be in upper or lower case. Kinds of tolerance: relative, absolute, combined, ignore.
class Tolerances {
 public:
  /// Everything relative 1e-6, without a floor.
  Tolerances();
  /// Throws base::Error(ExitCode::input) naming file, line and what is allowed, also when nothing is to be compared.
  static Tolerances read(const std::string& path);
  /// The same of the text of such a file.
  static Tolerances parse(const std::string& text, const std::string& nameInMessages);

  /// Nothing: the variable is not to be compared.
  std::optional<Tolerance> find(VariableKind kind, const std::string& variable) const;
  /// Names that the file asks for, in lower case and in its order; they must exist in both files.
  std::vector<std::string> requested(VariableKind kind) const;
  /// That of the times of the steps.
  const Tolerance& times() const { return times_; }
  /// Distance up to which two nodes are the same [length], for a model of extent `size` [length]. An absolute tolerance
  /// of coordinates is this distance, any other one is relative to `size`. The default is 1e-6 of it.
  double distance(double size) const;

 private:
  struct Variable {
    std::string name;
    bool excluded = false;
    Tolerance tolerance;
  };
  struct Section {
    bool present = false;
    bool all = false;
    Tolerance tolerance;
    std::vector<Variable> variables;
  };
  Section& section(VariableKind kind) { return sections_[static_cast<std::size_t>(kind)]; }
  const Section& section(VariableKind kind) const { return sections_[static_cast<std::size_t>(kind)]; }

  Tolerance coordinates_, times_;
  std::array<Section, 3> sections_;
};

}  // namespace harmos::files
