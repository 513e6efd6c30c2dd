// pov_growth.h — how far operands stand out of each other in a scene for POV-Ray. Internal to pov.cpp.
//
// POV-Ray decides by rounding where faces coincide: a bore flush with the plate it goes through stays covered in specks, or whole. So what cuts is larger than
// what it cuts, the later operand of an intersection than the earlier, and of touching operands of a union in two colours the first than the second (its
// colour shows): by steps of 2^-20 of the model's diagonal, far less than a pixel. A leaf grows about the middle of its box, so a concave cutter (an
// extruded L, a torus within its hole) may still end flush with what it cuts.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

// What lies above an occurrence of a node: its frame up to there, and the steps it grows by.
struct PovPlace {
    Placement frame;
    int steps = 0;
    bool cuts = false;  // below a subtracted operand, at any depth
};

class PovGrowth {
public:
    explicit PovGrowth(const Solid& solid);

    // Steps that each operand grows by beyond those of its combination.
    std::vector<int> steps_of_operands(const Combination& c);

    // Occurrences with equal keys may share a declaration: steps, and the lengths of the frame's axes to within 2^-8 where they matter.
    using Key = std::array<int, 4>;
    Key key(const PovPlace& place) const;

    // The map of a leaf with these bounds (in its own frame) that lets it grow; the identity where it does not, or is unbounded.
    Placement grown(const Bounds& leaf, const PovPlace& place) const;

private:
    int most_within(NodeId node);

    const Solid& solid_;
    double step_mm_;
    std::map<NodeId, int> most_within_;
};

}  // namespace whittle
