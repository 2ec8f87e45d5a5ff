#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// Numbers side by side, of which there are few, and many of them are looked at together.
using Row = std::vector<double>;

/// Sum of the products of two rows of one length.
double dot(const Row& a, const Row& b);
/// to += factor x
void add(double factor, const Row& x, Row& to);
/// dot() of all pairs of rows.
base::Matrix productsOf(const std::vector<Row>& rows);
/// An orthonormal basis of what the rows span; directions in which the sum of squares is not above `none` are left out.
std::vector<Row> basisOf(const std::vector<Row>& rows, double none);

}  // namespace harmos::latin
