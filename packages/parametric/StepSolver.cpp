#include <harmos/parametric/StepSolver.hpp>

#include <algorithm>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::parametric {
namespace {

// Error of solves in single precision from which on they are made in double.
constexpr double tooRough = 1e-5;

}  // namespace

void StepSolver::updateLoads() {
  const latin::BodyOperators& operators = fixedPoint_.linearStage().operators();
  const bool isOther = offset_ == nullptr || changes_ != operators.loadChanges();
  changes_ = operators.loadChanges();
  const std::vector<int> here{isOther ? 1 : 0, operators.areLoaded() ? 1 : 0};
  std::vector<int> anywhere(2);
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_MAX, 2, here.data(), anywhere.data());
  if (anywhere[0] == 0) return;
  const base::Matrix nothing(fixedPoint_.layout().rows(), fixedPoint_.assembly().steps());
  // A copy of a matrix without rows would have no columns either.
  auto offset = std::make_shared<base::Matrix>(nothing.numRows(), nothing.numCols());
  if (anywhere[1] != 0) fixedPoint_.solveLinear(nothing, *offset);
  offset_ = std::move(offset);
}

void StepSolver::solve(const std::vector<Request>& requests) {
  if (precision_ == substructure::Precision::single && fixedPoint_.prepareSingle() > tooRough) {
    precision_ = substructure::Precision::exact;
  }
  const int rows = fixedPoint_.layout().rows();
  const int count = static_cast<int>(requests.size());
  x_.shapeUninitialized(rows, count);
  images_.shape(rows, count);  // the row that stands for none, on ranks without bodies, is not solved for
  for (int j = 0; j < count; ++j) std::copy_n(requests[j].x, rows, x_[j]);
  fixedPoint_.solveChange(x_, images_, precision_);
  for (int j = 0; j < count; ++j) std::copy_n(images_[j], rows, requests[j].image);
}

}  // namespace harmos::parametric
