// parity.cpp — prisms and meshes: a ray is inside behind an odd number of crossings. Which facets it crosses is decided by sides of vertices and
// edges alone; where, by the class of the facet. A class that another's plane stands for may cross a ray that is almost in it far away from the facet, or
// nowhere: then the facet's own plane says where.
#include <algorithm>
#include <cmath>

#include "tracer/engine/leaf.h"
#include "tracer/engine/side.h"

namespace whittle {

namespace {

bool push_crossing(RayContext& context, ClassId id, std::vector<Event>& out) {
    Crossings c;
    context.crossings(id, c);
    if (c.count == 1) out.push_back({c.t[0], c.error[0], id, 0, false});
    return c.count == 1;
}

// Is the event in the box of the facet with these corners, or no further from it than kFacetReach of its size; seen along `along` (0: as it is)? In the root frame.
// A facet's own crossing is in it, and what culls by boxes counts with that reach. Of a ray almost in the class's plane double may hardly know t.
bool is_near(RayContext& context, const std::array<Vec3, 3>& corners, const Vec3& along, const Event& e) {
    const double length2 = dot(along, along);
    const auto seen = [&](const Vec3& v) { return length2 > 0 ? v - along * (dot(v, along) / length2) : v; };
    const Vec3 a = seen(corners[0]), b = seen(corners[1]), c = seen(corners[2]), origin = seen(context.ray().origin), way = seen(context.ray().direction);
    const Vec3 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c)), size = most - least;
    const double room = kFacetReach * std::max({size.x, size.y, size.z});
    const Vec3 lo = least - Vec3(room), hi = most + Vec3(room);
    if (e.error * length(way) <= 0x1p-20 * room) {
        const Vec3 at = origin + e.t * way;
        return glm::all(glm::lessThanEqual(lo, at)) && glm::all(glm::lessThanEqual(at, hi));
    }
    for (int i = 0; i < 3; ++i) {
        if (way[i] == 0 && !(lo[i] <= origin[i] && origin[i] <= hi[i])) return false;
        if (way[i] == 0) continue;
        const auto [from, to] = std::minmax({(lo[i] - origin[i]) / way[i], (hi[i] - origin[i]) / way[i]});
        if (context.compare(e, {from, 0, kNoClass, 0, false}) < 0 || context.compare(e, {to, 0, kNoClass, 0, false}) > 0) return false;
    }
    return true;
}

// The crossing of a facet whose class is another's plane: of the class where that is near it, otherwise of its own plane.
template <class Corners>
void push_near(RayContext& context, ClassId id, ClassId own, const Corners& corners, const Vec3& along, std::vector<Event>& out) {
    if (id == own) {
        push_crossing(context, id, out);
        return;
    }
    if (push_crossing(context, id, out)) {
        if (is_near(context, corners(), along, out.back())) return;
        out.pop_back();
    }
    push_crossing(context, own, out);
}

void push_edge(const PrismLeaf& p, std::size_t edge, RayContext& context, std::vector<Event>& out) {
    const ClassId id = p.edges[edge];
    if (id == kNoClass) return;
    if (p.own.empty()) {
        push_crossing(context, id, out);
        return;
    }
    const Placement& placement = context.frame(p.frame).placement;
    Vec3 along{0};
    along[p.axis] = 1;
    const auto corner = [&](const Vec2& v) {
        Vec3 at{0};
        at[(p.axis + 1) % 3] = v.x;
        at[(p.axis + 2) % 3] = v.y;
        return apply_to_point(placement, at);
    };
    const auto corners = [&] {
        const Vec3 a = corner(p.points[edge]), b = corner(p.points[p.next[edge]]);
        return std::array<Vec3, 3>{a, b, b};
    };
    push_near(context, id, p.own[edge], corners, apply_to_direction(placement, along), out);
}

// A ray along the prism: inside everywhere or nowhere.
bool inside_along(const PrismLeaf& p, RayContext& context) {
    bool inside = false;
    for (std::size_t i = 0; i < p.points.size(); ++i) {
        const Vec2 a = p.points[i], b = p.points[p.next[i]];
        const int ha = height_against(context, p.frame, p.axis, a.y), hb = height_against(context, p.frame, p.axis, b.y);
        if (ha == hb) continue;
        const int side = side_of_line(context, p.frame, p.axis, a, b);
        // Crossed by the half-line towards +u: left of an edge that goes up.
        if ((hb < 0) == (side > 0)) inside = !inside;
    }
    return inside;
}

}  // namespace

bool prism_events(const PrismLeaf& p, RayContext& context, std::vector<Event>& out) {
    const std::size_t first = out.size();
    for (std::size_t i = 0; i < p.points.size();) {
        // One contour: its last vertex leads back to its first.
        const std::size_t start = i;
        const int first_side = side_of_point(context, p.frame, p.axis, p.points[i]);
        if (first_side == 0) return inside_along(p, context);
        int side = first_side;
        while (true) {
            const bool closes = p.next[i] == start;
            const int next_side = closes ? first_side : side_of_point(context, p.frame, p.axis, p.points[i + 1]);
            if (side != next_side) push_edge(p, i, context, out);
            side = next_side;
            ++i;
            if (closes) break;
        }
    }
    sort_by_parity(context, out, first);
    return false;
}

namespace {

void test_triangle(const ParityMesh& m, std::uint32_t index, RayContext& context, std::vector<Event>& out) {
    const auto& t = m.mesh->triangles[index];
    int wanted = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        const int s = a < b ? side_of_edge(context, m.frame, m.mesh->points[a], m.mesh->points[b])
                            : -side_of_edge(context, m.frame, m.mesh->points[b], m.mesh->points[a]);
        if (s == 0 || (wanted != 0 && s != wanted)) return;
        wanted = s;
    }
    if (m.own.empty()) {
        push_crossing(context, m.facets[index], out);
        return;
    }
    const auto corners = [&] {
        const Placement& placement = context.frame(m.frame).placement;
        return std::array<Vec3, 3>{apply_to_point(placement, m.mesh->points[t[0]]), apply_to_point(placement, m.mesh->points[t[1]]), apply_to_point(placement, m.mesh->points[t[2]])};
    };
    push_near(context, m.facets[index], m.own[index], corners, Vec3(0), out);
}

}  // namespace

bool mesh_events(const ParityMesh& m, RayContext& context, std::vector<Event>& out) {
    const std::size_t first = out.size();
    const FrameRay& local = context.frame_ray(m.frame);
    // The local ray is rounded: boxes grow by what the rounding can move it within the mesh.
    const auto& nodes = m.hierarchy->nodes;
    double reach = 0, slack = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        reach = std::max({reach, std::abs(nodes[0].lo[i] - local.o[i]), std::abs(nodes[0].hi[i] - local.o[i])});
        slack = std::max(slack, local.eo[i]);
    }
    double fastest = 0, drift = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        fastest = std::max(fastest, std::abs(local.d[i]));
        drift = std::max(drift, local.ed[i]);
    }
    if (fastest > 0) slack += 2 * reach * (drift / fastest) + 0x1p-50 * reach;
    const SlabRay slab = slab_ray(local.o, local.d);
    std::array<std::uint32_t, 128> stack;
    std::size_t top = 0;
    stack[top++] = 0;
    while (top > 0) {
        const BoxNode& node = nodes[stack[--top]];
        std::array<double, 3> lo, hi;
        for (std::size_t i = 0; i < 3; ++i) lo[i] = node.lo[i] - slack, hi[i] = node.hi[i] + slack;
        double from = 0, to = 0;
        if (!slab_interval(lo, hi, slab, from, to)) continue;
        if (node.count > 0) {
            for (std::uint32_t i = 0; i < node.count; ++i) test_triangle(m, m.hierarchy->order[node.first + i], context, out);
        } else {
            stack[top++] = node.first;
            stack[top++] = node.first + 1;
        }
    }
    sort_by_parity(context, out, first);
    return false;
}

}  // namespace whittle
