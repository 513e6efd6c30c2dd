// emission.h — rays of light that leave the lamps towards what may focus them.
//
// Only light that first meets a mirror or clear matter is of use to photons, so lamps shine at a ball around all of that. Power is flux: of n rays each
// brings 1/n of what emit() says.
#pragma once

#include <vector>

#include "csg/base/vec.h"
#include "csg/span/ray.h"
#include "tracer/light/lights.h"

namespace whittle {

struct Emitted {
    Vec3 origin{0}, direction{0, 0, 1};
    Vec3 power{0};  // zero: nothing leaves that way
};

class Emission {
public:
    Emission() = default;
    // Suns shine from beyond `everything`. Environments are left out: paths from the eye find them.
    Emission(std::vector<LightSource> lamps, const Bounds& aim, const Bounds& everything);

    // False: no lamp sends anything there.
    bool shines() const { return !chances_.empty() && chances_.back() > 0; }
    Emitted emit(double lamp, Vec2 place, Vec2 direction) const;
    // Radius of the ball aimed at.
    double reach() const { return radius_; }

private:
    double estimated_flux(const LightSource& lamp) const;
    Emitted from_point(const LightSource& lamp, Vec2 direction) const;
    Emitted from_area(const LightSource& lamp, Vec3 origin, Vec3 normal, Vec2 direction) const;
    Emitted from_sun(const LightSource& lamp, Vec2 place, Vec2 direction) const;

    std::vector<LightSource> lamps_;
    std::vector<double> chances_;  // cumulative
    Vec3 centre_{0};
    double radius_ = 0;
    double far_ = 0;  // from the centre to where nothing is
};

}  // namespace whittle
