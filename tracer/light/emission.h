// emission.h — rays of light that leave the lamps towards what may focus them.
//
// Only light that first meets a mirror or clear matter is of use to photons, so lamps shine at balls around such things (aims.h). A ray is weighed by the
// density with which all balls together would have sent it, so balls may overlap. Power is flux: of n rays each brings 1/n of what emit() says.
// Source: Veach (1997), 9.2 (the balance heuristic as one density).
#pragma once

#include <vector>

#include "csg/base/vec.h"
#include "csg/span/ray.h"
#include "tracer/light/aims.h"
#include "tracer/light/lights.h"

namespace whittle {

struct Emitted {
    Vec3 origin{0}, direction{0, 0, 1};
    Vec3 power{0};  // zero: nothing leaves that way
};

class Emission {
public:
    Emission() = default;
    // Suns and pictures of surroundings shine from beyond `everything`.
    Emission(const std::vector<LightSource>& lamps, std::vector<Aim> aims, const Bounds& everything);

    // False: no lamp sends anything there.
    bool shines() const { return !choices_.empty(); }
    // `choice` picks lamp and ball.
    Emitted emit(double choice, Vec2 place, Vec2 direction) const;
    // Radius of the largest ball.
    double reach() const;

private:
    // A lamp and the ball it shines at.
    struct Choice {
        std::size_t lamp = 0, aim = 0;
        double below = 0;  // the chances of this and all before; of the last 1
        double chance = 0;
    };
    double estimated_flux(const LightSource& lamp, const Aim& aim) const;
    // Density of a direction from a point, or of a line along a direction, over all balls that this lamp shines at.
    double density_of_direction(std::size_t lamp, Vec3 from, Vec3 direction) const;
    double density_of_line(std::size_t lamp, Vec3 through, Vec3 direction) const;
    Emitted towards(const Choice& choice, Vec3 origin, Vec3 intensity, Vec2 direction) const;
    Emitted from_area(const Choice& choice, Vec2 place, Vec2 direction) const;
    Emitted from_afar(const Choice& choice, Vec2 place, Vec2 direction) const;

    std::vector<LightSource> lamps_;
    std::vector<Aim> aims_;
    std::vector<Choice> choices_;  // lamp by lamp
    Vec3 middle_{0};               // of everything
    double far_ = 0;               // from there to where nothing is
};

}  // namespace whittle
