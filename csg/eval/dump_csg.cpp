#include "csg/eval/dump_csg.h"

#include <fmt/format.h>

#include "csg/eval/value_text.h"

namespace whittle {
namespace {

std::string number(double x) {
    std::string out;
    append_number(out, x);
    return out;
}

std::string stream(double x) {
    std::string out;
    append_stream_number(out, x);
    return out;
}

template <class V>
std::string point(const V& p) {
    std::string out = "[";
    for (int i = 0; i < p.length(); ++i) out += (i > 0 ? ", " : "") + number(p[i]);
    return out + "]";
}

template <class Points>
std::string points_text(const Points& points, bool given) {
    if (points.empty()) return given ? "[]" : "undef";
    std::string out = "[";
    for (std::size_t i = 0; i < points.size(); ++i) out += (i > 0 ? ", " : "") + point(points[i]);
    return out + "]";
}

std::string indices_text(const std::vector<std::vector<std::int64_t>>& lists, bool given) {
    if (lists.empty()) return given ? "[]" : "undef";
    std::string out = "[";
    for (std::size_t i = 0; i < lists.size(); ++i) {
        out += i > 0 ? ", [" : "[";
        for (std::size_t k = 0; k < lists[i].size(); ++k) out += (k > 0 ? ", " : "") + number(static_cast<double>(lists[i][k]));
        out += "]";
    }
    return out + "]";
}

// The head of a node's line: `name(parameters)`.
struct Head {
    const SceneNode& node;

    std::string facets() const { return "$fn = " + stream(node.facets.fn) + ", $fa = " + stream(node.facets.fa) + ", $fs = " + stream(node.facets.fs); }

    std::string operator()(const scene::Group&) const { return "group()"; }
    std::string operator()(const scene::Cube& c) const {
        return fmt::format("cube(size = [{}, {}, {}], center = {})", stream(c.size.x), stream(c.size.y), stream(c.size.z), c.center);
    }
    std::string operator()(const scene::Sphere& s) const { return "sphere(" + facets() + ", r = " + stream(s.r) + ")"; }
    std::string operator()(const scene::Cylinder& c) const {
        return fmt::format("cylinder({}, h = {}, r1 = {}, r2 = {}, center = {})", facets(), stream(c.h), stream(c.r1), stream(c.r2), c.center);
    }
    std::string operator()(const scene::Polyhedron& p) const {
        return fmt::format("polyhedron(points = {}, faces = {}, convexity = {})", points_text(p.points, p.given_points), indices_text(p.faces, p.given_faces),
                           p.convexity);
    }
    std::string operator()(const scene::Square& s) const { return fmt::format("square(size = [{}, {}], center = {})", stream(s.size.x), stream(s.size.y), s.center); }
    std::string operator()(const scene::Circle& c) const { return "circle(" + facets() + ", r = " + stream(c.r) + ")"; }
    std::string operator()(const scene::Polygon& p) const {
        return fmt::format("polygon(points = {}, paths = {}, convexity = {})", points_text(p.points, p.given_points), indices_text(p.paths, p.given_paths),
                           p.convexity);
    }
    std::string operator()(const scene::Torus& t) const { return fmt::format("torus({}, r1 = {}, r2 = {})", facets(), stream(t.r1), stream(t.r2)); }
    std::string operator()(const scene::Ellipsoid& e) const { return "ellipsoid(" + facets() + ", r = " + point(e.r) + ")"; }
    std::string operator()(const scene::HalfSpace& h) const { return "halfspace(n = " + point(h.n) + ", d = " + stream(h.d) + ")"; }
    std::string operator()(const scene::Quadric& q) const {
        std::string out = "quadric([";
        for (std::size_t i = 0; i < q.c.size(); ++i) out += (i > 0 ? ", " : "") + stream(q.c[i]);
        return out + "])";
    }
    std::string operator()(const scene::Capsule& c) const { return fmt::format("capsule({}, p = {}, q = {}, r = {})", facets(), point(c.p), point(c.q), stream(c.r)); }
    std::string operator()(const scene::RoundCube& c) const {
        return fmt::format("roundcube({}, size = {}, r = {}, center = {})", facets(), point(c.size), stream(c.r), c.center);
    }
    std::string operator()(const scene::Union&) const { return "union()"; }
    std::string operator()(const scene::Difference&) const { return "difference()"; }
    std::string operator()(const scene::Intersection&) const { return "intersection()"; }
    std::string operator()(const scene::Hull&) const { return "hull()"; }
    std::string operator()(const scene::Minkowski& m) const { return fmt::format("minkowski(convexity = {})", static_cast<std::uint32_t>(m.convexity)); }
    std::string operator()(const scene::Transform& t) const { return "multmatrix(" + matrix(t.placement) + ")"; }
    std::string operator()(const scene::Color& c) const {
        return fmt::format("color([{}, {}, {}, {}])", stream(c.rgba.x), stream(c.rgba.y), stream(c.rgba.z), stream(c.rgba.w));
    }
    std::string operator()(const scene::Matter& m) const;
    std::string operator()(const scene::LinearExtrude& e) const {
        const Vec3 way = e.height * Vec3(e.lean, 1);
        std::string out = fmt::format("linear_extrude(height = {}, ", stream(e.lean == Vec2(0) ? e.height : glm::length(way)));
        if (e.lean != Vec2(0)) out += "v = " + point(way) + ", ";
        out += fmt::format("center = {}, convexity = {}", e.center, e.convexity);
        if (e.twist_deg != 0) out += ", twist = " + stream(e.twist_deg);
        if (e.slices) out += ", slices = " + std::to_string(*e.slices);
        if (e.segments > 0) out += ", segments = " + std::to_string(e.segments);
        out += fmt::format(", scale = [{}, {}]", stream(e.scale.x), stream(e.scale.y));
        if (!e.slices) out += ", " + facets();
        return out + ")";
    }
    std::string operator()(const scene::RotateExtrude& e) const {
        return fmt::format("rotate_extrude(angle = {}, convexity = {}, {})", stream(e.angle_deg), e.convexity, facets());
    }
    std::string operator()(const scene::Render& r) const { return fmt::format("render(convexity = {})", r.convexity); }
    std::string operator()(const scene::Resize& r) const {
        return fmt::format("resize(newsize = [{},{},{}], auto = [{:d},{:d},{:d}], convexity = {})", stream(r.size.x), stream(r.size.y), stream(r.size.z),
                           r.automatic[0], r.automatic[1], r.automatic[2], r.convexity);
    }
    std::string operator()(const scene::Offset& o) const {
        if (o.round) return fmt::format("offset(r = {}, {})", stream(o.delta), facets());
        return fmt::format("offset(delta = {}, chamfer = {}, {})", stream(o.delta), o.chamfer, facets());
    }
    std::string operator()(const scene::Projection& p) const { return fmt::format("projection(cut = {}, convexity = {})", p.cut, p.convexity); }
    std::string operator()(const scene::Fill&) const { return "fill()"; }
    std::string operator()(const scene::Roof& r) const { return fmt::format("roof(method = \"{}\", convexity = {}, {})", r.method, r.convexity, facets()); }
    std::string operator()(const scene::Text& t) const { return t.csg; }
    std::string operator()(const scene::Part& p) const { return "part(\"" + p.name + "\")"; }
    std::string operator()(const scene::Moving& m) const { return "moving(" + matrix(m.start) + ", " + matrix(m.end) + ")"; }
    std::string operator()(const scene::Import& i) const { return i.csg; }
    std::string operator()(const scene::Surface& s) const { return s.csg; }
    std::string operator()(const scene::Unsupported& u) const { return u.csg; }

    static std::string matrix(const Placement& p) {
        std::string out = "[";
        for (int i = 0; i < 3; ++i)
            out += fmt::format("[{}, {}, {}, {}], ", number(p.linear(i, 0)), number(p.linear(i, 1)), number(p.linear(i, 2)), number(p.offset(i)));
        return out + "[0, 0, 0, 1]]";
    }
};

std::string Head::operator()(const scene::Matter& matter) const {
    const Material& m = matter.material;
    std::string out;
    const auto add = [&out](const char* name, const std::string& value) { out += (out.empty() ? "" : ", ") + std::string(name) + " = " + value; };
    if (m.preset) out += "\"" + *m.preset + "\"";
    if (m.color) add("color", point(*m.color));
    if (m.roughness) add("roughness", stream(*m.roughness));
    if (m.metal) add("metal", stream(*m.metal));
    if (m.ior) add("ior", stream(*m.ior));
    if (m.transmission) add("transmission", stream(*m.transmission));
    if (m.absorption) add("absorption", point(*m.absorption));
    if (m.dispersion) add("dispersion", stream(*m.dispersion));
    if (m.emission) add("emission", point(*m.emission));
    if (m.priority) add("priority", stream(*m.priority));
    return "material(" + out + ")";
}

}  // namespace

// Depth first with a list of what is open, so that deep scenes need no deep stack.
std::string dump_csg(const Scene& scene) {
    std::string out;
    struct Open { SceneNodeId node; std::size_t next; std::size_t depth; bool block; };
    std::vector<Open> open{{scene.root, 0, 0, false}};
    const bool single = scene.nodes[scene.root].children.size() == 1 && (scene.nodes[scene.nodes[scene.root].children[0]].modifiers & kRoot);
    while (!open.empty()) {
        Open& top = open.back();
        const SceneNode& node = scene.nodes[top.node];
        if (top.next == node.children.size()) {
            const std::size_t depth = top.depth;
            if (top.block) out += std::string(depth - 1, '\t') + "}\n";
            open.pop_back();
            continue;
        }
        const SceneNodeId id = node.children[top.next++];
        const std::size_t depth = top.depth;
        const SceneNode& child = scene.nodes[id];
        const std::uint8_t modifiers = single && depth == 0 ? std::uint8_t{0} : child.modifiers;
        if (modifiers & kBackground) out += "%";
        if (modifiers & kHighlight) out += "#";
        out += std::string(depth, '\t') + std::visit(Head{child}, child.what) + (child.children.empty() ? ";\n" : " {\n");
        if (!child.children.empty()) open.push_back({id, 0, depth + 1, true});
    }
    return out + "\n";
}

}  // namespace whittle
