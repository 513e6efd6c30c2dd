// roof_module.h — the door of the module's roofs; nothing outside modeler/mesh includes this.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/solid.h"

// Appends the slopes over the floor (outer rings counter-clockwise, holes clockwise, none crossing), facet by facet, counter-clockwise seen from above;
// each facet has points of its own, equal ones bit for bit. False with a reason where it cannot.
extern "C" bool whittle_cgal_roof(const std::vector<std::vector<whittle::Vec2>>& floor, whittle::FacetList& out, std::string& fault);
