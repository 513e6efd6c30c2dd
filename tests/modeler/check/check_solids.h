// check_solids.h — small solids that the tests of measure and check share.
#pragma once

#include <vector>

#include <catch2/catch.hpp>

#include "csg/solid/solid.h"
#include "modeler/check/measure.h"
#include "tracer/engine/engine.h"

namespace whittle::test {

inline Use use(NodeId node, Placement placement = {}) {
    Use u;
    u.node = node;
    u.placement = placement;
    return u;
}

// Turn by `degrees` about the axis (1, 2, 3), rounded as std:: rounds: a rotation to 2^-50.
inline Placement tilted(double degrees, Vec3 shift = Vec3(0)) {
    const Vec3 a = glm::normalize(Vec3(1, 2, 3));
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180), k = 1 - c;
    return {{c + k * a.x * a.x, k * a.x * a.y - s * a.z, k * a.x * a.z + s * a.y, shift.x, k * a.x * a.y + s * a.z, c + k * a.y * a.y,
             k * a.y * a.z - s * a.x, shift.y, k * a.x * a.z - s * a.y, k * a.y * a.z + s * a.x, c + k * a.z * a.z, shift.z}};
}

// z to x, x to y, y to z: exact.
inline Placement cycled() { return {{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}}; }

inline std::shared_ptr<const Program> compiled(const Solid& solid) {
    auto program = compile(solid);
    REQUIRE(program);
    return *program;
}

inline Measurement measured(const Solid& solid, const MeasureOptions& options = {}) {
    const auto m = measure(solid, *compiled(solid), options);
    REQUIRE(m);
    return *m;
}

inline Solid one_shape(const Shape& shape, const Placement& placement = {}) {
    SolidBuilder b;
    const NodeId node = b.shape(shape);
    return b.finish(use(node, placement));
}

// Three crossing cylinders of radius r: what they share.
inline Solid tricylinder(double r) {
    SolidBuilder b;
    const NodeId rod = b.shape(shape::Frustum{-2 * r, 2 * r, r, r});
    const NodeId all = b.combine(SetOp::kIntersection, {use(rod), use(rod, cycled()), use(rod, cycled() * cycled())});
    return b.finish(use(all));
}

// A cube of edge 20 rounded by a ball of 13.5 and drilled three ways by 6, its cutters flush.
inline Solid carved_cube() {
    SolidBuilder b;
    const NodeId cube = b.shape(shape::Box{Vec3(-10), Vec3(10)});
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(13.5)});
    const NodeId bore = b.shape(shape::Frustum{-10, 10, 6, 6});
    const NodeId body = b.combine(SetOp::kIntersection, {use(cube), use(ball)});
    return b.finish(use(b.combine(SetOp::kDifference, {use(body), use(bore), use(bore, cycled()), use(bore, cycled() * cycled())})));
}

// Menger's sponge of edge 3^level: a cube less square bars.
inline Solid sponge(int level) {
    SolidBuilder b;
    double size = 1;
    for (int i = 0; i < level; ++i) size *= 3;
    std::vector<Use> operands{use(b.shape(shape::Box{Vec3(0), Vec3(size)}))};
    for (double hole = size / 3; hole >= 1; hole /= 3) {
        const NodeId bar = b.shape(shape::Box{Vec3(0), Vec3(hole, hole, size)});
        for (double x = hole; x < size; x += 3 * hole)
            for (double y = hole; y < size; y += 3 * hole) {
                const Placement at = Placement::translation({x, y, 0});
                for (const Placement& turn : {Placement{}, cycled(), cycled() * cycled()}) operands.push_back(use(bar, turn * at));
            }
    }
    return b.finish(use(b.combine(SetOp::kDifference, operands)));
}

}  // namespace whittle::test
