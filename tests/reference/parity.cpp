// parity.cpp — see parity.h.
#include "tests/reference/parity.h"

#include "csg/span/perturbation.h"

namespace whittle::reference {

namespace {

Triple exact(const Vec3& v) { return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)}; }

// On which side of the line the ray passes; 0 only where they are parallel.
int side(const Line& line, const Triple& origin, const Triple& direction) {
    const Triple moment = cross(direction, line.direction);  // det(d, e, o - p) = (d x e) . (o - p)
    if (const int s = dot(moment, minus(origin, line.point)).sign(); s != 0) return s;
    for (const Vec3& v : kPerturbation)
        if (const int s = dot(moment, exact(v)).sign(); s != 0) return s;
    return 0;
}

bool passes(const Facet& facet, const Triple& origin, const Triple& direction) {
    if (dot(facet.normal, direction).is_zero()) return false;
    int first = 0;
    for (const Line& line : facet.lines) {
        const int s = side(line, origin, direction);
        if (first == 0) first = s;
        if (s != first) return false;
    }
    return true;
}

// Side of the plane that the nudged point is on.
int side_of_plane(const Facet& facet, const Triple& point) {
    if (const int s = dot(facet.normal, minus(point, facet.lines[0].point)).sign(); s != 0) return s;
    for (const Vec3& v : kPerturbation)
        if (const int s = dot(facet.normal, exact(v)).sign(); s != 0) return s;
    return 0;
}

}  // namespace

Triple cross(const Triple& a, const Triple& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
Dyadic dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

std::vector<std::size_t> passed(const std::vector<Facet>& facets, const Ray& ray) {
    const Triple origin = exact(ray.origin), direction = exact(ray.direction);
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < facets.size(); ++i)
        if (passes(facets[i], origin, direction)) result.push_back(i);
    return result;
}

bool is_near(const Facet& facet, const Triple& along, const Ray& ray, const Dyadic& t) {
    // Everything times |along|^2, where that is not 0, to stay without a division.
    const Dyadic along2 = dot(along, along);
    const auto seen = [&](const Triple& v) {
        if (along2.is_zero()) return v;
        const Dyadic part = dot(v, along);
        return Triple{v[0] * along2 - along[0] * part, v[1] * along2 - along[1] * part, v[2] * along2 - along[2] * part};
    };
    Triple lo = seen(facet.lines[0].point), hi = lo;
    Dyadic size;
    for (std::size_t i = 0; i < 3; ++i) {
        for (const Line& line : facet.lines) {
            const Dyadic x = seen(line.point)[i];
            if (x < lo[i]) lo[i] = x;
            if (hi[i] < x) hi[i] = x;
        }
        if (size < hi[i] - lo[i]) size = hi[i] - lo[i];
    }
    const Triple origin = seen(exact(ray.origin)), direction = seen(exact(ray.direction));
    const Dyadic room = Dyadic(kFacetReach) * size;
    for (std::size_t i = 0; i < 3; ++i) {
        const Dyadic at = origin[i] + t * direction[i];
        if (at < lo[i] - room || hi[i] + room < at) return false;
    }
    return true;
}

bool is_along(const Faceted& solid, const Ray& ray) {
    const bool prism = !dot(solid.along, solid.along).is_zero();
    const Triple c = cross(solid.along, exact(ray.direction));
    return prism && dot(c, c).is_zero();
}

bool holds_along(const Faceted& solid, const Ray& ray) {
    const Triple origin = exact(ray.origin);
    bool odd = false;
    for (const Facet& f : solid.facets)
        if (passes(f, origin, solid.across) && side_of_plane(f, origin) * dot(f.normal, solid.across).sign() < 0) odd = !odd;
    return odd;
}

}  // namespace whittle::reference
