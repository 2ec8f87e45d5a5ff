#pragma once

#include <functional>
#include <vector>

namespace harmos::benchmarks {

using LinearMap = std::function<void(const std::vector<double>& x, std::vector<double>& y)>;

/// Solves A x = b by GMRES with right preconditioning until |b - A x| <= accuracy, at most `limit` iterations; x is the
/// start. Returns the iterations. Source: Saad (2003), algorithm 9.5.
int solveByGmres(const LinearMap& matrix, const LinearMap& preconditioner, const std::vector<double>& b,
                 double accuracy, int limit, std::vector<double>& x);

}  // namespace harmos::benchmarks
