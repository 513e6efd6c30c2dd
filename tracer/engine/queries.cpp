// queries.cpp — first hit, any hit, all spans: the walker's events made into borders with normals and labels.
#include <algorithm>

#include "tracer/engine/gradient.h"
#include "tracer/engine/mutation.h"
#include "tracer/engine/scratch.h"

namespace whittle {

Scratch::Scratch() : impl(std::make_unique<Impl>()) {}
Scratch::~Scratch() = default;
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;

namespace {

Event origin(bool before) { return {0, 0, kNoClass, 0, before}; }

// Only uses below the fewest subtractions count: what a cutter merely touches has a face of its own there. Bodies: the first. Cutters: the first of the
// outermost difference that names its surface; where none does, the use whose matter is left (docs/numerics.md, labels).
std::uint32_t shown_use(const Program& program, Walker& walker, const std::vector<Walker::Cause>& causes, const Event& at, bool entering) {
    if (causes.size() == 1 && program.leaves[causes[0].leaf].fills) return program.leaves[causes[0].leaf].use;
    constexpr std::uint32_t kNone = Walker::kNoLeafUse;
    std::uint32_t first = kNone, named = kNone;
    for (const Walker::Cause& c : causes) {
        const std::uint32_t use = program.leaves[c.leaf].use;
        const LeafUse& u = program.uses[use];
        if (first != kNone && u.subtractions > program.uses[first].subtractions) continue;
        const bool fewer = first == kNone || u.subtractions < program.uses[first].subtractions;
        if (fewer) named = kNone;
        first = fewer ? use : std::min(first, use);
        if (!u.material->names_surface()) continue;
        if (named == kNone || u.cut_depth < program.uses[named].cut_depth) named = use;
    }
    if (first != kNone && !program.uses[first].subtracts) return first;
    if (named != kNone) return named;
    if (program.flat && program.flat_matter != kNone) return program.flat_matter;
    const std::uint32_t held = walker.matter_at(program.root, Event::beside(at, !entering));
    return held != kNone ? held : first;
}

// Of the ray's reach: events whose t is known no better do not stand for a border that another of its events knows better.
constexpr double kPoorlyKnown = 0x1p-40;

bool is_before(const Event& a, const Event& b) { return a.id() < b.id() || (a.id() == b.id() && a.index() < b.index()); }

// Of the events that make a border at one place the first by class stands for it, however they were found; but not one whose plane the ray all but lies in, if
// there are others: its t is off by far more than theirs.
Event border_of(const std::vector<Walker::Cause>& causes, const Ray& ray, const Event& e) {
    if (causes.empty()) return Event::beside(e, false);
    const Event* first = &causes[0].event;
    double least = first->error;
    for (const Walker::Cause& c : causes) {
        if (is_before(c.event, *first)) first = &c.event;
        least = std::min(least, c.event.error);
    }
    const auto size = [](const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    const double poor = kPoorlyKnown * (std::abs(e.t) + size(ray.origin) / size(ray.direction));
    if (!(first->error > poor) || !(least <= poor)) return Event::beside(*first, false);
    for (const Walker::Cause& c : causes)
        if (c.event.error <= poor && (first->error > poor || is_before(c.event, *first))) first = &c.event;
    return Event::beside(*first, false);
}

// The border at `e`, which becomes the event that stands for it; its causes are left in `impl`.
void make_end(const Program& program, Scratch::Impl& impl, const Ray& ray, Event& e, bool entering, End& end) {
    impl.causes.clear();
    e = Event::beside(e, false);
    Walker::Cause sole;
    const ItemBall* ball = nullptr;
    if (impl.walker.sole_cause(e, sole, ball)) {
        impl.causes.push_back(sole);
    } else {
        impl.walker.causes(program.root, e, impl.causes);
    }
    if (impl.causes.empty() && !mutated(Mutation::kCausesInBoxesOnly)) impl.walker.causes_among_met(e, impl.causes);
    e = border_of(impl.causes, ray, e);
    end.t = std::max(e.t, 0.0);  // the exact t is not negative: still within the bound
    end.t_error = e.error;
    end.surface = e.id();
    end.certified = impl.walker.are_certain(impl.causes);
    if (!end.certified) ++impl.walker.context().counters().uncertified;
    end.use = shown_use(program, impl.walker, impl.causes, e, entering);
    const Vec3 point = point_at(ray, e.t);
    if (ball) {
        end.normal = unit_vector(point - Vec3(ball->x, ball->y, ball->z));  // its support's, which is far away in memory
    } else {
        const Support& support = program.classes[end.surface];
        end.normal = unit_gradient(support, impl.walker.context().frame(support.frame), point);
    }
    const double along = glm::dot(end.normal, ray.direction);
    if ((along > 0) == entering) end.normal = -end.normal;
}

// The classes that make a border: in order, the first of them if there are many.
void depart_from(const std::vector<Walker::Cause>& causes, Departure& d) {
    d = {};
    for (const Walker::Cause& c : causes) {
        const auto end = d.classes.begin() + d.count, at = std::lower_bound(d.classes.begin(), end, c.event.id());
        if (at == d.classes.end() || (at != end && *at == c.event.id())) continue;
        if (d.count < static_cast<int>(d.classes.size())) ++d.count;
        std::copy_backward(at, d.classes.begin() + d.count - 1, d.classes.begin() + d.count);
        *at = c.event.id();
    }
}

Found first_event(const Program& program, Walker& walker, const Event& start, bool& from_inside, Event& e) {
    Found found = walker.next(program.root, start, true, e);
    // Inside up to an exit at t = 0 is outside: the walk begins behind it.
    if (found == Found::kHere && start.before()) found = walker.next(program.root, origin(false), true, e);
    from_inside = found == Found::kHere;
    return from_inside ? walker.next(program.root, origin(false), false, e) : found;
}

// The same among all borders of the ray.
Found first_of_all(const Program& program, Walker& walker, const Event& start, bool& from_inside, Event& e) {
    const Walker::Changes changes = walker.all_changes(program.root);
    bool inside = changes.initial;
    std::uint32_t i = 0;
    for (; i < changes.count; ++i) {
        e = walker.change(changes.first + i);
        const int where = walker.context().compare(e, origin(false));
        if (where > 0 || (where == 0 && start.before() && !inside)) break;
        inside = !inside;
    }
    from_inside = inside;
    return i < changes.count ? Found::kLater : Found::kNever;
}

}  // namespace

bool first_hit(const Program& program, const Ray& ray, double t_max, Scratch& scratch, Hit& hit) {
    if (program.empty || program.everything) return false;
    Scratch::Impl& impl = *scratch.impl;
    ++scratch.counters.spans_evaluated;
    const Event start = origin(ray.departure == nullptr);
    const bool first_only = program.makes(EnginePass::kFirst);
    if (first_only) ++scratch.counters.skipped_by(EnginePass::kFirst);
    Event e;
    const auto ask = [&](double far) {
        impl.walker.start(program, ray, scratch.counters, far);
        return (first_only ? first_event : first_of_all)(program, impl.walker, start, hit.from_inside, e) == Found::kLater && e.t <= t_max;
    };
    if (!ask(t_max)) return false;
    // An event whose t is only known to lie about there may lie beyond the limit, and then others, left out for the limit, before it.
    if (impl.walker.context().compare(e, {t_max, 0, kNoClass}) > 0 && !ask(HUGE_VAL)) return false;
    make_end(program, impl, ray, e, !hit.from_inside, hit.end);
    hit.point = point_at(ray, e.t);
    depart_from(impl.causes, hit.departure);
    return true;
}

bool any_hit(const Program& program, const Ray& ray, double t_max, Scratch& scratch) {
    if (program.empty) return false;
    if (program.everything) return true;
    if (!program.makes(EnginePass::kAny)) {
        Hit hit;
        const bool found = first_hit(program, ray, t_max, scratch, hit);
        return hit.from_inside || (found && hit.end.t < t_max);
    }
    Walker& walker = scratch.impl->walker;
    ++scratch.counters.spans_evaluated;
    ++scratch.counters.skipped_by(EnginePass::kAny);
    walker.start(program, ray, scratch.counters, t_max);
    return walker.meets(program.root, origin(false));
}

void all_spans(const Program& program, const Ray& ray, Scratch& scratch, Spans& spans) {
    spans.clear();
    if (program.empty) return;
    if (program.everything) {
        spans.emplace_back();
        return;
    }
    Scratch::Impl& impl = *scratch.impl;
    Walker& walker = impl.walker;
    ++scratch.counters.spans_evaluated;
    walker.start(program, ray, scratch.counters, HUGE_VAL);
    const Walker::Changes changes = walker.all_changes(program.root);
    bool inside = changes.initial;
    bool open = false;
    const auto open_span = [&] {
        spans.emplace_back();
        open = true;
    };
    // Ends closer than rounding keep their order in t too: the exact t lies between the last end's and this one's, each within its bound.
    double last_t = 0, last_error = 0;
    const auto ascending = [&](Event e, bool entering) {
        End end;
        make_end(program, impl, ray, e, entering, end);
        if (end.t < last_t) {
            end.t = last_t;
            end.t_error = std::max(end.t_error, last_error);
        }
        last_t = end.t;
        last_error = end.t_error;
        return end;
    };
    bool started = false;
    for (std::uint32_t i = 0; i < changes.count; ++i) {
        Event e = walker.change(changes.first + i);
        const int where = walker.context().compare(e, origin(false));
        if (where < 0 || (where == 0 && ray.departure != nullptr)) {
            inside = !inside;
            continue;
        }
        if (!started && inside && where > 0) open_span();
        started = true;
        inside = !inside;
        if (inside) {
            open_span();
            spans.back().in = ascending(e, true);
        } else if (open) {
            spans.back().out = ascending(e, false);
            open = false;
        }
    }
    if (!started && inside) open_span();
}

}  // namespace whittle
