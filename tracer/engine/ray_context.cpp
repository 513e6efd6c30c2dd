// ray_context.cpp — frames, crossings and comparisons of one ray.
#include "tracer/engine/ray_context.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "tracer/engine/convex.h"

namespace whittle {

void RayContext::start(const Program& program, const Ray& ray, EngineCounters& counters) {
    // Grown and never cleared: another program asked in between is no harm, nor are stamps of an older ray.
    if (frame_stamps_.size() < program.frames.size()) {
        frame_stamps_.resize(program.frames.size());
        frame_rays_.resize(program.frames.size());
    }
    if (program.motions.size() > 1 && moved_.size() < program.frames.size()) moved_.resize(program.frames.size());
    program_ = &program;
    if (++stamp_ == 0) {
        std::fill(frame_stamps_.begin(), frame_stamps_.end(), 0);
        turned_.clear();
        stamp_ = 1;
    }
    ray_ = ray;
    if (mutated(Mutation::kEpsilonContinuation) && ray.departure != nullptr) {
        ray_.origin = point_at(ray, 1e-6);
        ray_.departure = nullptr;
    }
    counters_ = &counters;
    filter_ = program.makes(EnginePass::kFilter);
    exact_.clear();
    unsettled_.clear();
    root_ = ray_in_frame(program.frames[0], ray_);
    slab_ = slab_ray(root_.o, root_.d);
    has_towards_ = false;
    for (std::size_t i = 0; i < 3; ++i) regular_[i] = std::isnormal(slab_.inverse[i]) && std::isfinite(root_.o[i]);
    direct_ = filter_ && regular_[0] && regular_[1] && regular_[2];
}

namespace {

Placement whole_motion(const std::vector<MotionGroup>& motions, MotionId id, double time) {
    if (id == 0) return {};
    const MotionGroup& g = motions[id];
    return whole_motion(motions, g.parent, time) * g.outer * g.path.at(time);
}

bool same_bits(const Placement& a, const Placement& b) {
    return std::equal(a.m.begin(), a.m.end(), b.m.begin(), [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

}  // namespace

const Frame& RayContext::frame(FrameId id) {
    const Frame& f = program_->frames[id];
    if (f.motion == 0) return f;
    frame_ray(id);
    return moved_[id];
}

const FrameRay& RayContext::frame_ray(FrameId id) {
    if (id == 0) return root_;
    if (frame_stamps_[id] != stamp_) {
        frame_stamps_[id] = stamp_;
        const Frame& f = program_->frames[id];
        if (f.motion == 0) {
            frame_rays_[id] = ray_in_frame(f, ray_);
        } else {
            // Rays of one sample share its time: the inverse of the same placement is kept.
            const Placement motion = whole_motion(program_->motions, f.motion, ray_.time);
            if (f.section || !same_bits(moved_[id].placement, motion * f.placement)) moved_[id] = moved_frame(f, motion);
            if (moved_[id].twist != f.twist) moved_[id].twist = f.twist;
            if (moved_[id].body != f.body) moved_[id].body = f.body;
            frame_rays_[id] = ray_in_frame(moved_[id], ray_);
        }
    }
    return frame_rays_[id];
}

bool RayContext::is_transcendental(ClassId id) const {
    const Support& s = program_->classes[id];
    return whittle::is_transcendental(s.kind, program_->frames[s.frame]);
}

void RayContext::leave_unsettled(ClassId id) {
    if (!unsettled(id)) unsettled_.push_back(id);
}

FloatBox RayContext::place_of(const Event& e) const {
    FloatBox box;
    for (std::size_t i = 0; i < 3; ++i) {
        const double way = e.t * root_.d[i], at = root_.o[i] + way;
        const double room = 4 * kUnitRoundoff * (std::abs(root_.o[i]) + std::abs(way)) + 2 * e.error * std::abs(root_.d[i]);
        const auto lo = static_cast<float>(at - room), hi = static_cast<float>(at + room);
        box.lo[i] = lo - std::abs(lo) * 0x1p-22f - std::numeric_limits<float>::min();
        box.hi[i] = hi + std::abs(hi) * 0x1p-22f + std::numeric_limits<float>::min();
    }
    return box;
}

bool RayContext::crossings(const CellSlabs& slabs, Event& in, Event& out) const {
    if (!direct_) return false;
    if (ray_.departure != nullptr)
        for (const auto& pair : slabs.id)
            if (leaves(pair[0]) || leaves(pair[1])) return false;
    std::array<double, 3> begin, end;
    for (std::size_t i = 0; i < 3; ++i) {
        begin[i] = (slabs.at[i][slab_.negative[i]] - root_.o[i]) * slab_.inverse[i];
        end[i] = (slabs.at[i][1u - slab_.negative[i]] - root_.o[i]) * slab_.inverse[i];
    }
    const auto greater = [&](std::size_t i, std::size_t k) { return begin[i] > begin[k] ? i : k; };
    const auto lesser = [&](std::size_t i, std::size_t k) { return end[i] < end[k] ? i : k; };
    const std::size_t last = greater(2, greater(1, 0)), first = lesser(2, lesser(1, 0));
    // Bounds are 4 u |t|: as |x| <= |t| + gap, those of t and x are less than the gap together where it exceeds 12 u |t|.
    const double of_begin = 12 * kUnitRoundoff * std::abs(begin[last]), of_end = 12 * kUnitRoundoff * std::abs(end[first]);
    int close = 0;
    for (std::size_t i = 0; i < 3; ++i) close += !(begin[last] - begin[i] > of_begin) + !(end[i] - end[first] > of_end);
    if (close != 2) return false;
    const auto event = [&](std::size_t i, std::size_t side) {
        double t = 0, error = 0;
        single::axis_plane_crossing<double>(slabs.at[i][side], root_.o[i], slab_.inverse[i], t, error);
        return Event(t, mutated(Mutation::kNoBounds) ? 0 : error, slabs.id[i][side]);
    };
    in = event(last, slab_.negative[last]);
    out = event(first, 1u - slab_.negative[first]);
    return true;
}

void RayContext::curved_crossings(ClassId id, const Support& s, Crossings& out) {
    if (!has_polynomial(s.kind)) return shared_crossings(id, s, out);
    const FrameRay& local = frame_ray(s.frame);
    const bool decided = leaves(id) ? filtered_departure(s, local, out) : filtered_crossings(s, local, out);
    counters_->skipped_by(EnginePass::kFilter) += decided && filter_;
    if (decided || !kCertifies) return;
    ++counters_->escalated_double_double;
    if (!fine_crossings(s, frame(s.frame), ray_, leaves(id), out) && !mutated(Mutation::kNoExactTier)) out = exact(id).crossings;
}

void RayContext::shared_crossings(ClassId id, const Support& s, Crossings& out) {
    TurnedMemory::Side& side = turned_.side(id, stamp_);
    if (side.stamp != stamp_) {
        side.id = id;
        side.stamp = stamp_;
        is_turned(s.kind) ? find_turned(id, s, side.crossings) : find_convex(id, s, side.crossings);
    }
    out = side.crossings;
}

void RayContext::find_convex(ClassId id, const Support& s, Crossings& out) {
    if (convex_crossings(frame(s.frame), frame_ray(s.frame), leaves(id), out) || mutated(Mutation::kNoExactTier)) return;
    leave_unsettled(id);
    unsettled_convex(frame(s.frame), ray_, leaves(id), out);
}

void RayContext::find_turned(ClassId id, const Support& s, Crossings& out) {
    TurnedMemory::Piece& piece = turned_.piece(s.frame, stamp_);
    if (piece.stamp != stamp_) {
        const FrameRay& local = frame_ray(s.frame);
        piece.frame = s.frame;
        piece.stamp = stamp_;
        piece.in_double = turned_series(*frame(s.frame).twist, local, piece.series);
    }
    if (piece.in_double && series_crossings(s, *frame(s.frame).twist, piece.series, frame_ray(s.frame), leaves(id), out)) {
        counters_->skipped_by(EnginePass::kFilter) += filter_;
        return;
    }
    ++counters_->escalated_double_double;
    if (fine_turned(s, frame(s.frame), ray_, leaves(id), out) || mutated(Mutation::kNoExactTier)) return;
    if (!is_transcendental(id)) {
        out = exact(id).crossings;
        return;
    }
    leave_unsettled(id);
    unsettled_turned(s, frame(s.frame), ray_, leaves(id), out);
}

// The steps of filtered_crossings(), with what balls have in common taken once.
bool RayContext::crossings(const ItemBall& ball, Crossings& out) {
    if (ray_.departure != nullptr && leaves(ball.id)) return false;
    if (!has_towards_) {
        towards_ = single::round_direction<double, 3>(root_.d, root_.ed);
        has_towards_ = true;
    }
    const auto c = single::round_crossing<double, 3>({root_.o[0] - ball.x, root_.o[1] - ball.y, root_.o[2] - ball.z}, root_.eo, towards_, ball.r);
    out.count = c.met ? 2 : 0;
    out.first_sign = c.within ? -1 : 1;
    out.t = {c.t0, c.t1, 0, 0};
    out.error = {c.error0, c.error1, 0, 0};
    if (mutated(Mutation::kNoBounds)) out.error = {};
    counters_->skipped_by(EnginePass::kFilter) += (c.met || c.missed) && filter_;
    return c.met || c.missed;
}

const RayContext::Exact& RayContext::exact(ClassId id) {
    for (const Exact& e : exact_)
        if (e.id == id) return e;
    const Support& s = program_->classes[id];
    Exact e;
    e.id = id;
    ++counters_->escalated_exact;
    e.roots = exact_crossings(s, frame(s.frame), ray_, leaves(id), e.crossings);
    exact_.push_back(std::move(e));
    return exact_.back();
}

bool RayContext::fine(const Event& e, double& high, double& low, double& error) {
    if (e.id() == kNoClass) {
        high = e.t;
        low = error = 0;
        return true;
    }
    const Support& s = program_->classes[e.id()];
    if (is_turned(s.kind)) return fine_turned(s, frame(s.frame), ray_, leaves(e.id()), e.index(), high, low, error);
    if (!has_polynomial(s.kind)) return high = e.t, low = 0, error = e.error, true;  // a convex body is known no better
    return fine_crossing(s, frame(s.frame), ray_, leaves(e.id()), e.index(), high, low, error);
}

int RayContext::compare_closely(const Event& a, const Event& b) {
    if (a.id() == b.id()) return a.id() == kNoClass ? (a.t > b.t) - (a.t < b.t) : (a.index() > b.index()) - (a.index() < b.index());
    if ((a.error == 0 && b.error == 0) || !kCertifies) return (a.t > b.t) - (a.t < b.t);
    ++counters_->escalated_double_double;
    double ah = 0, al = 0, ae = 0, bh = 0, bl = 0, be = 0;
    if (fine(a, ah, al, ae) && fine(b, bh, bl, be)) {
        const double d = (ah - bh) + (al - bl), room = ae + be + 0x1p-100 * (std::abs(ah) + std::abs(bh));
        if (d > room) return 1;
        if (d < -room) return -1;
    }
    return compare_exactly(a, b);
}

int RayContext::compare_exactly(const Event& a, const Event& b) {
    if (mutated(Mutation::kNoExactTier)) return (a.t > b.t) - (a.t < b.t);
    // There is no exact form of a twisted side or a convex body: what bounds cannot tell apart is one place.
    for (const Event* e : {&a, &b}) {
        if (e->id() == kNoClass || !is_transcendental(e->id())) continue;
        leave_unsettled(e->id());
        return 0;
    }
    ++counters_->escalated_exact;
    if (a.id() == kNoClass) return -compare_exactly(b, a);
    const exact::RealRoot first = exact(a.id()).roots[a.index()];
    if (b.id() == kNoClass) return b.t == 0 ? first.sign() : exact::RealRoot::compare(first, exact::RealRoot::at(exact::Dyadic(b.t)));
    return exact::RealRoot::compare(first, exact(b.id()).roots[b.index()]);
}

}  // namespace whittle
