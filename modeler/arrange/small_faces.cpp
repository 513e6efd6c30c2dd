#include "modeler/arrange/small_faces.h"

#include <map>

#include "modeler/arrange/contacts.h"
#include "modeler/arrange/planar_mesh.h"
#include "modeler/arrange/sets.h"

namespace whittle {
namespace {

// What another piece leaves in a facet: a segment, or a point where from == to.
struct Trace {
    std::uint32_t facet;
    PointId from, to;
    std::uint32_t patch;  // the other piece
    auto operator<=>(const Trace&) const = default;
};

struct Meetings {
    std::vector<Trace> traces;
    DisjointSets planes;  // facets in one plane that touch
    std::vector<bool> shared;
    std::uint64_t pairs = 0;
};

// Is the trace a corner or an edge that the facet has anyway?
bool known_to(const Patches& patches, const Patch& patch, PointId from, PointId to) {
    const auto corners = patches.corners_of(patch);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (from == to) {
            if (corners[i] == from) return true;
            continue;
        }
        const PointId a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
        if ((a == from && b == to) || (a == to && b == from)) return patches.facets[patch.facet].patch_count == 1;
    }
    return false;
}

// A side of one piece may have corners in its middle; those within the segment are corners of the other facet too, even where the segment is its own edge.
void trace_corners(const Patches& patches, const Patch& of, const Contact& contact, const Patch& in, std::uint32_t number, std::vector<Trace>& out) {
    const auto strictly_within = [&](PointId p) {
        for (int k = 0; k < 3; ++k)
            if (const int s = patches.points.compare(contact.from, p, k); s != 0) return patches.points.compare(p, contact.to, k) == s;
        return false;
    };
    for (const PointId p : patches.corners_of(of))
        if (side_of(in.plane, patches.points.grid(p)) == 0 && strictly_within(p) && !known_to(patches, in, p, p)) out.push_back({in.facet, p, p, number});
}

Result<Meetings> meetings_of(Patches& patches, const BoxTree& all, const Buried& buried, const std::function<bool()>& cancelled) {
    Meetings out{{}, DisjointSets(patches.facets.size()), std::vector<bool>(patches.facets.size(), false)};
    bool stopped = false;
    constexpr std::uint64_t kAskEvery = 4096;
    const auto meet = [&](std::uint32_t i, std::uint32_t j) {
        if (stopped || (++out.pairs % kAskEvery == 0 && cancelled())) {
            stopped = true;
            return;
        }
        const Patch &a = patches.patches[i], &b = patches.patches[j];
        if (a.facet == b.facet) return;
        const Contact contact = contact_of(patches, a, b);
        if (contact.kind == Contact::Kind::kNone) return;
        if (contact.kind == Contact::Kind::kCoplanar) {
            out.planes.join(a.facet, b.facet);
            out.shared[a.facet] = out.shared[b.facet] = true;
            return;
        }
        if (!known_to(patches, a, contact.from, contact.to)) out.traces.push_back({a.facet, contact.from, contact.to, j});
        if (!known_to(patches, b, contact.from, contact.to)) out.traces.push_back({b.facet, contact.from, contact.to, i});
        if (contact.more_of_a) trace_corners(patches, a, contact, b, i, out.traces);
        if (contact.more_of_b) trace_corners(patches, b, contact, a, j, out.traces);
    };
    if (buried.count == 0) {
        all.pairs(meet);
    } else {
        std::vector<std::uint32_t> kept, owner;
        std::vector<DoubleBox> boxes;
        for (std::uint32_t i = 0; i < patches.patches.size(); ++i)
            if (!buried.facets[patches.patches[i].facet]) kept.push_back(i), boxes.push_back(patches.boxes[i]), owner.push_back(patches.owner[i]);
        BoxTree(std::move(boxes), std::move(owner)).pairs([&](std::uint32_t i, std::uint32_t j) { meet(kept[i], kept[j]); });
    }
    if (stopped) return fail(Fault::kInterrupted, "interrupted");
    return out;
}

// All facets of one plane that are to be cut together.
struct Cluster {
    std::vector<std::uint32_t> facets;
    std::vector<Trace> traces;
};

std::vector<Cluster> clusters_of(const Patches& patches, Meetings& meetings) {
    std::vector<bool> cut(patches.facets.size(), false);
    for (std::uint32_t f = 0; f < patches.facets.size(); ++f)
        if (meetings.shared[f]) cut[meetings.planes.find(f)] = true;
    for (const Trace& t : meetings.traces) cut[meetings.planes.find(t.facet)] = true;
    std::vector<std::uint32_t> number(patches.facets.size(), SmallFace::kWhole);
    std::vector<Cluster> clusters;
    for (std::uint32_t f = 0; f < patches.facets.size(); ++f) {
        const std::uint32_t root = meetings.planes.find(f);
        if (!cut[root]) continue;
        if (number[root] == SmallFace::kWhole) {
            number[root] = static_cast<std::uint32_t>(clusters.size());
            clusters.emplace_back();
        }
        clusters[number[root]].facets.push_back(f);
    }
    for (const Trace& t : meetings.traces) clusters[number[meetings.planes.find(t.facet)]].traces.push_back(t);
    return clusters;
}

// Covers by content.
class CoverTable {
public:
    explicit CoverTable(std::vector<Cover>& covers) : covers_(covers) { id({}); }
    std::uint32_t id(const Cover& cover) {
        const auto [at, fresh] = ids_.try_emplace(cover, static_cast<std::uint32_t>(covers_.size()));
        if (fresh) covers_.push_back(cover);
        return at->second;
    }
    // Numbers of the last cluster are not looked up again.
    void forget() {
        ids_.clear();
        ids_.try_emplace(Cover{}, 0U);
    }

private:
    std::map<Cover, std::uint32_t> ids_;
    std::vector<Cover>& covers_;
};

class ClusterCutter {
public:
    ClusterCutter(Patches& patches, SmallFaces& out) : patches_(patches), out_(out), covers_(out.covers) {}

    bool cut(const Cluster& cluster) {
        covers_.forget();
        const auto number = static_cast<std::uint32_t>(out_.planes.size());
        ExactPlane plane = patches_.patches[patches_.facets[cluster.facets.front()].first_patch].plane;
        axis_ = plane.largest_axis();
        if (plane.nd[static_cast<std::size_t>(axis_)] < 0)
            for (std::size_t i = 0; i < 3; ++i) plane.n[i] = -plane.n[i], plane.nd[i] = -plane.nd[i];
        out_.planes.push_back(plane);
        GridPoint lo, hi;
        find_frame(cluster, lo, hi);
        PlanarMesh mesh(patches_.points, plane, axis_, lo, hi);
        draw(cluster, mesh);
        if (mesh.failed() || !find_covers(cluster, mesh)) return false;
        for (std::uint32_t t = 0; t < mesh.cells().size(); ++t) {
            if (cover_of_[t] == 0 || cancels(out_.covers[cover_of_[t]])) continue;
            const auto& v = mesh.cells()[t].v;
            out_.faces.push_back({{mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])}, number, cover_of_[t], number});
        }
        return true;
    }

    void keep(std::uint32_t facet) {
        const Facet& f = patches_.facets[facet];
        const auto plane = static_cast<std::uint32_t>(out_.planes.size());
        out_.planes.push_back(patches_.patches[f.first_patch].plane);
        const auto cover = static_cast<std::uint32_t>(out_.covers.size());
        out_.covers.push_back({{facet, 1}});
        for (std::uint32_t i = 0; i < f.triangle_count; ++i)
            out_.faces.push_back({patches_.triangles[f.first_triangle + i], plane, cover, SmallFace::kWhole});
    }

private:
    void find_frame(const Cluster& cluster, GridPoint& lo, GridPoint& hi) const {
        DoubleBox box = patches_.boxes[patches_.facets[cluster.facets.front()].first_patch];
        for (const std::uint32_t f : cluster.facets)
            for (std::uint32_t i = 0; i < patches_.facets[f].patch_count; ++i) box.include(patches_.boxes[patches_.facets[f].first_patch + i]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t margin = 16 + static_cast<std::int64_t>((box.hi[k] - box.lo[k]) / 4);
            lo[k] = static_cast<std::int64_t>(box.lo[k]) - margin;
            hi[k] = static_cast<std::int64_t>(box.hi[k]) + margin;
        }
    }

    // Facets of one operand folded onto each other: no winding number changes here.
    bool cancels(const Cover& cover) const {
        if (cover.size() < 2) return false;
        std::vector<std::pair<std::uint32_t, int>> sums;
        for (const CoverEntry& e : cover) sums.emplace_back(patches_.facets[e.facet].operand, e.sign);
        std::sort(sums.begin(), sums.end());
        for (std::size_t i = 0, j; i < sums.size(); i = j) {
            int sum = 0;
            for (j = i; j < sums.size() && sums[j].first == sums[i].first; ++j) sum += sums[j].second;
            if (sum != 0) return false;
        }
        return true;
    }

    void draw(const Cluster& cluster, PlanarMesh& mesh) {
        std::vector<PointId> points;
        for (const std::uint32_t f : cluster.facets)
            for (const auto& [a, b] : patches_.borders_of(patches_.facets[f])) points.push_back(a), points.push_back(b);
        for (const Trace& t : cluster.traces) points.push_back(t.from), points.push_back(t.to);
        mesh.insert(points);
        std::vector<std::array<PointId, 2>> edges;
        for (const std::uint32_t f : cluster.facets)
            for (const auto& [a, b] : patches_.borders_of(patches_.facets[f])) edges.push_back({std::min(a, b), std::max(a, b)});
        sort_unique(edges);
        for (const auto& [a, b] : edges) {
            const GridPoint p = patches_.points.grid(a), q = patches_.points.grid(b);
            mesh.constrain(a, b, mesh.add_support({plane_along(p, q, axis_), true, p, q}));
        }
        std::vector<std::array<PointId, 3>> segments;
        for (const Trace& t : cluster.traces)
            if (t.from != t.to) segments.push_back({std::min(t.from, t.to), std::max(t.from, t.to), t.patch});
        sort_unique(segments);
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const auto& [a, b, patch] = segments[i];
            if (i > 0 && segments[i - 1][0] == a && segments[i - 1][1] == b) continue;
            mesh.constrain(a, b, mesh.add_support({patches_.patches[patch].plane, false, {}, {}}));
        }
    }

    template <class List>
    static void sort_unique(List& list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }

    // Winding numbers of every facet, from the frame inwards: to the left of a border they are one more than to its right.
    bool find_covers(const Cluster& cluster, PlanarMesh& mesh) {
        struct Step {
            std::uint32_t edge, facet;  // edge: 3 * cell + k
            int change;                 // from the cell over the edge
            auto operator<=>(const Step&) const = default;
        };
        std::vector<Step> steps;
        const auto& cells = mesh.cells();
        for (const std::uint32_t f : cluster.facets)
            for (const auto& [a, b] : patches_.borders_of(patches_.facets[f]))
                mesh.along(a, b, [&](std::uint32_t t, std::size_t k) {
                    const std::uint32_t u = cells[t].across[k];
                    std::uint32_t m = 0;
                    while (m < 2 && cells[u].across[m] != t) ++m;
                    steps.push_back({3 * t + static_cast<std::uint32_t>(k), f, -1});
                    steps.push_back({3 * u + m, f, 1});
                });
        if (mesh.failed()) return false;
        std::sort(steps.begin(), steps.end());
        cover_of_.assign(cells.size(), PlanarMesh::kNone);
        cover_of_[mesh.frame_cell()] = 0;
        todo_.assign(1, mesh.frame_cell());
        while (!todo_.empty()) {
            const std::uint32_t t = todo_.back();
            todo_.pop_back();
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t u = cells[t].across[k];
                if (u == PlanarMesh::kNone || cover_of_[u] != PlanarMesh::kNone) continue;
                Cover cover;
                auto at = std::lower_bound(steps.begin(), steps.end(), Step{3 * t + k, 0, -2});
                const bool same = at == steps.end() || at->edge != 3 * t + k;
                if (!same) {
                    cover = out_.covers[cover_of_[t]];
                    for (; at != steps.end() && at->edge == 3 * t + k; ++at) change(cover, at->facet, at->change);
                }
                cover_of_[u] = same ? cover_of_[t] : covers_.id(cover);
                todo_.push_back(u);
            }
        }
        return true;
    }

    static void change(Cover& cover, std::uint32_t facet, int by) {
        const auto at = std::lower_bound(cover.begin(), cover.end(), facet, [](const CoverEntry& e, std::uint32_t f) { return e.facet < f; });
        if (at == cover.end() || at->facet != facet) {
            cover.insert(at, {facet, by});
        } else if ((at->sign += by) == 0) {
            cover.erase(at);
        }
    }

    Patches& patches_;
    SmallFaces& out_;
    CoverTable covers_;
    int axis_ = 2;
    std::vector<std::uint32_t> cover_of_, todo_;
};

}  // namespace

Result<SmallFaces> small_faces_of(Patches& patches, const BoxTree& tree, const Buried& buried, const std::function<bool()>& cancelled) {
    auto meetings = meetings_of(patches, tree, buried, cancelled);
    if (!meetings) return tl::unexpected(meetings.error());
    const std::vector<Cluster> clusters = clusters_of(patches, *meetings);
    SmallFaces out;
    out.pairs = meetings->pairs;
    ClusterCutter cutter(patches, out);
    std::vector<bool> is_cut(patches.facets.size(), false);
    for (const Cluster& c : clusters) {
        if (cancelled()) return fail(Fault::kInterrupted, "interrupted");
        if (!cutter.cut(c)) return fail(Fault::kScene, "solids cannot be combined: a facet crosses itself");
        for (const std::uint32_t f : c.facets) is_cut[f] = true;
    }
    for (std::uint32_t f = 0; f < patches.facets.size(); ++f)
        if (!is_cut[f] && !buried.facets[f]) cutter.keep(f);
    return out;
}

}  // namespace whittle
