// environment.h — light from a picture of the surroundings, all around and far away.
//
// The picture is a latitude-longitude one: its middle lies in the direction +y, its right quarter at +x, its top at +z (rotate= turns that). Between pixels
// the radiance is interpolated; directions are drawn from the brightest of each pixel and its neighbours, so no light has no chance.
#pragma once

#include <memory>
#include <vector>

#include "csg/base/vec.h"
#include "tracer/image/image_file.h"

namespace whittle {

class EnvironmentMap {
public:
    // Of an image with at least a pixel, linear Rec.709 in its first three channels (grey: one). What is no number or negative is no light, what is infinite
    // the largest light there is; `mended` counts such pixels.
    EnvironmentMap(const Image& image, Vec3 tint, Vec3 rotate_deg, std::size_t& mended);

    Vec3 radiance(Vec3 direction) const;
    // Irradiance / pi on a surface with this normal, were nothing in the way: nine spherical harmonics, a few percent off. Source: Ramamoorthi and
    // Hanrahan, An Efficient Representation for Irradiance Environment Maps (2001).
    Vec3 smooth(Vec3 normal) const;
    // Radiance, mean over all directions.
    Vec3 mean() const;
    bool dark() const { return !(total_ > 0); }

    struct Drawn {
        Vec3 direction{0};
        double density = 0;  // over solid angle
    };
    Drawn draw(Vec2 u) const;
    double density(Vec3 direction) const;

private:
    Vec3 pixel(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)]; }
    void read(const Image& image, Vec3 tint, std::size_t& mended);
    void make_chances();
    void project();
    // Place in the picture, 0..1 each; and back.
    Vec2 place_of(Vec3 direction) const;
    Vec3 direction_of(Vec2 place) const;

    int width_ = 0, height_ = 0;
    std::vector<Vec3> pixels_;
    std::vector<double> rows_, cells_;  // cumulative; cells row by row, each row from 0 to 1
    double total_ = 0;
    std::array<Vec3, 9> harmonics_{};
    Vec3 x_{1, 0, 0}, y_{0, 1, 0}, z_{0, 0, 1};  // the picture's axes in the world
};

}  // namespace whittle
