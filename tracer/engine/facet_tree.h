// facet_tree.h — which sides of a convex cell with many planes a line, or a tile of them, can feel. Private to the engine.
//
// A line is inside such a cell from the last plane it enters by to the first it leaves by. Planes whose normals are alike stand together in chunks of eight
// boxes of (normal, offset): a box tells between which t the line crosses all planes in it, so whole groups lie before another plane's crossing on the way
// in, or behind another's on the way out, and are never asked. O(log n) chunks for a line through an n-gon cone or a ball of facets. Boxes are float, rounded
// outward: they drop what is certain not to matter and never decide.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

inline constexpr std::size_t kFacetLanes = 8;
inline constexpr std::uint32_t kManyFacets = 12;  // cells of fewer planes ask them all

// Of planes n.(x - centre) = d of the root frame, n a unit vector that points outward.
struct alignas(64) FacetChunk {
    std::array<std::array<std::array<float, kFacetLanes>, 3>, 2> n{};  // least and greatest, by axis, by child
    std::array<std::array<float, kFacetLanes>, 2> d{};
    std::array<std::uint32_t, kFacetLanes> child{};  // a plane's number in its cell; or the first of the child's chunks,
    std::array<std::uint8_t, kFacetLanes> chunks{};  // which are so many; 0: a plane
    std::uint32_t count = 0;
};

// Of the first `planes` half-spaces of a cell.
struct FacetTree {
    Vec3 centre{0};
    std::uint32_t first = 0, chunks = 0;
    std::uint32_t planes = 0;
};

struct FacetPlane {
    Vec3 n{0};
    double d = 0;
};

// Appends chunks. Requires: finite planes, at least one.
FacetTree build_facet_tree(const std::vector<FacetPlane>& planes, const Vec3& centre, std::vector<FacetChunk>& chunks);

// Lines x = q + t d, q measured from a tree's centre within `slack` (summed over the axes); each coordinate between its least and greatest.
struct FacetLines {
    std::array<double, 3> q_lo{}, q_hi{}, d_lo{}, d_hi{};
    double slack = 0;
};

// A line from a point at most a few sizes of the cell away: so its offset rounds little. t is another, but in the same order.
FacetLines facet_line(const FacetTree& tree, const Vec3& origin, const Vec3& direction);
FacetLines facet_lines(const FacetTree& tree, const std::array<double, 3>& o_lo, const std::array<double, 3>& o_hi, const std::array<double, 3>& d_lo,
                       const std::array<double, 3>& d_hi);

// Of the children of a chunk: the lines cross all their planes from outside (entering), or from inside (leaving), with t in [lo, hi]; or it is not known.
struct FacetRanges {
    std::array<double, kFacetLanes> lo, hi;
    std::uint32_t entering = 0, leaving = 0;
};

// For the processor at hand. The answers differ by no more than the boxes' room allows: what is found by them does not.
using FacetsMet = void (*)(const FacetChunk& chunk, const FacetLines& lines, FacetRanges& ranges);
FacetsMet facets_met();

class FacetSearch {
public:
    // False: every line misses the cell. Otherwise found() are the planes that may be the last in or the first out on some line, ascending.
    bool run(const std::vector<FacetChunk>& chunks, const FacetTree& tree, const FacetLines& lines);
    const std::vector<std::uint32_t>& found() const { return found_; }

private:
    enum class Way : std::uint8_t { kUnknown, kEntering, kLeaving };
    struct Waiting {
        double lo, hi;
        std::uint32_t child;
        std::uint8_t chunks;
        Way way;
    };
    void look(const std::vector<FacetChunk>& chunks, std::uint32_t first, std::uint32_t count, const FacetLines& lines);
    bool matters(const Waiting& w) const { return w.way == Way::kUnknown || (w.way == Way::kEntering ? !(w.hi < last_in_) : !(w.lo > first_out_)); }

    std::vector<Waiting> waiting_, planes_;
    std::vector<std::uint32_t> found_;
    FacetsMet met_ = nullptr;
    double last_in_ = 0, first_out_ = 0;
};

}  // namespace whittle
