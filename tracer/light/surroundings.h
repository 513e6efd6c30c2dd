// surroundings.h — what rays see that meet nothing: black, a constant environment, a picture, or the neutral studio; and the studio's lamps.
//
// The studio goes with the camera: a key lamp from the upper left in front, a weak fill from the right that casts no shadow, a soft sky from above
// and a little light from the floor. A white matte surface that faces the key is white. Its backdrop is a soft gradient over the height of the picture.
#pragma once

#include <vector>

#include "csg/base/vec.h"
#include "tracer/light/camera.h"
#include "tracer/light/lights.h"

namespace whittle {

class Surroundings {
public:
    static Surroundings black() { return {}; }
    static Surroundings constant(Vec3 radiance);
    static Surroundings picture(std::shared_ptr<const EnvironmentMap> map);
    static Surroundings studio(const Lens& lens);

    // Seen in a mirror or through glass along the unit direction.
    Vec3 radiance(Vec3 direction) const;
    // Behind everything, at height y (-1..1) of the picture.
    Vec3 backdrop(Vec3 direction, double y) const;
    // Irradiance / pi on a surface with this normal, were nothing in the way.
    Vec3 sky(Vec3 normal) const;
    bool dark() const { return kind_ == Kind::kBlack; }
    bool is_studio() const { return kind_ == Kind::kStudio; }
    // The picture; null: there is none.
    const EnvironmentMap* map() const { return map_.get(); }

private:
    enum class Kind { kBlack, kConstant, kPicture, kStudio };
    Vec3 gradient(double y) const;

    Kind kind_ = Kind::kBlack;
    Vec3 constant_{0};
    std::shared_ptr<const EnvironmentMap> map_;
    Vec3 forward_{0}, up_{0}, key_{0};
    double half_height_ = 1;
    bool orthographic_ = false;
};

// Key and fill.
std::vector<LightSource> studio_lamps(const Lens& lens);

}  // namespace whittle
