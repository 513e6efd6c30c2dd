// identity.cpp — classes of coinciding supports.
#include "tracer/engine/identity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "tracer/engine/convex.h"
#include "tracer/engine/mutation.h"
#include "tracer/engine/ordered_set.h"
#include "tracer/engine/turned.h"
#include "tracer/engine/world_surface.h"

namespace whittle {

namespace {

bool touching(const Bounds& a, const Bounds& b, double room) {
    for (int i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] + room || b.lo[i] > a.hi[i] + room) return false;
    return true;
}

double finite_extent(const Bounds& a) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        const double x = a.hi[i] - a.lo[i];
        if (std::isfinite(x)) most = std::max(most, x);
    }
    return most;
}

class Finder {
public:
    Finder(const SupportTable& table, bool snap) : table_(table), snap_(snap), founders_(table.supports.size() + 1) {
        if (!snap) return;
        spread_ = most_keys_differ();
        sort_keys();
    }

    Classes run() {
        for (SupportId id = 0; id < table_.supports.size(); ++id) has_polynomial(table_.supports[id].kind) ? place(id) : place_turned(id);
        return std::move(out_);
    }

private:
    // Of supports with a polynomial, ascending.
    void sort_keys() {
        for (SupportId id = 0; id < table_.supports.size(); ++id) {
            if (!has_polynomial(table_.supports[id].kind)) continue;
            const double key = key_of(surface(id));
            by_key_.push_back({std::isfinite(key) ? key : HUGE_VAL, id});  // what overflows is compared with all
        }
        std::sort(by_key_.begin(), by_key_.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key || (a.key == b.key && a.id < b.id); });
        rank_.resize(table_.supports.size());
        for (std::size_t k = 0; k < by_key_.size(); ++k) rank_[by_key_[k].id] = static_cast<std::uint32_t>(k);
    }

    WorldSurface surface(SupportId id) const { return world_surface(table_.supports[id], table_.frames[table_.supports[id].frame]); }

    // The class is that of the first support that agrees, or a new one, whose founder this is.
    void place(SupportId id) {
        const auto fresh = static_cast<ClassId>(out_.supports.size());
        ClassOfSupport best{fresh, false};
        if (snap_) {
            const std::size_t rank = rank_[id];
            const double key = by_key_[rank].key, window = kKeyRounding * (1 + std::abs(key)) + spread_;
            const bool apart = rank == 0 || by_key_[rank - 1].key < key - window;
            look_among(id, apart ? rank : first_at_least(key - window), key + window, best);
            if (is_plane(table_.supports[id].kind)) look_among(id, first_at_least(-key - window), -key + window, best);
        }
        if (best.id == fresh) {
            out_.supports.push_back(table_.supports[id]);
            if (snap_) founders_.insert(rank_[id]);
        } else {
            ++out_.fused;
        }
        out_.of.push_back(best);
    }

    std::size_t first_at_least(double key) const {
        return static_cast<std::size_t>(std::lower_bound(by_key_.begin(), by_key_.end(), key, [](const Keyed& a, double least) { return a.key < least; }) - by_key_.begin());
    }

    // Among founders from this rank on whose keys are at most `most`.
    void look_among(SupportId id, std::size_t first, double most, ClassOfSupport& best) {
        std::optional<WorldSurface> own;
        for (std::size_t k = founders_.next(first); k < by_key_.size() && by_key_[k].key <= most; k = founders_.next(k + 1)) {
            const SupportId founder = by_key_[k].id;
            const ClassId c = out_.of[founder].id;
            bool flipped = false;
            double distance = 0;
            if (c >= best.id || !may_agree(founder, id)) continue;
            if (!own) own = surface(id);
            if (!agree(founder, id, *own, flipped, distance)) continue;
            best = {c, flipped};
            out_.largest = std::max(out_.largest, distance);
        }
    }

    // Turned sides and convex bodies.
    void place_turned(SupportId id) {
        const Support& s = table_.supports[id];
        const Frame& frame = table_.frames[s.frame];
        ClassOfSupport best{static_cast<ClassId>(out_.supports.size()), false};
        double key = 0;
        if (snap_) {
            const Vec3 at = is_turned(s.kind) ? turned_middle(frame) : convex_middle(frame);
            key = 0.6180339887 * at.x + 0.7548776662 * at.y + 0.5698402910 * at.z;
            const double window = kKeyRounding * (1 + std::abs(key)) + spread_;
            const auto to = turned_.upper_bound(key + window);
            for (auto it = turned_.lower_bound(key - window); it != to; ++it) {
                bool flipped = false;
                double distance = 0;
                if (it->second.first < best.id && turned_agree(it->second.second, id, flipped, distance)) {
                    best = {it->second.first, flipped};
                    out_.largest = std::max(out_.largest, distance);
                }
            }
        }
        if (best.id == out_.supports.size()) {
            out_.supports.push_back(s);
            if (snap_) turned_.emplace(key, std::pair{best.id, id});
        } else {
            ++out_.fused;
        }
        out_.of.push_back(best);
    }

    bool turned_agree(SupportId first, SupportId id, bool& flipped, double& distance) const {
        const Support &s = table_.supports[id], &t = table_.supports[first];
        if (s.kind != t.kind || table_.frames[s.frame].motion != table_.frames[t.frame].motion) return false;
        const Occurrence &a = table_.occurrences[id], &b = table_.occurrences[first];
        const double tolerance = kSnapTolerance * std::max(finite_part(a.extent), finite_part(b.extent)) + a.rounding + b.rounding;
        if (!touching(a.box, b.box, tolerance)) return false;
        const Frame &in_s = table_.frames[s.frame], &in_t = table_.frames[t.frame];
        if (in_s.section || in_t.section) return false;
        distance = is_turned(s.kind) ? turned_distance(s, in_s, t, in_t, flipped) : convex_distance(in_s, in_t);
        return distance <= tolerance;
    }

    // How far apart the keys of two supports that agree may be: what agrees within a tolerance over a box differs by more at the origin, by as many times
    // as the origin is box sizes away. Capped: a sliver far out must not make all supports candidates for all.
    double most_keys_differ() const {
        constexpr double kMostSizesAway = 0x1p24, kCap = 0x1p-20, kTerms = 8;
        double most = 0, farthest = 0;
        for (const Occurrence& o : table_.occurrences) {
            const double extent = std::max(finite_part(o.extent), finite_extent(o.box));
            double reach = 0;
            for (int i = 0; i < 3; ++i) reach = std::max({reach, std::abs(finite_part(o.box.lo[i])), std::abs(finite_part(o.box.hi[i]))});
            farthest = std::max(farthest, reach);
            if (!(extent > 0)) continue;
            const double tolerance = kSnapTolerance * extent + finite_part(o.rounding);
            most = std::max(most, tolerance * (1 + std::min(reach / extent, kMostSizesAway)) + tolerance / extent);
        }
        return std::min(kTerms * most, kCap * (1 + farthest));
    }

    // A number that moves little where the surface moves little.
    static double key_of(const WorldSurface& w) {
        constexpr std::array<double, 6> k{0.6180339887, 0.7548776662, 0.5698402910, 0.8191725134, 0.6710436067, 0.5497004779};
        if (w.form == WorldSurface::Form::kPlane) return static_cast<double>(k[0] * w.b[0] + k[1] * w.b[1] + k[2] * w.b[2] + k[3] * w.c);
        if (w.form == WorldSurface::Form::kTorus) return static_cast<double>(k[0] * w.b[0] + k[1] * w.b[1] + k[2] * w.b[2] + k[3] * w.ring + k[4] * w.tube);
        Real most = 0;
        for (const Real x : w.m) most = std::max(most, magnitude(x));
        if (most == 0) return 0;
        Real key = 0, sign = 1;
        for (const Real x : w.m)
            if (magnitude(x) > most / 2) {
                sign = x < 0 ? -1 : 1;
                break;
            }
        for (std::size_t i = 0; i < 3; ++i) key += k[i] * (w.m[i] + w.b[i]) + k[3 + i] * w.m[3 + i];
        return static_cast<double>(sign * key / most);
    }

    // Where both can be, and within which distance there they are one.
    double tolerance_of(SupportId first, SupportId id) const {
        const Occurrence &a = table_.occurrences[id], &b = table_.occurrences[first];
        const double extent = std::max({finite_part(a.extent), finite_part(b.extent), finite_extent(a.box), finite_extent(b.box)});
        const double larger = std::max(finite_part(a.extent), finite_part(b.extent));
        return kSnapTolerance * (larger > 0 ? larger : extent) + a.rounding + b.rounding;
    }

    bool may_agree(SupportId first, SupportId id) const {
        const Support &s = table_.supports[id], &t = table_.supports[first];
        if (form_of(s.kind) != form_of(t.kind) || table_.frames[s.frame].motion != table_.frames[t.frame].motion) return false;
        return touching(table_.occurrences[id].box, table_.occurrences[first].box, tolerance_of(first, id));
    }

    static WorldSurface::Form form_of(SupportKind kind) {
        return is_plane(kind) ? WorldSurface::Form::kPlane : kind == SupportKind::kTorus ? WorldSurface::Form::kTorus : WorldSurface::Form::kQuadric;
    }

    bool agree(SupportId first, SupportId id, const WorldSurface& w, bool& flipped, double& distance) const {
        const Support &s = table_.supports[id], &t = table_.supports[first];
        const Bounds &a = table_.occurrences[id].box, &b = table_.occurrences[first].box;
        const double tolerance = tolerance_of(first, id);
        if (w.form == WorldSurface::Form::kPlane) return planes_agree(w, surface(first), a, b, tolerance, flipped, distance);
        if (w.form == WorldSurface::Form::kTorus) {
            const Frame &in_s = table_.frames[s.frame], &in_t = table_.frames[t.frame];
            if (!in_s.section != !in_t.section) return false;
            distance = static_cast<double>(in_s.section ? section_torus_distance(s, in_s, t, in_t, a) : torus_distance(s, in_s, t, in_t));
            return distance <= tolerance;
        }
        return quadrics_agree(w, surface(first), a, b, tolerance, flipped, distance);
    }

    // Over the hull of both boxes; where that is not bounded, over what is.
    static bool quadrics_agree(const WorldSurface& w, const WorldSurface& v, const Bounds& a, const Bounds& b, double tolerance, bool& flipped, double& distance) {
        Bounds hull{Vec3(0), Vec3(0)};
        for (int i = 0; i < 3; ++i) {
            const double lo = std::min(a.lo[i], b.lo[i]), hi = std::max(a.hi[i], b.hi[i]);
            if (!std::isfinite(lo) || !std::isfinite(hi)) continue;
            hull.lo[i] = lo;
            hull.hi[i] = hi;
        }
        const Vec3 centre = 0.5 * (hull.lo + hull.hi), size = hull.hi - hull.lo;
        const double extent = std::max({size.x, size.y, size.z}), scale = extent > 0 ? extent : 1;
        Vec3 half = 0.5 / scale * size;
        for (int i = 0; i < 3; ++i)
            if (!(half[i] > 0)) half[i] = 0.5;
        bool fw = false, fv = false;
        const auto x = normalised(w, centre, scale, fw), y = normalised(v, centre, scale, fv);
        flipped = fw != fv;
        distance = static_cast<double>(quadric_distance(x, y, half)) * scale;
        return distance <= tolerance;
    }

    static double finite_part(double x) { return std::isfinite(x) ? x : 0; }

    static bool planes_agree(const WorldSurface& w, const WorldSurface& v, const Bounds& a, const Bounds& b, double tolerance, bool& flipped, double& distance) {
        const Real along = w.b[0] * v.b[0] + w.b[1] * v.b[1] + w.b[2] * v.b[2];
        flipped = along < 0;
        const Real sign = flipped ? -1 : 1;
        std::array<Real, 3> n;
        for (std::size_t i = 0; i < 3; ++i) n[i] = w.b[i] - sign * v.b[i];
        const Real c = w.c - sign * v.c;
        Real worst = 0;
        for (const Bounds* box : {&a, &b}) {
            Real most = c, least = c;
            for (std::size_t i = 0; i < 3; ++i) {
                if (n[i] == 0) continue;
                const double lo = box->lo[static_cast<int>(i)], hi = box->hi[static_cast<int>(i)];
                if (!std::isfinite(lo) || !std::isfinite(hi)) {
                    if (magnitude(n[i]) > kSnapTolerance) return false;
                    continue;
                }
                most += std::max(n[i] * lo, n[i] * hi);
                least += std::min(n[i] * lo, n[i] * hi);
            }
            worst = std::max({worst, magnitude(most), magnitude(least)});
        }
        distance = static_cast<double>(worst);
        return distance <= tolerance;
    }

    static constexpr double kKeyRounding = 0x1p-30;  // of a key, long double to double and the cancellation before it

    const SupportTable& table_;
    bool snap_;
    double spread_ = 0;
    Classes out_;
    struct Keyed {
        double key;
        SupportId id;
    };
    std::vector<Keyed> by_key_;
    std::vector<std::uint32_t> rank_;  // by support: its place in by_key_
    OrderedSet founders_;              // of classes, by rank
    std::multimap<double, std::pair<ClassId, SupportId>> turned_;  // by the places of their middles
};

void keep_own_planes(const Formula& formula, Classes& classes) {
    classes.own.reserve(classes.of.size());
    for (const ClassOfSupport& c : classes.of) classes.own.push_back(c.id);
    const auto keep = [&](const std::vector<SupportId>& facets) {
        for (const SupportId s : facets) {
            if (s == kNoSupport || classes.own[s] != classes.of[s].id || classes.supports[classes.own[s]] == formula.table.supports[s]) continue;
            classes.own[s] = static_cast<ClassId>(classes.supports.size());
            classes.supports.push_back(formula.table.supports[s]);
        }
    };
    for (const PrismData& prism : formula.prisms) keep(prism.edges);
    for (const MeshData& mesh : formula.meshes) keep(mesh.facets);
}

}  // namespace

Classes find_classes(const Formula& formula, bool snap) {
    Classes classes = Finder(formula.table, snap && !mutated(Mutation::kOwnIdentity)).run();
    keep_own_planes(formula, classes);
    return classes;
}

}  // namespace whittle
