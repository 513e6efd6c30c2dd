// outline_builder.h — contours of a drawing under an affine map: lines, Bezier curves and arcs of circles and ellipses. Shared by the readers of SVG and DXF.
//
// A circle's arc under a similarity stays an arc. Any other ellipse becomes cubic curves of a 32nd of a turn, no further from it than 2e-11 of its size.
#pragma once

#include "csg/solid/imported.h"

namespace whittle {

// p -> (a x + c y + e, b x + d y + f), as SVG writes it.
struct PlaneMap {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
    Vec2 point(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    Vec2 direction(Vec2 v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
    double determinant() const { return a * d - b * c; }
    // Does it keep circles round, up to the rounding of its own numbers?
    bool is_similarity() const;
};
PlaneMap operator*(const PlaneMap& outer, const PlaneMap& inner);

class OutlineBuilder {
public:
    void move_to(const PlaneMap& map, Vec2 p);
    void line_to(const PlaneMap& map, Vec2 p);
    void quadratic_to(const PlaneMap& map, Vec2 a, Vec2 p);
    void cubic_to(const PlaneMap& map, Vec2 a, Vec2 b, Vec2 p);
    // Along centre + u cos t + v sin t from the angle `from` by `sweep` (radians); the arc must begin where the contour stands. `to` is its end.
    void arc(const PlaneMap& map, Vec2 centre, Vec2 u, Vec2 v, double from, double sweep, Vec2 to);
    // Ends the contour; what is open is closed by a line.
    void close();
    // For each contour that take() would give: did it end elsewhere than where it starts, without close()?
    std::vector<bool> left_open() const;
    // The contours with at least one side. The builder is empty afterwards.
    std::vector<DrawnContour> take();

private:
    void end();
    std::vector<DrawnContour> contours_;
    std::vector<bool> left_open_;  // of those that have ended
    bool open_ = false;
};

// A full ellipse about `centre` as a contour of its own.
void add_ellipse(OutlineBuilder& builder, const PlaneMap& map, Vec2 centre, Vec2 u, Vec2 v);

}  // namespace whittle
