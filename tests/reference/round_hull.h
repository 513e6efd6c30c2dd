// round_hull.h — the convex hull of balls (discs, in the plane) of any radii, 0 too, as a formula at a point whose coordinates are polynomials or numbers A + B rho.
//
// A point is in the hull of some balls where it is in a ball between them: |y|^2 - 2 l.b + l.G l < r^2 for some weights l, y and the others from the first centre.
// Every point of the hull's border is in the hull of as many balls as the space has dimensions, for a plane touches it there and each ball in one point only. What
// the hulls of so few leave out is between the centres: shrink all radii evenly, and either a border passes over the point or it is in the centres' hull at last.
#pragma once

#include <vector>

#include "tests/reference/formula.h"

namespace whittle::reference {

// Everything times one positive number, so that no quotient is needed.
template <class Number>
struct Round {
    std::vector<Number> centre;
    Number radius;
};

template <class Number>
class RoundHull {
public:
    RoundHull(Formulas& formulas, std::vector<Number> point, std::vector<Round<Number>> balls) : f_(formulas), p_(std::move(point)), balls_(std::move(balls)) {}

    // Requires: the point has two or three coordinates, and each centre as many.
    ExpressionId operator()() {
        std::vector<std::size_t> chosen;
        choose(0, chosen);
        return f_.any(std::move(parts_));
    }

private:
    using Place = std::vector<Number>;

    void choose(std::size_t from, std::vector<std::size_t>& chosen) {
        if (!chosen.empty()) parts_.push_back(chosen.size() == 1 ? in_ball(chosen[0]) : chosen.size() == 2 ? between_two(chosen[0], chosen[1]) : among(chosen));
        if (chosen.size() == p_.size() + 1) return;
        for (std::size_t i = from; i < balls_.size(); ++i) {
            chosen.push_back(i);
            choose(i + 1, chosen);
            chosen.pop_back();
        }
    }
    ExpressionId among(const std::vector<std::size_t>& chosen) {
        if (chosen.size() == 4) return within_tetrahedron(chosen);
        return p_.size() == 2 ? within_triangle(chosen) : between_three(chosen[0], chosen[1], chosen[2]);
    }

    static Place difference(const Place& a, const Place& b) {
        Place r;
        for (std::size_t i = 0; i < a.size(); ++i) r.push_back(a[i] - b[i]);
        return r;
    }
    static Number dot(const Place& a, const Place& b) {
        Number sum = a[0] * b[0];
        for (std::size_t i = 1; i < a.size(); ++i) sum = sum + a[i] * b[i];
        return sum;
    }
    // Of the ball from the first one: where, how much larger, and b of the head comment.
    struct Other {
        Place a;
        Number d, b;
    };
    Other other(std::size_t i, std::size_t first, const Place& y) const {
        Other o;
        o.a = difference(balls_[i].centre, balls_[first].centre);
        o.d = balls_[i].radius - balls_[first].radius;
        o.b = dot(o.a, y) + balls_[first].radius * o.d;
        return o;
    }
    Number power(std::size_t first, const Place& y) const { return dot(y, y) - balls_[first].radius * balls_[first].radius; }

    ExpressionId in_ball(std::size_t i) { return f_.negative(power(i, difference(p_, balls_[i].centre))); }

    ExpressionId between_two(std::size_t first, std::size_t second) {
        const Place y = difference(p_, balls_[first].centre);
        const Other o = other(second, first, y);
        const Number g = dot(o.a, o.a) - o.d * o.d;
        return f_.all({f_.positive(g), f_.positive(o.b), f_.negative(o.b - g), f_.negative(g * power(first, y) - o.b * o.b)});
    }

    ExpressionId between_three(std::size_t first, std::size_t second, std::size_t third) {
        const Place y = difference(p_, balls_[first].centre);
        const Other o = other(second, first, y), q = other(third, first, y);
        const Number oo = dot(o.a, o.a) - o.d * o.d, oq = dot(o.a, q.a) - o.d * q.d, qq = dot(q.a, q.a) - q.d * q.d;
        const Number det = oo * qq - oq * oq, l = qq * o.b - oq * q.b, m = oo * q.b - oq * o.b;
        return f_.all({f_.positive(oo), f_.positive(det), f_.positive(l), f_.positive(m), f_.negative(l + m - det), f_.negative(det * power(first, y) - (o.b * l + q.b * m))});
    }

    static Number cross(const Place& a, const Place& b) { return a[0] * b[1] - a[1] * b[0]; }
    ExpressionId within_triangle(const std::vector<std::size_t>& i) {
        const Place a = difference(balls_[i[1]].centre, balls_[i[0]].centre), b = difference(balls_[i[2]].centre, balls_[i[0]].centre), y = difference(p_, balls_[i[0]].centre);
        const Number area = cross(a, b), l = cross(y, b), m = cross(a, y);
        return f_.all({f_.positive(area * l), f_.positive(area * m), f_.positive(area * (area - l - m))});
    }

    static Number triple(const Place& a, const Place& b, const Place& c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    ExpressionId within_tetrahedron(const std::vector<std::size_t>& i) {
        const Place a = difference(balls_[i[1]].centre, balls_[i[0]].centre), b = difference(balls_[i[2]].centre, balls_[i[0]].centre);
        const Place c = difference(balls_[i[3]].centre, balls_[i[0]].centre), y = difference(p_, balls_[i[0]].centre);
        const Number volume = triple(a, b, c), l = triple(y, b, c), m = triple(a, y, c), n = triple(a, b, y);
        return f_.all({f_.positive(volume * l), f_.positive(volume * m), f_.positive(volume * n), f_.positive(volume * (volume - l - m - n))});
    }

    Formulas& f_;
    const Place p_;
    const std::vector<Round<Number>> balls_;
    std::vector<ExpressionId> parts_;
};

}  // namespace whittle::reference
