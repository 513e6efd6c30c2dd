// tessellate_round.cpp — balls, ellipsoids, capsules and rounded boxes: one net of eight octants, pulled apart by a box.
//
// Rows of triangles from the equator to the pole (round_rows.h); the southern half is the northern one mirrored.
#include <cmath>

#include "csg/base/degrees.h"
#include "modeler/mesh/round_rows.h"
#include "modeler/mesh/tessellate.h"

namespace whittle {
namespace {

// A ring as four arcs of `count` points each, consecutive from `first`.
struct Ring {
    std::uint32_t first = 0, count = 0;
    std::uint32_t at(std::uint32_t quadrant, std::uint32_t i) const { return first + quadrant * count + i; }
};

enum class Half { kNorth, kSouth };

class Net {
public:
    Net(const Vec3& lo, const Vec3& hi, double r) : lo_(lo), hi_(hi), r_(r) {}

    LeafMesh run(const std::vector<RoundRow>& rows) {
        const Ring equator = ring(rows.front(), Half::kNorth);
        Ring low = equator;
        if (hi_.z > lo_.z) {
            low = ring(rows.front(), Half::kSouth);
            for (std::uint32_t q = 0; q < 4; ++q) {
                for (std::uint32_t i = 0; i + 1 < low.count; ++i) mesh_.quad(low.at(q, i), low.at(q, i + 1), equator.at(q, i + 1), equator.at(q, i));
                seam(low, equator, q);
            }
        }
        cap(rows, equator, Half::kNorth);
        cap(rows, low, Half::kSouth);
        return std::move(mesh_);
    }

private:
    Ring ring(const RoundRow& row, Half half) {
        const double z = half == Half::kNorth ? hi_.z + r_ * row.sine : lo_.z - r_ * row.sine, radius = r_ * row.cosine;
        const Ring ring{static_cast<std::uint32_t>(mesh_.points.size()), static_cast<std::uint32_t>(row.along.size())};
        for (std::uint32_t q = 0; q < 4; ++q)
            for (const double share : row.along) {
                const double a = 90.0 * q + 90.0 * share;
                const double x = q == 0 || q == 3 ? hi_.x : lo_.x, y = q < 2 ? hi_.y : lo_.y;
                mesh_.points.emplace_back(x + radius * cosd(a), y + radius * sind(a), z);
            }
        return ring;
    }

    void cap(const std::vector<RoundRow>& rows, Ring below, Half half) {
        for (std::size_t row = 1; row < rows.size(); ++row) {
            const Ring above = ring(rows[row], half);
            for (std::uint32_t q = 0; q < 4; ++q) {
                for (const RowTriangle& t : triangles_between(rows[row - 1], rows[row])) {
                    const std::uint32_t a = below.at(q, t.below), b = above.at(q, t.above), c = t.stands ? below.at(q, t.below + 1) : above.at(q, t.above + 1);
                    put(half, {a, c, b});
                }
                if (half == Half::kNorth) seam(below, above, q);
                else seam(above, below, q);
            }
            below = above;
        }
        if (half == Half::kNorth) mesh_.quad(below.at(0, 0), below.at(1, 0), below.at(2, 0), below.at(3, 0));
        else mesh_.quad(below.at(3, 0), below.at(2, 0), below.at(1, 0), below.at(0, 0));
    }

    // Between two quadrants; empty in a ball.
    void seam(const Ring& low, const Ring& high, std::uint32_t q) {
        const std::uint32_t next = (q + 1) % 4;
        mesh_.quad(low.at(q, low.count - 1), low.at(next, 0), high.at(next, 0), high.at(q, high.count - 1));
    }

    void put(Half half, const Triangle& t) { mesh_.triangles.push_back(half == Half::kNorth ? t : Triangle{t[0], t[2], t[1]}); }

    Vec3 lo_, hi_;
    double r_;
    LeafMesh mesh_;
};

// Two unit vectors that make a right-handed frame with w; exact where w lies on an axis.
void frame_around(const Vec3& w, Vec3& u, Vec3& v) {
    const Vec3 a = glm::abs(w);
    const Vec3 helper = a.z >= a.x && a.z >= a.y ? Vec3{1, 0, 0} : a.x >= a.y ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    v = glm::normalize(glm::cross(w, helper));
    u = glm::cross(v, w);
}

}  // namespace

Tessellation tessellate_rounded(const Vec3& lo, const Vec3& hi, double r, const CurveRule& rule) {
    Tessellation out;
    out.mesh = Net(lo, hi, r).run(round_rows(r, rule));
    out.error = rule.chord(r) * rule.scale;
    return out;
}

Tessellation tessellate_ellipsoid(const Vec3& radii, const CurveRule& rule) {
    if (radii.x == radii.y && radii.y == radii.z) return tessellate_rounded(Vec3{0}, Vec3{0}, radii.x, rule);
    CurveRule unit = rule;
    unit.scale *= std::max({radii.x, radii.y, radii.z});
    Tessellation out = tessellate_rounded(Vec3{0}, Vec3{0}, 1, unit);
    for (Vec3& p : out.mesh.points) p *= radii;
    return out;
}

Tessellation tessellate_capsule(const shape::Capsule& s, const CurveRule& rule) {
    const double length = glm::length(s.q - s.p);
    if (!(length > 0)) {
        Tessellation ball = tessellate_rounded(s.p, s.p, s.r, rule);
        return ball;
    }
    const Vec3 w = (s.q - s.p) / length;
    Vec3 u, v;
    frame_around(w, u, v);
    Tessellation out = tessellate_rounded(Vec3{0}, Vec3{0, 0, length}, s.r, rule);
    for (Vec3& p : out.mesh.points) {
        const bool far_end = p.z >= length;
        p = (far_end ? s.q : s.p) + p.x * u + p.y * v + (far_end ? p.z - length : p.z) * w;
    }
    return out;
}

}  // namespace whittle
