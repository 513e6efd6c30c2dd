// motion.cpp — interpolation of placements by polar decomposition.
#include "tracer/engine/motion.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

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

Placement placement_at(const Motion& motion, double time) {
    if (time <= 0 || motion.start == motion.end) return motion.start;
    if (time >= 1) return motion.end;
    const glm::dmat3 a = linear_part(motion.start), b = linear_part(motion.end);
    const glm::dmat3 qa = rotation_of(a), qb = rotation_of(b);
    const glm::dmat3 sa = glm::transpose(qa) * a, sb = glm::transpose(qb) * b;
    const glm::dquat turn = glm::slerp(glm::quat_cast(qa), glm::quat_cast(qb), time);
    const glm::dmat3 m = glm::mat3_cast(turn) * (sa * (1 - time) + sb * time);
    Placement p;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) p.m[static_cast<std::size_t>(4 * r + c)] = m[c][r];
        p.m[static_cast<std::size_t>(4 * r + 3)] = motion.start.offset(r) * (1 - time) + motion.end.offset(r) * time;
    }
    return p;
}

}  // namespace whittle
