// splats.h — light drawn from the lamps onto the picture, found again by pixel.
//
// A place keeps its light as it is; a pixel weighs those within its filter by f over the integral of |f|, which is what samples of the pixel weigh in the
// mean. So neighbouring pixels share a place and none is drawn by lot. Source: Veach (1997), 10.3.4 (light tracing onto the film).
#pragma once

#include <vector>

#include "csg/base/vec.h"
#include "tracer/image/filter.h"

namespace whittle {

// Light that one ray from a lamp draws at a place of the picture, in pixels from its upper left corner, over the area of a pixel.
struct Splat {
    Vec2 at{0};
    Vec3 light{0};
};

// The filter of a picture, as places drawn on it see it.
class SplatFilter {
public:
    // `alone`: the picture has one sample a pixel, which shows what lies inside of the pixel.
    SplatFilter(FilterKind kind, bool alone);
    // Pixels further than this from a place, along an axis, see nothing of it.
    double radius() const { return radius_; }
    // What a place `off` pixels from the centre weighs along an axis; its integral is that of the filter over that of |filter|.
    double weight(double off) const;

private:
    FilterKind kind_;
    bool alone_;
    double radius_, scale_;
};

class Splats {
public:
    Splats(const SplatFilter& filter, int width, int height) : filter_(filter), width_(width), height_(height) {}
    // Does some pixel see a place there?
    bool shows(Vec2 at) const;
    // All that is to be found, in an order that does not depend on threads. Requires: shows() of each.
    void take(std::vector<Splat> splats);
    // What pixel (x, y) gets, weighed by the filter.
    Vec3 on_pixel(int x, int y) const;

private:
    int row_of(const Splat& s) const;

    SplatFilter filter_;
    int width_, height_;
    std::vector<Splat> splats_;        // by row, then by column
    std::vector<std::size_t> begins_;  // of rows, from the first that a filter reaches
};

}  // namespace whittle
