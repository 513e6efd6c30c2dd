// ray_context.h — one ray and what is known of it so far: its frames, its crossings, the order of its events. Private to the engine.
//
// An event is (class, crossing): only the class's coefficients compute its t. Two events are compared by t and bounds; where the bounds overlap, in
// double-double; where that cannot tell either, exactly. docs/numerics.md, order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/engine/certificates.h"
#include "tracer/engine/exact_crossings.h"
#include "tracer/engine/mutation.h"
#include "tracer/engine/program.h"
#include "tracer/engine/turned_series.h"

namespace whittle {

// A crossing of a class; or, with no class, t = 0 or an infinite t. As a cursor it means the place just behind the event, or just before it.
class Event {
public:
    double t = 0, error = 0;

    Event() = default;
    Event(double t_of, double error_of, ClassId id, std::uint32_t index = 0, bool before = false)
        : t(t_of), error(error_of), rest_(id | std::uint64_t{index} << 32 | std::uint64_t{before} << 63) {}
    // Before it or, as is usual, behind it.
    static Event beside(const Event& e, bool before) { return {e.t, e.error, e.id(), e.index(), before}; }

    ClassId id() const { return static_cast<ClassId>(rest_); }
    std::uint32_t index() const { return static_cast<std::uint32_t>(rest_ >> 32) & 0x7FFFFFFF; }
    bool before() const { return rest_ >> 63 != 0; }

private:
    std::uint64_t rest_ = kNoClass;  // written and copied as one: events are copied right after they are made
};

// What was found of turned sides and convex bodies on the ray, which cells share: the last few of each.
class TurnedMemory {
public:
    struct Piece {
        FrameId frame = 0;
        std::uint32_t stamp = 0;  // of the ray; 0: of none
        bool in_double = false;
        TurnedSeries series;
    };
    struct Side {
        ClassId id = 0;
        std::uint32_t stamp = 0;
        Crossings crossings;
    };

    // Where they are kept: another's, or of another ray, where the stamp is not the ray's.
    Piece& piece(FrameId frame, std::uint32_t stamp) { return other_if(place(pieces_, kPieces, frame), stamp, [&](const Piece& p) { return p.frame == frame; }); }
    Side& side(ClassId id, std::uint32_t stamp) { return other_if(place(sides_, kSides, id), stamp, [&](const Side& s) { return s.id == id; }); }
    void clear() {
        pieces_.clear();
        sides_.clear();
    }

private:
    static constexpr std::size_t kPieces = 16, kSides = 128;

    template <class T>
    static T& place(std::vector<T>& kept, std::size_t count, std::uint32_t number) {
        if (kept.empty()) kept.resize(count);
        return kept[number % count];
    }
    template <class T, class Same>
    static T& other_if(T& kept, std::uint32_t stamp, Same same) {
        if (kept.stamp == stamp && !same(kept)) kept.stamp = 0;
        return kept;
    }

    std::vector<Piece> pieces_;
    std::vector<Side> sides_;
};

class RayContext {
public:
    void start(const Program& program, const Ray& ray, EngineCounters& counters);

    const Program& program() const { return *program_; }
    const Ray& ray() const { return ray_; }
    const SlabRay& slab() const { return slab_; }
    const Frame& frame(FrameId id);
    const FrameRay& frame_ray(FrameId id);

    // Crossings of a class, certain in number and order.
    void crossings(ClassId id, Crossings& out) {
        const Support& s = program_->classes[id];
        if (s.kind == SupportKind::kAxisPlane && s.frame == 0 && regular_[s.axis] && !leaves(id)) {
            axis_plane_crossing(s.p[0], root_.o[s.axis], root_.d[s.axis], slab_.inverse[s.axis], out);
        } else {
            curved_crossings(id, s, out);
        }
        if (mutated(Mutation::kNoBounds)) out.error = {};
    }
    // Where the ray enters the last of the slabs and leaves the first, though it may leave before it enters. False: not known so quickly.
    bool crossings(const CellSlabs& slabs, Event& in, Event& out) const;
    // The same of an item that is one ball. False: not decidable in double.
    bool crossings(const ItemBall& ball, Crossings& out);
    // A box that holds the ray's place at the event, wherever within its bound that is.
    FloatBox place_of(const Event& e) const;
    // -1, 0, 1 as a lies before, at, behind b on the ray; `before` is not looked at.
    int compare(const Event& a, const Event& b) {
        if (!filter_ && std::isfinite(a.t) && std::isfinite(b.t)) return compare_closely(a, b);
        const double d = a.t - b.t, room = mutated(Mutation::kRayEpsilon) ? 1e-12 : kCertifies ? a.error + b.error : 0;
        const int order = (d > room) - (d < -room);
        counters_->skipped_by(EnginePass::kFilter) += order != 0 && filter_;
        if (order != 0) return order;
        if (mutated(Mutation::kRayEpsilon) && std::abs(d) <= 1e-12 && a.id() != b.id()) return 0;
        return compare_closely(a, b);
    }

    // Is this a surface without an exact form?
    bool is_transcendental(ClassId id) const;

    // Is it one whose crossings, or their order among others, neither double nor double-double could settle? Not certain before it was asked for.
    bool unsettled(ClassId id) const { return std::find(unsettled_.begin(), unsettled_.end(), id) != unsettled_.end(); }

    EngineCounters& counters() { return *counters_; }
    bool filters() const { return filter_; }  // may double decide where its bounds allow?
    FacetSearch& facet_search() { return facet_search_; }

private:
    struct Exact {
        ClassId id;
        std::vector<exact::RealRoot> roots;
        Crossings crossings;
    };

    bool leaves(ClassId id) const {
        if (ray_.departure == nullptr) return false;
        const auto end = ray_.departure->classes.begin() + ray_.departure->count;
        return std::find(ray_.departure->classes.begin(), end, id) != end;
    }
    void leave_unsettled(ClassId id);
    void curved_crossings(ClassId id, const Support& s, Crossings& out);
    void shared_crossings(ClassId id, const Support& s, Crossings& out);
    void find_convex(ClassId id, const Support& s, Crossings& out);
    void find_turned(ClassId id, const Support& s, Crossings& out);
    const Exact& exact(ClassId id);
    int compare_closely(const Event& a, const Event& b);
    bool fine(const Event& e, double& high, double& low, double& error);
    int compare_exactly(const Event& a, const Event& b);

    const Program* program_ = nullptr;
    EngineCounters* counters_ = nullptr;
    Ray ray_;
    FrameRay root_;
    single::RoundDirection<double, 3> towards_;  // of the root's direction; made when first asked for
    bool has_towards_ = false;
    std::vector<ClassId> unsettled_;  // seldom any
    SlabRay slab_;
    bool filter_ = true;             // EnginePass
    bool direct_ = false;            // the three coordinates are regular, and comparisons may be left to bounds
    std::array<bool, 3> regular_{};  // the direction's coordinate has a finite, normal inverse
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> frame_stamps_;
    std::vector<FrameRay> frame_rays_;
    std::vector<Frame> moved_;  // frames of motion groups, at the ray's time
    std::vector<Exact> exact_;
    FacetSearch facet_search_;
    TurnedMemory turned_;
};

}  // namespace whittle
