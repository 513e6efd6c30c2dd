// chord_sums.cpp — a chord from a to b with middle c adds l to the volume, l c to the first and l (c c^T + l^2/12 d d^T) to the second moments.
#include "modeler/check/chord_sums.h"

#include <cmath>

namespace whittle {

ChordSums& ChordSums::operator+=(const ChordSums& o) {
    volume += o.volume;
    first += o.first;
    for (std::size_t i = 0; i < second.size(); ++i) second[i] += o.second[i];
    area += o.area;
    slack += o.slack;
    unbounded = unbounded || o.unbounded;
    return *this;
}

ChordSums ChordSums::scaled(double factor) const {
    ChordSums r = *this;
    r.volume *= factor;
    r.first *= factor;
    for (double& s : r.second) s *= factor;
    r.area *= factor;
    r.slack *= factor;
    return r;
}

void add_chords(ChordSums& sums, const Ray& ray, const Spans& spans, Vec3 origin) {
    const double length_per_t = glm::length(ray.direction);
    const Vec3 d = ray.direction / length_per_t;
    for (const Span& span : spans) {
        if (!span.in || !span.out) {
            sums.unbounded = true;
            return;
        }
        const double l = (span.out->t - span.in->t) * length_per_t;
        const Vec3 c = ray.origin - origin + ray.direction * (span.in->t + (span.out->t - span.in->t) / 2);
        const double w = l * l / 12;
        sums.volume += l;
        sums.first += l * c;
        const std::array<double, 6> products{c.x * c.x + w * d.x * d.x, c.y * c.y + w * d.y * d.y, c.z * c.z + w * d.z * d.z,
                                             c.x * c.y + w * d.x * d.y, c.x * c.z + w * d.x * d.z, c.y * c.z + w * d.y * d.z};
        for (std::size_t i = 0; i < products.size(); ++i) sums.second[i] += l * products[i];
        sums.area += std::fabs(glm::dot(span.in->normal, d)) + std::fabs(glm::dot(span.out->normal, d));
        sums.slack += (span.in->t_error + span.out->t_error) * length_per_t;
    }
}

}  // namespace whittle
