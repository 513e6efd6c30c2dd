#include "modeler/arrange/planar_mesh.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace whittle {

PlanarMesh::PlanarMesh(PointTable& points, const ExactPlane& plane, int axis, const GridPoint& lo, const GridPoint& hi)
    : points_(points), plane_(plane), axis_(axis) {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    const auto corner = [&](std::int64_t x, std::int64_t y) {
        GridPoint p{};
        p[i] = x, p[j] = y;
        new_vertex(points_.add(p));
    };
    corner(lo[i], lo[j]), corner(hi[i], lo[j]), corner(hi[i], hi[j]), corner(lo[i], hi[j]);
    local_.clear();  // the frame's corners are not points of the plane
    cells_.push_back({{0, 1, 2}, {kNone, kNone, 1}, {kNone, kNone, kNone}});
    cells_.push_back({{0, 2, 3}, {0, kNone, kNone}, {kNone, kNone, kNone}});
    at_ = {0, 0, 0, 1};
}

PlanarMesh::VertexId PlanarMesh::new_vertex(PointId p) {
    const auto v = static_cast<VertexId>(ids_.size());
    ids_.push_back(p);
    at_.push_back(0);
    local_.emplace(p, v);
    return v;
}

void PlanarMesh::insert(std::span<const PointId> points) {
    std::vector<PointId> order(points.begin(), points.end());
    std::sort(order.begin(), order.end());
    order.erase(std::unique(order.begin(), order.end()), order.end());
    constexpr std::size_t kMany = 48;
    if (order.size() > kMany) {  // there and back in strips, so that the next point is never far
        const auto i = static_cast<std::size_t>((axis_ + 1) % 3), j = static_cast<std::size_t>((axis_ + 2) % 3);
        const Approximate &lo = points_.near(ids_[0]), &hi = points_.near(ids_[2]);
        const double strips = std::ceil(std::sqrt(static_cast<double>(order.size()) / 2));
        const auto strip = [&](PointId p) { return static_cast<int>((points_.near(p)[i] - lo[i]) / (hi[i] - lo[i]) * strips); };
        std::sort(order.begin(), order.end(), [&](PointId a, PointId b) {
            const int s = strip(a), t = strip(b);
            if (s != t) return s < t;
            const double x = points_.near(a)[j], y = points_.near(b)[j];
            return x != y ? (x < y) == (s % 2 == 0) : a < b;
        });
    }
    for (const PointId p : order)
        if (!failed_) insert_point(p);
}

PlanarMesh::VertexId PlanarMesh::insert_point(PointId p) {
    if (const auto known = local_.find(p); known != local_.end()) return known->second;
    int zeros = 0;
    const Edge where = locate(p, zeros);
    if (where.first == kNone || zeros > 1) {
        failed_ = true;
        return 0;
    }
    const VertexId v = new_vertex(p);
    if (zeros == 0) {
        split_cell(where.first, v);
    } else {
        split_edge(where, v);
    }
    last_ = at_[v];
    return v;
}

// Walks towards p. `zeros` says how many edges of the cell p lies on.
PlanarMesh::Edge PlanarMesh::locate(PointId p, int& zeros) const {
    std::uint32_t t = last_;
    std::size_t turnings = 0;
    for (std::size_t steps = 0; steps < cells_.size() + 8; ++steps) {
        const Cell& c = cells_[t];
        zeros = 0;
        std::size_t on = 0;
        bool moved = false;
        for (std::size_t n = 0; n < 3; ++n) {
            const std::size_t k = (n + turnings) % 3;  // beginning elsewhere each time keeps a walk from going in circles for ever
            const int s = points_.turn(ids_[c.v[k]], ids_[c.v[next(k)]], p, axis_);
            if (s < 0) {
                t = c.across[k];
                if (t == kNone) return {kNone, 0};
                ++turnings;
                moved = true;
                break;
            }
            if (s == 0) ++zeros, on = k;
        }
        if (!moved) return {t, on};
    }
    return locate_slowly(p, zeros);
}

PlanarMesh::Edge PlanarMesh::locate_slowly(PointId p, int& zeros) const {
    for (std::uint32_t t = 0; t < cells_.size(); ++t) {
        const Cell& c = cells_[t];
        zeros = 0;
        std::size_t on = 0;
        bool inside = true;
        for (std::size_t k = 0; k < 3 && inside; ++k) {
            const int s = points_.turn(ids_[c.v[k]], ids_[c.v[next(k)]], p, axis_);
            inside = s >= 0;
            if (s == 0) ++zeros, on = k;
        }
        if (inside) return {t, on};
    }
    return {kNone, 0};
}

void PlanarMesh::replace_neighbour(std::uint32_t cell, std::uint32_t was, std::uint32_t is) {
    if (cell == kNone) return;
    for (std::uint32_t& n : cells_[cell].across)
        if (n == was) {
            n = is;
            return;
        }
}

std::size_t PlanarMesh::index_of(std::uint32_t cell, std::uint32_t neighbour) const {
    const auto& across = cells_[cell].across;
    return across[0] == neighbour ? 0 : across[1] == neighbour ? 1 : 2;
}

void PlanarMesh::split_cell(std::uint32_t t, VertexId p) {
    const Cell old = cells_[t];
    const auto t1 = static_cast<std::uint32_t>(cells_.size()), t2 = t1 + 1;
    const auto [a, b, c] = old.v;
    cells_[t] = {{a, b, p}, {old.across[0], t1, t2}, {old.support[0], kNone, kNone}};
    cells_.push_back({{b, c, p}, {old.across[1], t2, t}, {old.support[1], kNone, kNone}});
    cells_.push_back({{c, a, p}, {old.across[2], t, t1}, {old.support[2], kNone, kNone}});
    replace_neighbour(old.across[1], t, t1);
    replace_neighbour(old.across[2], t, t2);
    at_[a] = at_[b] = at_[p] = t;
    at_[c] = t1;
    std::vector<Edge> stack{{t, 0}, {t1, 0}, {t2, 0}};
    legalise(stack);
}

void PlanarMesh::split_edge(Edge edge, VertexId p) {
    const auto [t, k] = edge;
    const std::uint32_t u = cells_[t].across[k];
    if (u == kNone) {
        failed_ = true;
        return;
    }
    const std::size_t m = index_of(u, t);
    const Cell one = cells_[t], two = cells_[u];
    const VertexId a = one.v[k], b = one.v[next(k)], c = one.v[next(next(k))], d = two.v[next(next(m))];
    const std::uint32_t bc = one.across[next(k)], ca = one.across[next(next(k))], ad = two.across[next(m)], db = two.across[next(next(m))];
    const std::uint32_t s = one.support[k], s_bc = one.support[next(k)], s_ca = one.support[next(next(k))];
    const std::uint32_t s_ad = two.support[next(m)], s_db = two.support[next(next(m))];
    const auto t2 = static_cast<std::uint32_t>(cells_.size()), u2 = t2 + 1;
    cells_[t] = {{a, p, c}, {u2, t2, ca}, {s, kNone, s_ca}};
    cells_[u] = {{b, p, d}, {t2, u2, db}, {s, kNone, s_db}};
    cells_.push_back({{p, b, c}, {u, bc, t}, {s, s_bc, kNone}});
    cells_.push_back({{p, a, d}, {t, ad, u}, {s, s_ad, kNone}});
    replace_neighbour(bc, t, t2);
    replace_neighbour(ad, u, u2);
    at_[a] = at_[c] = at_[p] = t;
    at_[b] = at_[d] = u;
    std::vector<Edge> stack{{t, 2}, {t2, 1}, {u, 2}, {u2, 1}};
    legalise(stack);
}

// Replaces the edge by the other diagonal of the two cells beside it.
void PlanarMesh::flip(Edge edge) {
    const auto [t, k] = edge;
    const std::uint32_t u = cells_[t].across[k];
    const std::size_t m = index_of(u, t);
    const Cell one = cells_[t], two = cells_[u];
    const VertexId a = one.v[k], b = one.v[next(k)], c = one.v[next(next(k))], d = two.v[next(next(m))];
    const std::uint32_t bc = one.across[next(k)], ca = one.across[next(next(k))], ad = two.across[next(m)], db = two.across[next(next(m))];
    cells_[t] = {{a, d, c}, {ad, u, ca}, {two.support[next(m)], kNone, one.support[next(next(k))]}};
    cells_[u] = {{d, b, c}, {db, bc, t}, {two.support[next(next(m))], one.support[next(k)], kNone}};
    replace_neighbour(ad, u, t);
    replace_neighbour(bc, t, u);
    at_[a] = at_[c] = at_[d] = t;
    at_[b] = u;
}

bool PlanarMesh::convex(Edge edge) const {
    const auto [t, k] = edge;
    const std::uint32_t u = cells_[t].across[k];
    const Cell &one = cells_[t], &two = cells_[u];
    const VertexId a = one.v[k], b = one.v[next(k)], c = one.v[next(next(k))], d = two.v[next(next(index_of(u, t)))];
    return turn(a, d, c) > 0 && turn(d, b, c) > 0;
}

// Does the far corner lie in the circle by more than rounding, so that flips come to an end?
bool PlanarMesh::nicer_flipped(Edge edge) const {
    const auto [t, k] = edge;
    const std::uint32_t u = cells_[t].across[k];
    const Cell &one = cells_[t], &two = cells_[u];
    const auto i = static_cast<std::size_t>((axis_ + 1) % 3), j = static_cast<std::size_t>((axis_ + 2) % 3);
    const Approximate& d = points_.near(ids_[two.v[next(next(index_of(u, t)))]]);
    double x[3], y[3], r[3];
    for (std::size_t n = 0; n < 3; ++n) {
        const Approximate& p = points_.near(ids_[one.v[n]]);
        x[n] = p[i] - d[i], y[n] = p[j] - d[j], r[n] = x[n] * x[n] + y[n] * y[n];
    }
    double det = 0, size = 0;
    for (std::size_t n = 0; n < 3; ++n) {
        const std::size_t o = next(n), q = next(o);
        det += r[n] * (x[o] * y[q] - x[q] * y[o]);
        size += r[n] * (std::fabs(x[o] * y[q]) + std::fabs(x[q] * y[o]));
    }
    constexpr double kCircleError = 0x1p-44;  // of the sums above: 2^-49 would do
    return det > kCircleError * size;
}

void PlanarMesh::legalise(std::vector<Edge>& stack) {
    while (!stack.empty()) {
        const auto [t, k] = stack.back();
        stack.pop_back();
        const std::uint32_t u = cells_[t].across[k];
        if (u == kNone || cells_[t].support[k] != kNone || !nicer_flipped({t, k}) || !convex({t, k})) continue;
        flip({t, k});
        stack.insert(stack.end(), {{t, 0}, {t, 2}, {u, 0}, {u, 1}});
    }
}

void PlanarMesh::improve() {
    std::vector<Edge> stack;
    for (std::uint32_t t = 0; t < cells_.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (cells_[t].across[k] > t) stack.push_back({t, k});
    legalise(stack);
}

}  // namespace whittle
