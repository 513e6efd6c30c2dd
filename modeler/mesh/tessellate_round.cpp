// tessellate_round.cpp — balls, ellipsoids, capsules and rounded boxes: one net of eight octants, pulled apart by a box.
//
// Rings of equal latitude, each with only as many points as its own size needs: 2/pi of the triangles of a net with equal longitudes.
#include <cmath>
#include <numbers>

#include "csg/base/degrees.h"
#include "modeler/mesh/tessellate.h"

namespace whittle {
namespace {

// Triangles between rings of unequal counts lean; measured over radii and tolerances, the worst one is this much farther off than a right-angled one.
constexpr double kLean = 1.25;

// A ring as four arcs of m + 1 points each, consecutive from `first`; m == 0 at a pole.
struct Ring {
    std::uint32_t first = 0, m = 0;
    std::uint32_t at(std::uint32_t quadrant, std::uint32_t i) const { return first + quadrant * (m + 1) + i; }
};

class Net {
public:
    Net(const Vec3& lo, const Vec3& hi, double r, const CurveRule& rule) : lo_(lo), hi_(hi), r_(r) {
        const double error = rule.chord(r) / 2 / kLean;
        steps_ = rule.turn_within(r, error) / 4;
        chord_ = std::sqrt(8 * error * r);
        if (rule.angle_deg) chord_ = std::min(chord_, *rule.angle_deg * kRadiansPerDegree * r);
    }

    LeafMesh run() {
        std::vector<Ring> rings;
        for (int i = -steps_; i <= 0; ++i) rings.push_back(ring(i, lo_.z));
        for (int i = hi_.z > lo_.z ? 0 : 1; i <= steps_; ++i) rings.push_back(ring(i, hi_.z));
        for (std::size_t i = 0; i + 1 < rings.size(); ++i) join(rings[i], rings[i + 1]);
        const Ring &south = rings.front(), &north = rings.back();
        mesh_.quad(south.at(0, 0), south.at(3, 0), south.at(2, 0), south.at(1, 0));
        mesh_.quad(north.at(0, 0), north.at(1, 0), north.at(2, 0), north.at(3, 0));
        return std::move(mesh_);
    }

private:
    Ring ring(int step, double base_z) {
        const double latitude = 90.0 * step / steps_, radius = r_ * cosd(latitude), z = base_z + r_ * sind(latitude);
        Ring ring;
        ring.first = static_cast<std::uint32_t>(mesh_.points.size());
        ring.m = radius > 0 ? static_cast<std::uint32_t>(std::max(1.0, std::ceil(std::numbers::pi / 2 * radius / chord_))) : 0;
        for (std::uint32_t q = 0; q < 4; ++q)
            for (std::uint32_t i = 0; i <= ring.m; ++i) {
                const double a = 90.0 * q + (ring.m > 0 ? 90.0 * i / ring.m : 0.0);
                const double x = q == 0 || q == 3 ? hi_.x : lo_.x, y = q < 2 ? hi_.y : lo_.y;
                mesh_.points.emplace_back(x + radius * cosd(a), y + radius * sind(a), z);
            }
        return ring;
    }

    void join(const Ring& low, const Ring& high) {
        for (std::uint32_t q = 0; q < 4; ++q) {
            std::uint32_t i = 0, j = 0;
            while (i < low.m || j < high.m) {
                const bool along_low = j == high.m || (i < low.m && (i + 1) * high.m <= (j + 1) * low.m);
                if (along_low) {
                    mesh_.triangles.push_back({low.at(q, i), low.at(q, i + 1), high.at(q, j)});
                    ++i;
                } else {
                    mesh_.triangles.push_back({low.at(q, i), high.at(q, j + 1), high.at(q, j)});
                    ++j;
                }
            }
            const std::uint32_t next = (q + 1) % 4;
            mesh_.quad(low.at(q, low.m), low.at(next, 0), high.at(next, 0), high.at(q, high.m));
        }
    }

    Vec3 lo_, hi_;
    double r_, chord_ = 0;
    int steps_ = 0;
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
    out.mesh = Net(lo, hi, r, rule).run();
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
