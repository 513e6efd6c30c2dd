// planes.h — what the ray through a pixel's centre meets, for the planes of a film and --xray.
#pragma once

#include "tracer/light/stage.h"

namespace whittle {

struct PixelPlace {
    int x = 0, y = 0;
};

// Fills the planes that belong to the pixels' centre rays. Where nothing is met: depth is infinite, ids are 0, the rest is 0.
// solid and surface are 1 + the engine's numbers; cost and variance are not of the centre ray and are left alone.
void fill_planes(const Stage& stage, const PixelPlace* pixels, int count, Scratch& scratch, Film& film);

// The ray through place (px, py) of the picture in pixels, and the place's height (-1..1).
Ray picture_ray(const Stage& stage, double px, double py);
double picture_height(const Stage& stage, double py);

// Length of the solid along the ray, in mm.
double thickness_along(const Stage& stage, const Ray& ray, Scratch& scratch, Spans& spans);

}  // namespace whittle
