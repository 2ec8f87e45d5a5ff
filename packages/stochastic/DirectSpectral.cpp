#include <harmos/stochastic/DirectSpectral.hpp>

#include <functional>

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::stochastic {
namespace {

using Operator = Tpetra::Operator<double, base::LocalOrdinal, base::GlobalOrdinal>;
using Map = Tpetra::Map<base::LocalOrdinal, base::GlobalOrdinal>;

constexpr int maximumIterations = 1000;

/// A function from column to column as an operator on this process.
class ColumnOperator final : public Operator {
 public:
  ColumnOperator(Teuchos::RCP<const Map> map, std::function<void(const double*, double*)> function)
      : map_(std::move(map)), function_(std::move(function)) {}
  Teuchos::RCP<const Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const Map> getRangeMap() const override { return map_; }
  void apply(const base::MultiVector& x, base::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    std::vector<double> image(map_->getGlobalNumElements());
    for (std::size_t j = 0; j < x.getNumVectors(); ++j) {
      function_(x.getData(j).getRawPtr(), image.data());
      const auto to = y.getDataNonConst(j);
      for (std::size_t i = 0; i < image.size(); ++i) {
        to[static_cast<Teuchos::Ordinal>(i)] =
            alpha * image[i] + (beta == 0.0 ? 0.0 : beta * to[static_cast<Teuchos::Ordinal>(i)]);
      }
    }
  }

 private:
  Teuchos::RCP<const Map> map_;
  std::function<void(const double*, double*)> function_;
};

}  // namespace

DirectSpectral::DirectSpectral(const assembly::Assembly& assembly, std::shared_ptr<const Projection> projection,
                               const Realisations& laws, const substructure::SolverOptions& solver,
                               base::Timers& timers)
    : projection_(std::move(projection)), solver_(solver), timers_(timers), system_([&] {
        const auto running = timers.start("assemble");
        return SpectralSystem(assembly, projection_, laws);
      }()) {}

void DirectSpectral::solve(Solver solver, double tolerance) {
  solution_.shape(unknowns(), system_.right().numCols());
  iterations_ = 0;
  if (solver == Solver::factorisation) {
    factor();
  } else {
    iterate(tolerance);
  }
}

substructure::SubstructureSolver DirectSpectral::factored(const Teuchos::RCP<base::CrsMatrix>& matrix,
                                                          int dimension) const {
  const auto running = timers_.start("factor");
  substructure::BoundaryTerm none;
  none.dimension = dimension;
  return {matrix, none, solver_, "the assembly"};
}

void DirectSpectral::factor() {
  const auto whole = factored(
      [&] {
        const auto running = timers_.start("assemble");
        return system_.wholeMatrix();
      }(),
      1);
  const auto running = timers_.start("solve");
  whole.solve(system_.right(), solution_);
}

void DirectSpectral::iterate(double tolerance) {
  const auto mean = factored(
      [&] {
        const auto running = timers_.start("assemble");
        return system_.meanMatrix();
      }(),
      system_.dimension());
  const auto running = timers_.start("solve");
  const int terms = projection_->terms();
  base::Matrix residual(system_.dofs(), terms), correction(system_.dofs(), terms);
  const auto precondition = [&](const double* from, double* to) {
    for (int a = 0; a < terms; ++a) {
      for (int dof = 0; dof < system_.dofs(); ++dof) residual(dof, a) = from[dof * terms + a];
    }
    mean.solve(residual, correction);
    for (int a = 0; a < terms; ++a) {
      for (int dof = 0; dof < system_.dofs(); ++dof) to[dof * terms + a] = correction(dof, a);
    }
  };
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(unknowns()), 0,
                                        Teuchos::rcp(new Teuchos::SerialComm<int>()), Tpetra::LocallyReplicated));
  const auto columns = static_cast<std::size_t>(solution_.numCols());
  const auto x = Teuchos::rcp(new base::MultiVector(map, columns));
  const auto b = Teuchos::rcp(new base::MultiVector(map, columns));
  for (std::size_t t = 0; t < columns; ++t) {
    std::copy_n(system_.right()[static_cast<int>(t)], unknowns(), b->getDataNonConst(t).begin());
  }
  const Teuchos::RCP<const Operator> matrix =
      Teuchos::rcp(new ColumnOperator(map, [&](const double* from, double* to) { system_.apply(from, to); }));
  const auto problem = Teuchos::rcp(new Belos::LinearProblem<double, base::MultiVector, Operator>(matrix, x, b));
  problem->setLeftPrec(Teuchos::rcp(new ColumnOperator(map, precondition)));
  problem->setProblem();
  const auto parameters = Teuchos::parameterList();
  parameters->set("Maximum Iterations", maximumIterations);
  parameters->set("Convergence Tolerance", tolerance);
  Belos::PseudoBlockCGSolMgr<double, base::MultiVector, Operator> manager(problem, parameters);
  const Belos::ReturnType end = manager.solve();
  iterations_ = manager.getNumIters();
  if (end != Belos::Converged) {
    throw base::Error("the conjugate gradients of the direct spectral method did not converge in " +
                          std::to_string(maximumIterations) + " iterations; is every random stiffness positive?",
                      base::ExitCode::notConverged);
  }
  for (std::size_t t = 0; t < columns; ++t) {
    const auto from = x->getData(t);
    std::copy(from.begin(), from.end(), solution_[static_cast<int>(t)]);
  }
}

base::Matrix DirectSpectral::coefficients(const latin::DisplacementResponse& response) const {
  const int terms = projection_->terms();
  base::Matrix result(terms, solution_.numCols());
  for (const auto& node : response.nodes()) {
    const int dof = system_.dofOf(node.body, node.node);
    for (int t = 0; t < result.numCols(); ++t) {
      for (int c = 0; c < system_.dimension(); ++c) {
        const double weight = node.weight * response.direction()[c];
        for (int a = 0; a < terms; ++a) result(a, t) += weight * solution_((dof + c) * terms + a, t);
      }
    }
  }
  return result;
}

}  // namespace harmos::stochastic
