// facet_tree.cpp — see facet_tree.h.
#include "tracer/engine/facet_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/engine/facet_targets.inc"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>  // NOLINT: includes facet_targets.inc for every target but the last
#include <hwy/highway.h>

#include "tracer/engine/facet_targets.inc"

namespace whittle {

HWY_EXPORT(facets_met);

FacetsMet facets_met() { return &HWY_DYNAMIC_DISPATCH(facets_met); }

namespace {

constexpr double kRoomOfNormal = 0x1p-25;  // far over what a plane's own numbers rounded
constexpr double kRoomOfOffset = 0x1p-30;  // relative
constexpr double kRounding = 0x1p-50;      // of a line's way to the centre

float below(double x) { return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity()); }
float above(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity()); }

class Builder {
public:
    Builder(const std::vector<FacetPlane>& planes, std::vector<FacetChunk>& chunks) : planes_(planes), chunks_(chunks), order_(planes.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
    }

    std::uint32_t run(std::uint32_t& count) { return add(0, static_cast<std::uint32_t>(order_.size()), count); }

private:
    // At most so many planes stand in chunks of their own, beside each other.
    static constexpr std::uint32_t kMostTogether = 16;
    static constexpr std::uint32_t kParts = 8, kLanes = kFacetLanes;

    std::uint32_t add(std::uint32_t from, std::uint32_t to, std::uint32_t& count) {
        const auto first = static_cast<std::uint32_t>(chunks_.size());
        if (to - from <= kMostTogether) {
            count = (to - from + kLanes - 1) / kLanes;
            chunks_.resize(first + count);
            sort_along_widest(from, to);
            for (std::uint32_t i = from; i < to; ++i) put(first + (i - from) / kLanes, i, i + 1, order_[i], 0);
            return first;
        }
        count = 1;
        chunks_.resize(first + 1);
        std::array<std::uint32_t, kParts + 1> ends{};
        part(from, to, ends.data(), 0, kParts);
        ends[kParts] = to;
        for (std::uint32_t k = 0; k < kParts; ++k) {
            std::uint32_t below_count = 0;
            const std::uint32_t child = add(ends[k], ends[k + 1], below_count);
            put(first, ends[k], ends[k + 1], child, static_cast<std::uint8_t>(below_count));
        }
        return first;
    }

    // Into `parts` (a power of two) of nearly equal size, halved along the widest axis of their normals. Writes where each begins.
    void part(std::uint32_t from, std::uint32_t to, std::uint32_t* begins, std::uint32_t at, std::uint32_t parts) {
        begins[at] = from;
        if (parts == 1) return;
        sort_along_widest(from, to);
        const std::uint32_t middle = from + (to - from) / 2;
        part(from, middle, begins, at, parts / 2);
        part(middle, to, begins, at + parts / 2, parts / 2);
    }

    void sort_along_widest(std::uint32_t from, std::uint32_t to) {
        Vec3 lo(HUGE_VAL), hi(-HUGE_VAL);
        for (std::uint32_t i = from; i < to; ++i) lo = glm::min(lo, planes_[order_[i]].n), hi = glm::max(hi, planes_[order_[i]].n);
        const Vec3 size = hi - lo;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::sort(order_.begin() + from, order_.begin() + to, [&](std::uint32_t a, std::uint32_t b) {
            const double x = planes_[a].n[axis], y = planes_[b].n[axis];
            return x < y || (x == y && a < b);
        });
    }

    void put(std::uint32_t chunk, std::uint32_t from, std::uint32_t to, std::uint32_t child, std::uint8_t chunks) {
        Vec3 lo(HUGE_VAL), hi(-HUGE_VAL);
        double near = HUGE_VAL, far = -HUGE_VAL;
        for (std::uint32_t i = from; i < to; ++i) {
            const FacetPlane& p = planes_[order_[i]];
            lo = glm::min(lo, p.n), hi = glm::max(hi, p.n);
            near = std::min(near, p.d - std::abs(p.d) * kRoomOfOffset), far = std::max(far, p.d + std::abs(p.d) * kRoomOfOffset);
        }
        FacetChunk& c = chunks_[chunk];
        const std::size_t k = c.count++;
        for (int i = 0; i < 3; ++i) {
            c.n[0][static_cast<std::size_t>(i)][k] = below(lo[i] - kRoomOfNormal);
            c.n[1][static_cast<std::size_t>(i)][k] = above(hi[i] + kRoomOfNormal);
        }
        c.d[0][k] = below(near);
        c.d[1][k] = above(far);
        c.child[k] = child;
        c.chunks[k] = chunks;
    }

    const std::vector<FacetPlane>& planes_;
    std::vector<FacetChunk>& chunks_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

FacetTree build_facet_tree(const std::vector<FacetPlane>& planes, const Vec3& centre, std::vector<FacetChunk>& chunks) {
    FacetTree tree;
    tree.centre = centre;
    tree.planes = static_cast<std::uint32_t>(planes.size());
    tree.first = Builder(planes, chunks).run(tree.chunks);
    return tree;
}

FacetLines facet_line(const FacetTree& tree, const Vec3& origin, const Vec3& direction) {
    const Vec3 from = origin - tree.centre;
    double t = -glm::dot(from, direction) / glm::dot(direction, direction);
    if (!std::isfinite(t)) t = 0;
    FacetLines r;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double step = t * direction[i];
        r.q_lo[k] = r.q_hi[k] = from[i] + step;
        r.d_lo[k] = r.d_hi[k] = direction[i];
        r.slack += kRounding * (std::abs(origin[i]) + std::abs(tree.centre[i]) + std::abs(step));
    }
    return r;
}

FacetLines facet_lines(const FacetTree& tree, const std::array<double, 3>& o_lo, const std::array<double, 3>& o_hi, const std::array<double, 3>& d_lo,
                       const std::array<double, 3>& d_hi) {
    FacetLines r{{}, {}, d_lo, d_hi, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = tree.centre[static_cast<int>(i)];
        r.q_lo[i] = o_lo[i] - c;
        r.q_hi[i] = o_hi[i] - c;
        r.slack += kRounding * (std::abs(o_lo[i]) + std::abs(o_hi[i]) + std::abs(c));
    }
    return r;
}

void FacetSearch::look(const std::vector<FacetChunk>& chunks, std::uint32_t first, std::uint32_t count, const FacetLines& lines) {
    FacetRanges r;
    for (std::uint32_t c = first; c < first + count; ++c) {
        const FacetChunk& chunk = chunks[c];
        met_(chunk, lines, r);
        for (std::uint32_t k = 0; k < chunk.count; ++k) {
            Waiting w{r.lo[k], r.hi[k], chunk.child[k], chunk.chunks[k], Way::kUnknown};
            if ((r.entering >> k & 1) != 0) {
                w.way = Way::kEntering;
                if (w.lo > last_in_) last_in_ = w.lo;
            } else if ((r.leaving >> k & 1) != 0) {
                w.way = Way::kLeaving;
                if (w.hi < first_out_) first_out_ = w.hi;
            }
            if (matters(w)) (w.chunks > 0 ? waiting_ : planes_).push_back(w);
        }
    }
}

bool FacetSearch::run(const std::vector<FacetChunk>& chunks, const FacetTree& tree, const FacetLines& lines) {
    met_ = facets_met();
    waiting_.clear();
    planes_.clear();
    found_.clear();
    last_in_ = -HUGE_VAL, first_out_ = HUGE_VAL;
    look(chunks, tree.first, tree.chunks, lines);
    for (std::size_t i = 0; i < waiting_.size() && last_in_ <= first_out_; ++i) {
        const Waiting w = waiting_[i];
        if (matters(w)) look(chunks, w.child, w.chunks, lines);
    }
    if (last_in_ > first_out_) return false;
    for (const Waiting& w : planes_)
        if (matters(w)) found_.push_back(w.child);
    std::sort(found_.begin(), found_.end());
    return true;
}

}  // namespace whittle
