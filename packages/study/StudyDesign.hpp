#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <harmos/design/Design.hpp>
#include <harmos/design/Refinement.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::study {

/// All combinations of levels.
struct GridOptions {};

/// The rows of a table.
struct TableOptions {
  std::string file;  // relative to the file of the study
};

/// Points over a box, or over the distributions of random parameters.
struct SamplingOptions {
  int count = 0;
};

/// Points that are chosen as results come, for the surface of a response.
struct AdaptiveOptions {
  std::string response;
  design::Refinement::Options refinement;
};

/// Random configurations that are solved only to judge.
struct HoldOutOptions {
  int count = 0;
  int seed = 0;
};

/// Expansions that are solved for.
struct ChaosOptions {
  /// How laws meet expansions; automatic: see chooseLocalStage().
  enum class LocalStage { automatic, galerkin, pseudoSpectral };

  int order = 0;                                  // the highest, if there is a tolerance
  int points = 0;                                 // Gauss points of each germ; 0: as many as needed
  HoldOutOptions holdOuts;                        // by which the expansions are judged
  LocalStage localStage = LocalStage::automatic;  // as asked for
  std::optional<double> tolerance;                // of the standard deviation, from order to order
  std::optional<std::string> response;            // that it is of; absent: of all

  /// Whether the residual of every law shall be orthogonal to the polynomials, whatever it costs.
  bool wantsGalerkin() const { return localStage == LocalStage::galerkin; }
};

/// Expansions through the responses at the points of a quadrature.
struct CollocationOptions {
  int order = 0;
  int points = 0;  // as of chaos
  HoldOutOptions holdOuts;
  bool isSparse = false;
};

/// Piecewise linear interpolation over random parameters, whose points are chosen as results come.
struct InterpolationOptions {
  std::optional<std::string> response;  // that chooses the points; absent: all do
  double tolerance = 0.0;
  int largestCount = 0;
  HoldOutOptions holdOuts;
};

/// What a study wants by its list Design, read once.
struct StudyDesign {
  /// One kind per family of designs.
  using Options = std::variant<GridOptions, TableOptions, SamplingOptions, AdaptiveOptions, ChaosOptions,
                               CollocationOptions, InterpolationOptions>;

  std::string type = "Grid";                     // as in the input
  std::string where;                             // the list stands, for messages; absent: where the study does
  Options options;                               // of its kind
  std::shared_ptr<const design::Design> points;  // to begin with; null: of a table, quadrature or interpolation

  /// Null when it is a design of another kind.
  template <class Kind>
  const Kind* as() const {
    return std::get_if<Kind>(&options);
  }
  /// Whether it is made for random parameters alone.
  bool wantsRandomness() const { return as<ChaosOptions>() || as<CollocationOptions>() || as<InterpolationOptions>(); }
};

}  // namespace harmos::study
