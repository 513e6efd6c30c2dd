// scenes.h — small solids and the calls that turn them into films, for tests.
#pragma once

#include <catch2/catch.hpp>

#include <memory>
#include <vector>

#include "csg/solid/solid.h"
#include "tracer/light/render.h"

namespace whittle::test {

inline Placement moved(double x, double y, double z) { return Placement::translation({x, y, z}); }

// A solid under construction: uses with matter, joined in one union unless told otherwise.
class SceneBuilder {
public:
    Use use(NodeId node, const Material& material = {}, const Placement& placement = {}) {
        Label label;
        label.material = material;
        Use u;
        u.node = node;
        u.label = builder_.label(label);
        u.placement = placement;
        return u;
    }
    Use box(Vec3 lo, Vec3 hi, const Material& m = {}) { return use(builder_.shape(shape::Box{lo, hi}), m); }
    Use ball(double r, const Material& m = {}, const Placement& p = {}) { return use(builder_.shape(shape::Ellipsoid{Vec3(r)}), m, p); }
    Use rod(double z0, double z1, double r, const Material& m = {}) { return use(builder_.shape(shape::Frustum{z0, z1, r, r}), m); }
    Use combined(SetOp op, std::vector<Use> operands) {
        Use u;
        u.node = builder_.combine(op, std::move(operands));
        return u;
    }
    // From where it stands to `end`, over the shutter.
    Use moving(Use u, const Placement& end) {
        u.motion = builder_.motion({Placement{}, end});
        return u;
    }
    SolidBuilder& shapes() { return builder_; }
    void add(Use u) { parts_.push_back(u); }
    Solid finish(const Placement& outer = {}) {
        Use all = combined(SetOp::kUnion, parts_);
        all.placement = outer;
        return builder_.finish(all);
    }

private:
    SolidBuilder builder_;
    std::vector<Use> parts_;
};

inline Material preset(const char* name) {
    Material m;
    m.preset = name;
    return m;
}
inline Material matte(double r, double g, double b) {
    Material m = preset("matte");
    m.color = Vec4(r, g, b, 1);
    return m;
}

// 32 x 24 pixels, one sample, no lights but the studio.
inline RenderOptions small_options() {
    RenderOptions o;
    o.width = 32;
    o.height = 24;
    o.samples = 1;
    return o;
}

inline Light lamp(PointLight p) { return {p, {}}; }
inline Light around(Vec3 color) {
    EnvironmentLight e;
    e.color = color;
    return {e, {}};
}
inline Camera looking(Vec3 eye, Vec3 target = Vec3(0), double fov_deg = 22.5) {
    Camera c;
    c.eye = eye;
    c.target = target;
    c.fov_deg = fov_deg;
    return c;
}

inline RenderResult drawn(const Solid& solid, RenderScene scene, const RenderOptions& options, const Film* resume = nullptr) {
    Result<std::shared_ptr<const Program>> program = compile(solid);
    REQUIRE(program);
    scene.solid = &solid;
    RenderControl control;
    Result<RenderResult> result = render(*program, scene, options, control, resume);
    INFO((result ? "" : result.error().message));
    REQUIRE(result);
    return std::move(*result);
}

inline Vec3 middle(const Film& film) { return film.color(film.index(film.width / 2, film.height / 2)); }

inline bool all_finite(const Film& film) {
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const Vec3 c = film.color(i);
        if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) return false;
    }
    return true;
}

// The classic: a cube less a ball and three rods.
inline Solid classic() {
    SceneBuilder b;
    Material red;
    red.color = Vec4(0.8, 0.2, 0.15, 1);
    Use across = b.rod(-20, 20, 6.5), along = across;
    across.placement = Placement{{0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0}};
    along.placement = Placement{{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}};
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-10), Vec3(10)), b.ball(12.5, red), b.rod(-20, 20, 6.5), across, along}));
    return b.finish();
}

}  // namespace whittle::test
