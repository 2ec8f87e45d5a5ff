#include <harmos/substructure/SymmetricTriangle.hpp>

#include <algorithm>
#include <cstring>

namespace harmos::substructure {
namespace {

// Columns of the matrix that are read together: what a row of the result is loaded and stored for.
constexpr int panel = 4;

#define HARMOS_INLINE inline __attribute__((always_inline))

/// As many numbers as a register has bytes for.
template <class Number, int bytes>
struct Register {
  typedef Number Type __attribute__((vector_size(bytes)));
  static constexpr int width = bytes / static_cast<int>(sizeof(Number));
};

// From and to any place; by reference, since registers are no arguments where a processor may lack them.
template <class Number, class Numbers>
HARMOS_INLINE void load(const Number* from, Numbers& to) {
  std::memcpy(&to, from, sizeof(Numbers));
}

template <class Number, class Numbers>
HARMOS_INLINE void store(const Numbers& from, Number* to) {
  std::memcpy(to, &from, sizeof(Numbers));
}

/// y += A x for as many columns as a register has numbers, row by row.
template <class Number, int bytes>
HARMOS_INLINE void addProduct(const Number* a, int height, const Number* x, Number* y) {
  using Numbers = typename Register<Number, bytes>::Type;
  constexpr int width = Register<Number, bytes>::width;
  for (int first = 0; first < height; first += panel, x += panel * width, y += panel * width) {
    const int rows = height - first;
    const Number *a0 = a, *a1 = a0 + rows, *a2 = a1 + rows, *a3 = a2 + rows;
    Numbers x0, x1, x2, x3, xi, yi, y0{}, y1{}, y2{}, y3{};
    load(x, x0);
    load(x + width, x1);
    load(x + 2 * width, x2);
    load(x + 3 * width, x3);
    for (int i = panel; i < rows; ++i) {
      load(x + i * width, xi);
      load(y + i * width, yi);
      yi += a0[i] * x0;
      y0 += a0[i] * xi;
      yi += a1[i] * x1;
      y1 += a1[i] * xi;
      yi += a2[i] * x2;
      y2 += a2[i] * xi;
      yi += a3[i] * x3;
      y3 += a3[i] * xi;
      store(yi, y + i * width);
    }
    const Numbers* const sums[panel] = {&y0, &y1, &y2, &y3};
    for (int i = 0; i < panel; ++i) {
      load(y + i * width, yi);
      yi += *sums[i] + a0[i] * x0 + a1[i] * x1 + a2[i] * x2 + a3[i] * x3;
      store(yi, y + i * width);
    }
    a = a3 + rows;
  }
}

/// The same for one column, along which registers reach.
template <class Number, int bytes>
HARMOS_INLINE void addProductOfOne(const Number* a, int height, const Number* x, Number* y) {
  using Numbers = typename Register<Number, bytes>::Type;
  constexpr int width = Register<Number, bytes>::width;
  for (int first = 0; first < height; first += panel, x += panel, y += panel) {
    const int rows = height - first;
    const Number *a0 = a, *a1 = a0 + rows, *a2 = a1 + rows, *a3 = a2 + rows;
    const Number x0 = x[0], x1 = x[1], x2 = x[2], x3 = x[3];
    Numbers xi, yi, b0, b1, b2, b3, y0{}, y1{}, y2{}, y3{};
    int i = panel;
    for (; i + width <= rows; i += width) {
      load(x + i, xi);
      load(y + i, yi);
      load(a0 + i, b0);
      load(a1 + i, b1);
      load(a2 + i, b2);
      load(a3 + i, b3);
      y0 += b0 * xi;
      y1 += b1 * xi;
      y2 += b2 * xi;
      y3 += b3 * xi;
      yi += b0 * x0 + b1 * x1 + b2 * x2 + b3 * x3;
      store(yi, y + i);
    }
    Number sums[panel] = {};
    for (int c = 0; c < width; ++c) {
      sums[0] += y0[c];
      sums[1] += y1[c];
      sums[2] += y2[c];
      sums[3] += y3[c];
    }
    for (; i < rows; ++i) {
      sums[0] += a0[i] * x[i];
      sums[1] += a1[i] * x[i];
      sums[2] += a2[i] * x[i];
      sums[3] += a3[i] * x[i];
      y[i] += a0[i] * x0 + a1[i] * x1 + a2[i] * x2 + a3[i] * x3;
    }
    for (int c = 0; c < panel; ++c) y[c] += sums[c] + a0[c] * x0 + a1[c] * x1 + a2[c] * x2 + a3[c] * x3;
    a = a3 + rows;
  }
}

#undef HARMOS_INLINE

template <class Number>
using Product = void (*)(const Number* a, int height, const Number* x, Number* y);

template <class Number>
void narrowOfOne(const Number* a, int height, const Number* x, Number* y) {
  addProductOfOne<Number, 16>(a, height, x, y);
}

template <class Number>
void narrow(const Number* a, int height, const Number* x, Number* y) {
  addProduct<Number, 16>(a, height, x, y);
}

#ifdef __x86_64__
template <class Number>
__attribute__((target("avx2,fma"))) void wideOfOne(const Number* a, int height, const Number* x, Number* y) {
  addProductOfOne<Number, 32>(a, height, x, y);
}

template <class Number>
__attribute__((target("avx2,fma"))) void narrowWithAvx2(const Number* a, int height, const Number* x, Number* y) {
  addProduct<Number, 16>(a, height, x, y);
}

template <class Number>
__attribute__((target("avx2,fma"))) void wide(const Number* a, int height, const Number* x, Number* y) {
  addProduct<Number, 32>(a, height, x, y);
}

template <class Number>
__attribute__((target("avx512f,fma"))) void widest(const Number* a, int height, const Number* x, Number* y) {
  addProduct<Number, 64>(a, height, x, y);
}
#endif

/// A product with so many columns.
template <class Number>
struct Kernel {
  int columns;
  Product<Number> product;
};

/// What this processor has, the narrowest first.
template <class Number>
std::vector<Kernel<Number>> makeKernels() {
  constexpr int width = Register<Number, 16>::width;
#ifdef __x86_64__
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    std::vector<Kernel<Number>> kernels{
        {1, wideOfOne<Number>}, {width, narrowWithAvx2<Number>}, {2 * width, wide<Number>}};
    if (__builtin_cpu_supports("avx512f")) kernels.push_back({4 * width, widest<Number>});
    return kernels;
  }
#endif
  return {{1, narrowOfOne<Number>}, {width, narrow<Number>}};
}

}  // namespace

template <class Number>
SymmetricTriangle<Number>::SymmetricTriangle(int rows) : rows_(rows), height_((rows + panel - 1) / panel * panel) {
  const auto n = static_cast<std::size_t>(height_), w = static_cast<std::size_t>(panel);
  values_.assign(n * (n + w) / 2, Number(0));
}

template <class Number>
std::size_t SymmetricTriangle<Number>::at(int row, int column) const {
  const int begin = column - column % panel;
  const auto n = static_cast<std::size_t>(height_), first = static_cast<std::size_t>(begin);
  const std::size_t before = first * n - first * (first - (first > 0 ? panel : 0)) / 2;
  return before + static_cast<std::size_t>(column % panel) * (n - first) + static_cast<std::size_t>(row) - first;
}

template <class Number>
void SymmetricTriangle<Number>::set(int row, int column, double value) {
  const auto rounded = static_cast<Number>(value);
  const int upper = std::min(row, column), lower = std::max(row, column);
  values_[at(lower, upper)] = rounded;
  if (lower / panel == upper / panel) values_[at(upper, lower)] = rounded;
}

template <class Number>
void SymmetricTriangle<Number>::multiply(const base::Matrix& b, base::Matrix& x) const {
  static const std::vector<Kernel<Number>> kernels = makeKernels<Number>();
  const int columns = b.numCols();
  if (x.numRows() != rows_ || x.numCols() != columns) x.shapeUninitialized(rows_, columns);
  std::vector<Number> right, left;
  for (int first = 0; first < columns;) {
    const auto fits = [&](const Kernel<Number>& kernel) { return kernel.columns >= columns - first; };
    auto kernel = std::find_if(kernels.begin(), kernels.end(), fits);
    if (kernel == kernels.end()) --kernel;
    const int width = kernel->columns, count = std::min(width, columns - first);
    right.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height_), Number(0));
    left.assign(right.size(), Number(0));
    for (int j = 0; j < count; ++j) {
      for (int row = 0; row < rows_; ++row) right[row * width + j] = static_cast<Number>(b[first + j][row]);
    }
    kernel->product(values_.data(), height_, right.data(), left.data());
    for (int j = 0; j < count; ++j) {
      for (int row = 0; row < rows_; ++row) x[first + j][row] = left[row * width + j];
    }
    first += count;
  }
}

template class SymmetricTriangle<float>;
template class SymmetricTriangle<double>;

}  // namespace harmos::substructure
