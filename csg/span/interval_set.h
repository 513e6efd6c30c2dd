// interval_set.h — sets of places on a ray as the borders where membership changes, and the algebra on them.
//
// A set is its membership before the first border and the borders themselves, strictly ascending. Operations compare borders and never compute
// one; equal borders are one place, where both operands change together. So nothing has length zero, the algebra holds no tolerance, and
// subtract(a, a) is empty however the borders were found.
//
// Source: Roth, Ray casting for modeling solids (1982), section 4; regularised sets: Requicha, Representations for rigid solids (1980).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace whittle {

template <class Border>
struct IntervalSet {
    bool inside_before = false;
    std::vector<Border> borders;

    bool empty() const { return !inside_before && borders.empty(); }
    bool everything() const { return inside_before && borders.empty(); }
    bool operator==(const IntervalSet&) const = default;
};

// The places where truth(in a, in b) holds. At most a's and b's borders together. Of two equal borders the result holds a's.
// Requires: compare(x, y) is negative, zero, positive as x lies before, at, behind y: a total order over the borders of both.
template <class Border, class Truth, class Compare>
IntervalSet<Border> combine(const IntervalSet<Border>& a, const IntervalSet<Border>& b, Truth truth, Compare compare) {
    bool in_a = a.inside_before, in_b = b.inside_before;
    IntervalSet<Border> r{truth(in_a, in_b), {}};
    bool now = r.inside_before;
    std::size_t i = 0, j = 0;
    while (i < a.borders.size() || j < b.borders.size()) {
        const int order = i == a.borders.size() ? 1 : j == b.borders.size() ? -1 : compare(a.borders[i], b.borders[j]);
        const Border& at = order <= 0 ? a.borders[i] : b.borders[j];
        if (order <= 0) in_a = !in_a, ++i;
        if (order >= 0) in_b = !in_b, ++j;
        if (truth(in_a, in_b) != now) {
            now = !now;
            r.borders.push_back(at);
        }
    }
    return r;
}

// Laws (of sets): idempotent, commutative up to which of two equal borders is kept, associative, De Morgan; subtract(a, a).empty();
// subtract(a, subtract(a, b)) == intersect(a, b).
template <class Border, class Compare>
IntervalSet<Border> unite(const IntervalSet<Border>& a, const IntervalSet<Border>& b, Compare compare) {
    return combine(a, b, [](bool x, bool y) { return x || y; }, compare);
}
template <class Border, class Compare>
IntervalSet<Border> intersect(const IntervalSet<Border>& a, const IntervalSet<Border>& b, Compare compare) {
    return combine(a, b, [](bool x, bool y) { return x && y; }, compare);
}
template <class Border, class Compare>
IntervalSet<Border> subtract(const IntervalSet<Border>& a, const IntervalSet<Border>& b, Compare compare) {
    return combine(a, b, [](bool x, bool y) { return x && !y; }, compare);
}
template <class Border>
IntervalSet<Border> complement(IntervalSet<Border> a) {
    a.inside_before = !a.inside_before;
    return a;
}

}  // namespace whittle
