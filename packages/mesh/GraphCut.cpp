#include <harmos/mesh/detail/GraphCut.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <harmos/base/Error.hpp>

namespace harmos::mesh {
namespace {

/// Splits a connected group of at least two vertices in two: of a spanning tree, the branch nearest to half of it
/// becomes the group `colour`.
void splitGroup(const FaceGraph& graph, std::vector<idx_t>& group, idx_t which, idx_t colour) {
  std::vector<int> order, parent(group.size(), -1), branch(group.size(), 1);
  order.push_back(static_cast<int>(std::find(group.begin(), group.end(), which) - group.begin()));
  parent[order[0]] = order[0];
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto at = static_cast<std::size_t>(order[i]);
    for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
      const auto next = static_cast<std::size_t>(graph.neighbour[k]);
      if (group[next] != which || parent[next] >= 0) continue;
      parent[next] = order[i];
      order.push_back(static_cast<int>(next));
    }
  }
  const int half = static_cast<int>(order.size()) / 2;
  int best = order[1];
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    const auto at = static_cast<std::size_t>(order[i]);
    branch[parent[at]] += branch[at];
    if (std::abs(branch[at] - half) < std::abs(branch[best] - half)) best = order[i];
  }
  group[best] = colour;
  for (const int vertex : order) {
    const auto at = static_cast<std::size_t>(vertex);
    if (group[parent[at]] == colour && parent[at] != vertex) group[at] = colour;
  }
}

/// Makes the connected groups as many as the pieces asked for, which METIS misses on small graphs: joins the smallest
/// group to its smallest neighbour, or splits the largest.
void repairGroups(const FaceGraph& graph, std::vector<idx_t>& group, int count, int pieces) {
  while (count != pieces) {
    std::vector<int> size(count, 0);
    for (const idx_t of : group) ++size[of];
    const auto extreme = std::minmax_element(size.begin(), size.end());
    if (count < pieces) {
      splitGroup(graph, group, static_cast<idx_t>(extreme.second - size.begin()), count);
      ++count;
      continue;
    }
    const auto smallest = static_cast<idx_t>(extreme.first - size.begin());
    idx_t target = -1;
    for (std::size_t at = 0; at < group.size(); ++at) {
      if (group[at] != smallest) continue;
      for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
        const idx_t other = group[graph.neighbour[k]];
        if (other == smallest) continue;
        if (target < 0 || size[other] < size[target]) target = other;
      }
    }
    --count;
    for (idx_t& of : group) {
      if (of == smallest) of = target;
      if (of == count) of = smallest;
    }
  }
}

/// Cuts a connected graph into connected pieces; the piece of every vertex. Of METIS' two methods takes the one with
/// fewer cut faces among those in balance, since either may be far off on small graphs.
std::vector<idx_t> cutConnected(FaceGraph graph, int pieces) {
  std::vector<idx_t> best(graph.size(), 0);
  if (pieces == 1) return best;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // the same pieces in every run
  idx_t vertices = graph.size();
  idx_t weights = 1;
  idx_t parts = pieces;
  idx_t unused = 0;
  const auto elements = std::accumulate(graph.weight.begin(), graph.weight.end(), std::size_t{0});
  const std::size_t inBalance =
      (11 * elements + 10 * static_cast<std::size_t>(pieces) - 1) / (10 * static_cast<std::size_t>(pieces));
  std::pair<std::size_t, std::size_t> bestCost;
  for (const auto method : {METIS_PartGraphKway, METIS_PartGraphRecursive}) {
    options[METIS_OPTION_CONTIG] = method == METIS_PartGraphKway ? 1 : 0;
    std::vector<idx_t> piece(best.size());
    if (method(&vertices, &weights, graph.first.data(), graph.neighbour.data(), graph.weight.data(), nullptr, nullptr,
               &parts, nullptr, nullptr, options, &unused, piece.data()) != METIS_OK) {
      throw base::Error("METIS cannot cut the graph of elements; there may not be enough memory.");
    }
    int groups = 0;
    piece = connectedGroups(graph, piece, groups);
    repairGroups(graph, piece, groups, pieces);
    std::vector<std::size_t> size(pieces, 0);
    std::size_t cutFaces = 0;
    for (std::size_t at = 0; at < piece.size(); ++at) {
      size[piece[at]] += static_cast<std::size_t>(graph.weight[at]);
      for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
        if (piece[graph.neighbour[k]] != piece[at]) ++cutFaces;
      }
    }
    const std::pair cost(std::max(inBalance, *std::max_element(size.begin(), size.end())), cutFaces);
    if (method == METIS_PartGraphKway || cost < bestCost) {
      best = std::move(piece);
      bestCost = cost;
    }
  }
  return best;
}

/// Vertices that weigh more than one of so many pieces does on average, when each of them is a piece by itself; `mean`
/// becomes the weight of the other pieces.
std::vector<bool> heavyVertices(const FaceGraph& graph, int pieces, idx_t& mean) {
  std::vector<bool> isHeavy(graph.weight.size(), false);
  auto rest = std::accumulate(graph.weight.begin(), graph.weight.end(), idx_t{0});
  for (bool isDone = false; !isDone;) {
    isDone = true;
    for (std::size_t at = 0; at < isHeavy.size() && pieces > 1; ++at) {
      if (isHeavy[at] || graph.weight[at] <= rest / pieces) continue;
      isHeavy[at] = true;
      rest -= graph.weight[at];
      --pieces;
      isDone = false;
    }
  }
  mean = rest / pieces;
  return isHeavy;
}

}  // namespace

std::vector<int> shares(const std::vector<int>& sizes, int pieces) {
  std::vector<int> result(sizes.size(), 1);
  const auto pieceSize = [&](std::size_t body) { return static_cast<double>(sizes[body]) / result[body]; };
  for (int given = static_cast<int>(sizes.size()); given < pieces; ++given) {
    std::size_t largest = 0;
    for (std::size_t body = 1; body < sizes.size(); ++body) {
      if (pieceSize(body) > pieceSize(largest)) largest = body;
    }
    ++result[largest];
  }
  return result;
}

std::vector<idx_t> cutGraph(const FaceGraph& graph, int pieces) {
  // Beside heavy vertices METIS finds bad cuts of the others, so they are set apart, with what little they enclose.
  idx_t mean = 0;
  const std::vector<bool> isHeavy = heavyVertices(graph, pieces, mean);
  std::vector<idx_t> colour(isHeavy.size(), 0);
  for (std::size_t at = 0; at < colour.size(); ++at) colour[at] = isHeavy[at] ? static_cast<idx_t>(at) + 1 : 0;
  int count = 0;
  std::vector<idx_t> group = connectedGroups(graph, colour, count);
  std::vector<idx_t> size(count, 0), enclosing(count, 0);
  for (std::size_t at = 0; at < group.size(); ++at) {
    size[group[at]] += graph.weight[at];
    for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k)
      enclosing[group[at]] = std::max(enclosing[group[at]], colour[graph.neighbour[k]]);
  }
  for (std::size_t at = 0; at < group.size(); ++at) {
    if (2 * size[group[at]] < mean) colour[at] = enclosing[group[at]];
  }
  group = connectedGroups(graph, colour, count);
  if (count == 1 || count > pieces) return cutConnected(graph, pieces);
  std::vector<int> weight(count, 0), vertices(count, 0);
  for (std::size_t at = 0; at < group.size(); ++at) {
    ++vertices[group[at]];
    if (colour[at] == 0) weight[group[at]] += graph.weight[at];
  }
  const std::vector<int> share = shares(weight, pieces);
  std::vector<idx_t> result(group.size());
  idx_t first = 0;
  for (int one = 0; one < count; first += share[one], ++one) {
    if (share[one] > vertices[one]) return cutConnected(graph, pieces);
    std::vector<int> members;
    const std::vector<idx_t> piece = cutConnected(partOf(graph, group, one, members), share[one]);
    for (std::size_t i = 0; i < members.size(); ++i) result[members[i]] = first + piece[i];
  }
  return result;
}

}  // namespace harmos::mesh
