// profile_line.h — where a straight line runs inside a 2D shape, in closed form.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// The points o + s d. `up`: across d, to the side whose neighbourhood counts where the line runs along a straight side.
struct ProfileLine {
    Vec2 o, d, up;
};

// Of s, ascending, apart.
using LineIntervals = std::vector<std::pair<double, double>>;

// What `made` makes of the line's intervals in each shape of the profile, under the profile's set operations. That is right where making commutes with them, as
// sweeping intervals across the line and turning them about a point do. Nothing where a shape is no 2D one, or moves, or nothing is made of one. Ends are in
// double, a few roundings off.
std::optional<Use> made_of_intervals(SolidBuilder& builder, const Use& profile, const ProfileLine& line, const std::function<std::optional<Use>(const LineIntervals&)>& made);

}  // namespace whittle
