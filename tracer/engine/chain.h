// chain.h — the placements above a shape, multiplied exactly enough and rounded once.
//
// world = outer * inner: `inner` permutes, scales and shifts the axes, and is absorbed into the numbers of a shape (an axis plane stays an axis
// plane, so shapes that the author shifts by literals share their planes to the bit); `outer` begins at the last placement that turns or
// shears, and becomes a frame. Products are formed in binary128: those of two doubles are exact, sums round at 2^-113, the result is rounded once.
#pragma once

#include <array>
#include <cmath>
#include <memory>

#include "csg/base/vec.h"

namespace whittle {

__extension__ using Wide = __float128;

inline double to_double(Wide x) { return static_cast<double>(x); }

// new coordinate i = scale[i] * old coordinate from[i] + shift[i]
struct AxisMap {
    std::array<std::uint8_t, 3> from{0, 1, 2};
    std::array<Wide, 3> scale{1, 1, 1};
    std::array<Wide, 3> shift{0, 0, 0};

    bool is_uniform() const {
        const auto a = [](Wide x) { return x < 0 ? -x : x; };
        return a(scale[0]) == a(scale[1]) && a(scale[1]) == a(scale[2]);
    }
};

struct ChainSection;

class Chain {
public:
    // A chain that begins anew within the section in the plane z = 0 of what this one places; the section is swept over these heights of it.
    Chain within_section(const std::array<double, 2>& heights) const;
    // Null where the chain begins in the root.
    const std::shared_ptr<const ChainSection>& section() const { return section_; }

    // The chain with `p` applied first (it stands further in).
    Chain then(const Placement& p) const;
    const AxisMap& inner() const { return inner_; }
    // The frame to put shapes in whose numbers absorb inner(); and the one for shapes that absorb nothing.
    Placement outer() const { return turned_ ? rounded(outer_) : Placement{}; }
    Placement whole() const { return rounded(whole_matrix()); }
    // Sum of the magnitudes that rounding acted on, for a point of the given size: times the unit roundoff, a bound of the displacement.
    double rounding_for(double size) const { return (links_ + 2) * 0x1p-53 * (reach_ + stretch_ * size); }

    // How far at most rounding outer(), or whole(), moves a point of the given size.
    double displacement_of_outer(double size) const { return turned_ ? displacement(outer_, size) : 0; }
    double displacement_of_whole(double size) const { return displacement(whole_matrix(), size); }

private:
    using Matrix = std::array<Wide, 12>;
    static Matrix as_matrix(const AxisMap& m);
    static Matrix product(const Matrix& a, const Matrix& b);
    Matrix whole_matrix() const { return turned_ ? product(outer_, as_matrix(inner_)) : as_matrix(inner_); }
    static Placement rounded(const Matrix& m);
    static double displacement(const Matrix& m, double size);

    Matrix outer_{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    AxisMap inner_;
    bool turned_ = false;  // outer_ is more than the identity
    bool placed_ = false;  // by anything yet
    std::shared_ptr<const ChainSection> section_;
    // Of all links, those above a section too.
    double reach_ = 0, stretch_ = 1;
    int links_ = 0;
};

struct ChainSection {
    Chain above;
    std::array<double, 2> heights;
};

}  // namespace whittle
