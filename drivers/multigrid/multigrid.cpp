#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/MultigridLibrary.hpp>

namespace {

// Unknowns of the coarsest level, which is factored: few beside those of parts for which this is made.
constexpr int coarsestUnknowns = 1000;
// Of the polynomial that smooths, and of the largest eigenvalue to the smallest that it damps: more than the usual 2
// and 7, which take four times as many iterations where elements are long or flat.
constexpr int degree = 3;
constexpr double eigenvalueRatio = 10.0;

}  // namespace

extern "C" void harmosMakeMultigrid(const Teuchos::RCP<const harmos::base::CrsMatrix>& matrix,
                                    const Teuchos::RCP<harmos::base::MultiVector>& nearKernel, int components,
                                    Teuchos::RCP<harmos::base::Operator>& multigrid) {
  Teuchos::ParameterList parameters;
  parameters.set("verbosity", "none");
  parameters.set("multigrid algorithm", "sa");
  parameters.set("problem: symmetric", true);
  parameters.set("transpose: use implicit", true);
  parameters.set("number of equations", components);
  parameters.set("coarse: max size", coarsestUnknowns);
  parameters.set("smoother: type", "CHEBYSHEV");
  parameters.sublist("smoother: params").set("chebyshev: degree", degree);
  parameters.sublist("smoother: params").set("chebyshev: ratio eigenvalue", eigenvalueRatio);
  parameters.sublist("user data").set("Nullspace", nearKernel);
  // MueLu asks for a matrix that may change, and changes none.
  const auto changeable = Teuchos::rcp_const_cast<harmos::base::CrsMatrix>(matrix);
  multigrid = MueLu::CreateTpetraPreconditioner<double, harmos::base::LocalOrdinal, harmos::base::GlobalOrdinal>(
      Teuchos::rcp_implicit_cast<harmos::base::Operator>(changeable), parameters);
}
