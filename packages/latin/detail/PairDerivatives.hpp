#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/FaceSums.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/latin/PointwiseLocalStage.hpp>
#include <harmos/latin/detail/ParameterDifference.hpp>

namespace harmos::latin {

/// What the local stage makes of a small change of a parameter, load step after load step: df^ of the change of its
/// law, of the dbeta that comes with it, and of the history that the load steps before have left.
///
/// All three are one difference of the laws along the direction, so that any law will do. Displacement form.
class PairDerivatives {
 public:
  /// The laws of all interfaces where a difference asks them.
  struct Laws {
    /// One value of the parameter.
    struct At {
      DifferencePoint point;
      std::vector<std::shared_ptr<const laws::InterfaceLaw>> laws;
    };
    std::vector<At> at;
  };

  /// `assembly` and `lines`, whose buffers it uses, must outlive it. Begins before the first load step.
  PairDerivatives(const assembly::Assembly& assembly, InterfaceLines& lines, std::vector<Laws> parameters);

  /// Takes the lines and histories of a column that `local` has just met with solveColumn(). Not collective. Throws
  /// base::Error where a law that is no CoupledLaw has answered otherwise than to the pairs of an interface by
  /// themselves.
  void meet(int column, const PointwiseLocalStage& local);
  /// Collective. traction = df^ [stress per unit of the parameter] of dbeta, one column for each parameter.
  void apply(const base::Matrix& dbeta, base::Matrix& traction);
  /// The histories of the last apply() are those that the next load step begins with. Not collective.
  void accept();

 private:
  struct Joint {
    int step = 0;
    std::vector<laws::LocalLine> lines;
    std::vector<double> history;
    std::vector<std::vector<double>> before, after;     // dhistory of every parameter
    std::vector<std::vector<laws::LocalState>> states;  // df^ of every parameter
  };

  void demandSame(int interfaceIndex, const PointwiseLocalStage::Met& met);
  /// Lines and history at a value of the parameter, into shifted_ and oldHistory_; what is asked with them answers in
  /// moved_ and newHistory_.
  laws::NodeArrays shift(int interfaceIndex, int parameter, double offset, const std::vector<laws::LocalLine>& change);
  /// The share of moved_ and newHistory_ in the difference, that of the first value first; after the last one the
  /// tractions are written.
  void add(int interfaceIndex, int parameter, std::size_t value, base::Matrix& traction);
  /// Collective. The rows of laws over whole faces, whose dbeta was exchanged.
  void applyFaces(const base::Matrix& dbeta, base::Matrix& traction);

  const assembly::Assembly& assembly_;
  InterfaceLines& lines_;
  FaceSums faces_;
  std::vector<Laws> parameters_;
  std::vector<Joint> joints_;
  // Of one interface and parameter.
  std::vector<laws::LocalLine> shifted_;
  std::vector<double> oldHistory_, newHistory_;
  std::vector<laws::LocalState> moved_;
};

}  // namespace harmos::latin
