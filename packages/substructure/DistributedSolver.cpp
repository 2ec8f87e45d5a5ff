#include <harmos/substructure/DistributedSolver.hpp>

#include <string>
#include <utility>

#ifdef HARMOS_MUMPS
#include <exception>

#include <dmumps_c.h>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <harmos/substructure/detail/TrialSolution.hpp>
#endif

namespace harmos::substructure {

#ifdef HARMOS_MUMPS

namespace {

constexpr int start = -1, end = -2, analyseAndFactor = 4, solution = 3;  // MUMPS' jobs
constexpr int notPositive = -40, singular = -10;                         // and errors of its that are no lack of memory
constexpr int memoryMargin = 50;                                         // per cent, over what the structure asks for

}  // namespace

/// MUMPS' record, between its start and its end.
struct DistributedSolver::Mumps {
  explicit Mumps(const Teuchos::Comm<int>& comm) {
    record.comm_fortran = MPI_Comm_c2f(*dynamic_cast<const Teuchos::MpiComm<int>&>(comm).getRawMpiComm());
    record.sym = 1;  // positive definite
    record.par = 1;  // the first rank works as well
    run(start);
    const auto setting = [&](int number) -> int& { return record.icntl[number - 1]; };
    for (const int stream : {1, 2, 3, 4}) setting(stream) = 0;  // says nothing
    setting(14) = memoryMargin;
    setting(18) = 3;  // every rank has entries
  }
  ~Mumps() {
    if (std::uncaught_exceptions() == exceptions) run(end);
  }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// MUMPS' error, the same on all ranks; not negative: none.
  int run(int job) {
    record.job = job;
    dmumps_c(&record);
    return record.infog[0];
  }

  DMUMPS_STRUC_C record{};
  int exceptions = std::uncaught_exceptions();
};

bool DistributedSolver::exists() {
  return true;
}

DistributedSolver::DistributedSolver(int rows, SymmetricEntries addends, Teuchos::RCP<const Teuchos::Comm<int>> comm)
    : rows_(rows), comm_(std::move(comm)), mumps_(std::make_unique<Mumps>(*comm_)) {
  for (std::vector<int>* numbers : {&addends.rows, &addends.columns}) {
    for (int& number : *numbers) ++number;  // Fortran
  }
  DMUMPS_STRUC_C& record = mumps_->record;
  record.n = rows;
  record.nnz_loc = static_cast<MUMPS_INT8>(addends.values.size());
  record.irn_loc = addends.rows.data();
  record.jcn_loc = addends.columns.data();
  record.a_loc = addends.values.data();
  const int error = mumps_->run(analyseAndFactor);
  for (std::vector<int>* numbers : {&addends.rows, &addends.columns}) {
    for (int& number : *numbers) --number;
  }
  // MUMPS may have gone on with a negative pivot.
  const bool failed = error == notPositive || error == singular || (error >= 0 && record.infog[11] > 0);
  if (failed || (error >= 0 && !isPositive(addends))) {
    mumps_.reset();  // all ranks are here
    throw NotPositiveDefinite("a matrix that the ranks share is not positive definite");
  }
  if (error < 0) {
    const std::string numbers = std::to_string(error) + ", " + std::to_string(record.infog[1]);
    mumps_.reset();
    throw base::Error("a matrix of " + std::to_string(rows) +
                      " rows that the ranks share cannot be factored, most often for want of memory (MUMPS: error " +
                      numbers + "); take more ranks or fewer pieces");
  }
}

DistributedSolver::~DistributedSolver() = default;

bool DistributedSolver::isPositive(const SymmetricEntries& addends) const {
  const base::Matrix b = randomForces(rows_, 1);
  base::Matrix x;
  solve(b, x);
  std::vector<double> here(rows_, 0.0);
  for (std::size_t k = 0; k < addends.values.size(); ++k) {
    const int row = addends.rows[k], column = addends.columns[k];
    here[row] += addends.values[k] * x(column, 0);
    if (row != column) here[column] += addends.values[k] * x(row, 0);
  }
  base::Matrix product(rows_, 1), residual(b);
  Teuchos::reduceAll(*comm_, Teuchos::REDUCE_SUM, rows_, here.data(), product.values());
  residual -= product;
  return judge(b, x, residual) == Definiteness::positive;
}

void DistributedSolver::solve(const base::Matrix& b, base::Matrix& x) const {
  x = b;  // MUMPS overwrites the right-hand sides, those of the first rank
  DMUMPS_STRUC_C& record = mumps_->record;
  record.rhs = x.values();
  record.nrhs = x.numCols();
  record.lrhs = x.stride();
  const int error = mumps_->run(solution);
  if (error < 0) throw base::Error("MUMPS cannot solve: error " + std::to_string(error));
  Teuchos::broadcast(*comm_, 0, x.stride() * x.numCols(), x.values());
}

#else

struct DistributedSolver::Mumps {};

bool DistributedSolver::exists() {
  return false;
}

DistributedSolver::DistributedSolver(int rows, SymmetricEntries, Teuchos::RCP<const Teuchos::Comm<int>> comm)
    : rows_(rows), comm_(std::move(comm)) {
  throw base::Error("this build has no MUMPS");
}

DistributedSolver::~DistributedSolver() = default;

void DistributedSolver::solve(const base::Matrix&, base::Matrix&) const {}

#endif

}  // namespace harmos::substructure
