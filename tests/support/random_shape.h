// random_shape.h — one random shape with sizes from a short list, and the points it is known by.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle::support {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    std::mt19937_64& engine() { return engine_; }
    int integer(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(engine_); }
    double real(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine_); }
    bool one_in(int n) { return integer(1, n) == 1; }
    template <class T>
    T pick(std::initializer_list<T> list) { return list.begin()[integer(0, static_cast<int>(list.size()) - 1)]; }

    // Draws the list that sizes and offsets come from: small multiples of 1/4, or decimals and random numbers among them.
    void pool(bool coarse);
    double length() { return pool_[static_cast<std::size_t>(integer(0, static_cast<int>(pool_.size()) - 1))]; }
    // 0, or a length of either sign.
    double offset() { return one_in(3) ? 0 : one_in(2) ? length() : -length(); }
    Vec3 vector() { return {offset(), offset(), offset()}; }

private:
    std::mt19937_64 engine_;
    std::vector<double> pool_{1};
};

enum class Repertoire : std::uint8_t { kPlanes, kRound, kAll };

struct Sketch {
    Shape shape;
    std::vector<Vec3> points;
    bool bounded = true;
};

Sketch random_shape(SolidBuilder& builder, Dice& dice, Repertoire repertoire);

// kHalfSpace and kQuadric may be unbounded; kTwist is a prism's, in slices, and it and kConvex are not among those of random_shape().
enum class ShapeKind : std::uint8_t { kBox, kPolyhedron, kEllipsoid, kFrustum, kTorus, kCapsule, kRoundBox, kQuadric, kHalfSpace, kExtrusion, kRevolution, kFaceted, kTwist, kConvex, kSection };
inline constexpr int kShapeKinds = 15;
const char* name_of(ShapeKind kind);
Sketch random_shape_of(ShapeKind kind, SolidBuilder& builder, Dice& dice);

// A convex body of round parts with an exact formula (tests/reference/convex.h); its flat faces are across axes.
Sketch random_convex(Dice& dice);

// A random 2D node within about [-2, 2]^2; with x >= 0 alone if `right`.
NodeId random_profile(SolidBuilder& builder, Dice& dice, bool planes, bool right);

}  // namespace whittle::support
