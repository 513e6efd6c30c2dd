// random_convex.cpp — hulls and sums of round parts, of the families whose exact formula is known (tests/reference/convex.h).
#include <algorithm>
#include <cmath>

#include "csg/solid/convex_body.h"
#include "tests/support/random_shape.h"

namespace whittle::support {

namespace {

BallImage ball(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, r}}; }
BallImage disc(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, 0}}; }

// Sums of lengths are exact in double.
double short_length(Dice& dice) { return std::max(0x1p-12, std::round(dice.length() * 0x1p12) * 0x1p-12); }
double short_offset(Dice& dice) { return dice.one_in(3) ? 0 : dice.one_in(2) ? short_length(dice) : -short_length(dice); }

// Balls and corners; of one radius as often as not, as a sum with a ball has them.
ConvexParts of_balls(Dice& dice) {
    ConvexParts parts;
    const double common = short_length(dice) * 0.5;
    const bool same = dice.one_in(2);
    for (int i = dice.integer(2, 4); i > 0; --i) {
        const double r = same ? common : dice.one_in(3) ? 0 : short_length(dice) * 0.5;
        parts.push_back({{short_offset(dice), short_offset(dice), short_offset(dice)}, {}});
        if (r > 0) parts.back().images.push_back(ball(r));
    }
    // Corners alone may lie in one plane that no tried direction finds thin.
    if (std::all_of(parts.begin(), parts.end(), [](const ConvexPart& p) { return p.images.empty(); })) parts[0].images.push_back(ball(common));
    return parts;
}

// Rings and balls about z: cylinders and cones grown by a ball, hulls of tori, of rings and balls on their axis.
ConvexParts turned(Dice& dice) {
    ConvexParts parts;
    const double common = short_length(dice) * 0.5;
    const bool same = dice.one_in(2);
    for (int i = dice.integer(1, 3); i > 0; --i) {
        parts.push_back({{0, 0, short_offset(dice)}, {}});
        const int kind = dice.integer(0, 3);
        if (kind < 3) parts.back().images.push_back(disc(short_length(dice)));
        if (kind > 0 && (same || !dice.one_in(3))) parts.back().images.push_back(ball(same ? common : short_length(dice) * 0.5));
    }
    return parts;
}

// Upright discs and corners at two heights: frusta that lean, boxes and prisms grown by a disc.
ConvexParts of_discs(Dice& dice) {
    ConvexParts parts;
    const double low = short_offset(dice), high = low + short_length(dice), common = short_length(dice) * 0.5;
    const bool sum = dice.one_in(2);
    const int count = dice.integer(1, 2);
    std::vector<ConvexPart> below;
    for (int i = 0; i < count; ++i) below.push_back({{short_offset(dice), short_offset(dice), low}, {disc(sum ? common : short_length(dice))}});
    for (ConvexPart part : below) {
        parts.push_back(part);
        part.centre.z = high;
        if (sum) parts.push_back(part);
    }
    if (!sum)
        for (int i = dice.integer(1, 2); i > 0; --i) {
            parts.push_back({{short_offset(dice), short_offset(dice), high}, {}});
            if (!dice.one_in(3)) parts.back().images.push_back(disc(short_length(dice)));
        }
    return parts;
}

// The planes of faces that lean are rounded, and then they, not the parts, say where the body ends.
bool has_upright_faces(const ConvexHullBody& body) {
    return std::all_of(body.faces.begin(), body.faces.end(), [](const FlatFace& f) { return std::abs(f.n.x) == 1 || std::abs(f.n.y) == 1 || std::abs(f.n.z) == 1; });
}

// Thicker than a tenth of its size, whichever way.
bool is_thick(const ConvexParts& parts, double size) {
    for (int i = 0; i <= 64; ++i) {
        const double z = i / 64.0, turn = 2.39996322972865332 * i, across = std::sqrt(1 - z * z);
        const Vec3 n(across * std::cos(turn), across * std::sin(turn), z);
        if (!(reach(parts, n) + reach(parts, -n) > 0.1 * size)) return false;
    }
    return true;
}

}  // namespace

Sketch random_convex(Dice& dice) {
    while (true) {
        const int family = dice.integer(0, 2);
        ConvexParts parts = family == 0 ? of_balls(dice) : family == 1 ? turned(dice) : of_discs(dice);
        const auto body = std::make_shared<const ConvexHullBody>(std::move(parts));
        if (!is_thick(body->parts, body->size) || !has_upright_faces(*body)) continue;
        std::vector<Vec3> points;
        for (const ConvexPart& part : body->parts) points.push_back(part.centre);
        for (int i = 0; i < 10; ++i) {
            const Vec3 n = i < 6 ? Vec3(i % 3 == 0, i % 3 == 1, i % 3 == 2) * (i < 3 ? 1.0 : -1.0) : dice.vector();
            if (n != Vec3(0)) points.push_back(farthest_point(body->parts, n));
        }
        for (const FlatFace& face : body->faces) points.push_back(face.middle);
        return {shape::ConvexBody{body}, std::move(points)};
    }
}

}  // namespace whittle::support
