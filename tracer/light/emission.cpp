#include "tracer/light/emission.h"

#include <algorithm>
#include <cmath>

#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

double length2(Vec3 v) { return glm::dot(v, v); }

// 1 - cos of the cap under which a ball is seen from outside; 2 from inside.
double cap_towards(double radius, double distance2) {
    const double sin2 = radius * radius / distance2;
    return sin2 < 1 ? sin2 / (1 + std::sqrt(1 - sin2)) : 2;
}

}  // namespace

Emission::Emission(const std::vector<LightSource>& lamps, std::vector<Aim> aims, const Bounds& everything) : aims_(std::move(aims)) {
    middle_ = everything.lo + 0.5 * (everything.hi - everything.lo);
    far_ = std::sqrt(length2(everything.hi - everything.lo));
    if (everything.empty() || !std::isfinite(far_)) return;
    double sum = 0;
    for (const LightSource& lamp : lamps) {
        lamps_.push_back(lamp);
        for (std::size_t aim = 0; aim < aims_.size(); ++aim) {
            const double flux = estimated_flux(lamp, aims_[aim]);
            if (!(flux > 0) || !std::isfinite(flux)) continue;
            sum += flux;
            choices_.push_back({lamps_.size() - 1, aim, sum, flux});
        }
    }
    if (!std::isfinite(sum)) choices_.clear();
    for (Choice& c : choices_) {
        c.below /= sum;
        c.chance /= sum;
    }
}

double Emission::reach() const {
    double most = 0;
    for (const Aim& aim : aims_) most = std::max(most, aim.radius);
    return most;
}

double Emission::estimated_flux(const LightSource& lamp, const Aim& aim) const {
    const double disc = kPi * aim.radius * aim.radius;
    if (lamp.kind == LightKind::kEnvironment) return luminance(lamp.map->mean()) * 4 * kPi * disc;
    const double bright = luminance(lamp.emitted);
    if (lamp.kind == LightKind::kSun) return bright * disc;
    const Vec3 middle = lamp.kind == LightKind::kParallelogram ? lamp.p + 0.5 * (lamp.u + lamp.v) : lamp.p;
    return bright * 2 * kPi * cap_towards(aim.radius, length2(aim.centre - middle)) * (lamp.kind == LightKind::kPoint ? 1 : lamp.area);
}

Emitted Emission::emit(double u, Vec2 place, Vec2 direction) const {
    const Choice& choice = *std::upper_bound(choices_.begin(), choices_.end() - 1, u, [](double x, const Choice& c) { return x < c.below; });
    const LightSource& lamp = lamps_[choice.lamp];
    switch (lamp.kind) {
        case LightKind::kPoint: return towards(choice, lamp.p, lamp.emitted, direction);
        case LightKind::kSphere:
        case LightKind::kParallelogram: return from_area(choice, place, direction);
        case LightKind::kSun:
        case LightKind::kEnvironment: break;
    }
    return from_afar(choice, place, direction);
}

double Emission::density_of_direction(std::size_t lamp, Vec3 from, Vec3 direction) const {
    double sum = 0;
    for (const Choice& c : choices_) {
        if (c.lamp != lamp) continue;
        const Aim& aim = aims_[c.aim];
        const Vec3 to = aim.centre - from;
        const double d2 = length2(to), cap = d2 > 0 ? cap_towards(aim.radius, d2) : 2, along = glm::dot(to, direction);
        if (cap >= 2 || (along > 0 && d2 - along * along <= aim.radius * aim.radius)) sum += c.chance / (2 * kPi * cap);
    }
    return sum;
}

double Emission::density_of_line(std::size_t lamp, Vec3 through, Vec3 direction) const {
    double sum = 0;
    for (const Choice& c : choices_) {
        if (c.lamp != lamp) continue;
        const Aim& aim = aims_[c.aim];
        const Vec3 to = aim.centre - through;
        const double along = glm::dot(to, direction);
        if (length2(to) - along * along <= aim.radius * aim.radius) sum += c.chance / (kPi * aim.radius * aim.radius);
    }
    return sum;
}

// A direction on the rim may miss every ball by rounding: the density of its own is what was meant.
Emitted Emission::towards(const Choice& choice, Vec3 origin, Vec3 intensity, Vec2 u) const {
    const Aim& aim = aims_[choice.aim];
    const Vec3 to = aim.centre - origin;
    const double d2 = length2(to), cap = d2 > 0 ? cap_towards(aim.radius, d2) : 2;
    const Vec3 direction = ShadingFrame(d2 > 0 ? to / std::sqrt(d2) : Vec3(0, 0, 1)).to_world(on_cap(u, cap));
    return {origin, direction, intensity / std::max(density_of_direction(choice.lamp, origin, direction), choice.chance / (2 * kPi * cap))};
}

// A parallelogram shines from both sides, a ball from its outside.
Emitted Emission::from_area(const Choice& choice, Vec2 place, Vec2 u) const {
    const LightSource& lamp = lamps_[choice.lamp];
    const bool flat = lamp.kind == LightKind::kParallelogram;
    const Vec3 normal = flat ? lamp.normal : on_cap(place, 2);
    Emitted e = towards(choice, flat ? lamp.p + place.x * lamp.u + place.y * lamp.v : lamp.p + lamp.radius * normal, lamp.emitted * lamp.area, u);
    const double cosine = glm::dot(e.direction, normal);
    e.power *= flat ? std::abs(cosine) : std::max(0.0, cosine);
    return e;
}

Emitted Emission::from_afar(const Choice& choice, Vec2 place, Vec2 u) const {
    const LightSource& lamp = lamps_[choice.lamp];
    Vec3 towards = lamp.p, irradiance = lamp.emitted;
    if (lamp.kind == LightKind::kEnvironment) {
        const EnvironmentMap::Drawn drawn = lamp.map->draw(u);
        if (!(drawn.density > 0)) return {};
        towards = drawn.direction;
        irradiance = lamp.map->radiance(towards) / drawn.density;
    } else if (lamp.one_minus_cos > 0) {
        towards = ShadingFrame(lamp.p).to_world(on_cap(u, lamp.one_minus_cos));
        // Irradiance is that of a surface facing the disc's middle: the mean cosine over the cap is 1 - h/2.
        irradiance /= 1 - lamp.one_minus_cos / 2;
    }
    const Aim& aim = aims_[choice.aim];
    const Vec2 disc = on_disc(place);
    const ShadingFrame frame(towards);
    const Vec3 through = aim.centre + aim.radius * (disc.x * frame.x + disc.y * frame.y);
    const double density = std::max(density_of_line(choice.lamp, through, towards), choice.chance / (kPi * aim.radius * aim.radius));
    // From beyond everything: the plane behind which nothing is.
    const double lift = far_ + glm::dot(middle_ - through, towards);
    return {through + lift * towards, -towards, irradiance / density};
}

}  // namespace whittle
