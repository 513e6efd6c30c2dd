// round_rows.h — an octant of the unit ball as rows of triangles, as few as the tolerance lets be.
//
// A triangle with its corners on a ball of radius r and a circumscribed circle of radius R is R^2/2r away from it at most, so equilateral ones cover the most:
// 4.84 r/e of them would be the whole ball within e. Rows of nearly such, each with its corners over the middles of the row below; towards the pole a row has fewer now
// and then. 5.4 r/e come of it. Rings with counts of their own, one not knowing the other, took 7.9 r/e; equal longitudes take 12.
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/mesh/curve_rule.h"

namespace whittle {

// Points at one latitude, from longitude 0 (share 0) to a quarter of a turn (share 1), both always among them; one at the pole.
struct RoundRow {
    double cosine = 1, sine = 0;  // of the latitude
    std::vector<double> along;
};

// From the equator to the pole, for a ball of radius r; rows and points are at most 45 degrees apart.
std::vector<RoundRow> round_rows(double r, const CurveRule& rule);

// Stands: on points below, below + 1 of the lower row with its tip at `above`; else hangs from above, above + 1 with its tip at `below`.
struct RowTriangle {
    std::uint32_t below = 0, above = 0;
    bool stands = true;
};
std::vector<RowTriangle> triangles_between(const RoundRow& lower, const RoundRow& upper);

}  // namespace whittle
