// nudged.h — polynomials in the infinitesimal of the perturbation: the ring in which a degenerate ray becomes a generic one.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "csg/span/perturbation.h"
#include "csg/span/ray.h"
#include "tracer/engine/dyadic.h"
#include "tracer/engine/mutation.h"

namespace whittle::exact {

// A polynomial in the infinitesimal of the perturbation: enough of a ring for support_polynomial.
class Nudged {
public:
    Nudged() = default;
    Nudged(double v) { c_.emplace_back(v); }  // NOLINT: exact
    explicit Nudged(std::vector<Dyadic> c) : c_(std::move(c)) {}

    Dyadic at(std::size_t power) const { return power < c_.size() ? c_[power] : Dyadic(); }
    std::size_t size() const { return c_.size(); }
    // Sign of the lowest power that does not vanish.
    int sign() const {
        for (const Dyadic& c : c_)
            if (!c.is_zero()) return c.sign();
        return 0;
    }

    Nudged operator-() const {
        Nudged r = *this;
        for (Dyadic& c : r.c_) c = -c;
        return r;
    }
    friend Nudged operator+(const Nudged& a, const Nudged& b) {
        Nudged r;
        for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) r.c_.push_back(a.at(i) + b.at(i));
        return r;
    }
    friend Nudged operator-(const Nudged& a, const Nudged& b) { return a + (-b); }
    friend Nudged operator*(const Nudged& a, const Nudged& b) {
        Nudged r;
        if (a.size() == 0 || b.size() == 0) return r;
        r.c_.resize(a.size() + b.size() - 1);
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t j = 0; j < b.size(); ++j) r.c_[i + j] = r.c_[i + j] + a.c_[i] * b.c_[j];
        return r;
    }

private:
    std::vector<Dyadic> c_;
};

// The ray's origin, nudged (csg/span/perturbation.h).
inline std::array<Nudged, 3> nudged_origin(const Ray& ray) {
    std::array<Nudged, 3> origin;
    const double way = mutated(Mutation::kReversedRule) ? -1 : 1;
    for (int i = 0; i < 3; ++i)
        origin[static_cast<std::size_t>(i)] =
            Nudged({Dyadic(ray.origin[i]), Dyadic(way * kPerturbation[0][i]), Dyadic(way * kPerturbation[1][i]), Dyadic(way * kPerturbation[2][i])});
    return origin;
}

}  // namespace whittle::exact
