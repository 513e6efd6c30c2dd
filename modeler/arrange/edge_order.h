// edge_order.h — sorts what knows the two ends of an edge, in time that grows with the number of edges alone.
//
// Dealt out by the lower end, then each hand sorted by itself: a corner has few edges. Sorting 3 million of them as a whole took five times as long.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace whittle {

// By low(e), then by `before`, which need not look at it. Requires: low(e) < `ends`. The order is that of a stable sort where `before` is a total order.
template <class Edge, class Low, class Before>
void sort_edges(std::vector<Edge>& edges, std::size_t ends, const Low& low, const Before& before) {
    std::vector<std::uint32_t> first(ends + 1, 0);
    for (const Edge& e : edges) ++first[low(e) + 1];
    for (std::size_t v = 0; v < ends; ++v) first[v + 1] += first[v];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    std::vector<Edge> dealt(edges.size());
    for (const Edge& e : edges) dealt[next[low(e)]++] = e;
    for (std::size_t v = 0; v < ends; ++v)
        if (first[v + 1] - first[v] > 1) std::sort(dealt.begin() + first[v], dealt.begin() + first[v + 1], before);
    edges = std::move(dealt);
}

}  // namespace whittle
