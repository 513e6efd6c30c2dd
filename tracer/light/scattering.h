// scattering.h — closed forms of reflection and refraction at a border: mirror, Snell, Fresnel, GGX.
//
// Directions are unit vectors that point away from the surface unless said otherwise; `n` is on the side of the viewer.
// Sources: Walter et al., Microfacet Models for Refraction (2007); Heitz, Understanding the Masking-Shadowing Function (2014), Sampling the GGX
// Distribution of Visible Normals (2018); Schlick (1994).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/base/vec.h"
#include "tracer/light/circle.h"

namespace whittle {

inline constexpr double kPi = 3.14159265358979323846;

// `d` travels towards the surface: r = d - 2 (d.n) n.
inline Vec3 mirrored(Vec3 d, Vec3 n) { return d - 2 * glm::dot(d, n) * n; }

// `d` travels towards the surface, `n` against it; `eta` = index before / index behind. Nothing at total internal reflection.
inline std::optional<Vec3> refracted(Vec3 d, Vec3 n, double eta) {
    const double cos_in = -glm::dot(d, n);
    const double sin2_out = eta * eta * (1 - cos_in * cos_in);
    if (sin2_out >= 1) return std::nullopt;
    return glm::normalize(eta * d + (eta * cos_in - std::sqrt(1 - sin2_out)) * n);
}

// Unpolarised reflectance of a smooth border between dielectrics; 1 at total internal reflection. `eta` as above.
inline double fresnel_dielectric(double cos_in, double eta) {
    const double sin2_out = eta * eta * std::max(0.0, 1 - cos_in * cos_in);
    if (sin2_out >= 1) return 1;
    const double cos_out = std::sqrt(1 - sin2_out);
    const double s = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
    const double p = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
    return 0.5 * (s * s + p * p);
}

// Unpolarised reflectance of a metal of complex index n + ik, seen from air.
inline double fresnel_conductor(double cos_in, double n, double k) {
    const double c = std::clamp(cos_in, 0.0, 1.0), c2 = c * c, s2 = 1 - c2;
    const double q = n * n - k * k - s2, a2b2 = std::sqrt(q * q + 4 * n * n * k * k), a = std::sqrt(std::max(0.0, 0.5 * (a2b2 + q)));
    const double rs = (a2b2 + c2 - 2 * a * c) / (a2b2 + c2 + 2 * a * c);
    const double rp = rs * (c2 * a2b2 + s2 * s2 - 2 * a * c * s2) / (c2 * a2b2 + s2 * s2 + 2 * a * c * s2);
    return 0.5 * (rs + rp);
}

inline double fifth_power(double x) { return x * x * x * x * x; }
// Schlick's reflectance from that at normal incidence.
inline Vec3 fresnel_schlick(Vec3 f0, double cos_in) { return f0 + (Vec3(1) - f0) * fifth_power(1 - std::clamp(cos_in, 0.0, 1.0)); }
inline double fresnel_schlick(double f0, double cos_in) { return f0 + (1 - f0) * fifth_power(1 - std::clamp(cos_in, 0.0, 1.0)); }

// GGX: density of microfacet normals at cosine `nh`.
inline double ggx_density(double nh, double alpha) {
    const double a2 = alpha * alpha, k = nh * nh * (a2 - 1) + 1;
    return a2 / (kPi * k * k);
}
// Smith's masking of one direction.
inline double ggx_masking(double nv, double alpha) {
    const double a2 = alpha * alpha;
    return 2 * nv / (nv + std::sqrt(a2 + (1 - a2) * nv * nv));
}
// Height-correlated masking and shadowing over 4 nl nv.
inline double ggx_visibility(double nl, double nv, double alpha) {
    const double a2 = alpha * alpha;
    return 0.5 / (nl * std::sqrt(a2 + (1 - a2) * nv * nv) + nv * std::sqrt(a2 + (1 - a2) * nl * nl));
}

// Right-handed frame around n. Source: Duff et al., Building an Orthonormal Basis, Revisited (2017).
struct ShadingFrame {
    Vec3 x, y, z;
    explicit ShadingFrame(Vec3 n) : z(n) {
        const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
        x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        y = {b, sign + n.y * n.y * a, -n.y};
    }
    Vec3 to_world(Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
    Vec3 to_local(Vec3 v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
};

// Point of the unit disc; equal areas. Source: Shirley and Chiu (1997).
inline Vec2 on_disc(Vec2 u) {
    const Vec2 o{2 * u.x - 1, 2 * u.y - 1};
    if (o.x == 0 && o.y == 0) return {0, 0};
    const bool wide = std::abs(o.x) > std::abs(o.y);
    const double r = wide ? o.x : o.y, turns = wide ? 0.125 * (o.y / o.x) : 0.25 - 0.125 * (o.x / o.y);
    return r * on_circle(turns);
}
// Around +z with density cos/pi.
inline Vec3 on_cosine_hemisphere(Vec2 u) {
    const Vec2 p = on_disc(u);
    return {p.x, p.y, std::sqrt(std::max(0.0, 1 - p.x * p.x - p.y * p.y))};
}
// Around +z, equal solid angles, up to the angle whose 1 - cosine is given.
inline Vec3 on_cap(Vec2 u, double one_minus_cos) {
    const double h = u.x * one_minus_cos, r = std::sqrt(std::max(0.0, h * (2 - h)));
    const Vec2 p = r * on_circle(u.y);
    return {p.x, p.y, 1 - h};
}

// The microfacet normal seen from `v` (local frame, v.z > 0) at a place of the disc that the visible ones make, evenly by area.
inline Vec3 ggx_normal_on_disc(Vec3 v, double alpha, Vec2 p) {
    const Vec3 stretched = glm::normalize(Vec3(alpha * v.x, alpha * v.y, v.z));
    const ShadingFrame frame(stretched);
    // The half of the disc that the lower hemisphere would fill is squeezed to the rim.
    const double s = 0.5 * (1 + stretched.z);
    const Vec3 side = std::abs(stretched.z) < 0.9999999 ? glm::normalize(glm::cross(Vec3(0, 0, 1), stretched)) : frame.x;
    const Vec3 other = glm::cross(stretched, side);
    p.y = (1 - s) * std::sqrt(std::max(0.0, 1 - p.x * p.x)) + s * p.y;
    const Vec3 h = p.x * side + p.y * other + std::sqrt(std::max(0.0, 1 - p.x * p.x - p.y * p.y)) * stretched;
    return glm::normalize(Vec3(alpha * h.x, alpha * h.y, std::max(0.0, h.z)));
}
// One drawn from the visible ones.
inline Vec3 ggx_visible_normal(Vec3 v, double alpha, Vec2 u) { return ggx_normal_on_disc(v, alpha, on_disc(u)); }

}  // namespace whittle
