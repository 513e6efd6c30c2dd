// cone_formula.h — what of the solid's formula a cone may meet: its half-spaces as polynomials along the axis with their slopes across it, and at places on
// the axis the formula's value at 64 points of the section at once, a bit each.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tracer/engine/bvh.h"
#include "tracer/engine/cone.h"
#include "tracer/engine/program.h"

namespace whittle {

// A half-space about the cone: its polynomial on the axis, and what it gains a mm along u and v.
struct ConeSide {
    std::uint32_t packed = 0;
    bool departs = false;  // the axis leaves it
    LinePolynomial<double> axis, along_u, along_v;
    std::uint32_t class_id() const { return packed >> 1; }
    double inside_sign() const { return (packed & 1) != 0 ? -1 : 1; }
};

inline double value_at(const LinePolynomial<double>& p, double t) {
    double sum = 0;
    for (int i = p.degree; i >= 0; --i) sum = sum * t + p.c[static_cast<std::size_t>(i)];
    return sum;
}

inline double slope_at(const LinePolynomial<double>& p, double t) {
    double sum = 0;
    for (int i = p.degree; i >= 1; --i) sum = sum * t + i * p.c[static_cast<std::size_t>(i)];
    return sum;
}

// The unit disc's image in a section, as the symmetric matrix of the image in the coordinates (u, v).
struct ConeSection {
    double uu = 0, uv = 0, vv = 0;
};

// Does it name the class? Null names none.
inline bool names(const Departure* events, ClassId id) {
    return events && std::find(events->classes.begin(), events->classes.begin() + events->count, id) != events->classes.begin() + events->count;
}

// Points of the unit disc, each for an equal share.
inline constexpr int kDiscPoints = 64;
struct DiscPoint {
    double x = 0, y = 0;
};
const std::array<DiscPoint, kDiscPoints>& disc_points();

// Where a half-space ends in the section at t, drawn in the unit disc: inside is (x, y) . (u, v) <= offset. `mask`: the points inside.
struct ConeEdge {
    double offset = 0, u = 0, v = 0, t = 0;
    std::uint64_t mask = 0;
};

class ConeFormula {
public:
    // Memory of an earlier cone is used again. False: something is here that cones do not divide, or nothing has a width.
    bool read(const Program& program, const Cone& cone, double t_most);

    std::vector<ConeSide> sides;
    std::vector<ConeEdge> edges;
    Vec3 u{0}, v{0};  // across the axis

    ConeSection section(double t) const;
    // A plane through the axis's point at t that leans by so much a mm along u and v.
    struct Leaning {
        double t = 0, u = 0, v = 0;
    };
    // Of the side in that plane; of one that ends outside the disc `mask` is all or nothing, and its offset beyond [-1, 1].
    ConeEdge edge(std::size_t side, const ConeSection& section, const Leaning& plane) const;
    // Points at which, in that plane and ahead of what the cone departs from, being inside the side `own` or not decides whether they are in the solid. The
    // edges that cross the disc there are added to `edges`.
    std::uint64_t face(std::size_t own, const Leaning& plane);

private:
    // A group, a leaf of several half-spaces (their indices are its children), or what is the same everywhere.
    struct Part {
        bool leaf = false, is_and = false, negated = false;
        bool constant = false, constant_value = false;
        std::size_t first = 0, count = 0;  // of `children_`
    };

    // The axis and the lines one step beside it, in a frame.
    struct FrameLines {
        std::uint32_t frame = 0;
        FrameLine<double> axis;
        std::array<FrameLine<double>, 4> beside;  // +u, -u, +v, -v
    };

    template <class Lo>
    bool meets(const Lo& lo, const Lo& hi) const;
    bool meets(const Bounds& b) const;
    std::size_t add(const Part& part);
    std::size_t constant(bool value) { return add({true, false, false, true, value, 0, 0}); }
    // The part whose children lie on `pending_` from `base` on, which are taken off it.
    std::size_t add_with_children(Part part, std::size_t base);
    std::size_t gather(Ref ref);
    std::size_t gather_leaf(const Leaf& leaf);
    std::size_t gather_group(const Group& group);
    void gather_items(std::uint32_t at);
    // Of the plane: beyond the cone's start, and before twice t, where the section is another.
    std::uint64_t points_ahead(const ConeSection& section, const Leaning& plane) const;
    const FrameLines& lines_in(std::uint32_t frame);
    std::size_t side_of(HalfSpace half_space);
    std::uint64_t inside_side(std::size_t side, std::size_t own, std::uint64_t own_mask) const;
    std::uint64_t inside(std::size_t part, std::size_t own, std::uint64_t own_mask) const;

    const Program* program_ = nullptr;
    const Cone* cone_ = nullptr;
    double t_most_ = 0, step_ = 0;  // step across the axis by which slopes are found
    std::array<double, 2> near_u_{}, near_v_{}, far_u_{}, far_v_{};  // in u and v
    double near_size_ = 0, far_size_ = 0;
    SlabRay slab_;
    std::vector<FrameLines> lines_;
    std::vector<Part> parts_;
    std::vector<std::size_t> children_, pending_;
    std::vector<std::uint64_t> masks_;  // of the sides, in the plane last asked
    std::size_t root_ = 0;
    bool readable_ = true;
};

}  // namespace whittle
