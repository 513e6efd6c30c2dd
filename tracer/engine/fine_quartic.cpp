// fine_quartic.cpp — Descartes' rule in the Bernstein basis, over double-double numbers that carry their errors.
//
// As the filter in torus_roots.cpp does it, but every piece's ends are exact: the interval is a power of two long, and pieces are halved.
// Source: Lane and Riesenfeld, Bounds on a polynomial (1981).
#include "tracer/engine/fine_quartic.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

using Coefficients = std::array<Bounded, 5>;

struct Piece {
    Coefficients b;
    double from = 0, width = 0;
};

Bounded value(const Coefficients& c, const Bounded& s) { return (((c[4] * s + c[3]) * s + c[2]) * s + c[1]) * s + c[0]; }
double slope(const Coefficients& c, double s) { return ((4 * c[4].high() * s + 3 * c[3].high()) * s + 2 * c[2].high()) * s + c[1].high(); }

int sign(const Bounded& x) { return x.is_certain() ? x.sign() : 0; }

// On [-reach, reach], a power of two: the blossom's values, elementary symmetric functions of four signs.
Piece bernstein(const Coefficients& c, double reach) {
    const Bounded third = Bounded(1.0) / Bounded(3.0);
    const Bounded c1 = c[1].scaled(reach), c2 = c[2].scaled(reach * reach), c3 = c[3].scaled(reach * reach * reach), c4 = c[4].scaled(reach * reach * reach * reach);
    const Bounded even = c[0] + c4, odd = c1 + c3, half = (c1 - c3).scaled(0.5), inner = c[0] - c4;
    return {{even + c2 - odd, inner - half, even - third * c2, inner + half, even + c2 + odd}, -reach, 2 * reach};
}

void halve(const Piece& p, Piece& left, Piece& right) {
    Coefficients b = p.b;
    left.b[0] = b[0];
    right.b[4] = b[4];
    for (std::size_t level = 1; level < 5; ++level) {
        for (std::size_t j = 0; j + level < 5; ++j) b[j] = (b[j] + b[j + 1]).scaled(0.5);
        left.b[level] = b[0];
        right.b[4 - level] = b[4 - level];
    }
    left.from = p.from;
    left.width = right.width = p.width * 0.5;
    right.from = p.from + left.width;
}

// Changes of sign along the coefficients; -1 where one is not certain.
int variations(const Coefficients& b) {
    int count = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        if (sign(b[i]) == 0) return -1;
        count += i > 0 && sign(b[i]) != sign(b[i - 1]);
    }
    return count;
}

// The root in the piece, certified by opposite signs on both sides of it.
bool refine(const Coefficients& c, const Piece& p, Bounded& root) {
    double lo = p.from, hi = p.from + p.width;
    const int before = sign(p.b[0]);
    double s = 0.5 * (lo + hi);
    for (int i = 0; i < 70; ++i) {
        const double v = value(c, s).high(), newton = s - v / slope(c, s);
        ((v > 0) == (before > 0) ? lo : hi) = s;
        const double next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        if (next == s || next <= lo || next >= hi) break;
        s = next;
    }
    const double k = slope(c, s);
    Bounded at(s);
    for (int i = 0; i < 3; ++i) {
        const Bounded moved = at - value(c, at) / Bounded(k);
        at = Bounded::about(moved.high(), moved.low(), 0);
        if (!std::isfinite(at.high())) return false;
    }
    const Bounded rest = value(c, at);
    double error = 1.25 * (std::abs(rest.high()) + rest.error()) / std::abs(k) + std::abs(at.high()) * 0x1p-104;
    for (int i = 0; i < 40 && std::isfinite(error); ++i, error *= 2) {
        const Bounded a = at - Bounded(error), b = at + Bounded(error);
        if (a.high() - a.error() <= p.from || b.high() + b.error() >= p.from + p.width) return false;
        if (sign(value(c, a)) != before || sign(value(c, b)) != -before) continue;
        root = Bounded::about(at.high(), at.low(), error + std::max(a.error(), b.error()));
        return true;
    }
    return false;
}

}  // namespace

bool fine_quartic_roots(const Coefficients& c, double reach, std::array<Bounded, 4>& roots, int& count) {
    count = 0;
    if (!std::isfinite(reach) || !(reach > 0)) return false;
    std::array<Piece, 64> stack;
    int top = 0;
    stack[0] = bernstein(c, std::exp2(std::ceil(std::log2(reach)) + 1));
    const double least = stack[0].width * 0x1p-50;
    while (top >= 0) {
        const Piece piece = stack[static_cast<std::size_t>(top--)];
        const int turns = variations(piece.b);
        if (turns == 0) continue;
        if (turns == 1) {
            if (count == 4 || !refine(c, piece, roots[static_cast<std::size_t>(count++)])) return false;
            continue;
        }
        if (piece.width < least || top > 60 || sign(piece.b[0]) == 0 || sign(piece.b[4]) == 0) return false;
        Piece left, right;
        halve(piece, left, right);
        stack[static_cast<std::size_t>(++top)] = right;
        stack[static_cast<std::size_t>(++top)] = left;
    }
    return true;
}

}  // namespace whittle
