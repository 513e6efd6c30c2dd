// booleans_cgal.cpp — the one translation unit of CGAL booleans: corefinement over exact constructions, Nef polyhedra where it declines.
//
// Corefinement is quick but refuses results that are not 2-manifold (solids that touch along an edge). Those two operands are combined as Nef
// polyhedra; a result that is a 2-manifold goes on as a surface, any other stays a Nef polyhedron until the end.
// Source: CGAL 5.5 manual, Polygon Mesh Processing (corefinement) and 3D Boolean Operations on Nef Polyhedra.
#include "modeler/mesh/cgal/ordered_blocks.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "modeler/mesh/cgal/cgal_module.h"

namespace CGAL::Box_intersection_d {

// Corefinement breaks ties between boxes by their addresses, so the order in which it finds intersections, and with it the triangles it makes, would
// depend on the heap. Numbers in order of construction give every thread the same order.
template <>
class Box_with_info_d<double, 3, SM_Halfedge_index, ID_FROM_BOX_ADDRESS> : public Box_with_info_d<double, 3, SM_Halfedge_index, ID_EXPLICIT> {
public:
    using Box_with_info_d<double, 3, SM_Halfedge_index, ID_EXPLICIT>::Box_with_info_d;
};

}  // namespace CGAL::Box_intersection_d

namespace whittle {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Number = Kernel::FT;
using Surface = CGAL::Surface_mesh<Point>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Face = Surface::Face_index;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Tags = Surface::Property_map<Face, FacetTag>;

struct Interrupted {};

struct Soup {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    std::vector<FacetTag> tags;
};

// How a result was made.
struct Recipe {
    SetOp op;
    std::vector<PlacedExact> a, b;
};

// Either a 2-manifold surface, or a Nef polyhedron with its boundary as triangles. A surface that touches itself in a point (two vertices in one
// place) keeps its recipe: corefinement through that point is beyond CGAL, so it may have to be made again as a Nef polyhedron.
class Exact final : public ExactMesh {
public:
    Surface surface;
    std::optional<Recipe> pinched;
    std::optional<Nef> nef;
    Soup soup;
};

const Exact& implementation(const ExactMesh& mesh) { return static_cast<const Exact&>(mesh); }

Tags tags_of(Surface& surface) { return surface.add_property_map<Face, FacetTag>("f:tag", 0).first; }
Tags tags_of(const Surface& surface) { return surface.property_map<Face, FacetTag>("f:tag").first; }

// Forces every coordinate to its exact value: later filters and roundings then do not depend on what was asked before, by which thread.
void settle(const std::vector<Point>& points) {
    for (const Point& p : points) CGAL::exact(p);
}

template <class Range>
GridBox box_of_points(const Range& points) {
    GridBox box;
    bool first = true;
    for (const Point& p : points) {
        const auto b = p.bbox();
        for (int i = 0; i < 3; ++i) {
            const auto lo = static_cast<std::int64_t>(std::floor(b.min(i))), hi = static_cast<std::int64_t>(std::ceil(b.max(i)));
            const auto k = static_cast<std::size_t>(i);
            box.lo[k] = first ? lo : std::min(box.lo[k], lo);
            box.hi[k] = first ? hi : std::max(box.hi[k], hi);
        }
        first = false;
    }
    return box;
}

std::shared_ptr<Exact> finished(Surface&& surface) {
    auto result = std::make_shared<Exact>();
    surface.collect_garbage();
    for (Vertex v : surface.vertices()) CGAL::exact(surface.point(v));
    result->surface = std::move(surface);
    result->box = box_of_points(result->surface.points());
    result->triangles = result->surface.number_of_faces();
    return result;
}

// Carries tags through corefinement, and stops it.
struct TagVisitor : pmp::Corefinement::Default_visitor<Surface> {
    Surface* first = nullptr;
    Tags first_tags, second_tags;
    const MeshControl* control = nullptr;
    FacetTag current = 0;

    Tags& of(const Surface& s) { return &s == first ? first_tags : second_tags; }
    void before_subface_creations(Face f, Surface& s) {
        if (control && control->cancelled()) throw Interrupted{};
        current = of(s)[f];
    }
    void after_subface_created(Face f, Surface& s) { of(s)[f] = current; }
    void after_face_copy(Face source, Surface& from, Face target, Surface& to) { of(to)[target] = of(from)[source]; }
};

// ---------------------------------------------------------------------------------------------------------------- decimation

// Removes vertices inside a facet or on a straight border of two. Exact: no point moves, no set changes.
class Decimator {
public:
    explicit Decimator(Surface& surface) : s_(surface), tags_(tags_of(surface)) {}

    std::uint64_t run() {
        std::uint64_t removed = 0;
        std::vector<Vertex> queue(s_.vertices().begin(), s_.vertices().end()), again;
        while (!queue.empty()) {
            again.clear();
            std::uint64_t now = 0;
            for (Vertex v : queue)
                if (!s_.is_removed(v) && try_remove(v, again)) ++now;
            removed += now;
            std::sort(again.begin(), again.end());
            again.erase(std::unique(again.begin(), again.end()), again.end());
            queue.swap(again);
            if (now == 0) break;
        }
        return removed;
    }

private:
    bool try_remove(Vertex v, std::vector<Vertex>& again) {
        borders_.clear();
        spokes_.clear();
        for (Halfedge h : CGAL::halfedges_around_target(s_.halfedge(v), s_)) {
            spokes_.push_back(h);
            if (tags_[s_.face(h)] != tags_[s_.face(s_.opposite(h))]) borders_.push_back(h);
        }
        if (spokes_.size() < 3) return false;
        if (borders_.empty()) return collapse_along(spokes_, v, again);
        if (borders_.size() != 2) return false;
        if (!CGAL::collinear(s_.point(s_.source(borders_[0])), s_.point(v), s_.point(s_.source(borders_[1])))) return false;
        return collapse_along(borders_, v, again);
    }

    bool collapse_along(const std::vector<Halfedge>& ways, Vertex v, std::vector<Vertex>& again) {
        for (Halfedge h : ways) {  // source(h) stays, v goes
            if (!CGAL::Euler::does_satisfy_link_condition(s_.edge(h), s_) || !keeps_orientation(h, v)) continue;
            ring_.clear();
            for (Halfedge k : spokes_) ring_.push_back(s_.source(k));
            // collapse_edge keeps target(h) of the halfedge of the edge; its place is set afterwards.
            const Point stays = s_.point(s_.source(h));
            const Vertex kept = CGAL::Euler::collapse_edge(s_.edge(h), s_);
            s_.point(kept) = stays;
            again.insert(again.end(), ring_.begin(), ring_.end());
            again.push_back(kept);
            std::erase_if(again, [&](Vertex w) { return s_.is_removed(w); });
            return true;
        }
        return false;
    }

    // Every triangle of v that is left keeps its side in its plane when v moves onto the other end of h.
    bool keeps_orientation(Halfedge h, Vertex v) const {
        const Point &from = s_.point(v), &to = s_.point(s_.source(h));
        for (Halfedge k : spokes_) {
            const Vertex a = s_.source(k), b = s_.target(s_.next(k));
            if (a == s_.source(h) || b == s_.source(h)) continue;
            if (!same_side(from, to, s_.point(a), s_.point(b))) return false;
        }
        return true;
    }

    // (from, a, b) and (to, a, b) lie in one plane: same orientation in it, seen along an axis that does not flatten it?
    static bool same_side(const Point& from, const Point& to, const Point& a, const Point& b) {
        for (int axis = 0; axis < 3; ++axis) {
            const CGAL::Orientation was = seen_along(axis, from, a, b);
            if (was != CGAL::COLLINEAR) return seen_along(axis, to, a, b) == was;
        }
        return false;
    }
    static CGAL::Orientation seen_along(int axis, const Point& p, const Point& q, const Point& r) {
        const auto flat = [axis](const Point& x) {
            return axis == 0 ? Kernel::Point_2(x.y(), x.z()) : axis == 1 ? Kernel::Point_2(x.z(), x.x()) : Kernel::Point_2(x.x(), x.y());
        };
        return CGAL::orientation(flat(p), flat(q), flat(r));
    }

    Surface& s_;
    Tags tags_;
    std::vector<Halfedge> spokes_, borders_;
    std::vector<Vertex> ring_;
};

// ---------------------------------------------------------------------------------------------------------------- operands

void append(Surface& whole, const PlacedExact& part) {
    Surface copy = implementation(*part.mesh).surface;
    Tags tags = tags_of(copy);
    if (part.tag_base != 0)
        for (Face f : copy.faces()) tags[f] += part.tag_base;
    if (part.offset != GridPoint{}) {
        const Number x(static_cast<double>(part.offset[0])), y(static_cast<double>(part.offset[1])), z(static_cast<double>(part.offset[2]));
        for (Vertex v : copy.vertices()) {
            const Point& p = copy.point(v);
            copy.point(v) = Point(p.x() + x, p.y() + y, p.z() + z);
            CGAL::exact(copy.point(v));
        }
    }
    if (whole.number_of_vertices() == 0) {
        whole = std::move(copy);
    } else {
        whole += copy;
    }
}

Surface gathered(std::span<const PlacedExact> parts) {
    Surface whole;
    for (const PlacedExact& part : parts) append(whole, part);
    tags_of(whole);
    return whole;
}

bool all_surfaces(std::span<const PlacedExact> parts) {
    for (const PlacedExact& p : parts)
        if (implementation(*p.mesh).nef) return false;
    return true;
}

// The places where two vertices of the surface lie.
std::vector<Point> pinches_of(const Surface& surface) {
    std::vector<const Point*> points;
    points.reserve(surface.number_of_vertices());
    for (Vertex v : surface.vertices()) points.push_back(&surface.point(v));
    std::sort(points.begin(), points.end(), [](const Point* p, const Point* q) { return *p < *q; });
    std::vector<Point> pinches;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (*points[i] == *points[i - 1]) pinches.push_back(*points[i]);
    return pinches;
}

bool passes_through(const Surface& surface, const Point& p) {
    const auto at = p.bbox();
    for (Face f : surface.faces()) {
        const Halfedge h = surface.halfedge(f);
        const Point &a = surface.point(surface.source(h)), &b = surface.point(surface.target(h)), &c = surface.point(surface.target(surface.next(h)));
        if (CGAL::do_overlap(at, a.bbox() + b.bbox() + c.bbox()) && Kernel::Triangle_3(a, b, c).has_on(p)) return true;
    }
    return false;
}

bool any_pinched(std::span<const PlacedExact> parts) {
    return std::any_of(parts.begin(), parts.end(), [](const PlacedExact& p) { return implementation(*p.mesh).pinched.has_value(); });
}

// Does `other` go through a place where the operand touches itself?
bool meets_pinch(std::span<const PlacedExact> parts, const Surface& operand, const Surface& other) {
    if (!any_pinched(parts)) return false;
    const std::vector<Point> pinches = pinches_of(operand);
    return std::any_of(pinches.begin(), pinches.end(), [&](const Point& p) { return passes_through(other, p); });
}

bool corefined(SetOp op, Surface& a, Surface& b, const KernelWatch& watch) {
    TagVisitor visitor;
    visitor.first = &a;
    visitor.first_tags = tags_of(a);
    visitor.second_tags = tags_of(b);
    visitor.control = watch.control;
    const OrderedBlocks::Scope in_order;
    const auto options = CGAL::parameters::visitor(visitor).throw_on_self_intersection(true);
    switch (op) {
        case SetOp::kUnion: return pmp::corefine_and_compute_union(a, b, a, options);
        case SetOp::kIntersection: return pmp::corefine_and_compute_intersection(a, b, a, options);
        case SetOp::kDifference: return pmp::corefine_and_compute_difference(a, b, a, options);
    }
    return false;
}

// ---------------------------------------------------------------------------------------------------------------- Nef

// The plane through a triangle as coefficients whose first nonzero one is 1: equal keys, equal planes, whatever the side.
using PlaneKey = std::array<Number, 4>;

PlaneKey plane_key(const Point& p, const Point& q, const Point& r) {
    const Kernel::Plane_3 plane(p, q, r);
    PlaneKey key{plane.a(), plane.b(), plane.c(), plane.d()};
    const Number lead = key[0] != 0 ? key[0] : key[1] != 0 ? key[1] : key[2];
    if (lead != 0)
        for (Number& k : key) k /= lead;
    return key;
}

// Gives triangles of a Nef result the tags of the operands' triangles they lie in.
class TagFinder {
public:
    void add(const Point& p, const Point& q, const Point& r, FacetTag tag) { by_plane_[plane_key(p, q, r)].push_back({p, q, r, tag}); }
    FacetTag find(const Point& p, const Point& q, const Point& r) const {
        const auto found = by_plane_.find(plane_key(p, q, r));
        if (found == by_plane_.end()) return 0;
        const Point middle = CGAL::centroid(p, q, r);
        for (const Entry& e : found->second)
            if (Kernel::Triangle_3(e.p, e.q, e.r).has_on(middle)) return e.tag;
        return found->second.front().tag;
    }

private:
    struct Entry { Point p, q, r; FacetTag tag; };
    std::map<PlaneKey, std::vector<Entry>> by_plane_;
};

void add_tags(TagFinder& finder, const Surface& surface) {
    const Tags tags = tags_of(surface);
    for (Face f : surface.faces()) {
        const Halfedge h = surface.halfedge(f);
        finder.add(surface.point(surface.source(h)), surface.point(surface.target(h)), surface.point(surface.target(surface.next(h))), tags[f]);
    }
}

Nef combined_nef(SetOp op, const Nef& a, const Nef& b) { return (op == SetOp::kUnion ? a + b : op == SetOp::kIntersection ? a * b : a - b).regularization(); }

Nef nef_of(std::span<const PlacedExact> parts, TagFinder& finder);

// A pinched surface once more, from what it was made of. Its triangles have the tags already.
Nef made_again(const Recipe& recipe) {
    TagFinder unused;
    return combined_nef(recipe.op, nef_of(recipe.a, unused), nef_of(recipe.b, unused));
}

Nef nef_of(std::span<const PlacedExact> parts, TagFinder& finder) {
    Nef whole(Nef::EMPTY);
    Surface plain;
    for (const PlacedExact& part : parts) {
        const Exact& e = implementation(*part.mesh);
        if (!e.nef && !e.pinched) {
            append(plain, part);
            continue;
        }
        const Kernel::Vector_3 move(Number(static_cast<double>(part.offset[0])), Number(static_cast<double>(part.offset[1])),
                                    Number(static_cast<double>(part.offset[2])));
        Nef moved = e.nef ? *e.nef : made_again(*e.pinched);
        moved.transform(Nef::Aff_transformation_3(CGAL::TRANSLATION, move));
        whole += moved;
        if (e.pinched) {
            Surface placed;
            append(placed, part);
            add_tags(finder, placed);
        }
        for (std::size_t i = 0; i < e.soup.polygons.size(); ++i) {
            const auto& t = e.soup.polygons[i];
            finder.add(e.soup.points[t[0]] + move, e.soup.points[t[1]] + move, e.soup.points[t[2]] + move, e.soup.tags[i] + part.tag_base);
        }
    }
    if (plain.number_of_faces() > 0) {
        add_tags(finder, plain);
        whole += Nef(plain);
    }
    return whole;
}

// Points and triangles in an order of their own, not in that of the Nef polyhedron's memory.
void put_in_order(Soup& soup) {
    std::vector<std::size_t> order(soup.points.size()), place(soup.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return soup.points[i] < soup.points[j]; });
    std::vector<Point> points;
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
        points.push_back(soup.points[order[i]]);
    }
    soup.points.swap(points);
    for (auto& polygon : soup.polygons) {
        for (std::size_t& v : polygon) v = place[v];
        std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
    }
    std::sort(soup.polygons.begin(), soup.polygons.end());
}

// CGAL's conversion to triangles crashes on a facet with a point alone inside it (a corner of another part that touches the face).
bool has_lone_point(const Nef& nef) {
    for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f)
        for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle)
            if (!cycle.is_shalfedge()) return true;
    return false;
}

std::shared_ptr<Exact> by_nef(SetOp op, std::span<const PlacedExact> a, std::span<const PlacedExact> b) {
    TagFinder finder;
    const Nef left = nef_of(a, finder), right = nef_of(b, finder);
    const Nef whole = combined_nef(op, left, right);
    if (has_lone_point(whole)) throw std::domain_error("a corner touches the inside of a face");
    auto result = std::make_shared<Exact>();
    Soup& soup = result->soup;
    {
        const OrderedBlocks::Scope in_order;
        CGAL::convert_nef_polyhedron_to_polygon_soup(whole, soup.points, soup.polygons, true);
    }
    settle(soup.points);
    put_in_order(soup);
    for (const auto& t : soup.polygons) soup.tags.push_back(finder.find(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
    result->triangles = soup.polygons.size();
    result->box = box_of_points(soup.points);
    if (whole.is_simple() && pmp::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
        Surface surface;
        pmp::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, surface);
        Tags tags = tags_of(surface);
        std::size_t i = 0;
        for (Face f : surface.faces()) tags[f] = soup.tags[i++];
        if (pinches_of(surface).empty()) return finished(std::move(surface));
    }
    result->nef = whole;
    return result;
}

// ---------------------------------------------------------------------------------------------------------------- kernel

template <class Work>
auto guarded(Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const Interrupted&) {
        return fail(Fault::kInterrupted, "interrupted");
    } catch (const std::domain_error& e) {
        return fail(Fault::kScene, std::string("solids cannot be combined: ") + e.what());
    } catch (const std::bad_alloc&) {
        return fail(Fault::kWorld, "out of memory while combining meshes");
    } catch (const std::exception& e) {
        return fail(Fault::kWorld, std::string("CGAL: ") + e.what());
    }
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Origin {
    SetOp op;
    std::span<const PlacedExact> a, b;
};

std::shared_ptr<Exact> decimated(Surface&& surface, const Origin& from, KernelWatch& watch) {
    const auto start = std::chrono::steady_clock::now();
    if (watch.decimate) watch.decimated += Decimator(surface).run();
    watch.seconds_decimate += seconds_since(start);
    auto result = finished(std::move(surface));
    if (!pinches_of(result->surface).empty()) result->pinched = Recipe{from.op, {from.a.begin(), from.a.end()}, {from.b.begin(), from.b.end()}};
    return result;
}

}  // namespace

Result<ExactRef> CgalBooleans::load(const GridMesh& mesh) const {
    return guarded([&]() -> Result<ExactRef> {
        Surface surface;
        surface.reserve(static_cast<unsigned>(mesh.points.size()), static_cast<unsigned>(mesh.triangles.size() * 3 / 2),
                        static_cast<unsigned>(mesh.triangles.size()));
        for (const GridPoint& p : mesh.points)
            surface.add_vertex(Point(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])));
        Tags tags = tags_of(surface);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const Triangle& t = mesh.triangles[i];
            const Face f = surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
            if (f == Surface::null_face()) return fail(Fault::kScene, "a polyhedron is not a closed surface: an edge or corner is shared by several sheets");
            tags[f] = mesh.tags[i];
        }
        return ExactRef(finished(std::move(surface)));
    });
}

Result<ExactRef> CgalBooleans::combine(SetOp op, std::span<const PlacedExact> a, std::span<const PlacedExact> b, KernelWatch& watch) const {
    return guarded([&]() -> Result<ExactRef> {
        ++watch.booleans;
        if (watch.control && watch.control->cancelled()) throw Interrupted{};
        if (all_surfaces(a) && all_surfaces(b)) {
            std::array<Surface, 2> operands{gathered(a), gathered(b)};  // an array: corefinement orders meshes by address
            const bool safe = !meets_pinch(a, operands[0], operands[1]) && !meets_pinch(b, operands[1], operands[0]);
            try {
                if (safe && corefined(op, operands[0], operands[1], watch)) return ExactRef(decimated(std::move(operands[0]), {op, a, b}, watch));
            } catch (const pmp::Corefinement::Self_intersection_exception&) {  // going on would be wrong, or crash
                if (!any_pinched(a) && !any_pinched(b)) throw std::domain_error("one of them touches or crosses itself where they meet");
            }
        }
        ++watch.fallbacks;
        return ExactRef(by_nef(op, a, b));
    });
}

RoundedMesh CgalBooleans::rounded(const ExactMesh& mesh) const {
    const Exact& e = implementation(mesh);
    RoundedMesh out;
    const auto put = [&](const Point& p) { out.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())); };
    if (e.nef) {
        for (const Point& p : e.soup.points) put(p);
        for (const auto& t : e.soup.polygons)
            out.triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
        out.tags = e.soup.tags;
        return out;
    }
    const Tags tags = tags_of(e.surface);
    for (Vertex v : e.surface.vertices()) put(e.surface.point(v));
    for (Face f : e.surface.faces()) {
        const Halfedge h = e.surface.halfedge(f);
        out.triangles.push_back({e.surface.source(h), e.surface.target(h), e.surface.target(e.surface.next(h))});
        out.tags.push_back(tags[f]);
    }
    return out;
}

}  // namespace whittle
