// motion.cpp — interpolation of placements by polar decomposition.
#include "tracer/engine/motion.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/placement.h"

namespace whittle {

namespace {

glm::dmat3 linear_part(const Placement& p) {
    glm::dmat3 m;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) m[c][r] = p.linear(r, c);
    return m;
}

// The rotation nearest to m (with the sign of its determinant taken into the stretch), by Higham's iteration.
glm::dmat3 rotation_of(const glm::dmat3& m) {
    constexpr int kSteps = 40;  // converges quadratically; a stretch of 1e9 needs about 35
    glm::dmat3 q = glm::determinant(m) < 0 ? -m : m;
    for (int i = 0; i < kSteps; ++i) {
        const glm::dmat3 next = 0.5 * (q + glm::transpose(glm::inverse(q)));
        if (next == q) break;
        q = next;
    }
    return q;
}

}  // namespace

MotionPath::MotionPath(const Motion& motion) : ends_(motion) {
    if (motion.start == motion.end) return;
    const glm::dmat3 a = linear_part(motion.start), b = linear_part(motion.end);
    const glm::dmat3 qa = rotation_of(a), qb = rotation_of(b);
    from_ = glm::quat_cast(qa);
    to_ = glm::quat_cast(qb);
    stretch_from_ = glm::transpose(qa) * a;
    stretch_to_ = glm::transpose(qb) * b;
    // slerp takes the shorter way. An angle found by its cosine is off by up to sqrt(2^-51).
    constexpr double kRoundingOfAngle = 1e-7;
    if (a != b) turn_ = 2 * std::acos(std::min(1.0, std::abs(glm::dot(from_, to_)))) + kRoundingOfAngle;
}

Placement MotionPath::at(double time) const {
    if (time <= 0 || ends_.start == ends_.end) return ends_.start;
    if (time >= 1) return ends_.end;
    const glm::dmat3 m = glm::mat3_cast(glm::slerp(from_, to_, time)) * (stretch_from_ * (1 - time) + stretch_to_ * time);
    Placement p;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) p.m[static_cast<std::size_t>(4 * r + c)] = m[c][r];
        p.m[static_cast<std::size_t>(4 * r + 3)] = ends_.start.offset(r) * (1 - time) + ends_.end.offset(r) * time;
    }
    return p;
}

// A point y of the unturned frame goes along R(t) ((1 - t) y0 + t y1): from the chord of its ends it departs by at most
// 2 (1 - t) sin(t w / 2) |y0| + 2 t sin((1 - t) w / 2) |y1| <= (w / 4) (|y0| + |y1|), w being the whole turn.
Bounds MotionPath::swept(const Bounds& box) const {
    Bounds all = around(placed_bounds(box, ends_.start), placed_bounds(box, ends_.end));
    if (all.empty() || turn_ == 0) return all;
    double from = 0, to = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{(corner & 1 ? box.hi : box.lo).x, (corner & 2 ? box.hi : box.lo).y, (corner & 4 ? box.hi : box.lo).z};
        from = std::max(from, glm::length(apply_to_direction(ends_.start, p)));
        to = std::max(to, glm::length(apply_to_direction(ends_.end, p)));
    }
    // Roundings of the decomposition and of the lengths, far below a millionth.
    constexpr double kRoom = 1 + 1e-6;
    const double reach = kRoom * turn_ / 4 * (from + to);
    if (!std::isfinite(reach)) return {Vec3(-HUGE_VAL), Vec3(HUGE_VAL)};
    all.lo -= reach;
    all.hi += reach;
    return all;
}

Bounds swept_bounds(const std::vector<MotionGroup>& groups, MotionId id, const Bounds& box) {
    Bounds r = box;
    for (; id != 0; id = groups[id].parent) r = placed_bounds(groups[id].path.swept(r), groups[id].outer);
    return r;
}

}  // namespace whittle
