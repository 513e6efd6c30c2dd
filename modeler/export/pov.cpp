#include "modeler/export/pov.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "csg/solid/facets.h"
#include "csg/solid/polyhedron.h"
#include "modeler/export/number_text.h"
#include "modeler/export/pov_growth.h"
#include "modeler/export/pov_shapes.h"
#include "tracer/image/tone.h"
#include "tracer/light/lights.h"
#include "tracer/light/surface.h"
#include "tracer/light/surroundings.h"

namespace whittle {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::string rgb(const Vec3& c) { return "rgb " + pov_vector(c); }

// Diffuse, gloss, mirror and glass as POV-Ray knows them.
std::string texture_of(const Surface& s) {
    const double diffuse = (1 - s.metal) * (1 - s.transmission);
    const std::string see = s.clear() ? " filter " + shortest(s.transmission) : s.coverage < 1 ? " transmit " + shortest(1 - s.coverage) : "";
    std::string finish = "diffuse " + shortest(diffuse);
    if (s.emits()) finish += " emission " + rgb(s.emission);
    if (s.metal > 0) finish += " metallic reflection{" + shortest(s.metal) + " metallic} ambient 0";
    else if (s.clear()) finish += " reflection{0,1 fresnel on} conserve_energy";
    else if (!s.sharp()) finish += " specular " + shortest(s.dielectric_f0) + " roughness " + shortest(std::max(s.alpha * s.alpha, 5e-4));
    std::string out = " texture{pigment{" + rgb(s.color) + see + "} finish{" + finish + "}}";
    if (s.clear()) out += " interior{ior " + shortest(s.ior) + "}";
    return out;
}

class PovWriter {
public:
    PovWriter(const Solid& solid, const MeshOptions& mesh, PovGroups groups, PovFile& file)
        : solid_(solid), mesh_options_(mesh), groups_(groups), file_(file), inner_faces_show_(is_see_through(solid)), growth_(solid) {}

    Result<void> write() {
        const auto root = object(solid_.root(), Material{}, {});
        if (!root) return tl::unexpected(root.error());
        file_.text += *root + "\n";
        if (meshes_ > 0)
            file_.warnings.push_back(fmt::format("{} extrusions, revolutions or convex bodies have no counterpart in POV-Ray, written as meshes", meshes_));
        return {};
    }

private:
    // POV-Ray's union is quicker than its merge, and the same where nobody can see inside.
    static bool is_see_through(const Solid& solid) {
        const auto shows = [&](const Use& use) {
            const Material& m = solid.label(use.label).material;
            return is_clear(m) || (m.color && m.color->w >= 0 && m.color->w < 1);
        };
        if (solid.root().node == kEmptyNode) return false;
        bool any = shows(solid.root());
        for (NodeId id = 0; id < solid.node_count(); ++id)
            if (const auto* c = std::get_if<Combination>(&solid.node(id))) any = any || std::any_of(c->operands.begin(), c->operands.end(), shows);
        return any;
    }

    // "object{n7 matrix<...>}" after its declaration.
    Result<std::string> object(const Use& use, const Material& outer, PovPlace place) {
        const Material material = use.label == kNoLabel ? outer : nested(outer, solid_.label(use.label).material);
        Placement placement = use.placement;
        if (use.motion != 0) placement = placement * solid_.motion(use.motion).start;
        place.frame = place.frame * placement;
        const auto name = declared(use.node, material, place);
        if (!name) return name;
        return "object{" + *name + pov_matrix(placement) + "}";
    }

    Result<std::string> declared(NodeId node, const Material& material, const PovPlace& place) {
        const std::size_t paint = paint_of(material);
        const auto key = std::tuple(node, paint, place.cuts, growth_.key(place));
        if (const auto known = names_.find(key); known != names_.end()) return known->second;
        const auto* shape = std::get_if<Shape>(&solid_.node(node));
        auto body = shape ? leaf(node, *shape) : combination(std::get<Combination>(solid_.node(node)), material, place);
        if (!body) return body;
        if (shape && !(place.cuts && !material.names_surface())) {
            const auto texture = texture_of_paint(paint);
            if (!texture) return texture;
            *body += *texture;
        }
        if (shape) *body += pov_matrix(growth_.grown(solid_.bounds(node), place));
        return names_[key] = declare(*body + "}");
    }

    std::string declare(const std::string& body) {
        const std::string name = "N" + std::to_string(declared_++);
        file_.text += "#declare " + name + "=" + body + "\n";
        return name;
    }

    std::size_t paint_of(const Material& material) {
        for (std::size_t i = 0; i < paints_.size(); ++i)
            if (paints_[i].material == material) return i;
        paints_.push_back({material, {}});
        return paints_.size() - 1;
    }

    Result<std::string> texture_of_paint(std::size_t paint) {
        Paint& p = paints_[paint];
        if (p.texture.empty()) {
            const auto surface = resolve_surface(p.material);
            if (!surface) return tl::unexpected(surface.error());
            p.texture = texture_of(*surface);
        }
        return p.texture;
    }

    const char* opening_of(SetOp op) const { return op == SetOp::kUnion ? (inner_faces_show_ ? "merge{" : "union{") : op == SetOp::kIntersection ? "intersection{" : "difference{"; }

    Result<std::string> combination(const Combination& c, const Material& material, const PovPlace& place) {
        std::string out = c.operands.size() == 1 ? "object{" : opening_of(c.op);
        std::vector<BoxedText> parts;
        const std::vector<int> steps = growth_.steps_of_operands(c);
        for (std::size_t i = 0; i < c.operands.size(); ++i) {
            const PovPlace inner{place.frame, place.steps + steps[i], place.cuts || (c.op == SetOp::kDifference && i > 0)};
            const auto operand = object(c.operands[i], material, inner);
            if (!operand) return operand;
            const Use& use = c.operands[i];
            parts.push_back({*operand, use_bounds(solid_.bounds(use.node), use, solid_.motion(use.motion))});
        }
        const std::size_t alone = c.op == SetOp::kDifference ? 1 : c.op == SetOp::kIntersection ? parts.size() : 0;
        for (std::size_t i = 0; i < std::min(alone, parts.size()); ++i) out += (i > 0 ? " " : "") + parts[i].text;
        if (alone < parts.size()) out += (alone > 0 ? " " : "") + grouped(parts.data() + alone, parts.data() + parts.size(), false);
        // Within a cutter nothing may have a texture: the difference that it cuts finds one.
        return c.op == SetOp::kDifference && c.operands.size() > 1 && !place.cuts ? out + " cutaway_textures" : out;
    }

    struct BoxedText {
        std::string text;
        Bounds box;
    };

    static Bounds box_around(const BoxedText* begin, const BoxedText* end) {
        Bounds all = begin->box;
        for (const BoxedText* part = begin; part != end; ++part) all = {glm::min(all.lo, part->box.lo), glm::max(all.hi, part->box.hi)};
        return all;
    }

    // The parts one after the other; kBounded: halved along the longest side of their box until a group has few.
    std::string grouped(BoxedText* begin, BoxedText* end, bool boxed) const {
        constexpr std::ptrdiff_t kFew = 4;
        const Bounds all = box_around(begin, end);
        const Vec3 size = all.hi - all.lo;
        const bool finite = std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
        std::string out;
        if (groups_ == PovGroups::kFlat || end - begin <= kFew || !finite) {
            for (const BoxedText* part = begin; part != end; ++part) out += (part != begin ? " " : "") + part->text;
        } else {
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            BoxedText* middle = begin + (end - begin) / 2;
            std::stable_sort(begin, end, [axis](const BoxedText& a, const BoxedText& b) { return a.box.lo[axis] + a.box.hi[axis] < b.box.lo[axis] + b.box.hi[axis]; });
            out = grouped(begin, middle, true) + " " + grouped(middle, end, true);
        }
        return boxed ? opening_of(SetOp::kUnion) + out + " bounded_by{box{" + pov_vector(all.lo) + "," + pov_vector(all.hi) + "}}}" : out;
    }

    Result<std::string> leaf(NodeId node, const Shape& shape) {
        if (auto direct = pov_shape(shape)) return *direct;
        if (const auto* e = std::get_if<shape::Extrusion>(&shape); e && e->twist_deg == 0 && e->scale_top == Vec2(1))
            if (auto raised = raised_set(e->profile, e->z0, e->z1)) return "object{" + declare(*raised + "}");
        if (const auto* r = std::get_if<shape::Revolution>(&shape); r && r->fragments == 0)
            if (auto turned = turned_set(r->profile, {})) return "object{" + in_wedge(declare(*turned + "}"), *r);
        return mesh(node);
    }

    // Extruding commutes with set operations and with placements in the plane. What cuts stands out at both ends, so that no caps coincide.
    std::optional<std::string> raised_set(NodeId node, double z0, double z1) {
        if (const auto* shape = std::get_if<Shape>(&solid_.node(node))) return pov_raised(*shape, z0, z1);
        const Combination& c = std::get<Combination>(solid_.node(node));
        return flat_set(c, [&](const Use& use, bool first) -> std::optional<std::string> {
            const double out = first || c.op == SetOp::kUnion ? 0 : (z1 - z0) / 2;
            const auto body = raised_set(use.node, z0 - out, z1 + out);
            if (!body) return std::nullopt;
            return *body + pov_matrix(use.placement);
        });
    }
    // Turning commutes with set operations beside the axis.
    std::optional<std::string> turned_set(NodeId node, const Placement& placement) {
        if (const auto* shape = std::get_if<Shape>(&solid_.node(node))) return pov_turned(*shape, placement);
        return flat_set(std::get<Combination>(solid_.node(node)), [&](const Use& use, bool) { return turned_set(use.node, placement * use.placement); });
    }
    template <class Operand>
    std::optional<std::string> flat_set(const Combination& c, Operand operand) {
        if (c.operands.size() == 1) return operand(c.operands[0], true);
        std::string out = opening_of(c.op);
        for (const Use& use : c.operands) {
            const auto body = operand(use, &use == &c.operands.front());
            if (!body) return std::nullopt;
            out += *body + "} ";
        }
        return out;
    }

    std::string in_wedge(const std::string& name, const shape::Revolution& r) {
        if (r.angle_deg >= 360) return name;
        const double end = r.start_deg + r.angle_deg;
        const std::string from = "plane{" + pov_vector(Vec3(sind(r.start_deg), -cosd(r.start_deg), 0)) + ",0}", to = "plane{" + pov_vector(Vec3(-sind(end), cosd(end), 0)) + ",0}";
        const std::string wedge = r.angle_deg <= 180 ? "intersection{" + from + " " + to + "}" : "merge{" + from + " " + to + "}";
        return declare("intersection{object{" + name + "} " + wedge + "}");
    }

    Result<std::string> mesh(NodeId node) {
        if (const auto facets = facets_of(solid_, node)) {
            std::vector<Triangle> triangles;
            for (const auto& facet : facets->facets)
                for (const auto& t : triangulated(*facets, facet)) triangles.push_back({t[0], t[1], t[2]});
            return pov_mesh(facets->points, triangles);
        }
        MeshControl control;
        Use use;
        use.node = node;
        const auto made = mesh_use(solid_, use, mesh_options_, control);
        if (!made) return tl::unexpected(made.error());
        ++meshes_;
        return pov_mesh(made->mesh.points, made->mesh.triangles);
    }

    const Solid& solid_;
    const MeshOptions& mesh_options_;
    PovGroups groups_;
    PovFile& file_;
    bool inner_faces_show_;
    PovGrowth growth_;
    std::map<std::tuple<NodeId, std::size_t, bool, PovGrowth::Key>, std::string> names_;
    struct Paint {
        Material material;
        std::string texture;  // written when first asked for
    };
    std::vector<Paint> paints_;
    std::size_t declared_ = 0, meshes_ = 0;
};

// POV-Ray's fading is 2 / (1 + (d / f)^2), the inverse square but for a share of (f / d)^2: a millionth at 1 mm from the lamp, less than a step
// of a picture of 8 bits down to 0.02 mm.
constexpr double kFade = 1e-3;

// POV-Ray's diffuse reflection leaves out the 1/pi.
std::string light_text(const PointLight& light, const Vec3& centre) {
    const LightSource source = resolve_light(light, centre);
    // A sphere's radiance counts by its disc.
    const Vec3 intensity = source.radius > 0 ? source.emitted * (kPi * source.radius * source.radius) : source.emitted;
    std::string out = "light_source{" + pov_vector(light.p) + " " + rgb(intensity / (2 * kFade * kFade * kPi)) + " fade_distance " + shortest(kFade) + " fade_power 2";
    if (source.radius > 0) out += " area_light " + shortest(2 * source.radius) + "*x," + shortest(2 * source.radius) + "*y,5,5 adaptive 2 jitter circular orient";
    return out + "}\n";
}
std::string sun_text(const Vec3& towards, const Vec3& irradiance, bool shadows) {
    constexpr double kFar = 1e7;
    return "light_source{" + pov_vector(towards * kFar) + " " + rgb(irradiance / kPi) + " parallel point_at 0" + (shadows ? "" : " shadowless") + "}\n";
}
std::string light_text(const AreaLight& light, const Vec3& centre) {
    const LightSource source = resolve_light(light, centre);
    return "light_source{" + pov_vector(light.p + (light.u + light.v) / 2.0) + " " + rgb(source.emitted * (source.area / (2 * kFade * kFade * kPi))) + " fade_distance " + shortest(kFade) + " fade_power 2 area_light " +
           pov_vector(light.u) + "," + pov_vector(light.v) + ",5,5 adaptive 2 jitter}\n";
}

std::string lamps_text(const std::vector<Light>& lights, const Lens& lens, const Vec3& centre) {
    std::string out;
    Vec3 around(0);
    for (const Light& light : lights) {
        if (const auto* l = std::get_if<PointLight>(&light.what)) out += light_text(*l, centre);
        if (const auto* l = std::get_if<AreaLight>(&light.what)) out += light_text(*l, centre);
        if (const auto* l = std::get_if<SunLight>(&light.what)) {
            const LightSource sun = resolve_light(*l);
            out += sun_text(sun.p, sun.emitted, true);
        }
        if (const auto* l = std::get_if<EnvironmentLight>(&light.what)) around += srgb_to_linear(l->color) * l->intensity;
    }
    if (lights.empty()) {
        for (const LightSource& lamp : studio_lamps(lens)) out += sun_text(lamp.p, lamp.emitted, lamp.casts_shadow);
        around = Vec3(0.26);  // the mean of the studio's sky and floor
    }
    return "global_settings{assumed_gamma 1 max_trace_level 16 ambient_light " + rgb(around) + "}\n#default{finish{ambient 1}}\nbackground{" + rgb(around) + "}\n" + out;
}

std::string camera_text(const Lens& lens, double aspect) {
    const double height = 2 * lens.half_height;
    std::string out = lens.orthographic ? "camera{orthographic" : "camera{perspective";
    out += " location " + pov_vector(lens.eye) + " direction " + pov_vector(lens.forward) + " right " + pov_vector(lens.right * (height * aspect)) + " up " + pov_vector(lens.up * height);
    if (lens.aperture > 0 && !lens.orthographic)
        out += " aperture " + shortest(lens.aperture) + " focal_point " + pov_vector(lens.eye + lens.forward * lens.focus) + " blur_samples 64 variance 0";
    return out + "}\n";
}

}  // namespace

Result<PovFile> pov_scene(const Solid& solid, const std::vector<Light>& lights, const Lens& lens, double aspect, const MeshOptions& mesh, PovGroups groups) {
    PovFile file;
    const Bounds box = solid.root_bounds();
    file.text = "// Whittle: a scene for POV-Ray 3.7, lengths in millimetres; render with +W and +H of the camera's aspect.\n#version 3.7;\n";
    file.text += lamps_text(lights, lens, box.empty() ? Vec3(0) : (box.lo + box.hi) / 2.0) + camera_text(lens, aspect);
    if (auto written = PovWriter(solid, mesh, groups, file).write(); !written) return tl::unexpected(written.error());
    return file;
}

}  // namespace whittle
