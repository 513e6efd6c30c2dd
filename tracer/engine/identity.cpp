// identity.cpp — classes of coinciding supports.
#include "tracer/engine/identity.h"

#include <array>
#include <cmath>
#include <map>

namespace whittle {

namespace {

using Real = long double;  // 64 bits of mantissa: rounding here is 2^11 below that of the numbers compared

// Surface in the root frame, up to a factor: a plane (n, d) with unit n, or a quadric x'Mx + 2b'x + c, or a torus.
struct World {
    enum class Form : std::uint8_t { kPlane, kQuadric, kTorus } form = Form::kPlane;
    std::array<Real, 6> m{};  // xx yy zz xy xz yz
    std::array<Real, 3> b{};  // a plane's normal; a torus's axis
    Real c = 0;               // plane: b.x + c = 0
    std::array<Real, 3> centre{};
    Real ring = 0, tube = 0;
};

Real magnitude(Real x) { return x < 0 ? -x : x; }

constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

Real entry(const std::array<Real, 6>& m, std::size_t i, std::size_t j) {
    if (i == j) return m[i];
    return m[i + j + 2];
}

// Adds weight * (n.x + k)^2.
void add_square(World& w, const std::array<Real, 3>& n, Real k, Real weight) {
    for (std::size_t e = 0; e < 6; ++e) w.m[e] += weight * n[kPairs[e][0]] * n[kPairs[e][1]];
    for (std::size_t i = 0; i < 3; ++i) w.b[i] += weight * n[i] * k;
    w.c += weight * k * k;
}

World local_plane(const Support& s) {
    World w;
    const auto& p = s.p;
    if (s.kind == SupportKind::kAxisPlane) {
        w.b[s.axis] = 1;
        w.c = -Real(p[0]);
    } else if (s.kind == SupportKind::kPlane) {
        for (std::size_t i = 0; i < 3; ++i) w.b[i] = p[i];
        w.c = -Real(p[3]);
    } else if (s.kind == SupportKind::kEdgePlane) {
        const std::size_t u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
        w.b[u] = Real(p[3]) - p[1];
        w.b[v] = Real(p[0]) - p[2];
        w.c = -(w.b[u] * p[0] + w.b[v] * p[1]);
    } else {
        std::array<Real, 3> e, f;
        for (std::size_t i = 0; i < 3; ++i) e[i] = Real(p[3 + i]) - p[i], f[i] = Real(p[6 + i]) - p[i];
        for (std::size_t i = 0; i < 3; ++i) {
            w.b[i] = e[(i + 1) % 3] * f[(i + 2) % 3] - e[(i + 2) % 3] * f[(i + 1) % 3];
            w.c -= w.b[i] * p[i];
        }
    }
    return w;
}

void add_tube(World& w, const std::array<double, 10>& p) {
    std::array<Real, 3> axis;
    Real length2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        axis[i] = Real(p[3 + i]) - p[i];
        length2 += axis[i] * axis[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        std::array<Real, 3> n{};
        n[k] = axis[j];
        n[j] = -axis[k];
        add_square(w, n, -(axis[j] * p[k] - axis[k] * p[j]), 1);
    }
    w.c -= Real(p[6]) * p[6] * length2;
}

World local_quadric(const Support& s) {
    World w;
    w.form = World::Form::kQuadric;
    const auto& p = s.p;
    const auto unit = [](std::size_t i) {
        std::array<Real, 3> n{};
        n[i] = 1;
        return n;
    };
    const std::size_t u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
    switch (s.kind) {
        case SupportKind::kBall:
        case SupportKind::kTorusCore:
            for (std::size_t i = 0; i < 3; ++i) add_square(w, unit(i), -Real(p[i]), 1);
            w.c += s.kind == SupportKind::kBall ? -Real(p[3]) * p[3] : Real(p[3]) * p[3] - Real(p[4]) * p[4];
            break;
        case SupportKind::kEllipsoid:
            for (std::size_t i = 0; i < 3; ++i) add_square(w, unit(i), -Real(p[i]), 1 / (Real(p[3 + i]) * p[3 + i]));
            w.c -= 1;
            break;
        case SupportKind::kCylinder:
            add_square(w, unit(u), -Real(p[0]), 1);
            add_square(w, unit(v), -Real(p[1]), 1);
            w.c -= Real(p[2]) * p[2];
            break;
        case SupportKind::kCone: {
            const Real slope = (Real(p[5]) - p[4]) / (Real(p[3]) - p[2]);
            add_square(w, unit(u), -Real(p[0]), 1);
            add_square(w, unit(v), -Real(p[1]), 1);
            std::array<Real, 3> n{};
            n[s.axis] = slope;
            add_square(w, n, p[4] - slope * p[2], -1);
            break;
        }
        case SupportKind::kTube: add_tube(w, p); break;
        default:
            w.m = {p[0], p[1], p[2], Real(p[3]) / 2, Real(p[4]) / 2, Real(p[5]) / 2};
            w.b = {Real(p[6]) / 2, Real(p[7]) / 2, Real(p[8]) / 2};
            w.c = p[9];
    }
    return w;
}

using Rows = std::array<std::array<Real, 3>, 3>;

Rows inverse_of(const Placement& a) {
    const auto at = [&](std::size_t r, std::size_t c) { return Real(a.m[4 * (r % 3) + c % 3]); };
    const auto minor = [&](std::size_t r, std::size_t c) { return at(r + 1, c + 1) * at(r + 2, c + 2) - at(r + 1, c + 2) * at(r + 2, c + 1); };
    const Real det = at(0, 0) * minor(0, 0) + at(0, 1) * minor(0, 1) + at(0, 2) * minor(0, 2);
    Rows r;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) r[i][j] = minor(j, i) / det;
    return r;
}

// x_local = inverse (x - offset).
World to_root(const World& local, const Frame& frame) {
    if (frame.identity) return local;
    const Rows inverse = inverse_of(frame.placement);
    World w = local;
    if (local.form == World::Form::kTorus) {
        for (std::size_t i = 0; i < 3; ++i) {
            w.centre[i] = frame.placement.m[4 * i + 3];
            w.b[i] = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                w.centre[i] += Real(frame.placement.m[4 * i + j]) * local.centre[j];
                w.b[i] += Real(frame.placement.m[4 * i + j]) * local.b[j];
            }
        }
        return w;
    }
    w.b = {};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) w.b[j] += inverse[i][j] * local.b[i];
    w.m = {};
    for (std::size_t e = 0; e < 6; ++e)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) w.m[e] += inverse[i][kPairs[e][0]] * entry(local.m, i, j) * inverse[j][kPairs[e][1]];
    // Shift by the offset b: M stays, b -> b - M b0, c -> c - 2 b.b0 + b0'M b0 (for a plane c - b.b0).
    std::array<Real, 3> moved{};
    Real linear = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Real oi = frame.placement.m[4 * i + 3];
        linear += w.b[i] * oi;
        for (std::size_t j = 0; j < 3; ++j) {
            const Real oj = frame.placement.m[4 * j + 3];
            moved[i] += entry(w.m, i, j) * oj;
            square += oi * entry(w.m, i, j) * oj;
        }
    }
    if (local.form == World::Form::kPlane) {
        w.c -= linear;
    } else {
        w.c += square - 2 * linear;
        for (std::size_t i = 0; i < 3; ++i) w.b[i] -= moved[i];
    }
    return w;
}

World world_of(const Support& s, const Frame& frame) {
    World w;
    if (is_plane(s.kind)) {
        w = to_root(local_plane(s), frame);
        const Real length = std::sqrt(w.b[0] * w.b[0] + w.b[1] * w.b[1] + w.b[2] * w.b[2]);
        for (Real& x : w.b) x /= length;
        w.c /= length;
        return w;
    }
    if (s.kind != SupportKind::kTorus) return to_root(local_quadric(s), frame);
    w.form = World::Form::kTorus;
    w.b[s.axis] = 1;
    for (std::size_t i = 0; i < 3; ++i) w.centre[i] = s.p[i];
    w.ring = s.p[3];
    w.tube = s.p[4];
    return to_root(w, frame);
}

// The quadric with x = centre + extent * y, its largest coefficient 1 in magnitude and its first large one positive.
std::array<Real, 10> normalised(const World& w, const Vec3& centre, Real extent, bool& flipped) {
    std::array<Real, 3> mc{};
    Real c = w.c;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) mc[i] += entry(w.m, i, j) * centre[static_cast<int>(j)];
        c += (2 * w.b[i] + mc[i]) * centre[static_cast<int>(i)];
    }
    std::array<Real, 10> r{};
    for (std::size_t e = 0; e < 6; ++e) r[e] = w.m[e] * extent * extent;
    for (std::size_t i = 0; i < 3; ++i) r[6 + i] = (w.b[i] + mc[i]) * extent;
    r[9] = c;
    Real most = 0;
    for (const Real x : r) most = std::max(most, magnitude(x));
    flipped = false;
    for (const Real x : r)
        if (magnitude(x) > most / 2) {
            flipped = x < 0;
            break;
        }
    for (Real& x : r) x = most > 0 ? (flipped ? -x : x) / most : x;
    return r;
}

Real value_at(const std::array<Real, 10>& q, const std::array<Real, 3>& y, std::array<Real, 3>& gradient) {
    Real value = q[9];
    for (std::size_t i = 0; i < 3; ++i) {
        Real m = 0;
        for (std::size_t j = 0; j < 3; ++j) m += (i == j ? q[i] : q[i + j + 2]) * y[j];
        value += (m + 2 * q[6 + i]) * y[i];
        gradient[i] = 2 * (m + q[6 + i]);
    }
    return value;
}

// How far the second surface is from points of the first, in and about the box [-1, 1]^3: the points are those that Newton's steps lead to from a
// spread of starts. More than any tolerance if hardly a start leads anywhere.
Real quadric_distance(const std::array<Real, 10>& a, const std::array<Real, 10>& b) {
    constexpr int kStarts = 24, kSteps = 12, kEnough = 10;  // ten coefficients up to a factor: nine points tell two quadrics apart
    for (std::size_t i = 0; i < 10; ++i)
        if (magnitude(a[i] - b[i]) > 0x1p-20L) return 1;
    Real worst = 0;
    int reached = 0;
    for (int k = 0; k < kStarts; ++k) {
        // A lattice of generic slopes: no start on an axis or a symmetry plane.
        std::array<Real, 3> y, g;
        for (std::size_t i = 0; i < 3; ++i) {
            const Real slope = i == 0 ? 0.8191725133961645L : i == 1 ? 0.6710436067037893L : 0.5497004779019703L;
            const Real turn = (k + 1) * slope;
            y[i] = 2 * (turn - std::floor(turn)) - 1;
        }
        for (int step = 0; step < kSteps; ++step) {
            const Real v = value_at(a, y, g), g2 = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
            if (!(g2 > 0)) break;
            for (std::size_t i = 0; i < 3; ++i) y[i] -= v * g[i] / g2;
        }
        const Real left = magnitude(value_at(a, y, g)), slope = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        const Real size = std::max({magnitude(y[0]), magnitude(y[1]), magnitude(y[2])});
        if (!(size < 2) || !(left < slope * 0x1p-50L)) continue;
        const Real gap = magnitude(value_at(b, y, g)), steep = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        if (!(steep > 0)) continue;
        worst = std::max(worst, gap / steep);
        ++reached;
    }
    return reached >= kEnough ? worst : Real(1);
}

bool touching(const Bounds& a, const Bounds& b, double room) {
    for (int i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] + room || b.lo[i] > a.hi[i] + room) return false;
    return true;
}

double finite_extent(const Bounds& a) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        const double x = a.hi[i] - a.lo[i];
        if (std::isfinite(x)) most = std::max(most, x);
    }
    return most;
}

class Finder {
public:
    Finder(const SupportTable& table, bool snap) : table_(table), snap_(snap) {}

    Classes run() {
        for (SupportId id = 0; id < table_.supports.size(); ++id) place(id);
        return std::move(out_);
    }

private:
    struct Member {
        ClassId id;
        SupportId first;
        World world;
    };

    void place(SupportId id) {
        const Support& s = table_.supports[id];
        const Frame& frame = table_.frames[s.frame];
        const World w = world_of(s, frame);
        const double key = key_of(w);
        // Wide enough for any two that agree: keys move by the snap's tolerance and by rounding far from the origin.
        const double window = 0x1p-30 * (1 + std::abs(key));
        ClassOfSupport best{static_cast<ClassId>(out_.supports.size()), false};
        if (snap_)
            for (const double sign : {1.0, -1.0}) {
                if (sign < 0 && w.form != World::Form::kPlane) break;
                const auto to = members_.upper_bound(sign * key + window);
                for (auto it = members_.lower_bound(sign * key - window); it != to; ++it) {
                    bool flipped = false;
                    double distance = 0;
                    if (it->second.id < best.id && agree(it->second, id, w, flipped, distance)) {
                        best = {it->second.id, flipped};
                        out_.largest = std::max(out_.largest, distance);
                    }
                }
            }
        if (best.id == out_.supports.size()) {
            out_.supports.push_back(s);
            if (snap_) members_.emplace(key, Member{best.id, id, w});
        } else {
            ++out_.fused;
        }
        out_.of.push_back(best);
    }

    // A number that moves little where the surface moves little.
    static double key_of(const World& w) {
        constexpr std::array<double, 6> k{0.6180339887, 0.7548776662, 0.5698402910, 0.8191725134, 0.6710436067, 0.5497004779};
        if (w.form == World::Form::kPlane) return static_cast<double>(k[0] * w.b[0] + k[1] * w.b[1] + k[2] * w.b[2] + k[3] * w.c);
        if (w.form == World::Form::kTorus) return static_cast<double>(k[0] * w.centre[0] + k[1] * w.centre[1] + k[2] * w.centre[2] + k[3] * w.ring + k[4] * w.tube);
        Real most = 0;
        for (const Real x : w.m) most = std::max(most, magnitude(x));
        if (most == 0) return 0;
        Real key = 0, sign = 1;
        for (const Real x : w.m)
            if (magnitude(x) > most / 2) {
                sign = x < 0 ? -1 : 1;
                break;
            }
        for (std::size_t i = 0; i < 3; ++i) key += k[i] * (w.m[i] + w.b[i]) + k[3 + i] * w.m[3 + i];
        return static_cast<double>(sign * key / most);
    }

    bool agree(const Member& member, SupportId id, const World& w, bool& flipped, double& distance) const {
        const Support &s = table_.supports[id], &t = table_.supports[member.first];
        if (w.form != member.world.form || table_.frames[s.frame].motion != table_.frames[t.frame].motion) return false;
        const Occurrence &a = table_.occurrences[id], &b = table_.occurrences[member.first];
        const double extent = std::max({finite_part(a.extent), finite_part(b.extent), finite_extent(a.box), finite_extent(b.box)});
        const double larger = std::max(finite_part(a.extent), finite_part(b.extent));
        const double tolerance = kSnapTolerance * (larger > 0 ? larger : extent) + a.rounding + b.rounding;
        if (!touching(a.box, b.box, tolerance)) return false;
        if (w.form == World::Form::kPlane) return planes_agree(w, member.world, a.box, b.box, tolerance, flipped, distance);
        if (w.form == World::Form::kTorus) return tori_agree(w, member.world, tolerance, distance);
        const double scale = extent > 0 ? extent : 1;
        const Vec3 centre = finite_centre(a.box);
        bool fa = false, fb = false;
        const auto x = normalised(w, centre, scale, fa), y = normalised(member.world, centre, scale, fb);
        flipped = fa != fb;
        distance = static_cast<double>(quadric_distance(x, y)) * scale;
        return distance <= tolerance;
    }

    static double finite_part(double x) { return std::isfinite(x) ? x : 0; }

    static Vec3 finite_centre(const Bounds& a) {
        Vec3 c{0};
        for (int i = 0; i < 3; ++i) {
            const double m = 0.5 * (a.lo[i] + a.hi[i]);
            c[i] = std::isfinite(m) ? m : 0;
        }
        return c;
    }

    static bool planes_agree(const World& w, const World& v, const Bounds& a, const Bounds& b, double tolerance, bool& flipped, double& distance) {
        const Real along = w.b[0] * v.b[0] + w.b[1] * v.b[1] + w.b[2] * v.b[2];
        flipped = along < 0;
        const Real sign = flipped ? -1 : 1;
        std::array<Real, 3> n;
        for (std::size_t i = 0; i < 3; ++i) n[i] = w.b[i] - sign * v.b[i];
        const Real c = w.c - sign * v.c;
        Real worst = 0;
        for (const Bounds* box : {&a, &b}) {
            Real most = c, least = c;
            for (std::size_t i = 0; i < 3; ++i) {
                if (n[i] == 0) continue;
                const double lo = box->lo[static_cast<int>(i)], hi = box->hi[static_cast<int>(i)];
                if (!std::isfinite(lo) || !std::isfinite(hi)) {
                    if (magnitude(n[i]) > kSnapTolerance) return false;
                    continue;
                }
                most += std::max(n[i] * lo, n[i] * hi);
                least += std::min(n[i] * lo, n[i] * hi);
            }
            worst = std::max({worst, magnitude(most), magnitude(least)});
        }
        distance = static_cast<double>(worst);
        return distance <= tolerance;
    }

    static bool tori_agree(const World& w, const World& v, double tolerance, double& distance) {
        Real worst = std::max(magnitude(w.ring - v.ring), magnitude(w.tube - v.tube)), lw = 0, lv = 0, cross = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            worst = std::max(worst, magnitude(w.centre[i] - v.centre[i]));
            lw += w.b[i] * w.b[i];
            lv += v.b[i] * v.b[i];
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            cross = std::max(cross, magnitude(w.b[j] * v.b[k] - w.b[k] * v.b[j]));
        }
        // Only frames that keep a torus round to the tolerance may share one.
        worst = std::max({worst, cross * (w.ring + w.tube), magnitude(std::sqrt(lw) - 1) * w.ring, magnitude(std::sqrt(lv) - 1) * v.ring});
        distance = static_cast<double>(worst);
        return distance <= tolerance;
    }

    const SupportTable& table_;
    bool snap_;
    Classes out_;
    std::multimap<double, Member> members_;
};

}  // namespace

Classes find_classes(const SupportTable& table, bool snap) { return Finder(table, snap).run(); }

}  // namespace whittle
