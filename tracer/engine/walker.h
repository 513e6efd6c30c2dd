// walker.h — the evaluator: walks a ray through the program from event to event. Private to the engine.
//
// A cursor is an event, never a number: the place just behind it (or just before). next() leaps to the first place at or behind the cursor where a
// node has a wanted state. In an OR that wants true any child will do: the nearest of them, found front to back in the hierarchy; in an OR that
// wants false all must agree: the cursor jumps from exit to exit until no child holds it. AND is the dual. Ties need no rule.
// all_changes() is the other evaluator, for whole rays: children's changes merged and swept once.
// Source: Kensler, Ray tracing CSG objects using single hit intersections (2006), without its state table; Roth (1982) for the sweep.
#pragma once

#include <vector>

#include "tracer/engine/leaf.h"

namespace whittle {

enum class Found { kHere, kLater, kNever };

class Walker {
public:
    void start(const Program& program, const Ray& ray, EngineCounters& counters, double far);

    // The first place at or behind the cursor where the root, or a node, is `want`. kLater: it is at `out`.
    Found next(Ref ref, const Event& cursor, bool want, Event& out);
    bool state(Ref ref, const Event& cursor) {
        Event unused;
        return next(ref, cursor, true, unused) == Found::kHere;
    }

    // Is the node true anywhere behind the cursor and before the ray's far end? Any part of a union will do, not the nearest.
    bool meets(Ref ref, const Event& cursor);

    // Changes of the node along the ray, as far as they matter for t >= 0; its state before the first.
    struct Changes {
        std::uint32_t first = 0, count = 0;
        bool initial = false;
    };
    Changes all_changes(Ref ref);
    const Event& change(std::uint32_t i) const { return events_[i]; }

    // Leaves that change in the node's stead at the event, with the event that each does it by.
    struct Cause {
        std::uint32_t leaf;
        Event event;
    };
    void causes(Ref ref, const Event& at, std::vector<Cause>& out);
    // The same by asking every leaf met so far: for a ray whose rounded origin misses a box by the rounding of its departure.
    void causes_among_met(const Event& at, std::vector<Cause>& out);
    // Do causes of one border come from true surfaces, and lie where it is said? Not those that meet a turned side in one place: that is as far as
    // double-double sees.
    bool are_certain(const std::vector<Cause>& causes) const;
    // The one leaf that changes at an event that was found on this ray, and its ball if it was met as one. False: another leaf does too, or the program is
    // not flat.
    bool sole_cause(const Event& at, Cause& cause, const ItemBall*& ball);
    // Whose matter fills the place: of the uses that hold it and are not subtracted the first by Program::matter_order; kNoLeafUse if there is none.
    std::uint32_t matter_at(Ref ref, const Event& cursor);
    // Changes along the ray of all leaves, leaf by leaf: matter changes at no other place. A cutter may end the one and leave another.
    struct MatterChange {
        Event event;
        std::uint32_t leaf;
    };
    void matter_changes(Ref ref, std::vector<MatterChange>& out);
    static constexpr std::uint32_t kNoLeafUse = 0xFFFFFFFF;

    RayContext& context() { return context_; }

private:
    struct Slot {
        std::uint32_t stamp = 0;
        Changes changes;
    };

    Changes leaf_changes(std::uint32_t leaf);
    Found next_in_leaf(std::uint32_t leaf, const Event& cursor, bool want, Event& out);
    Found next_of_any(const Group& g, const Event& cursor, bool want, Event& out);
    Found next_of_all(const Group& g, const Event& cursor, bool want, Event& out);
    Found advance(Ref ref, Event& cursor, bool want);
    Found advance_over_items(const Group& g, Event& cursor, bool want);
    bool passed(const Event& change, const Event& cursor) {
        const int order = context_.compare(change, cursor);
        return order < 0 || (order == 0 && !cursor.before());
    }
    bool misses(const Group& g, double begin);
    // By exact order: the t of a ray that grazes a face may be wrong by more than the part is away.
    bool is_before_far(Found found, const Event& e) { return found == Found::kHere || (found == Found::kLater && context_.compare(e, {far_, 0, kNoClass}) < 0); }
    Found next_in_item(std::uint32_t ref, const Event& cursor, bool want, Event& out);

    // Of t; boxes that the ray meets in it matter.
    struct Range {
        double begin, end;
    };
    void open(const WideNode& node, const Range& range);
    template <class Take>
    bool each_item(const Group& g, const Range& range, Take take);
    template <class Take>
    bool each_ahead(const Group& g, const Range& range, Take take);
    template <class Visit>
    bool each_entered(const Group& g, const Range& range, Visit visit);
    template <class Visit>
    bool each_entered_at(const Group& g, const Event& at, Visit visit);
    template <class Take>
    bool each_item_at(const Group& g, const FloatBox& place, Take take);
    Changes merge(const Group& g, std::size_t first_list);

    RayContext context_;
    double far_ = 0;
    BoxesAheadOf boxes_ahead_ = nullptr;
    BoxesTouchedBy boxes_touched_ = nullptr;
    // Of the hierarchies that are being gone through, the innermost last: a stack of `top_`.
    struct Waiting {
        WideChild child;
        float from;
    };
    std::vector<Waiting> waiting_;
    std::size_t top_ = 0;
    std::uint64_t late_ = 0;  // of those, how many turned out to lie behind their range
    bool boxes_ = true, occlusion_ = true;  // EnginePass
    std::uint32_t stamp_ = 0;
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> met_;  // leaves whose changes stand in their slots
    struct MetBall {
        std::uint32_t ref;
        Event in, out;
    };
    std::vector<MetBall> met_balls_;  // items that were met as balls
    std::vector<Event> events_;
    std::vector<Changes> lists_;
    struct Tagged {
        Event event;
        std::uint32_t child;
    };
    std::vector<Tagged> sweep_;
};

}  // namespace whittle
