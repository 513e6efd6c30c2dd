// mesh_rays.cpp — every crossing of a ray with a mesh, decided exactly.
//
// A triangle is crossed when the ray passes its three edges on the same side: the sign of det(d, u - o, v - o) for each edge (u, v), taken in one
// order for both its triangles, so no ray slips between two. A zero takes the sign of its first nonzero derivative along the vectors of
// csg/span/perturbation.h. Signs are decided in double with Shewchuk's bound, else in rationals; so is the order of crossings that are too close.
// Sources: Segura and Feito, Algorithms to test ray-triangle intersection (2001); Shewchuk, Adaptive Precision (1997); Wald, On fast construction
// of SAH-based bounding volume hierarchies (2007).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gmpxx.h>

#include "csg/span/perturbation.h"
#include "modeler/mesh/mesh_queries.h"

namespace whittle {
namespace {

constexpr double kEpsilon = 0x1p-53;
// Of a 3 x 3 determinant of differences, against the sum of its terms' magnitudes (Shewchuk's o3derrboundA).
constexpr double kDeterminantBound = (7 + 56 * kEpsilon) * kEpsilon;
// Of a dot product of such a vector and a cross product of two of them, once more multiplied.
constexpr double kTripleBound = 16 * kEpsilon;

using Rational3 = std::array<mpq_class, 3>;
Rational3 rational(const Vec3& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }
Rational3 minus(const Rational3& a, const Rational3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational3 cross(const Rational3& a, const Rational3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dot(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// det(a, b, c) and the sum of its terms' magnitudes.
struct Determinant {
    double value, magnitude;
    bool certain() const { return std::fabs(value) > kDeterminantBound * magnitude; }
};
Determinant determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double x1 = b.y * c.z, x2 = b.z * c.y, y1 = b.z * c.x, y2 = b.x * c.z, z1 = b.x * c.y, z2 = b.y * c.x;
    return {a.x * (x1 - x2) + a.y * (y1 - y2) + a.z * (z1 - z2), std::fabs(a.x) * (std::fabs(x1) + std::fabs(x2)) +
                                                                    std::fabs(a.y) * (std::fabs(y1) + std::fabs(y2)) +
                                                                    std::fabs(a.z) * (std::fabs(z1) + std::fabs(z2))};
}
int sign(double x) { return (x > 0) - (x < 0); }

// Which side of edge (u, v) the ray passes on; antisymmetric in u and v. Zero only when the edge is parallel to the ray.
int exact_side(const Ray& ray, const Vec3& u, const Vec3& v) {
    const Rational3 d = rational(ray.direction), o = rational(ray.origin), ru = rational(u), rv = rational(v);
    if (const int s = sgn(dot(d, cross(minus(ru, o), minus(rv, o)))); s != 0) return s;
    const Rational3 edge = minus(rv, ru);
    for (const Vec3& nudge : kPerturbation)
        if (const int s = -sgn(dot(d, cross(rational(nudge), edge))); s != 0) return s;
    return 0;
}
int side(const Ray& ray, const Vec3& u, const Vec3& v) {
    const Determinant det = determinant(ray.direction, u - ray.origin, v - ray.origin);
    return det.certain() ? sign(det.value) : exact_side(ray, u, v);
}

// t as a fraction, with its derivatives by the perturbation: t = (a - o).n / d.n.
struct ExactPlace {
    mpq_class t;
    std::array<mpq_class, 3> slopes;
    ExactPlace(const Ray& ray, const std::array<Vec3, 3>& p) {
        const Rational3 a = rational(p[0]), n = cross(minus(rational(p[1]), a), minus(rational(p[2]), a));
        const mpq_class along = dot(rational(ray.direction), n);
        t = dot(minus(a, rational(ray.origin)), n) / along;
        for (std::size_t k = 0; k < 3; ++k) slopes[k] = -dot(rational(kPerturbation[k]), n) / along;
    }
    bool operator<(const ExactPlace& o) const { return t != o.t ? t < o.t : slopes < o.slopes; }
    bool before_origin() const {
        if (t != 0) return t < 0;
        for (const mpq_class& s : slopes)
            if (s != 0) return s < 0;
        return false;
    }
};

struct TreeNode {
    Vec3 lo, hi;
    std::uint32_t first = 0;  // of its triangles, or its left child; the right one follows that
    std::uint32_t count = 0;  // 0: inner
};

}  // namespace

struct MeshRays::Impl {
    std::vector<TreeNode> nodes;
    std::vector<std::uint32_t> order;               // triangles as the tree lists them
    std::vector<std::array<Vec3, 3>> corners;       // in that order
    std::vector<Triangle> indices;

    explicit Impl(const Mesh& mesh);
    void split(std::uint32_t node, std::vector<Vec3>& centres);
    void fit(TreeNode& node) const;
    bool meets(const Ray& ray, const Vec3& inverse, const TreeNode& node) const;
    void try_triangle(const Ray& ray, std::uint32_t i, std::vector<MeshCrossing>& out) const;
};

namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr int kBins = 16;

double half_area(const Vec3& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

struct Bin {
    Vec3 lo{std::numeric_limits<double>::infinity()}, hi{-std::numeric_limits<double>::infinity()};
    std::uint32_t count = 0;
    void add(const Bin& o) { lo = glm::min(lo, o.lo), hi = glm::max(hi, o.hi), count += o.count; }
    double cost() const { return count == 0 ? 0 : half_area(hi - lo) * count; }
};

}  // namespace

MeshRays::Impl::Impl(const Mesh& mesh) {
    const std::size_t n = mesh.triangles.size();
    order.resize(n);
    std::iota(order.begin(), order.end(), 0U);
    indices = mesh.triangles;
    corners.reserve(n);
    std::vector<Vec3> centres;
    for (const Triangle& t : mesh.triangles) {
        corners.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
        centres.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0);
    }
    if (n == 0) return;
    nodes.reserve(n);
    nodes.push_back({{}, {}, 0, static_cast<std::uint32_t>(n)});
    fit(nodes[0]);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) split(i, centres);
}

void MeshRays::Impl::fit(TreeNode& node) const {
    node.lo = Vec3(std::numeric_limits<double>::infinity());
    node.hi = -node.lo;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        for (const Vec3& p : corners[i]) node.lo = glm::min(node.lo, p), node.hi = glm::max(node.hi, p);
}

// At the best of 15 planes across the longest axis of the centres.
void MeshRays::Impl::split(std::uint32_t at, std::vector<Vec3>& centres) {
    const std::uint32_t first = nodes[at].first, count = nodes[at].count, last = first + count;
    if (count <= kLeafSize) return;
    Vec3 lo = centres[first], hi = lo;
    for (std::uint32_t i = first; i < last; ++i) lo = glm::min(lo, centres[i]), hi = glm::max(hi, centres[i]);
    const Vec3 size = hi - lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (!(size[axis] > 0)) return;
    const auto bin_of = [&](std::uint32_t i) { return std::min(kBins - 1, static_cast<int>((centres[i][axis] - lo[axis]) / size[axis] * kBins)); };
    std::array<Bin, kBins> bins;
    for (std::uint32_t i = first; i < last; ++i) {
        Bin one;
        one.count = 1;
        for (const Vec3& p : corners[i]) one.lo = glm::min(one.lo, p), one.hi = glm::max(one.hi, p);
        bins[static_cast<std::size_t>(bin_of(i))].add(one);
    }
    std::array<double, kBins> left{};
    Bin sum;
    for (std::size_t b = 0; b + 1 < kBins; ++b) sum.add(bins[b]), left[b] = sum.cost();
    sum = Bin{};
    double best = std::numeric_limits<double>::infinity();
    int plane = 0;
    for (std::size_t b = kBins - 1; b > 0; --b) {
        sum.add(bins[b]);
        if (const double cost = left[b - 1] + sum.cost(); cost < best) best = cost, plane = static_cast<int>(b);
    }
    std::uint32_t middle = first;
    for (std::uint32_t i = first; i < last; ++i)
        if (bin_of(i) < plane) {
            std::swap(order[i], order[middle]);
            std::swap(corners[i], corners[middle]);
            std::swap(indices[i], indices[middle]);
            std::swap(centres[i], centres[middle]);
            ++middle;
        }
    if (middle == first || middle == last) return;
    const auto child = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({{}, {}, first, middle - first});
    nodes.push_back({{}, {}, middle, last - middle});
    fit(nodes[child]);
    fit(nodes[child + 1]);
    nodes[at].first = child;
    nodes[at].count = 0;
}

// Never a false no: a slab's interval is widened by its rounding. Source: Ize, Robust BVH Ray Traversal (2013).
bool MeshRays::Impl::meets(const Ray& ray, const Vec3& inverse, const TreeNode& node) const {
    constexpr double kWiden = 1 + 8 * kEpsilon;
    double in = 0, out = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) {
            if (ray.origin[i] < node.lo[i] || ray.origin[i] > node.hi[i]) return false;
            continue;
        }
        double a = (node.lo[i] - ray.origin[i]) * inverse[i], b = (node.hi[i] - ray.origin[i]) * inverse[i];
        if (a > b) std::swap(a, b);
        in = std::max(in, a > 0 ? a / kWiden : a * kWiden);
        out = std::min(out, b > 0 ? b * kWiden : b / kWiden);
    }
    return in <= out;
}

void MeshRays::Impl::try_triangle(const Ray& ray, std::uint32_t i, std::vector<MeshCrossing>& out) const {
    const auto& p = corners[i];
    const Triangle& v = indices[i];
    int common = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3;
        const int s = v[k] < v[l] ? side(ray, p[k], p[l]) : -side(ray, p[l], p[k]);
        if (s == 0 || (k > 0 && s != common)) return;  // parallel to an edge: seen from the side, never crossed
        common = s;
    }
    MeshCrossing c;
    c.triangle = order[i];
    c.entering = common < 0;
    const Vec3 ab = p[1] - p[0], ac = p[2] - p[0];
    const Determinant along = determinant(ray.direction, ab, ac), far = determinant(p[0] - ray.origin, ab, ac);
    const double along_error = kTripleBound * along.magnitude, far_error = kTripleBound * far.magnitude;
    const bool sure = std::fabs(along.value) > 4 * along_error && std::fabs(far.value) > far_error;
    if (sure) {
        c.t = far.value / along.value;
        c.t_error = (far_error + std::fabs(c.t) * along_error) / (std::fabs(along.value) - along_error) + 2 * kEpsilon * std::fabs(c.t);
        if (c.t < 0) return;
    } else {
        const ExactPlace place(ray, p);
        if (place.before_origin()) return;
        c.t = place.t.get_d();
        c.t_error = 4 * kEpsilon * std::fabs(c.t);
    }
    out.push_back(c);
}

MeshRays::MeshRays(const Mesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
MeshRays::~MeshRays() = default;
MeshRays::MeshRays(MeshRays&&) noexcept = default;
MeshRays& MeshRays::operator=(MeshRays&&) noexcept = default;

void MeshRays::crossings(const Ray& ray, std::vector<MeshCrossing>& out) const {
    out.clear();
    if (impl_->nodes.empty()) return;
    const Vec3 inverse = 1.0 / ray.direction;
    std::array<std::uint32_t, 128> stack;  // depth-first: one entry a level; SAH trees of 2^32 triangles stay far below
    std::vector<std::uint32_t> deep;       // and if one does not
    std::size_t top = 0;
    const auto push = [&](std::uint32_t n) { top < stack.size() ? void(stack[top++] = n) : deep.push_back(n); };
    std::vector<std::uint32_t> places;     // where in the tree each crossing's triangle is
    push(0);
    while (top > 0 || !deep.empty()) {
        std::uint32_t at;
        if (!deep.empty()) {
            at = deep.back();
            deep.pop_back();
        } else {
            at = stack[--top];
        }
        const TreeNode& node = impl_->nodes[at];
        if (!impl_->meets(ray, inverse, node)) continue;
        if (node.count == 0) {
            push(node.first);
            push(node.first + 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const std::size_t before = out.size();
            impl_->try_triangle(ray, i, out);
            if (out.size() > before) places.push_back(i);
        }
    }
    std::vector<std::uint32_t> rank(out.size());
    std::iota(rank.begin(), rank.end(), 0U);
    std::sort(rank.begin(), rank.end(), [&](std::uint32_t i, std::uint32_t j) {
        const MeshCrossing &a = out[i], &b = out[j];
        if (std::fabs(a.t - b.t) > a.t_error + b.t_error) return a.t < b.t;
        const ExactPlace x(ray, impl_->corners[places[i]]), y(ray, impl_->corners[places[j]]);
        if (x < y) return true;
        if (y < x) return false;
        return a.triangle < b.triangle;
    });
    std::vector<MeshCrossing> sorted;
    sorted.reserve(out.size());
    for (const std::uint32_t i : rank) sorted.push_back(out[i]);
    out.swap(sorted);
}

}  // namespace whittle
