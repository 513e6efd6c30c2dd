// compare.cpp — see compare.h.
#include "tests/stress/compare.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/span/perturbation.h"
#include "tests/stress/lowered.h"
#include "tracer/engine/program.h"
#include "tracer/engine/scratch.h"

namespace whittle::stress {

namespace {

using reference::Border;
using reference::Borders;
using reference::Dyadic;
using support::to_text;

double about(const Border& b) { return middle(b.lo, b.hi).to_double(); }

std::string described(const Borders& b) {
    std::string text = b.starts_inside ? "[inside]" : "";
    for (const Border& x : b.borders) text += fmt::format(" {}{:.17g}", x.entering ? "+" : "-", about(x));
    return text;
}

std::string described(const Spans& spans) {
    std::string text;
    for (const Span& s : spans) {
        text += s.in ? fmt::format(" +{:.17g}", s.in->t) : " [inside]";
        text += s.out ? fmt::format(" -{:.17g}", s.out->t) : " ...";
    }
    return text;
}

struct Met {
    End end;
    bool entering;
};

// The spans as borders; `inside`: the first has no `in`.
std::vector<Met> flattened(const Spans& spans, bool& inside, std::string& fault) {
    std::vector<Met> r;
    inside = !spans.empty() && !spans[0].in;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (spans[i].in) r.push_back({*spans[i].in, true});
        else if (i > 0) fault = "a later span has no in";
        if (spans[i].out) r.push_back({*spans[i].out, false});
        else if (i + 1 < spans.size()) fault = "an earlier span has no out";
    }
    for (std::size_t i = 1; i < r.size(); ++i)
        if (r[i].end.t < r[i - 1].end.t - r[i].end.t_error - r[i - 1].end.t_error) fault = "ends are out of order";
    return r;
}

// Bounds are doubles: what is left below the least of them no double tells.
bool within(const End& end, const Border& b) {
    const Dyadic t(end.t), e = Dyadic(end.t_error) + Dyadic(0x1p-1074);
    return b.lo <= t + e && t - e <= b.hi;
}

// A border belongs to a use that changes there; a cut that names no matter of its own belongs to what it cuts.
std::string use_fault(const Subject& subject, const End& end, const Border& b) {
    const auto& uses = leaf_uses(*subject.program);
    if (end.use >= uses.size()) return "no such use";
    const auto changes = [&](std::uint32_t leaf) { return subject.use_of_leaf[leaf] == end.use; };
    const auto subtracts = [&](std::uint32_t leaf) { return uses[subject.use_of_leaf[leaf]].subtracts; };
    if (std::any_of(b.leaves.begin(), b.leaves.end(), changes)) return {};
    if (std::any_of(b.leaves.begin(), b.leaves.end(), subtracts) && !uses[end.use].subtracts) return {};
    return fmt::format("use {} does not change there", end.use);
}

// Does the program hold leaves that stand for a curved surface? Only their ends may be uncertified.
bool may_be_uncertified(const Program& program) {
    if (std::any_of(program.classes.begin(), program.classes.end(), [](const Support& s) { return s.kind == SupportKind::kConvex; })) return true;
    return std::any_of(program.leaves.begin(), program.leaves.end(), [](const Leaf& leaf) { return !leaf.exact; });
}

std::string end_fault(const Subject& subject, const Ray& ray, const End& end, const Border& b, Tally& tally) {
    if (!std::isfinite(end.t) || !std::isfinite(end.t_error) || end.t < 0 || end.t_error < 0) return "t or t_error is no such number";
    if (!end.certified && !may_be_uncertified(*subject.program)) ++tally.uncertified;
    if (end.certified && !within(end, b)) return fmt::format("t {:.17g} is off by {:.3g}, t_error {:.3g}", end.t, end.t - about(b), end.t_error);
    if (end.certified && end.t_error > 0) tally.worst_ratio = std::max(tally.worst_ratio, std::abs((Dyadic(end.t) - b.lo).to_double()) / end.t_error);
    if (!(std::abs(length(end.normal) - 1) < 1e-9)) return "the normal is not of length 1";
    const double against = dot(end.normal, ray.direction) / length(ray.direction);
    if (b.entering ? against > 1e-6 : against < -1e-6) return fmt::format("the normal faces the wrong way: {:.3g}", against);
    return use_fault(subject, end, b);
}

bool leaves_undecided(const Subject& subject, Scratch& scratch) {
    return std::any_of(subject.bodies.begin(), subject.bodies.end(), [&](ClassId id) { return scratch.impl->walker.context().unsettled(id); });
}

std::string spans_fault(const Subject& subject, const Ray& ray, const Borders& want, Scratch& scratch, double& first_error, Tally& tally) {
    Spans spans;
    all_spans(*subject.program, ray, scratch, spans);
    const auto fail_with = [&](const std::string& why) { return fmt::format("all_spans: {}\n  engine   {}\n  reference{}", why, described(spans), described(want)); };
    bool inside = false;
    std::string fault;
    const std::vector<Met> met = flattened(spans, inside, fault);
    if (!fault.empty()) return fail_with(fault);
    if (met.size() != want.borders.size()) return fail_with("another number of borders");
    if (!met.empty()) first_error = met[0].end.t_error;
    const bool enters_at_zero = !want.borders.empty() && want.borders[0].entering;
    if (inside != (want.starts_inside && !enters_at_zero)) return fail_with("another start");
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (met[i].entering != want.borders[i].entering) return fail_with("another direction");
        if (std::string why = end_fault(subject, ray, met[i].end, want.borders[i], tally); !why.empty()) return fail_with(why);
    }
    return {};
}

std::string first_hit_fault(const Subject& subject, const Ray& ray, const Borders& want, double t_max, Scratch& scratch, Tally& tally) {
    Hit hit;
    const bool found = first_hit(*subject.program, ray, t_max, scratch, hit);
    const auto fail_with = [&](const std::string& why) { return fmt::format("first_hit up to {:.17g}: {}\n  reference{}", t_max, why, described(want)); };
    const bool wanted = !want.borders.empty() && want.borders[0].hi <= Dyadic(std::min(t_max, 0x1p1000));
    if (found != wanted) return fail_with(found ? fmt::format("hit at {:.17g}", hit.end.t) : "nothing");
    if (!found) return {};
    if (hit.from_inside != !want.borders[0].entering) return fail_with("another direction");
    const std::string why = end_fault(subject, ray, hit.end, want.borders[0], tally);
    return why.empty() ? why : fail_with(why);
}

std::string any_hit_fault(const Subject& subject, const Ray& ray, const Borders& want, double t_max, Scratch& scratch) {
    const bool enters_before = !want.borders.empty() && want.borders[0].entering && want.borders[0].hi < Dyadic(std::min(t_max, 0x1p1000));
    const bool wanted = want.starts_inside || enters_before;
    if (any_hit(*subject.program, ray, t_max, scratch) == wanted) return {};
    return fmt::format("any_hit up to {:.17g}: not {}\n  reference{}", t_max, wanted, described(want));
}

// A little way along, a ray that leaves a surface is where the plain ray is that starts there.
bool is_plausible(const Subject& subject, const Ray& leaving, const Borders& want) {
    const double way = 0x1p-20 * (1e-3 + length(leaving.origin)) / length(leaving.direction);
    bool inside = want.starts_inside;
    for (const Border& b : want.borders) {
        if (about(b) > way * 0.5 && about(b) < way * 2) return true;
        if (about(b) < way) inside = b.entering;
    }
    Ray there;
    there.origin = leaving.origin + leaving.direction * way;
    there.direction = leaving.direction;
    return subject.exact->borders(there).starts_inside == inside;
}

// Borders less the intervals (inside or outside) shorter than `least`.
std::vector<Border> without_slivers(const Borders& b, double least) {
    std::vector<Border> r;
    for (const Border& x : b.borders) {
        if (!r.empty() && about(x) - about(r.back()) < least) r.pop_back();
        else r.push_back(x);
    }
    if (!r.empty() && about(r[0]) < least) r.erase(r.begin());
    return r;
}

bool alike(const std::vector<Border>& a, const std::vector<Border>& b, double room) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Border& p, const Border& q) {
        const double apart = std::max((p.lo - q.hi).to_double(), (q.lo - p.hi).to_double());
        return p.entering == q.entering && apart <= room + 1e-9 * std::abs(about(p));
    });
}

// Are the borders near those of the ray, or of one moved by less than 2^-20 of the solid's size?
bool is_near(const Subject& subject, const Ray& ray, const Spans& spans, const Borders& want, std::mt19937_64& random) {
    const Bounds box = program_bounds(*subject.program);
    const double size = length(box.hi - box.lo), room = 0x1p-10 * size / length(ray.direction);
    Borders have;
    have.starts_inside = !spans.empty() && !spans[0].in;
    const auto border = [](const End& e, bool entering) {
        const Dyadic error(std::isfinite(e.t_error) ? e.t_error : 0);
        return Border{Dyadic(e.t) - error, Dyadic(e.t) + error, entering, {}, {}};
    };
    for (const Span& s : spans) {
        if (s.in) have.borders.push_back(border(*s.in, true));
        if (s.out) have.borders.push_back(border(*s.out, false));
    }
    const auto plain = without_slivers(have, room);
    if (alike(plain, without_slivers(want, room), room)) return true;
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 60; ++i) {
        Ray moved = ray;
        const double step = size * std::ldexp(1.0, -50 + i / 2);
        const Vec3 way = i % 2 == 0 ? kPerturbation[0] / length(kPerturbation[0]) : Vec3(uniform(random), uniform(random), uniform(random));
        moved.origin += step * way;
        if (alike(plain, without_slivers(subject.exact->borders(moved), room), room)) return true;
    }
    return false;
}

}  // namespace

Subject subject_of(const Solid& solid, bool snap) {
    Subject s;
    s.snap = snap;
    EngineOptions options;
    options.snap = snap;
    auto program = compile(solid, options);
    if (!program) {
        s.failure = program.error().message;
        return s;
    }
    auto formula = lowered(solid, snap);
    if (!formula) {
        s.failure = formula.error().message;
        return s;
    }
    s.program = *program;
    s.exact = std::make_unique<reference::Evaluator>(std::move(formula->tree));
    s.use_of_leaf = std::move(formula->use_of_leaf);
    s.support_of_class = std::move(formula->support_of_class);
    for (ClassId id = 0; id < s.program->classes.size(); ++id)
        if (s.program->classes[id].kind == SupportKind::kConvex) s.bodies.push_back(id);
    return s;
}

std::string disagreement(const Subject& subject, const Ray& ray, Scratch& scratch, std::mt19937_64& random, Tally& tally) {
    const Borders want = subject.exact->borders(ray);
    ++tally.pairs;
    tally.borders += want.borders.size();
    tally.from_inside += want.starts_inside;
    double first_error = 0;
    std::string why = spans_fault(subject, ray, want, scratch, first_error, tally);
    if (!subject.bodies.empty()) {
        Spans spans;
        all_spans(*subject.program, ray, scratch, spans);
        ++tally.body_rays;
        if (leaves_undecided(subject, scratch)) {
            ++tally.undecided;
            tally.loose += !why.empty();
            return why.empty() || is_near(subject, ray, spans, want, random) ? std::string() : "undecided, and not near: " + why;
        }
    }
    // No limit, and limits before and after the first border, further from it than its bound.
    std::vector<double> limits{HUGE_VAL};
    if (!want.borders.empty()) {
        const double first = about(want.borders[0]);
        limits.push_back(first * 0.5);
        limits.push_back(first * (1 + std::uniform_real_distribution<double>(0x1p-20, 2)(random)));
    }
    for (const double t_max : limits) {
        if (!(t_max > 0) || (std::isfinite(t_max) && !(std::abs(t_max - about(want.borders[0])) > 2 * first_error))) continue;
        if (why.empty()) why = first_hit_fault(subject, ray, want, t_max, scratch, tally);
        if (why.empty()) why = any_hit_fault(subject, ray, want, t_max, scratch);
    }
    return why;
}

std::string continuation_disagreement(const Subject& subject, const Ray& ray, Scratch& scratch, std::mt19937_64& random, Tally& tally) {
    Hit hit;
    // Without the snap coincident surfaces may be two classes, of which the hit names one: then leaving is not defined to the last bit.
    if (!subject.snap || !first_hit(*subject.program, ray, HUGE_VAL, scratch, hit)) return {};
    if (!hit.end.certified) return {};  // the place may lie further off the surface than rounding
    const auto& departure = hit.departure;
    if (departure.count == 0) return "a hit names no class to leave";
    const auto is_body = [&](ClassId id) { return std::find(subject.bodies.begin(), subject.bodies.end(), id) != subject.bodies.end(); };
    if (std::any_of(departure.classes.begin(), departure.classes.begin() + departure.count, is_body)) return {};  // many surfaces of the reference: convex_test.cpp
    if (departure.count == static_cast<int>(departure.classes.size())) return {};  // perhaps more are tied than it holds
    std::uniform_real_distribution<double> uniform(-1, 1);
    Ray next;
    next.origin = hit.point;
    next.departure = &departure;
    do next.direction = {uniform(random), uniform(random), uniform(random)};
    while (dot(next.direction, next.direction) < 0.01);
    std::set<std::uint32_t> leaving;
    for (int i = 0; i < departure.count; ++i) leaving.insert(subject.support_of_class[departure.classes[static_cast<std::size_t>(i)]]);
    // Halves of one curve, with control points of their own, are two classes of the engine and one support here: leaving one is then not leaving it.
    const auto end = departure.classes.begin() + departure.count;
    for (ClassId id = 0; id < subject.support_of_class.size(); ++id)
        if (leaving.count(subject.support_of_class[id]) != 0 && std::find(departure.classes.begin(), end, id) == end) return {};
    const Borders want = subject.exact->borders(next, leaving);
    ++tally.continued;
    const auto told = [&](const std::string& why) { return fmt::format("leaving at {:.17g} in {}: {}", hit.end.t, to_text(next), why); };
    if (!is_plausible(subject, next, want)) return told("the reference starts on the wrong side");
    double first_error = 0;
    std::string why = spans_fault(subject, next, want, scratch, first_error, tally);
    if (leaves_undecided(subject, scratch)) return {};
    if (why.empty()) why = first_hit_fault(subject, next, want, HUGE_VAL, scratch, tally);
    if (why.empty()) why = any_hit_fault(subject, next, want, HUGE_VAL, scratch);
    return why.empty() ? why : told(why);
}

std::string loose_disagreement(const reference::Evaluator& a, const reference::Evaluator& b, const Ray& ray, double size, std::mt19937_64& random,
                               Tally& tally) {
    const double unit = size / length(ray.direction);
    const auto plain = [&](const Borders& x) { return without_slivers(x, 1e-9 * unit); };
    const Borders left = a.borders(ray), right = b.borders(ray);
    ++tally.pairs;
    tally.borders += left.borders.size();
    if (alike(plain(left), plain(right), 1e-8 * unit)) return {};
    for (int i = 0; i < 64; ++i) {
        Ray moved = ray;
        const double step = std::pow(10.0, -12 - i % 6);
        std::uniform_real_distribution<double> little(-step, step);
        for (int k = 0; k < 3; ++k) {
            moved.origin[k] += little(random) * (size + length(ray.origin));
            moved.direction[k] += little(random) * length(ray.direction);
        }
        if (!alike(plain(left), plain(a.borders(moved)), 1e-8 * unit) || alike(plain(left), plain(b.borders(moved)), 1e-8 * unit)) {
            ++tally.masked;
            return {};
        }
    }
    return fmt::format("the solid{}\n  its formula{}", described(left), described(right));
}

}  // namespace whittle::stress
