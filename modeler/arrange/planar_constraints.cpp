// planar_constraints.cpp — segments in a PlanarMesh: they follow vertices in their way, and cross other segments in new points.
#include <algorithm>
#include <deque>

#include "modeler/arrange/planar_mesh.h"

namespace whittle {

std::uint32_t PlanarMesh::add_support(const LineSupport& support) {
    supports_.push_back(support);
    return static_cast<std::uint32_t>(supports_.size() - 1);
}

// Of three points in a line: does `via` lie on the side of `from` on which `to` does?
bool PlanarMesh::ahead(VertexId from, VertexId via, VertexId to) const {
    for (int n = 1; n <= 2; ++n) {
        const int k = (axis_ + n) % 3, s = points_.compare(ids_[from], ids_[to], k);
        if (s != 0) return points_.compare(ids_[from], ids_[via], k) == s;
    }
    return false;
}

// What lies first on the straight way: a vertex joined to `from` by an edge, or an edge opposite to it.
PlanarMesh::Step PlanarMesh::step_towards(VertexId from, VertexId to) const {
    const std::uint32_t start = at_[from];
    std::uint32_t t = start;
    bool backwards = false;
    for (std::size_t guard = 0; guard < 2 * cells_.size() + 2; ++guard) {
        const Cell& c = cells_[t];
        const std::size_t i = c.v[0] == from ? 0 : c.v[1] == from ? 1 : 2;
        const VertexId l = c.v[next(i)], r = c.v[next(next(i))];
        if (l == to || r == to) return {Step::Kind::kVertex, to, {}};
        const int left = turn(from, to, l), right = turn(from, to, r);
        if (left == 0 && ahead(from, l, to)) return {Step::Kind::kVertex, l, {}};
        if (right == 0 && ahead(from, r, to)) return {Step::Kind::kVertex, r, {}};
        if (left < 0 && right > 0) return {Step::Kind::kEdge, 0, {t, next(i)}};
        std::uint32_t on = backwards ? c.across[i] : c.across[next(next(i))];  // counter-clockwise over the edge to r
        if (on == kNone && !backwards) backwards = true, t = start, on = cells_[start].across[cells_[start].v[0] == from ? 0 : cells_[start].v[1] == from ? 1 : 2];
        if (on == kNone || (on == start && !backwards)) break;
        t = on;
    }
    return {};
}

std::optional<PlanarMesh::Edge> PlanarMesh::find_edge(VertexId a, VertexId b) const {
    const std::uint32_t start = at_[a];
    const auto slot = [&](std::uint32_t t) { return cells_[t].v[0] == a ? std::size_t{0} : cells_[t].v[1] == a ? std::size_t{1} : std::size_t{2}; };
    std::uint32_t t = start;
    for (std::size_t guard = 0; guard <= cells_.size(); ++guard) {
        const std::size_t i = slot(t);
        if (cells_[t].v[next(i)] == b) return Edge{t, i};
        t = cells_[t].across[next(next(i))];
        if (t == start) return std::nullopt;
        if (t == kNone) break;
    }
    for (t = cells_[start].across[slot(start)]; t != kNone; t = cells_[t].across[slot(t)])
        if (cells_[t].v[next(slot(t))] == b) return Edge{t, slot(t)};
    return std::nullopt;
}

void PlanarMesh::mark(VertexId a, VertexId b, std::uint32_t support) {
    const auto edge = find_edge(a, b);
    if (!edge) {
        failed_ = true;
        return;
    }
    const auto [t, k] = *edge;
    if (cells_[t].support[k] != kNone) return;
    cells_[t].support[k] = support;
    if (const std::uint32_t u = cells_[t].across[k]; u != kNone) cells_[u].support[index_of(u, t)] = support;
}

std::optional<PointId> PlanarMesh::crossing(std::uint32_t support, std::uint32_t other) {
    const LineSupport &p = supports_[support], &q = supports_[other];
    if (p.is_edge || q.is_edge) {
        const LineSupport &edge = p.is_edge ? p : q, &plane = p.is_edge ? q : p;
        const ExactPoint x = crossing_of(edge.a, edge.b, plane.plane);
        if (x.w.sign() == 0) return std::nullopt;
        return points_.add(x);
    }
    const auto x = common_point(plane_, p.plane, q.plane);
    if (!x) return std::nullopt;
    return points_.add(*x);
}

// Makes an edge from `from` to the first vertex on the way to `to`, past edges that are not constrained; a constrained one gets a vertex where it is
// crossed, and the way is to be looked at again (false).
bool PlanarMesh::open_way(VertexId from, VertexId to, std::uint32_t support, VertexId& reached) {
    const Step step = step_towards(from, to);
    if (step.kind == Step::Kind::kLost) {
        failed_ = true;
        return false;
    }
    if (step.kind == Step::Kind::kVertex) {
        reached = step.vertex;
        return true;
    }
    std::vector<std::array<VertexId, 2>> crossed;
    Edge edge = step.edge;
    while (true) {
        const auto [t, k] = edge;
        const Cell& c = cells_[t];
        if (c.support[k] != kNone) {
            const auto x = crossing(support, c.support[k]);
            if (!x || local_.contains(*x)) {
                failed_ = true;
                return false;
            }
            split_edge(edge, new_vertex(*x));
            return false;
        }
        crossed.push_back({c.v[k], c.v[next(k)]});
        const std::uint32_t u = c.across[k];
        if (u == kNone) {
            failed_ = true;
            return false;
        }
        const std::size_t m = index_of(u, t);
        const VertexId apex = cells_[u].v[next(next(m))];
        const int s = turn(from, to, apex);
        if (apex == to || s == 0) {
            reached = apex;
            break;
        }
        // u is (b, a, apex), b left of the way and a right of it
        edge = s < 0 ? Edge{u, next(next(m))} : Edge{u, next(m)};
    }
    clear_crossed(from, reached, crossed);
    return !failed_;
}

void PlanarMesh::clear_crossed(VertexId from, VertexId to, std::vector<std::array<VertexId, 2>>& crossed) {
    std::deque<std::array<VertexId, 2>> todo(crossed.begin(), crossed.end());
    const std::size_t most = 64 + 16 * todo.size() * todo.size();
    for (std::size_t n = 0; !todo.empty(); ++n) {
        const auto [a, b] = todo.front();
        todo.pop_front();
        const auto edge = find_edge(a, b);
        if (!edge || n > most) {
            failed_ = true;
            return;
        }
        if (!convex(*edge)) {
            todo.push_back({a, b});
            continue;
        }
        flip(*edge);
        const VertexId c = cells_[edge->first].v[2], d = cells_[edge->first].v[1];
        if (c == from || c == to || d == from || d == to) continue;
        if (turn(from, to, c) * turn(from, to, d) < 0) todo.push_back({c, d});
    }
}

void PlanarMesh::constrain(PointId from, PointId to, std::uint32_t support) {
    VertexId at = local_.at(from);
    const VertexId end = local_.at(to);
    while (at != end && !failed_) {
        VertexId reached = at;
        if (!open_way(at, end, support, reached)) continue;
        mark(at, reached, support);
        at = reached;
    }
}

}  // namespace whittle
