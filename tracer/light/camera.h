// camera.h — where the eye stands: OpenSCAD's cameras, the scene's camera(), framing; and the rays through the picture.
//
// OpenSCAD's gimbal camera: eye = t + R (0, 0, d), up = R (0, 1, 0), R = Rz Ry Rx. Framing: d = (|box centre - t| + half diagonal) / sin(fov / 2).
#pragma once

#include <optional>
#include <vector>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/eval/scene.h"
#include "csg/span/ray.h"

namespace whittle {

// The command line's wishes. `numbers` empty: no --camera.
struct CameraSpec {
    std::vector<double> numbers;
    bool viewall = false, autocenter = false;
    std::optional<bool> orthographic;  // --projection
};

// A resolved camera. `right`, `up`, `forward` are orthonormal.
struct Lens {
    Vec3 eye{0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
    bool orthographic = false;
    double half_height = 0.2;  // at distance 1 in perspective, else in mm
    double aperture = 0;       // diameter in mm; of a polygon, of the circle around it
    int blades = 0;            // corners of the aperture; 0: a disc
    double focus = 1;          // distance in mm
    double exposure = 0;       // stops
    double target_distance = 1;
};

// --camera wins over the scene's camera(), that over $vp*, these over framing the whole `bounds`. `aspect` is width / height: the framing
// looks to the narrower side. Empty or infinite bounds count as a unit box at the target.
// kCommand: neither 6 nor 7 numbers, or numbers that are not finite; kScene: a camera without a direction.
Result<Lens> resolve_camera(const CameraSpec& spec, const std::optional<Camera>& scene, const ViewVariables& view, const Bounds& bounds, double aspect);

// The ray through (x, y), both -1..1 over the half height: x to the right (up to the aspect), y up. The direction is a unit vector.
Ray camera_ray(const Lens& lens, double x, double y);
// The same for the place `u` in [0,1)^2 of a thin lens: it meets the pinhole ray in the plane of focus.
Ray camera_ray(const Lens& lens, double x, double y, Vec2 u);

// A point as the place `u` of the lens sees it: where it stands in the picture (as in camera_ray), and how much radiance of one unit of that plane, over
// cosine at the surface, is one unit of flux that leaves the point per solid angle.
struct Sighting {
    Vec3 eye{0};
    double x = 0, y = 0;
    double radiance_per_intensity = 0;
};
// Nothing behind the eye. An orthographic eye stands in the plane of the camera.
std::optional<Sighting> sighting(const Lens& lens, Vec3 point, Vec2 u);

}  // namespace whittle
