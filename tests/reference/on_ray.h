// on_ray.h — supports on a ray: the polynomial in t that each becomes, nudged symbolically where it would vanish (csg/span/perturbation.h).
#pragma once

#include <map>

#include "csg/span/ray.h"
#include "tests/reference/form.h"
#include "tests/reference/polynomial.h"

namespace whittle::reference {

class OnRay {
public:
    explicit OnRay(const Ray& ray);
    // The support along o + t d; where that is identically 0, the lowest power of eps that is not, along o + eps v1 + eps^2 v2 + eps^3 v3 + t d.
    Polynomial along(const Form& support);
    // The same with a root at t = 0 made exact: the constant of the first is left out.
    Polynomial leaving(const Form& support);

private:
    Polynomial unnudged(const Form& support);
    Polynomial lowest_nudged(const Form& support);
    using Series = std::vector<Polynomial>;  // by power of eps

    const Polynomial& straight(const Monomial& m);
    const Series& nudged(const Monomial& m);

    std::array<Polynomial, 3> coordinate_;
    std::array<Series, 3> nudged_coordinate_;
    std::map<Monomial, Polynomial> straight_;
    std::map<Monomial, Series> nudged_;
};

}  // namespace whittle::reference
