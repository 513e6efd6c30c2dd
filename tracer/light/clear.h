// clear.h — where a ray of light goes at the border of clear matter: reflected or refracted, sharp or rough, at one wavelength or all.
//
// Shared by everyone who walks through clear matter one direction at a time: paths from the eye, paths from the lamps, and rough glass in Whitted's tree.
#pragma once

#include "tracer/light/sampler.h"
#include "tracer/light/spectrum.h"
#include "tracer/light/stage.h"

namespace whittle {

struct Crossing {
    Vec3 direction{0};
    bool through = false;
    double radiance_scale = 1;  // (index before / index behind)^2 where it went through: radiance is less in the rarer matter
};

// Numbers a crossing needs.
struct CrossingDraws {
    Vec2 lobe{0};
    double choice = 0;      // in [0, 1)
    double wavelength = 0;  // in [0, 1); read where the border is the path's first that disperses
};

// Nothing where the ray is lost. `direction` travels towards the border; `hues` begin here where they must.
std::optional<Crossing> cross_border(const Stage& stage, const Border& border, Vec3 direction, const CrossingDraws& draws, Hues& hues);

// Index before over index behind, at `nm` (0: the line d).
double eta_at(const Border& border, double nm);
bool disperses(const Border& border);

}  // namespace whittle
