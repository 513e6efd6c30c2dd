#include "modeler/arrange/exact_points.h"

#include <cmath>

namespace whittle {
namespace {

// A Located's doubles are off by less than this share of their size, and by 2^-60 at most beside.
constexpr double kNearError = 0x1p-52;
// Rounding of the few products and sums of a filter, relative to the sum of the magnitudes.
constexpr double kFilterError = 0x1p-49;

double largest(const Approximate& p) { return std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}); }

Wide<3> scaled_distance(const ExactPlane& plane, const GridPoint& p) {
    Wide<3> sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + Wide<2>(plane.n[i]) * Wide<1>(p[i] - plane.at[i]);
    return sum;
}

std::array<Wide<4>, 3> cross_of(const ExactPlane& p, const ExactPlane& q) {
    std::array<Wide<4>, 3> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = Wide<2>(p.n[j]) * Wide<2>(q.n[k]) - Wide<2>(p.n[k]) * Wide<2>(q.n[j]);
    }
    return out;
}

void make_positive(ExactPoint& p) {
    if (!p.w.negative()) return;
    p.w = -p.w;
    for (auto& x : p.x) x = -x;
}

}  // namespace

Wide<3> ExactPlane::offset() const {
    Wide<3> sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + Wide<2>(n[i]) * Wide<1>(at[i]);
    return sum;
}

int ExactPlane::largest_axis() const {
    const double x = std::fabs(nd[0]), y = std::fabs(nd[1]), z = std::fabs(nd[2]);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

ExactPlane plane_through(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    ExactPlane plane;
    plane.at = a;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        plane.n[i] = static_cast<Int128>(b[j] - a[j]) * (c[k] - a[k]) - static_cast<Int128>(b[k] - a[k]) * (c[j] - a[j]);
    }
    for (std::size_t i = 0; i < 3; ++i)  // an axis' own plane: the points in it then stay small
        if (plane.n[(i + 1) % 3] == 0 && plane.n[(i + 2) % 3] == 0 && plane.n[i] != 0) plane.n[i] = plane.n[i] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) plane.nd[i] = static_cast<double>(plane.n[i]);
    return plane;
}

ExactPlane plane_along(const GridPoint& a, const GridPoint& b, int axis) {
    GridPoint c = a;
    ++c[static_cast<std::size_t>(axis)];
    return plane_through(a, b, c);
}

ExactPoint exact_point(const GridPoint& p) {
    ExactPoint out;
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = Wide<6>(p[i]);
    out.w = Wide<5>(std::int64_t{1});
    return out;
}

ExactPoint crossing_of(const GridPoint& a, const GridPoint& b, const ExactPlane& plane) {
    const Wide<3> sa = scaled_distance(plane, a), sb = scaled_distance(plane, b);
    ExactPoint out;
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = (sa * Wide<1>(b[i]) - sb * Wide<1>(a[i])).as<6>();
    out.w = (sa - sb).as<5>();
    make_positive(out);
    return out;
}

std::optional<ExactPoint> common_point(const ExactPlane& p, const ExactPlane& q, const ExactPlane& r) {
    const auto qr = cross_of(q, r), rp = cross_of(r, p), pq = cross_of(p, q);
    Wide<6> w;
    for (std::size_t i = 0; i < 3; ++i) w = w + Wide<2>(p.n[i]) * qr[i];
    if (w.sign() == 0) return std::nullopt;
    const Wide<3> dp = p.offset(), dq = q.offset(), dr = r.offset();
    ExactPoint out;
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = (dp * qr[i] + dq * rp[i] + dr * pq[i]).as<6>();
    out.w = w.as<5>();
    make_positive(out);
    return out;
}

int side_of(const ExactPlane& plane, const GridPoint& p) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double term = plane.nd[i] * static_cast<double>(p[i] - plane.at[i]);
        sum += term;
        size += std::fabs(term);
    }
    if (std::fabs(sum) > size * kFilterError) return sum > 0 ? 1 : -1;
    if (size == 0) return 0;
    return scaled_distance(plane, p).sign();
}

int turn_of(const GridPoint& a, const GridPoint& b, const GridPoint& c, int axis) {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    const Int128 t = static_cast<Int128>(b[i] - a[i]) * (c[j] - a[j]) - static_cast<Int128>(b[j] - a[j]) * (c[i] - a[i]);
    return t > 0 ? 1 : t < 0 ? -1 : 0;
}

int turn_of(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    const auto minor = [&](const ExactPoint& p, const ExactPoint& q) { return p.x[i] * q.x[j] - q.x[i] * p.x[j]; };  // 730 bits
    const Wide<17> sum = (minor(a, b) * c.w + minor(b, c) * a.w + minor(c, a) * b.w).template as<17>();
    return sum.sign();
}

PointTable::Located PointTable::located(const GridPoint& p) {
    Located out;
    out.exact = exact_point(p);
    for (std::size_t i = 0; i < 3; ++i) {
        out.key[i] = p[i] * (std::int64_t{1} << kKeyBits);
        out.near[i] = static_cast<double>(p[i]);
    }
    out.on_grid = true;
    return out;
}

PointTable::Located PointTable::located(const ExactPoint& p) {
    Located out;
    out.exact = p;
    out.on_grid = true;
    const long double w = p.w.value();
    const Wide<6> one_more = p.w.as<6>();
    constexpr std::int64_t kUnit = std::int64_t{1} << kKeyBits;
    for (std::size_t i = 0; i < 3; ++i) {
        auto q = static_cast<std::int64_t>(std::floor(p.x[i].value() / w * static_cast<long double>(kUnit)));
        Wide<6> rest = (p.x[i] << kKeyBits) - (p.w * Wide<1>(q)).template as<6>();
        for (; rest.negative(); rest = rest + one_more) --q;
        for (Wide<6> less = rest - one_more; !less.negative(); less = rest - one_more) rest = less, ++q;
        const bool whole = rest.sign() == 0;
        out.key[i] = q;
        out.near[i] = static_cast<double>((static_cast<long double>(q) + (whole ? 0 : rest.value() / w)) / static_cast<long double>(kUnit));
        out.on_grid = out.on_grid && whole && q % kUnit == 0;
    }
    if (out.on_grid) return located(GridPoint{out.key[0] / kUnit, out.key[1] / kUnit, out.key[2] / kUnit});
    return out;
}

namespace {

std::uint64_t hash_of(const PointTable::Key& key) {
    std::uint64_t h = 0x9E3779B97F4A7C15ULL;
    for (const std::int64_t x : key) h = (h ^ static_cast<std::uint64_t>(x)) * 0xD6E8FEB86659FD93ULL, h ^= h >> 32;
    return h;
}

bool equal(const ExactPoint& a, const ExactPoint& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (!(a.x[i] * b.w == b.x[i] * a.w)) return false;
    return true;
}

}  // namespace

template <class Same>
PointId PointTable::found_or_new(const Key& key, Same same) {
    if (slots_.size() < 2 * (keys_.size() + 1)) grow();
    std::size_t i = hash_of(key) & (slots_.size() - 1);
    for (; slots_[i] != 0; i = (i + 1) & (slots_.size() - 1)) {
        const PointId id = slots_[i] - 1;
        if (keys_[id] == key && same(id)) return id;
    }
    const auto id = static_cast<PointId>(keys_.size());
    slots_[i] = id + 1;
    keys_.push_back(key);
    return id;
}

void PointTable::grow() {
    std::size_t size = std::max<std::size_t>(1024, slots_.size() * 2);
    slots_.assign(size, 0);
    for (std::uint32_t id = 0; id < keys_.size(); ++id) {
        std::size_t i = hash_of(keys_[id]) & (size - 1);
        while (slots_[i] != 0) i = (i + 1) & (size - 1);
        slots_[i] = id + 1;
    }
}

PointId PointTable::add(const GridPoint& p) {
    Key key;
    for (std::size_t i = 0; i < 3; ++i) key[i] = p[i] * (std::int64_t{1} << kKeyBits);
    const std::size_t before = keys_.size();
    const PointId id = found_or_new(key, [&](PointId other) { return on_grid(other); });
    if (keys_.size() > before) {
        near_.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
        exact_.push_back(kOnGrid);
    }
    return id;
}

PointId PointTable::add(const Located& p) {
    const std::size_t before = keys_.size();
    const PointId id = found_or_new(p.key, [&](PointId other) {
        return on_grid(other) ? p.on_grid : !p.on_grid && equal(rational_[exact_[other]], p.exact);
    });
    if (keys_.size() == before) return id;
    near_.push_back(p.near);
    exact_.push_back(p.on_grid ? kOnGrid : static_cast<std::uint32_t>(rational_.size()));
    if (!p.on_grid) rational_.push_back(p.exact);
    return id;
}

int PointTable::compare(const Located& a, const Located& b, int k) {
    const auto i = static_cast<std::size_t>(k);
    if (a.key[i] != b.key[i]) return a.key[i] < b.key[i] ? -1 : 1;
    return (a.exact.x[i] * b.exact.w - b.exact.x[i] * a.exact.w).sign();
}

int PointTable::compare(PointId a, PointId b, int k) const {
    const auto i = static_cast<std::size_t>(k);
    if (keys_[a][i] != keys_[b][i]) return keys_[a][i] < keys_[b][i] ? -1 : 1;
    if (a == b || (on_grid(a) && on_grid(b))) return 0;
    const ExactPoint p = exact(a), q = exact(b);
    return (p.x[i] * q.w - q.x[i] * p.w).sign();
}

int PointTable::turn_if_clear(PointId a, PointId b, PointId c, int axis) const {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    const Approximate &p = near_[a], &q = near_[b], &r = near_[c];
    const double ax = q[i] - p[i], ay = q[j] - p[j], bx = r[i] - p[i], by = r[j] - p[j];
    const double one = ax * by, two = ay * bx;
    const double off = 3 * kNearError * std::max({largest(p), largest(q), largest(r)}) + 0x1p-58;
    const double bound = off * (std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by) + 2 * off) + kFilterError * (std::fabs(one) + std::fabs(two));
    const double det = one - two;
    return det > bound ? 1 : det < -bound ? -1 : 0;
}

int PointTable::turn(PointId a, PointId b, PointId c, int axis) const {
    if (const int clear = turn_if_clear(a, b, c, axis); clear != 0) return clear;
    if (a == b || b == c || c == a) return 0;
    if (on_grid(a) && on_grid(b) && on_grid(c)) return turn_of(grid(a), grid(b), grid(c), axis);
    return turn_of(exact(a), exact(b), exact(c), axis);
}

int PointTable::side(const ExactPlane& plane, PointId p) const {
    if (on_grid(p)) return side_of(plane, grid(p));
    const Approximate& at = near_[p];
    double sum = 0, size = 0, steep = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double term = plane.nd[i] * (at[i] - static_cast<double>(plane.at[i]));
        sum += term;
        size += std::fabs(term);
        steep += std::fabs(plane.nd[i]);
    }
    const double bound = size * kFilterError + steep * (2 * kNearError * largest(at) + 0x1p-58);
    if (std::fabs(sum) > bound) return sum > 0 ? 1 : -1;
    const ExactPoint e = exact(p);
    Wide<8> exact_sum;
    for (std::size_t i = 0; i < 3; ++i) exact_sum = exact_sum + Wide<2>(plane.n[i]) * e.x[i];
    return (exact_sum - (plane.offset() * e.w)).sign();
}

}  // namespace whittle
