// on_ray.cpp — see on_ray.h.
#include "tests/reference/on_ray.h"

#include "csg/span/perturbation.h"

namespace whittle::reference {

OnRay::OnRay(const Ray& ray) {
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        coordinate_[at] = Polynomial({ray.origin[i], ray.direction[i]});
        nudged_coordinate_[at] = {coordinate_[at]};
        for (const Vec3& v : kPerturbation) nudged_coordinate_[at].push_back(Polynomial({v[i]}));
    }
    const Polynomial one({Dyadic(1.0)});
    straight_[{0, 0, 0}] = one;
    nudged_[{0, 0, 0}] = {one};
}

const Polynomial& OnRay::straight(const Monomial& m) {
    if (const auto at = straight_.find(m); at != straight_.end()) return at->second;
    Monomial smaller = m;
    const std::size_t axis = m[0] > 0 ? 0 : m[1] > 0 ? 1 : 2;
    --smaller[axis];
    return straight_[m] = straight(smaller) * coordinate_[axis];
}

const OnRay::Series& OnRay::nudged(const Monomial& m) {
    if (const auto at = nudged_.find(m); at != nudged_.end()) return at->second;
    Monomial smaller = m;
    const std::size_t axis = m[0] > 0 ? 0 : m[1] > 0 ? 1 : 2;
    --smaller[axis];
    const Series a = nudged(smaller), &b = nudged_coordinate_[axis];
    Series product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] = product[i + j] + a[i] * b[j];
    return nudged_[m] = std::move(product);
}

Polynomial OnRay::unnudged(const Form& support) {
    Polynomial sum;
    for (const auto& [m, c] : support.terms()) sum = sum + c * straight(m);
    return sum;
}

Polynomial OnRay::lowest_nudged(const Form& support) {
    Series series;
    for (const auto& [m, c] : support.terms()) {
        const Series& s = nudged(m);
        if (series.size() < s.size()) series.resize(s.size());
        for (std::size_t i = 0; i < s.size(); ++i) series[i] = series[i] + c * s[i];
    }
    for (std::size_t i = 1; i < series.size(); ++i)
        if (!series[i].is_zero()) return series[i];
    return {};
}

Polynomial OnRay::along(const Form& support) {
    const Polynomial p = unnudged(support);
    return p.is_zero() ? lowest_nudged(support) : p;
}

Polynomial OnRay::leaving(const Form& support) {
    const Polynomial p = unnudged(support);
    const Polynomial rest = p.is_zero() ? p : p + Polynomial({-p[0]});
    return rest.is_zero() ? lowest_nudged(support) : rest;
}

}  // namespace whittle::reference
