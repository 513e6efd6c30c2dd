// turned.h — crossings of a ray with a turned side: the surface that a curve of a profile sweeps while it is turned and scaled on its way up.
//
// On a ray its function is a polynomial in t and in the sine and cosine of an angle linear in t. A double t can be certified: by interval bounds no sign
// change lies elsewhere, and the function's sign differs for certain a little before t and a little behind it. Where nothing turns, an uneven taper, it is a
// polynomial, and what double-double does not settle the exact tier does (exact_crossings.h). Of twists, which have no exact form, it is answered for a ray
// moved a little, and said to be uncertified. docs/numerics.md.
#pragma once

#include "tracer/engine/roots.h"

namespace whittle {

// The part of the ray that can matter: a little more than what lies in the piece's cylinder. The same for all sides of a piece, so that beyond it the formula
// keeps the value it has at its ends, which is outside. Empty: the ray is out of reach at all the piece's heights, and has no crossing.
struct TurnedWindow {
    double from = 0, to = 0;
    bool empty = false;
    bool holds_origin() const { return !empty && from < 0 && to > 0; }
};

// False: entering the frame rounds too much.
bool turned_window(const Twist& twist, const FrameRay& ray, TurnedWindow& out);

// The side's sign at a place out of the piece's reach, one for all its sides: there the formula is outside.
int sign_out_of_reach(const Support& support, const Twist& twist);

// Requires of what follows: is_turned(support.kind), and the frame is the support's.

// In double-double. False: not decidable.
bool fine_turned(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out);

// One crossing's t in double-double, high + low. False: not decidable.
bool fine_turned(const Support& support, const Frame& frame, const Ray& ray, bool leaving, int index, double& high, double& low, double& error);

// Of a ray moved a little, by the rule of csg/span/perturbation.h but not without end: an answer, not a certificate.
void unsettled_turned(const Support& support, const Frame& frame, const Ray& ray, bool leaving, Crossings& out);

// The middle of the piece's axis in the root frame: what agrees has it in one place.
Vec3 turned_middle(const Frame& frame);

// How far points of the first are, in the root frame, from the second; infinite where they are not the same piece of one way up. `flipped`: outside of the one is
// inside of the other.
double turned_distance(const Support& a, const Frame& in_a, const Support& b, const Frame& in_b, bool& flipped);

// The function's gradient at a point of the frame.
Vec3 turned_gradient(const Support& support, const Twist& twist, const Vec3& point);

}  // namespace whittle
