#include "tracer/light/emission.h"

#include <algorithm>
#include <cmath>

#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

// A ball that touches the lamp from outside: its cap is open, not a hemisphere.
constexpr double kMargin = 1 + 1e-9;

double length2(Vec3 v) { return glm::dot(v, v); }

// 1 - cos of the cap under which a ball is seen from outside; 2 from inside.
double cap_towards(double radius, double distance2) {
    const double sin2 = radius * radius / distance2;
    return sin2 < 1 ? sin2 / (1 + std::sqrt(1 - sin2)) : 2;
}

}  // namespace

Emission::Emission(std::vector<LightSource> lamps, const Bounds& aim, const Bounds& everything) {
    const Vec3 diagonal = aim.hi - aim.lo;
    radius_ = 0.5 * std::sqrt(length2(diagonal)) * kMargin;
    if (aim.empty() || !(radius_ > 0) || !std::isfinite(radius_)) return;
    centre_ = aim.lo + 0.5 * diagonal;
    far_ = 2 * radius_ + std::sqrt(length2(0.5 * (everything.lo + everything.hi) - centre_)) + 0.5 * std::sqrt(length2(everything.hi - everything.lo));
    if (!std::isfinite(far_)) return;
    double sum = 0;
    for (LightSource& lamp : lamps) {
        if (lamp.kind == LightKind::kEnvironment) continue;
        const double flux = estimated_flux(lamp);
        if (!(flux > 0) || !std::isfinite(flux)) continue;
        sum += flux;
        lamps_.push_back(std::move(lamp));
        chances_.push_back(sum);
    }
    for (double& chance : chances_) chance /= sum;
}

double Emission::estimated_flux(const LightSource& lamp) const {
    const double bright = luminance(lamp.emitted);
    if (lamp.kind == LightKind::kSun) return bright * kPi * radius_ * radius_;
    const Vec3 middle = lamp.kind == LightKind::kParallelogram ? lamp.p + 0.5 * (lamp.u + lamp.v) : lamp.p;
    const double angle = 2 * kPi * cap_towards(radius_, length2(centre_ - middle));
    return bright * angle * (lamp.kind == LightKind::kPoint ? 1 : lamp.area);
}

Emitted Emission::emit(double u, Vec2 place, Vec2 direction) const {
    const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(std::upper_bound(chances_.begin(), chances_.end(), u) - chances_.begin()), lamps_.size() - 1);
    const double chance = chances_[i] - (i > 0 ? chances_[i - 1] : 0);
    const LightSource& lamp = lamps_[i];
    Emitted e;
    switch (lamp.kind) {
        case LightKind::kPoint: e = from_point(lamp, direction); break;
        case LightKind::kSphere: {
            const Vec3 normal = on_cap(place, 2);
            e = from_area(lamp, lamp.p + lamp.radius * normal, normal, direction);
            break;
        }
        case LightKind::kParallelogram: {
            const Vec3 at = lamp.p + place.x * lamp.u + place.y * lamp.v;
            e = from_area(lamp, at, glm::dot(centre_ - at, lamp.normal) < 0 ? -lamp.normal : lamp.normal, direction);
            break;
        }
        case LightKind::kSun: e = from_sun(lamp, place, direction); break;
        case LightKind::kEnvironment: break;
    }
    e.power /= chance;
    return e;
}

Emitted Emission::from_point(const LightSource& lamp, Vec2 u) const {
    const Vec3 to = centre_ - lamp.p;
    const double d2 = length2(to), cap = d2 > 0 ? cap_towards(radius_, d2) : 2;
    const Vec3 axis = d2 > 0 ? to / std::sqrt(d2) : Vec3(0, 0, 1);
    return {lamp.p, Frame(axis).to_world(on_cap(u, cap)), lamp.emitted * (2 * kPi * cap)};
}

// Where the ball lies on both sides of the lamp's plane, a parallelogram shines from both.
Emitted Emission::from_area(const LightSource& lamp, Vec3 origin, Vec3 normal, Vec2 u) const {
    const Vec3 to = centre_ - origin;
    const double d2 = length2(to), cap = d2 > 0 ? cap_towards(radius_, d2) : 2;
    const Vec3 direction = Frame(d2 > 0 ? to / std::sqrt(d2) : normal).to_world(on_cap(u, cap));
    const double cosine = glm::dot(direction, normal);
    const double leaves = lamp.kind == LightKind::kParallelogram ? std::abs(cosine) : std::max(0.0, cosine);
    return {origin, direction, lamp.emitted * (leaves * lamp.area * 2 * kPi * cap)};
}

Emitted Emission::from_sun(const LightSource& lamp, Vec2 place, Vec2 u) const {
    const Vec3 towards = lamp.one_minus_cos > 0 ? Frame(lamp.p).to_world(on_cap(u, lamp.one_minus_cos)) : lamp.p;
    const Vec2 disc = on_disc(place);
    const Frame frame(towards);
    const Vec3 origin = centre_ + far_ * towards + radius_ * (disc.x * frame.x + disc.y * frame.y);
    // Irradiance is that of a surface facing the disc's middle: the mean cosine over the cap is 1 - h/2.
    return {origin, -towards, lamp.emitted * (kPi * radius_ * radius_ / (1 - lamp.one_minus_cos / 2))};
}

}  // namespace whittle
