#pragma once

#include <vector>

#include <harmos/mortar/detail/Cell.hpp>

namespace harmos::mortar {

/// How far flat cells lie from the curved surface that they stand for [length]: the largest |(n_b - n_a) . (b - a)| / 8
/// of two corners a, b of a cell, n the mean normal of the cells around a corner, which is the distance from chord to
/// arc where the surface is round. Corners around which normals differ by more than `creaseAngle` [degrees] lie on
/// edges that are meant, and do not count. O(n log n) for n cells.
double sagittaOf(const std::vector<Cell>& cells, double creaseAngle);

}  // namespace harmos::mortar
