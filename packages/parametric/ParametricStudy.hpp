#pragma once

#include <harmos/parametric/CalibratedSchedule.hpp>
#include <harmos/parametric/CertifiedSchedule.hpp>

/// Many configurations on the same operators: starts from solved states, and estimates calibrated with them.
namespace harmos::parametric {

/// Solves the configurations of a study on operators that are factored once.
///
/// A configuration changes laws only: friction, preload, stiffness of interfaces, prescribed displacements and
/// tractions. The accuracy is that of the responses and of the field of interface forces; see CalibratedSchedule.
/// Studies of fewer than 10 configurations, the velocity form and the algorithms of the literature get a certificate
/// for each configuration; see CertifiedSchedule. All calls are collective over the communicator.
class ParametricStudy {
 public:
  /// Puts the laws of a configuration into the assembly.
  using Install = StudySolver::Install;

  /// Factors all operators. `assembly` and `timers` must outlive this object. Throws base::Error as
  /// latin::LatinSolver.
  ParametricStudy(assembly::Assembly& assembly, Install install,
                  std::vector<std::shared_ptr<const latin::Response>> responses, const latin::LatinOptions& options,
                  const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);

  /// Asked on every rank between iterations; when it is true on any rank, run() leaves at once and what is in flight is
  /// not recorded.
  void setInterrupt(std::function<bool()> interrupted) { solver_.setInterrupt(std::move(interrupted)); }

  /// Called on every rank with the fields of every solution, also of one that replaces an earlier one.
  void setObserver(StudySolver::Observer observer) { solver_.setObserver(std::move(observer)); }

  /// At most so many configurations march side by side, at least 1: what they wait for is solved together.
  void setWidestBatch(int widest) { calibrated_.setWidest(widest); }

  /// Goes on from what another run of this study has found, before the first run(): its calibrations and audits count
  /// as if they were of this one, and what it has accepted is taken up again when a ratio falls.
  void resume(const std::vector<EarlierResult>& earlier);
  /// Solves all of `open`. `sink` is called on every rank; a configuration may be reported again when its estimate or
  /// its solution has changed. What is solved serves later calls as well.
  void run(const std::vector<design::Configuration>& open, results::ResultSink& sink);
  /// Of all calls of run() together; lives as long as this object.
  const Trust& summary() { return solver_.summary(); }

 private:
  StudySolver solver_;
  int solvedEarlier_ = 0;  // by another run
  CalibratedSchedule calibrated_;
  CertifiedSchedule certified_;
};

/// Whether each of so many configurations gets a certificate of its own, by CertifiedSchedule; the others march from
/// their neighbours, by CalibratedSchedule.
bool certifiesEach(const latin::LatinOptions& options, std::size_t configurations);

/// `options` for a study of so many configurations with so many load steps: how many solves are expected, which decide
/// whether operators that solve single load steps faster pay.
latin::LatinOptions optionsForStudy(latin::LatinOptions options, std::size_t configurations, int steps);

}  // namespace harmos::parametric
