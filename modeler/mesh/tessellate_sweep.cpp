// tessellate_sweep.cpp — extrusions and revolutions of profiles: layers of the profile's contours joined by walls, closed by its triangles.
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/facets.h"
#include "modeler/mesh/profile_mesh.h"
#include "modeler/mesh/tessellate.h"

namespace whittle {
namespace {

constexpr const char* kCrossing = "a 2D profile cannot be triangulated: its contours cross";

double longest_side(const ProfileMesh& profile) {
    double most = 0;
    for (const auto& c : profile.contours)
        for (std::size_t i = 0; i < c.size(); ++i) most = std::max(most, glm::distance(profile.points[c[i]], profile.points[c[(i + 1) % c.size()]]));
    return most;
}
double farthest_point(const ProfileMesh& profile) {
    double most = 0;
    for (const Vec2& p : profile.points) most = std::max(most, glm::length(p));
    return most;
}

// ---------------------------------------------------------------------------------------------------------------- extrusion

struct Layers {
    int slices = 1;
    double side_limit = 0;  // longest side that stays whole; 0: any
    double error = 0;
};

// A twisted or unevenly scaled wall is a saddle over each side and slice: cut into two triangles it is off by a quarter of how far the fourth
// corner is from the parallelogram of the other three. Half of the tolerance is for that, half for the arcs that points run through.
Layers smooth_layers(const ProfileMesh& profile, const shape::Extrusion& s, const CurveRule& rule) {
    const bool even = s.scale_top.x == s.scale_top.y;
    if (s.twist_deg == 0 && even) return {};
    const double widest = std::max({1.0, s.scale_top.x, s.scale_top.y}), radius = farthest_point(profile) * widest;
    const double error = rule.chord(radius), side = longest_side(profile) * widest;
    const double twist = std::fabs(s.twist_deg) * kRadiansPerDegree;
    const double warp = twist + std::max(std::fabs(1 - s.scale_top.x), std::fabs(1 - s.scale_top.y));
    Layers out;
    out.error = error * rule.scale;
    if (twist > 0) out.slices = std::max(1, static_cast<int>(std::ceil(rule.turn_within(radius, error / 2) * twist / 6.283185307179586)));
    const double per_slice = warp / out.slices * side / 4 / (error / 2);  // into how many pieces the longest side would have to be cut
    if (per_slice > 1) {
        const int finer = static_cast<int>(std::ceil(std::sqrt(per_slice)));  // shared between more slices and shorter sides
        out.slices *= finer;
        out.side_limit = side / widest / std::ceil(per_slice / finer);
    }
    return out;
}

Vec2 at_height(const shape::Extrusion& s, const Vec2& p, int slice, int slices) {
    if (slice == 0) return p;
    const double turn = s.twist_deg * slice / slices;
    const Vec2 scale{1 - (1 - s.scale_top.x) * slice / slices, 1 - (1 - s.scale_top.y) * slice / slices};
    const double c = cosd(-turn), n = sind(-turn);
    return {scale.x * (c * p.x - n * p.y), scale.y * (n * p.x + c * p.y)};
}

// The quad (a, b, c, d) cut along its shorter diagonal; equal ones along the one that follows the twist.
void wall_quad(LeafMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, bool with_twist) {
    const double ac = glm::distance(mesh.points[a], mesh.points[c]), bd = glm::distance(mesh.points[b], mesh.points[d]);
    const bool along_ac = std::fabs(ac - bd) <= kEqualDiagonals ? with_twist : ac < bd;
    if (along_ac) {
        mesh.quad(a, b, c, d);
    } else {
        mesh.quad(b, c, d, a);
    }
}

}  // namespace

Result<Tessellation> tessellate_extrusion(const Solid& solid, const shape::Extrusion& s, const CurveRule& rule) {
    CurveRule profile_rule = rule;
    profile_rule.scale *= std::max({1.0, s.scale_top.x, s.scale_top.y});
    auto contours = profile_contours(solid, s.profile, profile_rule);
    if (!contours) return tl::unexpected(contours.error());
    ProfileMesh profile = std::move(*contours);
    const Layers layers = s.slices > 0 ? Layers{s.slices, 0, 0} : smooth_layers(profile, s, rule);
    if (layers.side_limit > 0)
        profile = with_sides_cut(profile, [&](const Vec2& a, const Vec2& b) {
            return std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / layers.side_limit)));
        });
    const auto lid = profile_triangles(profile);
    if (!lid) return fail(Fault::kScene, kCrossing);

    Tessellation out;
    out.error = profile.error + layers.error;
    const auto count = static_cast<std::uint32_t>(profile.points.size());
    for (int j = 0; j <= layers.slices; ++j) {
        const double z = j == layers.slices ? s.z1 : s.z0 + (s.z1 - s.z0) * j / layers.slices;
        for (const Vec2& p : profile.points) {
            const Vec2 q = at_height(s, p, j, layers.slices);
            out.mesh.points.emplace_back(q.x, q.y, z);
        }
    }
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(layers.slices); ++j)
        for (const auto& c : profile.contours)
            for (std::size_t i = 0; i < c.size(); ++i) {
                const std::uint32_t a = c[i] + j * count, b = c[(i + 1) % c.size()] + j * count;
                wall_quad(out.mesh, a, b, b + count, a + count, s.twist_deg >= 0);
            }
    const std::uint32_t top = static_cast<std::uint32_t>(layers.slices) * count;
    for (const Triangle& t : *lid) {
        out.mesh.triangles.push_back({t[0], t[2], t[1]});
        out.mesh.triangles.push_back({t[0] + top, t[1] + top, t[2] + top});
    }
    return out;
}

// ---------------------------------------------------------------------------------------------------------------- revolution

namespace {

// Sine and cosine of the j-th of n steps. OpenSCAD's facets count from the y axis: the same numbers, to the last bit.
Vec2 direction(const shape::Revolution& s, int j, int n) {
    if (s.fragments == 0) {
        const double a = s.start_deg + s.angle_deg * j / n;
        return {cosd(a), sind(a)};
    }
    const double a = s.angle_deg == 360 ? 90 - s.start_deg + 360.0 * j / n : 90 - s.start_deg - j * s.angle_deg / n;
    return {sind(a), cosd(a)};
}

}  // namespace

Result<Tessellation> tessellate_revolution(const Solid& solid, const shape::Revolution& s, const CurveRule& rule) {
    CurveRule half = rule;
    half.largest /= 2;
    half.share_of_radius /= 2;
    auto contours = profile_contours(solid, s.profile, s.fragments > 0 ? rule : half);
    if (!contours) return tl::unexpected(contours.error());
    ProfileMesh profile = std::move(*contours);
    const CurveRule& turn = profile.error > 0 ? half : rule;  // a straight profile leaves the whole tolerance to the turn
    double least = 0, radius = 0;
    for (const Vec2& p : profile.points) least = std::min(least, p.x), radius = std::max(radius, p.x);
    if (least < 0) profile = right_half(profile);
    if (!(radius > 0)) return Tessellation{};

    const bool whole = s.angle_deg == 360;
    const int n = s.fragments > 0 ? s.fragments : std::max(1, static_cast<int>(std::ceil(turn.turn(radius) * s.angle_deg / 360)));
    // OpenSCAD's whole turn runs clockwise; everything else counter-clockwise.
    const bool clockwise = whole && s.fragments > 0;
    const auto layers = static_cast<std::uint32_t>(whole ? n : n + 1), count = static_cast<std::uint32_t>(profile.points.size());

    Tessellation out;
    out.error = profile.error + (s.fragments > 0 ? 0 : turn.chord(radius) * rule.scale);
    for (std::uint32_t j = 0; j < layers; ++j) {
        const Vec2 d = direction(s, static_cast<int>(j), n);
        for (const Vec2& p : profile.points) out.mesh.points.emplace_back(p.x * d.x, p.x * d.y, p.y);
    }
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(n); ++j) {
        const std::uint32_t here = j * count, next = (j + 1) % layers * count;
        const std::uint32_t from = clockwise ? next : here, to = clockwise ? here : next;
        for (const auto& c : profile.contours)
            for (std::size_t i = 0; i < c.size(); ++i) {
                const std::uint32_t a = c[i], b = c[(i + 1) % c.size()];
                if (profile.points[a].x == 0 && profile.points[b].x == 0) continue;
                out.mesh.quad(a + from, a + to, b + to, b + from);
            }
    }
    if (whole) return out;
    const auto lid = profile_triangles(profile);
    if (!lid) return fail(Fault::kScene, kCrossing);
    const std::uint32_t last = static_cast<std::uint32_t>(n) * count;
    for (const Triangle& t : *lid) {
        out.mesh.triangles.push_back({t[0], t[1], t[2]});
        out.mesh.triangles.push_back({t[0] + last, t[2] + last, t[1] + last});
    }
    return out;
}

}  // namespace whittle
