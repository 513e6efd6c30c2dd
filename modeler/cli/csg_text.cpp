// csg_text.cpp — a walk over the scene.
#include "modeler/cli/csg_text.h"

#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace whittle {

namespace {

using namespace scene;

std::string text_of(double x) { return fmt::format("{}", x == 0 ? 0.0 : x); }
std::string text_of(bool b) { return b ? "true" : "false"; }
std::string text_of(Vec2 v) { return fmt::format("[{}, {}]", text_of(v.x), text_of(v.y)); }
std::string text_of(Vec3 v) { return fmt::format("[{}, {}, {}]", text_of(v.x), text_of(v.y), text_of(v.z)); }
std::string text_of(const std::vector<std::int64_t>& list) { return fmt::format("[{}]", fmt::join(list, ", ")); }

template <class T>
std::string text_of(const std::vector<T>& list) {
    std::vector<std::string> texts;
    for (const auto& item : list) texts.push_back(text_of(item));
    return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string text_of(const Placement& p) {
    std::string rows;
    for (int i = 0; i < 3; ++i) rows += fmt::format("[{}, {}, {}, {}], ", text_of(p.linear(i, 0)), text_of(p.linear(i, 1)), text_of(p.linear(i, 2)), text_of(p.offset(i)));
    return "[" + rows + "[0, 0, 0, 1]]";
}

// The head of a node: what stands before its `;` or `{`.
class Head {
public:
    explicit Head(const Facets& facets) : facets_(fmt::format("$fn = {}, $fa = {}, $fs = {}", text_of(facets.fn), text_of(facets.fa), text_of(facets.fs))) {}

    // `name` and children are all that a .csg keeps of a group, as OpenSCAD writes it.
    std::string operator()(const Group&) const { return "group()"; }
    std::string operator()(const Cube& c) const { return fmt::format("cube(size = {}, center = {})", text_of(c.size), text_of(c.center)); }
    std::string operator()(const Sphere& s) const { return fmt::format("sphere({}, r = {})", facets_, text_of(s.r)); }
    std::string operator()(const Cylinder& c) const {
        return fmt::format("cylinder({}, h = {}, r1 = {}, r2 = {}, center = {})", facets_, text_of(c.h), text_of(c.r1), text_of(c.r2), text_of(c.center));
    }
    std::string operator()(const Polyhedron& p) const {
        return fmt::format("polyhedron(points = {}, faces = {}, convexity = {})", text_of(p.points), text_of(p.faces), p.convexity);
    }
    std::string operator()(const Square& s) const { return fmt::format("square(size = {}, center = {})", text_of(s.size), text_of(s.center)); }
    std::string operator()(const Circle& c) const { return fmt::format("circle({}, r = {})", facets_, text_of(c.r)); }
    std::string operator()(const Polygon& p) const {
        const std::string paths = p.paths.empty() ? "undef" : text_of(p.paths);
        return fmt::format("polygon(points = {}, paths = {}, convexity = {})", text_of(p.points), paths, p.convexity);
    }
    std::string operator()(const Torus& t) const { return fmt::format("torus({}, r1 = {}, r2 = {})", facets_, text_of(t.r1), text_of(t.r2)); }
    std::string operator()(const Ellipsoid& e) const { return fmt::format("ellipsoid({}, r = {})", facets_, text_of(e.r)); }
    std::string operator()(const HalfSpace& h) const { return fmt::format("halfspace(n = {}, d = {})", text_of(h.n), text_of(h.d)); }
    std::string operator()(const Quadric& q) const { return fmt::format("quadric([{}])", fmt::join(q.c, ", ")); }
    std::string operator()(const Capsule& c) const { return fmt::format("capsule({}, p = {}, q = {}, r = {})", facets_, text_of(c.p), text_of(c.q), text_of(c.r)); }
    std::string operator()(const RoundCube& c) const {
        return fmt::format("roundcube({}, size = {}, r = {}, center = {})", facets_, text_of(c.size), text_of(c.r), text_of(c.center));
    }
    std::string operator()(const Union&) const { return "union()"; }
    std::string operator()(const Difference&) const { return "difference()"; }
    std::string operator()(const Intersection&) const { return "intersection()"; }
    std::string operator()(const Hull&) const { return "hull()"; }
    std::string operator()(const Minkowski& m) const { return fmt::format("minkowski(convexity = {})", m.convexity); }
    std::string operator()(const Transform& t) const { return fmt::format("multmatrix({})", text_of(t.placement)); }
    std::string operator()(const Color& c) const {
        return fmt::format("color([{}, {}, {}, {}])", text_of(c.rgba.x), text_of(c.rgba.y), text_of(c.rgba.z), text_of(c.rgba.w));
    }
    std::string operator()(const Matter& m) const;
    std::string operator()(const LinearExtrude& e) const {
        std::string text = fmt::format("linear_extrude(height = {}, center = {}, convexity = {}", text_of(e.height), text_of(e.center), e.convexity);
        if (e.twist_deg != 0) text += fmt::format(", twist = {}", text_of(e.twist_deg));
        if (e.slices) text += fmt::format(", slices = {}", *e.slices);
        if (e.scale != Vec2(1)) text += fmt::format(", scale = {}", text_of(e.scale));
        return text + fmt::format(", {})", facets_);
    }
    std::string operator()(const RotateExtrude& e) const {
        return fmt::format("rotate_extrude(angle = {}, convexity = {}, {})", text_of(e.angle_deg), e.convexity, facets_);
    }
    std::string operator()(const Render& r) const { return fmt::format("render(convexity = {})", r.convexity); }
    std::string operator()(const Resize& r) const {
        return fmt::format("resize(newsize = {}, auto = [{}, {}, {}])", text_of(r.size), r.automatic[0], r.automatic[1], r.automatic[2]);
    }
    std::string operator()(const Offset& o) const {
        return o.round ? fmt::format("offset(r = {}, {})", text_of(o.delta), facets_) : fmt::format("offset(delta = {}, chamfer = {}, {})", text_of(o.delta), o.chamfer, facets_);
    }
    std::string operator()(const Projection& p) const { return fmt::format("projection(cut = {}, convexity = 0)", p.cut); }
    std::string operator()(const Part& p) const { return fmt::format("part(\"{}\")", p.name); }
    std::string operator()(const Moving& m) const { return fmt::format("multmatrix({})", text_of(m.start)); }  // at time 0
    std::string operator()(const Unsupported& u) const { return u.name + "()"; }

private:
    std::string facets_;
};

std::string Head::operator()(const Matter& m) const {
    const Material& material = m.material;
    std::vector<std::string> members;
    const auto add = [&members](const char* name, const std::optional<double>& value) {
        if (value) members.push_back(fmt::format("{} = {}", name, text_of(*value)));
    };
    if (material.preset) members.push_back(fmt::format("\"{}\"", *material.preset));
    if (material.color) members.push_back(fmt::format("color = [{}, {}, {}, {}]", material.color->x, material.color->y, material.color->z, material.color->w));
    add("roughness", material.roughness);
    add("metal", material.metal);
    add("ior", material.ior);
    add("transmission", material.transmission);
    add("dispersion", material.dispersion);
    add("priority", material.priority);
    if (material.absorption) members.push_back("absorption = " + text_of(*material.absorption));
    if (material.emission) members.push_back("emission = " + text_of(*material.emission));
    return fmt::format("material({})", fmt::join(members, ", "));
}

std::string modifiers_of(const SceneNode& node) {
    std::string text;
    if (node.modifiers & kBackground) text += '%';
    if (node.modifiers & kHighlight) text += '#';
    if (node.modifiers & kRoot) text += '!';
    return text;
}

struct Pending {
    SceneNodeId node;
    int depth;
    bool closes;
};

}  // namespace

std::string csg_text(const Scene& scene) {
    std::string text;
    std::vector<Pending> stack;
    const auto push_children = [&](SceneNodeId id, int depth) {
        const auto& children = scene.nodes[id].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child) stack.push_back({*child, depth, false});
    };
    push_children(scene.root, 0);
    while (!stack.empty()) {
        const auto [id, depth, closes] = stack.back();
        stack.pop_back();
        const std::string indent(static_cast<std::size_t>(depth), '\t');
        if (closes) {
            text += indent + "}\n";
            continue;
        }
        const SceneNode& node = scene.nodes[id];
        text += indent + modifiers_of(node) + std::visit(Head(node.facets), node.what);
        text += node.children.empty() ? ";\n" : " {\n";
        if (node.children.empty()) continue;
        stack.push_back({id, depth, true});
        push_children(id, depth + 1);
    }
    return text;
}

}  // namespace whittle
