// tessellate_quadric.cpp — any quadric, cut a little outside of the room it is needed in.
//
// Its principal axes bring it to one of a few kinds: a set of revolution scaled across its axis (ellipsoid, cylinder, cone, paraboloid,
// hyperboloids), the points on one side of a height field (saddle, parabolic cylinder), a strip between two curves (hyperbolic cylinder, pair of
// planes), or all but one of these.
#include <algorithm>
#include <cmath>
#include <functional>

#include "csg/base/degrees.h"
#include "modeler/mesh/tessellate.h"

namespace whittle {
namespace {

// A coefficient in principal axes this small against the largest is what rounding left of zero: 40 of 53 bits were cancelled.
constexpr double kVanishes = 0x1p-40;

// sum of l[i] y[i]^2 + b.y + c <= 0 with x = axes * y.
struct Principal {
    glm::dmat3 axes{1};
    Vec3 l{0}, b{0};
    double c = 0;
};

// Jacobi rotations; converge quadratically, 3 x 3 in a handful of sweeps. Source: Golub and Van Loan, Matrix Computations, 8.5.
void diagonalise(double a[3][3], glm::dmat3& axes) {
    for (int sweep = 0; sweep < 32; ++sweep) {
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                for (int k = 0; k < 3; ++k) {
                    const double akp = a[k][p], akq = a[k][q];
                    a[k][p] = c * akp - s * akq;
                    a[k][q] = s * akp + c * akq;
                }
                for (int k = 0; k < 3; ++k) {
                    const double apk = a[p][k], aqk = a[q][k];
                    a[p][k] = c * apk - s * aqk;
                    a[q][k] = s * apk + c * aqk;
                }
                a[p][q] = a[q][p] = 0;
                const Vec3 u = axes[p], v = axes[q];
                axes[p] = c * u - s * v;
                axes[q] = s * u + c * v;
            }
        if (a[0][1] == 0 && a[0][2] == 0 && a[1][2] == 0) return;
    }
}

Principal principal(const std::array<double, 10>& c) {
    Principal out;
    double a[3][3] = {{c[0], c[3] / 2, c[4] / 2}, {c[3] / 2, c[1], c[5] / 2}, {c[4] / 2, c[5] / 2, c[2]}};
    diagonalise(a, out.axes);
    out.l = {a[0][0], a[1][1], a[2][2]};
    out.b = Vec3{c[6], c[7], c[8]} * out.axes;  // transposed axes times the vector
    out.c = c[9];
    const double largest = std::max({std::fabs(out.l.x), std::fabs(out.l.y), std::fabs(out.l.z)});
    for (int i = 0; i < 3; ++i)
        if (std::fabs(out.l[i]) <= largest * kVanishes) out.l[i] = 0;
    return out;
}

// The room in principal axes.
Bounds seen_along(const glm::dmat3& axes, const Bounds& room) {
    Bounds out;
    for (int k = 0; k < 8; ++k) {
        const Vec3 q = Vec3{k & 1 ? room.hi.x : room.lo.x, k & 2 ? room.hi.y : room.lo.y, k & 4 ? room.hi.z : room.lo.z} * axes;
        out.lo = k == 0 ? q : glm::min(out.lo, q);
        out.hi = k == 0 ? q : glm::max(out.hi, q);
    }
    return out;
}

// A smooth plane curve as chords no farther from it than `error`, looked at in three places of each.
std::vector<Vec2> chords(const std::function<Vec2(double)>& curve, double from, double to, double error) {
    std::vector<Vec2> out{curve(from)};
    const std::function<void(double, double, int)> cut = [&](double a, double b, int depth) {
        const Vec2 p = curve(a), q = curve(b), along = q - p;
        const double length = glm::length(along);
        double off = 0;
        for (const double share : {0.25, 0.5, 0.75}) {
            const Vec2 d = curve(a + (b - a) * share) - p;
            off = std::max(off, length > 0 ? std::fabs(along.x * d.y - along.y * d.x) / length : glm::length(d));
        }
        constexpr int kDeepest = 12, kShallowest = 2;
        if (depth >= kDeepest || (depth >= kShallowest && off <= error)) {
            out.push_back(q);
        } else {
            cut(a, (a + b) / 2, depth + 1);
            cut((a + b) / 2, b, depth + 1);
        }
    };
    cut(from, to, 0);
    return out;
}

class Cutter {
public:
    Cutter(Principal p, const CurveRule& rule, const Bounds& room) : p_(p), rule_(rule), room_(widened(room)) {
        box_ = seen_along(p_.axes, room_);
        const double size = glm::length(box_.hi - box_.lo);
        error_ = rule_.chord(size / 2) / 2;
    }

    Tessellation run() {
        complete_squares();
        const int plus = count(1), minus = count(-1);
        if (plus + minus == 0) return flat();
        if (plus + minus == 3 || (plus + minus == 2 && plus != 1)) return around_axis(plus, minus);
        if (plus == 1 && minus == 1 && p_.b.z == 0) return strips();
        return height_field();
    }

private:
    int count(int sign) const {
        int n = 0;
        for (int i = 0; i < 3; ++i) n += p_.l[i] * sign > 0 ? 1 : 0;
        return n;
    }
    // Exchanges axes, keeping them right-handed.
    void exchange(int i, int j) {
        if (i == j) return;
        std::swap(p_.axes[i], p_.axes[j]);
        p_.axes[i] = -p_.axes[i];
        std::swap(p_.l[i], p_.l[j]);
        std::swap(p_.b[i], p_.b[j]);
        p_.b[i] = -p_.b[i];
        box_ = seen_along(p_.axes, room_);
    }

    // Moves the origin so that axes with a square have no linear part; brings those without a square to the end, with one linear part, in z.
    void complete_squares() {
        for (int i = 0; i < 3; ++i)
            if (p_.l[i] != 0) {
                centre_[i] = -p_.b[i] / (2 * p_.l[i]);
                p_.c -= p_.b[i] * p_.b[i] / (4 * p_.l[i]);
            }
        shift_ = p_.axes * centre_;
        for (int i = 0; i < 3; ++i)
            if (p_.l[i] != 0) p_.b[i] = 0;
        for (int i = 0; i < 2; ++i)
            for (int j = i + 1; j < 3; ++j)
                if (p_.l[i] == 0 && p_.l[j] != 0) exchange(i, j);
        if (p_.l.y == 0 && p_.b.y != 0) {  // turn y and z so that the linear part lies along z
            const double length = std::hypot(p_.b.y, p_.b.z);
            const Vec3 y = p_.axes[1], z = p_.axes[2];
            p_.axes[2] = (p_.b.y * y + p_.b.z * z) / length;
            p_.axes[1] = (p_.b.z * y - p_.b.y * z) / length;
            p_.b = {0, 0, length};
        }
        box_ = seen_along(p_.axes, room_);
        const Vec3 origin = shift_ * p_.axes;
        box_.lo -= origin;
        box_.hi -= origin;
    }

    Tessellation placed(Tessellation t) const {
        const auto place = [&](LeafMesh& m) {
            for (Vec3& p : m.points) p = shift_ + p_.axes * p;
        };
        place(t.mesh);
        for (LeafMesh& m : t.more) place(m);
        t.error = 2 * error_ * rule_.scale;
        if (inverted_) t.less = tessellate_box(room_.lo, room_.hi).mesh;
        return t;
    }
    // All of the room, or nothing of it.
    Tessellation whole(bool all) const { return all ? tessellate_box(room_.lo, room_.hi) : Tessellation{}; }

    Tessellation flat() const {
        if (p_.b == Vec3{0}) return whole(p_.c <= 0);
        return tessellate_half_space({p_.axes * p_.b, -p_.c}, room_);
    }

    // ------------------------------------------------------------------------------------------------ about an axis

    // l0 x^2 + l1 y^2 <= g(z) with l0, l1 > 0, or all but that.
    Tessellation around_axis(int plus, int minus) {
        if (plus < minus) {
            inverted_ = true;
            p_.l = -p_.l;
            p_.b = -p_.b;
            p_.c = -p_.c;
            std::swap(plus, minus);
        }
        for (int i = 0; i < 2; ++i)
            if (p_.l[i] < 0) exchange(i, 2), box_ = recentred();
        const double a = -p_.l.z, b = -p_.b.z, c = -p_.c;  // g = a z^2 + b z + c
        if (a < 0) return c > 0 ? ellipsoid() : whole(inverted_);
        if (a == 0 && b == 0) return c > 0 ? stacked({{{std::sqrt(c), box_.lo.z}, {std::sqrt(c), box_.hi.z}}}) : whole(inverted_);
        if (a == 0) return stacked({paraboloid(b, c)});
        if (c > 0) return stacked({waist(a, c)});
        return stacked(nappes(a, -c));
    }
    Bounds recentred() const {
        Bounds b = seen_along(p_.axes, room_);
        const Vec3 origin = shift_ * p_.axes;
        return {b.lo - origin, b.hi - origin};
    }

    Tessellation ellipsoid() {
        Tessellation t = tessellate_ellipsoid({std::sqrt(-p_.c / p_.l.x), std::sqrt(-p_.c / p_.l.y), std::sqrt(-p_.c / p_.l.z)}, rule_);
        const double error = t.error;
        t = placed(std::move(t));
        t.error = error;
        return t;
    }
    // The largest value of f = sqrt(g) that shows in the room.
    double reach() const {
        const Vec3 m = glm::max(glm::abs(box_.lo), glm::abs(box_.hi));
        return std::sqrt(p_.l.x * m.x * m.x + p_.l.y * m.y * m.y);
    }
    double profile_error() const { return error_ * std::sqrt(std::min(p_.l.x, p_.l.y)); }  // f to length

    // Curves run with z upward, (f, z), from the axis or the end of the room to the same.
    std::vector<Vec2> paraboloid(double b, double c) const {
        const double top = reach();
        auto curve = chords([&](double f) { return Vec2{f, (f * f - c) / b}; }, 0, top, profile_error());
        curve.emplace_back(top, b > 0 ? std::max(box_.hi.z, curve.back().y) : std::min(box_.lo.z, curve.back().y));
        if (b < 0) std::reverse(curve.begin(), curve.end());
        return curve;
    }
    std::vector<Vec2> waist(double a, double c) const {
        return chords([&](double z) { return Vec2{std::sqrt(a * z * z + c), z}; }, box_.lo.z, box_.hi.z, profile_error());
    }
    std::vector<std::vector<Vec2>> nappes(double a, double c) const {
        const double top = reach();
        std::vector<std::vector<Vec2>> out;
        auto up = chords([&](double f) { return Vec2{f, std::sqrt((f * f + c) / a)}; }, 0, top, profile_error());
        if (c == 0) up = {up.front(), up.back()};
        const double apex = up.front().y;
        if (box_.hi.z > apex) {
            out.push_back(up);
            out.back().emplace_back(top, std::max(box_.hi.z, up.back().y));
        }
        if (box_.lo.z < -apex) {
            out.emplace_back();
            out.back().emplace_back(top, std::min(box_.lo.z, -up.back().y));
            for (auto p = up.rbegin(); p != up.rend(); ++p) out.back().emplace_back(p->x, -p->y);
        }
        return out;
    }

    Tessellation stacked(const std::vector<std::vector<Vec2>>& curves) {
        Tessellation t;
        double widest = 0;
        for (const auto& c : curves)
            for (const Vec2& p : c) widest = std::max(widest, p.x);
        const Vec2 radii{1 / std::sqrt(p_.l.x), 1 / std::sqrt(p_.l.y)};
        const double radius = widest * std::max(radii.x, radii.y);
        const int n = rule_.turn_within(radius, std::min(error_, rule_.chord(radius) / 2));
        for (std::size_t k = 0; k < curves.size(); ++k) {
            LeafMesh mesh;
            const auto count = static_cast<std::uint32_t>(n);
            for (const Vec2& p : curves[k])
                for (int i = 0; i < n; ++i) mesh.points.emplace_back(p.x * radii.x * cosd(360.0 * i / n), p.x * radii.y * sind(360.0 * i / n), p.y);
            const auto rings = static_cast<std::uint32_t>(curves[k].size());
            for (std::uint32_t i = 0; i + 1 < rings; ++i) join_rings(mesh, i * count, (i + 1) * count, count);
            if (curves[k].front().x > 0) close_ring(mesh, 0, count, Facing::kReversed);
            if (curves[k].back().x > 0) close_ring(mesh, (rings - 1) * count, count, Facing::kAsListed);
            (k == 0 ? t.mesh : t.more.emplace_back()) = std::move(mesh);
        }
        if (curves.empty()) return whole(inverted_);
        return placed(std::move(t));
    }

    // ------------------------------------------------------------------------------------------------ strips and fields

    // l0 x^2 + l1 y^2 + c <= 0 with signs apart (b = 0): between or outside two branches, the same at every z.
    Tessellation strips() {
        if (p_.l.x < 0) exchange(0, 1), box_ = recentred();
        const double a = -p_.l.y / p_.l.x, c = -p_.c / p_.l.x;  // x^2 <= a y^2 + c
        const double error = error_;
        Tessellation t;
        if (c > 0) {
            auto right = chords([&](double y) { return Vec2{std::sqrt(a * y * y + c), y}; }, box_.lo.y, box_.hi.y, error);
            t.mesh = prism(right);
            return placed(std::move(t));
        }
        const double far_x = std::max(std::fabs(box_.lo.x), std::fabs(box_.hi.x)), far_y = std::max(std::fabs(box_.lo.y), std::fabs(box_.hi.y));
        auto up = chords([&](double x) { return Vec2{x, std::sqrt((x * x - c) / a)}; }, 0, far_x, error);
        if (c == 0) up = {up.front(), up.back()};
        up.emplace_back(far_x, std::max(far_y, up.back().y));
        std::vector<Vec2> down(up.rbegin(), up.rend());
        for (Vec2& p : down) p.y = -p.y;
        t.mesh = prism(up);
        t.more.push_back(prism(down));
        return placed(std::move(t));
    }
    // The set |x| <= half[i].x between rising y, as a prism along z.
    LeafMesh prism(const std::vector<Vec2>& half) const {
        LeafMesh mesh;
        for (const double z : {box_.lo.z, box_.hi.z})
            for (const Vec2& p : half) {
                mesh.points.emplace_back(-p.x, p.y, z);
                mesh.points.emplace_back(p.x, p.y, z);
            }
        const auto n = static_cast<std::uint32_t>(half.size()), top = 2 * n;
        for (std::uint32_t i = 0; i + 1 < n; ++i) {
            const std::uint32_t l0 = 2 * i, r0 = l0 + 1, l1 = l0 + 2, r1 = l0 + 3;
            mesh.quad(l0, l1, r1, r0);
            mesh.quad(l0 + top, r0 + top, r1 + top, l1 + top);
            mesh.quad(r0, r1, r1 + top, r0 + top);
            mesh.quad(l1, l0, l0 + top, l1 + top);
        }
        mesh.quad(0, 1, 1 + top, top);
        mesh.quad(2 * n - 1, 2 * n - 2, 2 * n - 2 + top, 2 * n - 1 + top);
        return mesh;
    }

    // A field over x and y where z is linear; or, without z, the slab of one square.
    Tessellation height_field() {
        if (p_.b.z == 0) return slab();
        const auto height = [&](double x, double y) { return -(p_.c + p_.l.x * x * x + p_.l.y * y * y) / p_.b.z; };
        const int nx = cells(p_.l.x, box_.hi.x - box_.lo.x), ny = cells(p_.l.y, box_.hi.y - box_.lo.y);
        const bool below = p_.b.z > 0;
        double end = below ? box_.lo.z : box_.hi.z;
        Tessellation t;
        LeafMesh& mesh = t.mesh;
        for (int i = 0; i <= nx; ++i)
            for (int j = 0; j <= ny; ++j) {
                const double x = box_.lo.x + (box_.hi.x - box_.lo.x) * i / nx, y = box_.lo.y + (box_.hi.y - box_.lo.y) * j / ny;
                mesh.points.emplace_back(x, y, height(x, y));
                end = below ? std::min(end, mesh.points.back().z) : std::max(end, mesh.points.back().z);
            }
        end += (below ? -1 : 1) * (box_.hi.z - box_.lo.z) / 8;
        const std::size_t fields = mesh.points.size();
        for (std::size_t i = 0; i < fields; ++i) mesh.points.emplace_back(mesh.points[i].x, mesh.points[i].y, end);
        const auto at = [&](int i, int j, bool base) { return static_cast<std::uint32_t>(i * (ny + 1) + j + (base ? static_cast<int>(fields) : 0)); };
        for (int i = 0; i < nx; ++i)
            for (int j = 0; j < ny; ++j) {
                mesh.quad(at(i, j, !below), at(i + 1, j, !below), at(i + 1, j + 1, !below), at(i, j + 1, !below));
                mesh.quad(at(i, j, below), at(i, j + 1, below), at(i + 1, j + 1, below), at(i + 1, j, below));
            }
        const bool up = below, low = !below;  // which layer is above, as `base` says it
        const auto wall = [&](int i0, int j0, int i1, int j1) { mesh.quad(at(i0, j0, up), at(i1, j1, up), at(i1, j1, low), at(i0, j0, low)); };
        for (int i = 0; i < nx; ++i) wall(i, 0, i + 1, 0), wall(i + 1, ny, i, ny);
        for (int j = 0; j < ny; ++j) wall(nx, j, nx, j + 1), wall(0, j + 1, 0, j);
        return placed(std::move(t));
    }
    // A chord of width d under a parabola l x^2/b is off by l d^2/(4 b); the two directions share the error.
    int cells(double l, double width) const {
        if (l == 0) return 1;
        const double curvature = std::fabs(l / p_.b.z);
        return std::clamp(static_cast<int>(std::ceil(width * std::sqrt(curvature / (4 * error_)))), 1, 512);
    }
    Tessellation slab() {
        if (p_.l.x < 0) {
            inverted_ = true;
            p_.l = -p_.l;
            p_.c = -p_.c;
        }
        if (p_.c >= 0) return whole(inverted_);
        const double half = std::sqrt(-p_.c / p_.l.x);
        Tessellation t = tessellate_box({-half, box_.lo.y, box_.lo.z}, {half, box_.hi.y, box_.hi.z});
        t = placed(std::move(t));
        t.error = 0;
        return t;
    }

    Principal p_;
    CurveRule rule_;
    Bounds room_, box_;
    Vec3 centre_{0}, shift_{0};
    double error_ = 0;
    bool inverted_ = false;
};

}  // namespace

Result<Tessellation> tessellate_quadric(const shape::Quadric& s, const CurveRule& rule, const Bounds& room) {
    return Cutter(principal(s.c), rule, room).run();
}

}  // namespace whittle
