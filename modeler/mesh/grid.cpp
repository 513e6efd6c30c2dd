#include "modeler/mesh/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "modeler/arrange/edge_order.h"
#include "modeler/arrange/exact_points.h"

namespace whittle {
namespace {

struct PointHash {
    std::size_t operator()(const GridPoint& p) const {
        std::uint64_t h = 0x9E3779B97F4A7C15ULL;
        for (const std::int64_t x : p) h = (h ^ static_cast<std::uint64_t>(x)) * 0xD6E8FEB86659FD93ULL, h ^= h >> 32;
        return h;
    }
};

// Finds equal points: first come, first numbered.
class PointIndex {
public:
    explicit PointIndex(std::size_t expected) { map_.reserve(expected); }
    std::uint32_t put(const GridPoint& p, std::vector<GridPoint>& points) {
        const auto [at, fresh] = map_.try_emplace(p, static_cast<std::uint32_t>(points.size()));
        if (fresh) points.push_back(p);
        return at->second;
    }

private:
    std::unordered_map<GridPoint, std::uint32_t, PointHash> map_;
};

// The directed edges of a mesh and the triangle each belongs to, sorted, so that the twin of an edge is found by bisection.
class EdgeIndex {
public:
    EdgeIndex(const std::vector<Triangle>& triangles, std::size_t points) {
        edges_.reserve(triangles.size() * 3);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) edges_.push_back({key(triangles[i][k], triangles[i][(k + 1) % 3]), static_cast<std::uint32_t>(i)});
        sort_edges(edges_, points, [](const Entry& e) { return e.edge >> 32; }, std::less<>());
    }
    // The triangle on the other side of (from, to) where it is the only one.
    std::optional<std::uint32_t> across(std::uint32_t from, std::uint32_t to) const {
        const std::uint64_t wanted = key(to, from);
        const auto at = std::lower_bound(edges_.begin(), edges_.end(), Entry{wanted, 0});
        if (at == edges_.end() || at->edge != wanted) return std::nullopt;
        const auto next = at + 1;
        if (next != edges_.end() && next->edge == wanted) return std::nullopt;
        return at->triangle;
    }

private:
    struct Entry {
        std::uint64_t edge;
        std::uint32_t triangle;
        auto operator<=>(const Entry&) const = default;
    };
    static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return static_cast<std::uint64_t>(a) << 32 | b; }
    std::vector<Entry> edges_;
};

// Two opposite triangles on the same three points enclose nothing: both go.
void drop_folded_pairs(std::vector<Triangle>& triangles, std::vector<std::uint32_t>& group) {
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto sorted_corners = [&](std::size_t i) {
        Triangle t = triangles[i];
        std::sort(t.begin(), t.end());
        return t;
    };
    std::vector<Triangle> corners(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) corners[i] = sorted_corners(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return corners[a] != corners[b] ? corners[a] < corners[b] : a < b; });
    std::vector<bool> gone(triangles.size(), false);
    bool any = false;
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        if (corners[order[i]] == corners[order[i + 1]]) {
            gone[order[i]] = gone[order[i + 1]] = any = true;
            ++i;
        }
    if (!any) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (gone[i]) continue;
        triangles[kept] = triangles[i];
        if (!group.empty()) group[kept] = group[i];
        ++kept;
    }
    triangles.resize(kept);
    if (!group.empty()) group.resize(kept);
}

// One tag for each region of exactly coplanar triangles of a group that hang together by edges.
FacetTag tag_facets(GridMesh& mesh, const std::vector<std::uint32_t>& group) {
    constexpr FacetTag kNone = std::numeric_limits<FacetTag>::max();
    mesh.tags.assign(mesh.triangles.size(), kNone);
    const EdgeIndex edges(mesh.triangles, mesh.points.size());
    FacetTag count = 0;
    const auto plane_of = [&](const Triangle& t) { return plane_through(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]); };
    std::vector<std::uint32_t> todo;
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (mesh.tags[seed] != kNone) continue;
        const Triangle base = mesh.triangles[seed];
        mesh.tags[seed] = count;
        todo.assign(1, seed);
        const ExactPlane plane = plane_of(base);
        if (!plane.valid()) todo.clear();  // everything would be coplanar with it
        while (!todo.empty()) {
            const Triangle t = mesh.triangles[todo.back()];
            todo.pop_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto other = edges.across(t[k], t[(k + 1) % 3]);
                if (!other || mesh.tags[*other] != kNone || (!group.empty() && group[*other] != group[seed])) continue;
                const Triangle& o = mesh.triangles[*other];
                const auto flat = [&](std::uint32_t v) { return side_of(plane, mesh.points[v]) == 0; };
                if (!flat(o[0]) || !flat(o[1]) || !flat(o[2]) || !plane_of(o).valid()) continue;
                mesh.tags[*other] = count;
                todo.push_back(*other);
            }
        }
        ++count;
    }
    return count;
}

// Numbers the tags anew, group by group, and gives the first of each.
std::vector<FacetTag> sort_tags(GridMesh& mesh, FacetTag tag_count, const std::vector<std::uint32_t>& group, std::uint32_t group_count) {
    std::vector<std::uint32_t> group_of(tag_count, 0);
    for (std::size_t i = 0; i < group.size(); ++i) group_of[mesh.tags[i]] = group[i];
    std::vector<FacetTag> next(group_count + 1, 0);
    for (const std::uint32_t g : group_of) ++next[g + 1];
    for (std::uint32_t g = 0; g < group_count; ++g) next[g + 1] += next[g];
    next.pop_back();
    const std::vector<FacetTag> starts = next;
    std::vector<FacetTag> renamed(tag_count);
    for (FacetTag t = 0; t < tag_count; ++t) renamed[t] = next[group_of[t]]++;
    for (FacetTag& t : mesh.tags) t = renamed[t];
    return starts;
}

// Moves the low corner of the box to the origin and drops points no triangle uses.
void normalise(SnappedLeaf& leaf) {
    std::vector<std::uint32_t> renamed(leaf.mesh.points.size(), std::numeric_limits<std::uint32_t>::max());
    std::vector<GridPoint> used;
    for (Triangle& t : leaf.mesh.triangles)
        for (std::uint32_t& v : t) {
            if (renamed[v] == std::numeric_limits<std::uint32_t>::max()) {
                renamed[v] = static_cast<std::uint32_t>(used.size());
                used.push_back(leaf.mesh.points[v]);
            }
            v = renamed[v];
        }
    GridPoint lo = used.front(), hi = used.front();
    for (const GridPoint& p : used)
        for (std::size_t i = 0; i < 3; ++i) lo[i] = std::min(lo[i], p[i]), hi[i] = std::max(hi[i], p[i]);
    for (GridPoint& p : used)
        for (std::size_t i = 0; i < 3; ++i) p[i] -= lo[i];
    leaf.mesh.points.swap(used);
    leaf.offset = lo;
    for (std::size_t i = 0; i < 3; ++i) leaf.size[i] = hi[i] - lo[i];
}

}  // namespace

struct KnownPoints::Table {
    std::unordered_map<GridPoint, Vec3, PointHash> map;
};
KnownPoints::KnownPoints() : table_(std::make_unique<Table>()) {}
KnownPoints::~KnownPoints() = default;
KnownPoints::KnownPoints(KnownPoints&&) noexcept = default;
KnownPoints& KnownPoints::operator=(KnownPoints&&) noexcept = default;
void KnownPoints::add(const GridPoint& at, const Vec3& was) { table_->map.try_emplace(at, was); }
const Vec3* KnownPoints::find(const GridPoint& at) const {
    const auto found = table_->map.find(at);
    return found == table_->map.end() ? nullptr : &found->second;
}

Grid Grid::for_sizes(double of_result, double of_leaves) {
    Grid grid;
    const double most = static_cast<double>(kLargestGridCoordinate) / 2, farthest = static_cast<double>(kLargestPlacedCoordinate) / 2;
    const auto fits = [&](double scale) { return of_result * scale <= most && of_leaves * scale <= farthest; };
    const int kMostDigits = 22;  // larger powers of ten are not doubles
    for (int digits = 0; digits < kMostDigits && fits(grid.per_mm * 10); ++digits) grid.per_mm *= 10;
    while (!fits(grid.per_mm)) grid.per_mm /= 10;
    return grid;
}

std::int64_t Grid::snapped(double value_mm) const { return std::llround(value_mm * per_mm); }

SnappedLeaf snap_leaf(const LeafMesh& leaf, const Placement& placement, const Placement& to_frame, const Grid& grid, KnownPoints& known) {
    SnappedLeaf out;
    PointIndex index(leaf.points.size());
    std::vector<std::uint32_t> renamed;
    renamed.reserve(leaf.points.size());
    for (const Vec3& p : leaf.points) {
        const Vec3 q = apply_to_point(placement, p), r = to_frame.is_identity() ? q : apply_to_point(to_frame, q);
        const GridPoint snapped{grid.snapped(r.x), grid.snapped(r.y), grid.snapped(r.z)};
        const std::size_t before = out.mesh.points.size();
        renamed.push_back(index.put(snapped, out.mesh.points));
        if (out.mesh.points.size() > before) known.add(snapped, q);
    }
    const bool mirrored = determinant(placement) < 0;
    out.mesh.triangles.reserve(leaf.triangles.size());
    std::vector<std::uint32_t> group;
    for (std::size_t i = 0; i < leaf.triangles.size(); ++i) {
        const Triangle& t = leaf.triangles[i];
        Triangle u{renamed[t[0]], renamed[t[1]], renamed[t[2]]};
        if (u[0] == u[1] || u[1] == u[2] || u[2] == u[0]) continue;
        if (mirrored) std::swap(u[1], u[2]);
        out.mesh.triangles.push_back(u);
        if (!leaf.group.empty()) group.push_back(leaf.group[i]);
    }
    drop_folded_pairs(out.mesh.triangles, group);
    if (out.mesh.triangles.empty()) return {};
    normalise(out);
    out.tag_count = tag_facets(out.mesh, group);
    if (!group.empty()) out.starts = sort_tags(out.mesh, out.tag_count, group, leaf.group_count);
    return out;
}

}  // namespace whittle
