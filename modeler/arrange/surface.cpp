// surface.cpp — flat pieces of one facet become one polygon, straight pieces of its border one edge; what is left is triangulated anew.
//
// Which corners stay is decided for all facets at once: one that has exactly two edges, in one line, goes. So neighbours always agree.
#include "modeler/arrange/surface.h"

#include <map>

#include "modeler/arrange/edge_order.h"
#include "modeler/arrange/planar_mesh.h"
#include "modeler/arrange/sets.h"

namespace whittle {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

// A face of the result, counter-clockwise seen from outside.
struct OuterFace {
    std::array<PointId, 3> v;
    FacetTag tag = 0;
    std::uint32_t filled = OperandMatter::kNone;
    std::uint32_t cluster = 0;
    bool turned = false;  // its outside is the back of the plane
};

std::vector<OuterFace> outer_faces(const Patches& patches, std::span<const Operand> operands, const SmallFaces& small, const std::vector<FaceSides>& sides) {
    std::vector<OuterFace> out;
    for (std::size_t f = 0; f < small.faces.size(); ++f) {
        if (sides[f].front == sides[f].back) continue;
        const SmallFace& face = small.faces[f];
        OuterFace o{face.v, 0, OperandMatter::kNone, face.cluster, sides[f].front};
        if (o.turned) std::swap(o.v[1], o.v[2]);
        const Cover& cover = small.covers[face.cover];
        std::uint32_t shown = sides[f].shown;
        if (shown == FaceSides::kLeast)
            shown = std::min_element(cover.begin(), cover.end(), [&](const CoverEntry& a, const CoverEntry& b) {
                        return operands[patches.facets[a.facet].operand].number < operands[patches.facets[b.facet].operand].number;
                    })->facet;
        o.tag = patches.facets[shown].tag;
        const OperandMatter& matter = operands[patches.facets[shown].operand].matter;
        o.filled = matter.shows_filled ? sides[f].filled : matter.hides_cutters ? matter.fills : OperandMatter::kNone;
        out.push_back(o);
    }
    return out;
}

struct HalfEdge {
    PointId lo, hi;
    std::uint32_t face;
    bool forward;
};

std::vector<HalfEdge> half_edges_of(const std::vector<OuterFace>& faces, std::size_t points) {
    std::vector<HalfEdge> edges;
    edges.reserve(faces.size() * 3);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const PointId a = faces[f].v[k], b = faces[f].v[k == 2 ? 0 : k + 1];
            edges.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    sort_edges(edges, points, [](const HalfEdge& e) { return e.lo; }, [](const HalfEdge& a, const HalfEdge& b) { return a.hi != b.hi ? a.hi < b.hi : a.face < b.face; });
    return edges;
}

class Joiner {
public:
    Joiner(PointTable& points, const SmallFaces& small, std::vector<OuterFace>& faces)
        : points_(points), small_(small), faces_(faces), groups_(faces.size()), vertices_(points.size()) {}

    // The faces joined, in the order of the first face of each group; as they were where one could not be triangulated, which its input does not allow.
    // Counts vertices that went.
    std::vector<OuterFace> run(std::uint64_t& removed) {
        find_creases();
        find_removable(removed);
        std::map<std::uint32_t, Group> groups;
        std::vector<OuterFace> out;
        for (std::uint32_t f = 0; f < faces_.size(); ++f) {
            if (faces_[f].cluster == SmallFace::kWhole) {
                out.push_back(faces_[f]);
            } else {
                groups[groups_.find(f)].faces.push_back(f);
            }
        }
        for (const Crease& c : creases_) groups[groups_.find(c.face)].edges.push_back({c.from, c.to});
        for (const auto& [root, group] : groups)
            if (!emit(group, out)) return faces_;
        return out;
    }

private:
    struct Crease {
        PointId from, to;
        std::uint32_t face;  // on its left
    };
    struct Group {
        std::vector<std::uint32_t> faces;
        std::vector<std::array<PointId, 2>> edges;
    };
    // What meets at a point: its first two crease neighbours.
    struct Corner {
        std::uint32_t creases = 0;
        PointId neighbour[2]{kNone, kNone};
        std::uint32_t face = kNone;  // one of a cluster
        bool fixed = false;          // a face that is not cut has it
        bool removable = false;
    };

    bool same_facet(std::uint32_t a, std::uint32_t b) const {
        const OuterFace &f = faces_[a], &g = faces_[b];
        return f.cluster != SmallFace::kWhole && f.cluster == g.cluster && f.tag == g.tag && f.filled == g.filled && f.turned == g.turned;
    }

    void find_creases() {
        const auto edges = half_edges_of(faces_, points_.size());
        for (std::size_t i = 0, j; i < edges.size(); i = j) {
            for (j = i + 1; j < edges.size() && edges[j].lo == edges[i].lo && edges[j].hi == edges[i].hi; ++j) {}
            if (j - i == 2 && edges[i].forward != edges[i + 1].forward && same_facet(edges[i].face, edges[i + 1].face)) {
                groups_.join(edges[i].face, edges[i + 1].face);
                continue;
            }
            add_neighbour(edges[i].lo, edges[i].hi);
            add_neighbour(edges[i].hi, edges[i].lo);
            for (std::size_t k = i; k < j; ++k) {
                const HalfEdge& e = edges[k];
                if (faces_[e.face].cluster == SmallFace::kWhole) continue;
                creases_.push_back(e.forward ? Crease{e.lo, e.hi, e.face} : Crease{e.hi, e.lo, e.face});
            }
        }
        for (std::uint32_t f = 0; f < faces_.size(); ++f)
            for (const PointId v : faces_[f].v) {
                if (faces_[f].cluster == SmallFace::kWhole) {
                    vertices_[v].fixed = true;
                } else {
                    vertices_[v].face = f;
                }
            }
    }
    void add_neighbour(PointId at, PointId other) {
        Corner& c = vertices_[at];
        if (c.creases < 2) c.neighbour[c.creases] = other;
        ++c.creases;
    }

    void find_removable(std::uint64_t& removed) {
        for (PointId v = 0; v < vertices_.size(); ++v) {
            Corner& c = vertices_[v];
            if (c.fixed || c.face == kNone || (c.creases != 0 && c.creases != 2)) continue;
            c.removable = c.creases == 0 || between(c.neighbour[0], v, c.neighbour[1], small_.planes[faces_[c.face].cluster].largest_axis());
            removed += c.removable ? 1U : 0U;
        }
    }
    // Three points of a plane: is v strictly between the others, in a line with them?
    bool between(PointId a, PointId v, PointId b, int axis) const {
        if (points_.turn(a, v, b, axis) != 0) return false;
        for (int k = 0; k < 3; ++k)
            if (const int s = points_.compare(a, v, k); s != 0) return points_.compare(v, b, k) == s;
        return false;
    }

    // The last point of the straight way that begins from -> to.
    PointId end_of(PointId from, PointId to) const {
        while (vertices_[to].removable) {
            const Corner& c = vertices_[to];
            const PointId on = c.neighbour[0] == from ? c.neighbour[1] : c.neighbour[0];
            from = to;
            to = on;
        }
        return to;
    }

    bool emit(const Group& group, std::vector<OuterFace>& out) {
        bool changed = false;
        for (const std::uint32_t f : group.faces)
            for (const PointId v : faces_[f].v) changed = changed || vertices_[v].removable;
        if (changed) return retriangulated(group, out);
        for (const std::uint32_t f : group.faces) out.push_back(faces_[f]);
        return true;
    }

    bool retriangulated(const Group& group, std::vector<OuterFace>& out) {
        const OuterFace& model = faces_[group.faces.front()];
        const ExactPlane& plane = small_.planes[model.cluster];
        const int axis = plane.largest_axis();
        std::vector<PointId> points;
        for (const std::uint32_t f : group.faces)
            for (const PointId v : faces_[f].v)
                if (!vertices_[v].removable) points.push_back(v);
        std::vector<std::array<PointId, 2>> edges;  // with the group on their left, seen along the axis
        for (const auto& [a, b] : group.edges) {
            if (vertices_[a].removable) continue;
            const PointId end = end_of(a, b);
            edges.push_back(model.turned ? std::array{end, a} : std::array{a, end});
        }
        DoubleBox box = DoubleBox::at(points_.near(points.front()));
        for (const PointId p : points) box.include(points_.near(p));
        GridPoint lo, hi;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t margin = 16 + static_cast<std::int64_t>((box.hi[k] - box.lo[k]) / 4);
            lo[k] = static_cast<std::int64_t>(box.lo[k]) - margin;
            hi[k] = static_cast<std::int64_t>(box.hi[k]) + margin;
        }
        PlanarMesh mesh(points_, plane, axis, lo, hi);
        mesh.insert(points);
        const std::uint32_t line = mesh.add_support({});
        for (const auto& [a, b] : edges) mesh.constrain(a, b, line);
        mesh.improve();
        return !mesh.failed() && flood(mesh, edges, model, out);
    }

    bool flood(PlanarMesh& mesh, const std::vector<std::array<PointId, 2>>& edges, const OuterFace& model, std::vector<OuterFace>& out) {
        const auto& cells = mesh.cells();
        std::vector<bool> within(cells.size(), false);
        std::vector<std::uint32_t> todo;
        const auto reach = [&](std::uint32_t t) {
            if (!within[t]) within[t] = true, todo.push_back(t);
        };
        for (const auto& [a, b] : edges) mesh.along(a, b, [&](std::uint32_t t, std::size_t) { reach(t); });
        if (mesh.failed()) return false;
        while (!todo.empty()) {
            const std::uint32_t t = todo.back();
            todo.pop_back();
            for (std::size_t k = 0; k < 3; ++k) {
                if (cells[t].support[k] != PlanarMesh::kNone) continue;
                if (cells[t].across[k] == PlanarMesh::kNone) return false;
                reach(cells[t].across[k]);
            }
        }
        for (std::size_t t = 0; t < cells.size(); ++t) {
            if (!within[t]) continue;
            OuterFace face = model;
            for (std::size_t k = 0; k < 3; ++k) face.v[k] = mesh.point(cells[t].v[k]);
            if (model.turned) std::swap(face.v[1], face.v[2]);
            out.push_back(face);
        }
        return true;
    }

    PointTable& points_;
    const SmallFaces& small_;
    std::vector<OuterFace>& faces_;
    DisjointSets groups_;
    std::vector<Corner> vertices_;
    std::vector<Crease> creases_;
};

}  // namespace

ArrangedMesh surface_of(Patches& patches, std::span<const Operand> operands, const SmallFaces& small, const std::vector<FaceSides>& sides,
                        const ArrangeOptions& options, ArrangeStats& stats) {
    std::vector<OuterFace> faces = outer_faces(patches, operands, small, sides);
    if (options.join) faces = Joiner(patches.points, small, faces).run(stats.removed);
    ArrangedMesh out;
    std::vector<std::uint32_t> renamed(patches.points.size(), kNone);
    for (const OuterFace& f : faces) {
        std::array<std::uint32_t, 3> t{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& name = renamed[f.v[k]];
            if (name == kNone) {
                name = static_cast<std::uint32_t>(out.points.size());
                const Approximate& p = patches.points.near(f.v[k]);
                out.points.emplace_back(p[0], p[1], p[2]);
                out.on_grid = out.on_grid && patches.points.on_grid(f.v[k]);
            }
            t[k] = name;
        }
        out.triangles.push_back(t);
        out.tags.push_back(f.tag);
        if (options.matters) out.filled.push_back(f.filled);
    }
    return out;
}

}  // namespace whittle
