#include <harmos/latin/detail/SymmetricEigen.hpp>

#include <algorithm>
#include <string>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::latin {

std::vector<double> symmetricEigen(base::Matrix& matrix) {
  const int n = matrix.numRows();
  std::vector<double> values(n);
  std::vector<double> work(std::max(1, 34 * n));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', n, matrix.values(), matrix.stride(), values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  if (info != 0) throw base::Error("LAPACK dsyev failed with info = " + std::to_string(info));
  return values;
}

}  // namespace harmos::latin
