// use.h — solids written by hand in tests: a node where it is placed.
#pragma once

#include "csg/base/degrees.h"
#include "csg/solid/solid.h"

namespace whittle::support {

inline Use use(NodeId node, const Placement& placement = {}) {
    Use u;
    u.node = node;
    u.placement = placement;
    return u;
}

inline Placement moved(double x, double y, double z) { return Placement::translation({x, y, z}); }
inline Placement turned_about_z(double deg) { return {{cosd(deg), -sind(deg), 0, 0, sind(deg), cosd(deg), 0, 0, 0, 0, 1, 0}}; }

}  // namespace whittle::support
