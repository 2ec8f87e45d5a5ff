#pragma once

#include <vector>

#include <harmos/mesh/detail/FaceGraph.hpp>

namespace harmos::mesh {

/// How many pieces each of some bodies gets: one, and the others where the pieces are largest.
std::vector<int> shares(const std::vector<int>& sizes, int pieces);

/// Cuts a connected graph into connected pieces of about the same weight, at most one for every vertex; the piece of
/// every vertex. Vertices that are heavier than pieces are such by themselves, with what little they enclose, where
/// what is left can still be shared out. The same in every run. Throws base::Error when METIS has not enough memory.
/// Source: Karypis, Kumar (1998), doi:10.1137/S1064827595287997.
std::vector<idx_t> cutGraph(const FaceGraph& graph, int pieces);

}  // namespace harmos::mesh
