#include "tracer/light/surroundings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracer/light/scattering.h"

namespace whittle {

namespace {

// The studio, in units of white. Chosen on the gallery: the three faces of a cube in OpenSCAD's default view stand clearly apart and
// none is clipped; key + sky on a surface that faces the key is 1.
constexpr Vec3 kKeyInView{-0.60, 0.55, 0.75}, kFillInView{0.85, 0.10, 0.50};
constexpr Vec3 kKey{0.72, 0.71, 0.69}, kFill{0.10, 0.105, 0.115};
constexpr Vec3 kSkyAbove{0.34, 0.35, 0.37}, kFloorBelow{0.17, 0.165, 0.16};
constexpr double kKeyDiscDeg = 5;

// What mirrors see: floor, horizon, zenith, the key's soft box.
constexpr Vec3 kMirrorFloor{0.16, 0.15, 0.14}, kMirrorHorizon{0.95, 0.96, 1.0}, kMirrorZenith{0.42, 0.46, 0.54};
constexpr double kBoxRadiance = 3.2, kBoxOuterCos = 0.88, kBoxInnerCos = 0.93;

// Backdrop at the top and the bottom of the picture.
constexpr Vec3 kBackdropTop{0.90, 0.92, 0.95}, kBackdropBottom{0.50, 0.53, 0.58};

double smooth(double lo, double hi, double x) {
    const double t = std::clamp((x - lo) / (hi - lo), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Vec3 in_world(const Lens& lens, Vec3 in_view) { return glm::normalize(in_view.x * lens.right + in_view.y * lens.up - in_view.z * lens.forward); }

}  // namespace

Surroundings Surroundings::constant(Vec3 radiance) {
    Surroundings s;
    s.kind_ = radiance == Vec3(0) ? Kind::kBlack : Kind::kConstant;
    s.constant_ = radiance;
    return s;
}

Surroundings Surroundings::picture(std::shared_ptr<const EnvironmentMap> map) {
    Surroundings s;
    s.kind_ = map->dark() ? Kind::kBlack : Kind::kPicture;
    if (!map->dark()) s.map_ = std::move(map);
    return s;
}

Surroundings Surroundings::studio(const Lens& lens) {
    Surroundings s;
    s.kind_ = Kind::kStudio;
    s.forward_ = lens.forward;
    s.up_ = lens.up;
    s.key_ = in_world(lens, kKeyInView);
    s.half_height_ = lens.half_height;
    s.orthographic_ = lens.orthographic;
    return s;
}

Vec3 Surroundings::gradient(double y) const { return glm::mix(kBackdropBottom, kBackdropTop, smooth(-1.3, 1.3, y)); }

Vec3 Surroundings::radiance(Vec3 d) const {
    if (kind_ == Kind::kPicture) return map_->radiance(d);
    if (kind_ != Kind::kStudio) return constant_;
    const Vec3 sky = glm::mix(kMirrorHorizon, kMirrorZenith, smooth(0.0, 0.8, d.z));
    const Vec3 room = glm::mix(kMirrorFloor, sky, smooth(-0.12, 0.06, d.z)) + kKey * (kBoxRadiance * smooth(kBoxOuterCos, kBoxInnerCos, glm::dot(d, key_)));
    const double ahead = glm::dot(d, forward_);
    if (ahead <= 0.3) return room;
    const double y = orthographic_ ? 0 : glm::dot(d, up_) / (ahead * half_height_);
    return glm::mix(room, gradient(y), smooth(0.3, 0.8, ahead));
}

Vec3 Surroundings::backdrop(Vec3 direction, double y) const { return kind_ == Kind::kStudio ? gradient(y) : radiance(direction); }

Vec3 Surroundings::sky(Vec3 normal) const {
    if (kind_ == Kind::kPicture) return map_->smooth(normal);
    if (kind_ != Kind::kStudio) return constant_;
    return glm::mix(kFloorBelow, kSkyAbove, 0.5 + 0.5 * normal.z);
}

std::vector<LightSource> studio_lamps(const Lens& lens) {
    SunLight key;
    key.direction = -in_world(lens, kKeyInView);
    key.angle_deg = kKeyDiscDeg;
    SunLight fill;
    fill.direction = -in_world(lens, kFillInView);
    std::vector<LightSource> lamps{resolve_light(key), resolve_light(fill)};
    lamps[0].emitted = kKey * kPi;
    lamps[1].emitted = kFill * kPi;
    lamps[1].casts_shadow = false;
    return lamps;
}

}  // namespace whittle
