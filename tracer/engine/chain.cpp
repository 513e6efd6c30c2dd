// chain.cpp — products of placements.
#include "tracer/engine/chain.h"

#include <algorithm>

namespace whittle {

namespace {

// The axis map equal to p, if p only permutes, scales and shifts axes.
bool as_axis_map(const Placement& p, AxisMap& map) {
    std::array<bool, 3> used{};
    for (int i = 0; i < 3; ++i) {
        int at = -1;
        for (int j = 0; j < 3; ++j)
            if (p.linear(i, j) != 0) {
                if (at >= 0) return false;
                at = j;
            }
        if (at < 0 || used[static_cast<std::size_t>(at)]) return false;
        used[static_cast<std::size_t>(at)] = true;
        map.from[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(at);
        map.scale[static_cast<std::size_t>(i)] = p.linear(i, at);
        map.shift[static_cast<std::size_t>(i)] = p.offset(i);
    }
    return true;
}

AxisMap after(const AxisMap& outer, const AxisMap& inner) {
    AxisMap r;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = outer.from[i];
        r.from[i] = inner.from[j];
        // What is 1 or 0 is not multiplied: most maps only shift.
        r.scale[i] = inner.scale[j] == 1 ? outer.scale[i] : outer.scale[i] * inner.scale[j];
        r.shift[i] = inner.shift[j] == 0 ? outer.shift[i] : (outer.scale[i] == 1 ? inner.shift[j] : outer.scale[i] * inner.shift[j]) + outer.shift[i];
    }
    return r;
}

}  // namespace

Chain::Matrix Chain::as_matrix(const AxisMap& m) {
    Matrix r{};
    for (std::size_t i = 0; i < 3; ++i) {
        r[4 * i + m.from[i]] = m.scale[i];
        r[4 * i + 3] = m.shift[i];
    }
    return r;
}

Chain::Matrix Chain::product(const Matrix& a, const Matrix& b) {
    Matrix r{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            Wide s = j == 3 ? a[4 * i + 3] : Wide(0);
            for (std::size_t k = 0; k < 3; ++k)
                if (a[4 * i + k] != 0 && b[4 * k + j] != 0) s += a[4 * i + k] * b[4 * k + j];
            r[4 * i + j] = s;
        }
    return r;
}

Placement Chain::rounded(const Matrix& m) {
    Placement p;
    for (std::size_t i = 0; i < 12; ++i) p.m[i] = to_double(m[i]) + 0.0;
    return p;
}

double Chain::displacement(const Matrix& m, double size) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double moved = 0;
        for (std::size_t j = 0; j < 4; ++j) {
            const double off = to_double(m[4 * i + j] - to_double(m[4 * i + j]));
            moved += std::abs(off) * (j == 3 ? 1 : size);
        }
        most = std::max(most, moved);
    }
    return most;
}

Chain Chain::then(const Placement& p) const {
    Chain r = *this;
    AxisMap map;
    if (as_axis_map(p, map)) {
        r.inner_ = after(inner_, map);
    } else {
        Matrix wide{};
        for (std::size_t i = 0; i < 12; ++i) wide[i] = p.m[i];
        r.outer_ = placed_ ? product(whole_matrix(), wide) : wide;
        r.inner_ = AxisMap{};
        r.turned_ = true;
    }
    double shift = 0, stretch = 0;
    for (int i = 0; i < 3; ++i) {
        shift = std::max(shift, std::abs(p.offset(i)));
        stretch = std::max(stretch, std::abs(p.linear(i, 0)) + std::abs(p.linear(i, 1)) + std::abs(p.linear(i, 2)));
    }
    r.reach_ = reach_ + stretch_ * shift;
    r.stretch_ = stretch_ * stretch;
    ++r.links_;
    r.placed_ = true;
    return r;
}

Chain Chain::within_section(const std::array<double, 2>& heights) const {
    Chain r;
    r.section_ = std::make_shared<const ChainSection>(ChainSection{*this, heights});
    r.reach_ = reach_;
    r.stretch_ = stretch_;
    r.links_ = links_;
    return r;
}

}  // namespace whittle
