// tile_cell.cpp — bounds that hold for all rays of a tile, and half-spaces that none of them can feel.
#include "tracer/engine/tile_cell.h"

#include <algorithm>
#include <cmath>

#include "tracer/engine/coarse_view.h"
#include "tracer/engine/tile_magnitudes.h"

namespace whittle {

using namespace tile_magnitudes;

namespace {

constexpr double u = kFineUnit;
// Lanes that graze a ball or cylinder by less than this cosine, or a plane by less than this share of the tile's steepest slope, are undecided: a few in a
// million, for bounds that are a few hundred times those of the steep ones and still far below any distance between surfaces.
struct Thresholds {
    double unit, least_slope;
    double most_error;        // of the horizon: lanes whose crossing is worse are undecided, rather than every event of the tile loose
    double most_round_error;  // rays that have little in common: all grazing angles at once, from all distances
};
constexpr Thresholds kFine{kFineUnit, 0x1p-9, 0x1p-34, 0x1p-24}, kCoarse{kCoarseUnit, 0x1p-6, 0x1p-15, 0x1p-12};
constexpr double kMostQuadricError = 0x1p-38;
constexpr double kDepartureRoom = 0x1p-34;  // of the horizon: rays that leave a surface begin on it but for the rounding of their origin


TileLine line_in_frame(const TileLine& root, const Frame& frame) {
    TileLine r;
    for (std::size_t i = 0; i < 3; ++i) {
        double o = frame.lift(i), ho = 0, d = 0, hd = 0, so = std::abs(o), sd = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            const double k = frame.inverse[3 * i + j], size = std::abs(k), offset = frame.entry(static_cast<int>(j));
            const double lo = root.o_lo[j] - offset, hi = root.o_hi[j] - offset;
            o += k * (0.5 * (lo + hi));
            d += k * (0.5 * (root.d_lo[j] + root.d_hi[j]));
            ho += size * (0.5 * (hi - lo));
            hd += size * (0.5 * (root.d_hi[j] - root.d_lo[j]));
            so += size * largest(lo, hi);
            sd += size * largest(root.d_lo[j], root.d_hi[j]);
        }
        // Twelve units bound what a ray's own way into the frame costs; the intervals get as much again for their own rounding.
        r.eo[i] = 12 * u * so * kRoom;
        r.ed[i] = 12 * u * sd * kRoom;
        r.o_lo[i] = o - ho - 2 * r.eo[i], r.o_hi[i] = o + ho + 2 * r.eo[i];
        r.d_lo[i] = d - hd - 2 * r.ed[i], r.d_hi[i] = d + hd + 2 * r.ed[i];
    }
    return r;
}

// The numbers of a plane's linear form: n.(x - a) - d, each n_i within en_i.
struct PlaneNumbers {
    std::array<double, 3> n{}, en{}, a{};
    double d = 0;
};

PlaneNumbers plane_numbers(const Support& s) {
    PlaneNumbers r;
    const auto& p = s.p;
    const std::size_t i = s.axis, j = (i + 1) % 3, k = (i + 2) % 3;
    if (s.kind == SupportKind::kAxisPlane) {
        r.n[i] = 1;
        r.a[i] = p[0];
    } else if (s.kind == SupportKind::kPlane) {
        r.n = {p[0], p[1], p[2]};
        r.d = p[3];
    } else if (s.kind == SupportKind::kEdgePlane) {
        r.n[j] = p[3] - p[1], r.n[k] = p[0] - p[2];
        r.a[j] = p[0], r.a[k] = p[1];
        r.en[j] = u * std::abs(r.n[j]), r.en[k] = u * std::abs(r.n[k]);
    } else {
        for (std::size_t x = 0; x < 3; ++x) {
            const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
            const double first = (p[3 + y] - p[y]) * (p[6 + z] - p[z]), second = (p[3 + z] - p[z]) * (p[6 + y] - p[y]);
            r.n[x] = first - second;
            r.en[x] = 5 * u * (std::abs(first) + std::abs(second));
            r.a[x] = p[x];
        }
    }
    return r;
}

struct Interval {
    double lo = 0, hi = 0;
};

Interval quotient(const Interval& a, const Interval& b) {
    const double w = a.lo / b.lo, x = a.lo / b.hi, y = a.hi / b.lo, z = a.hi / b.hi;
    const double lo = std::min(std::min(w, x), std::min(y, z)), hi = std::max(std::max(w, x), std::max(y, z));
    return {lo - std::abs(lo) * (kRoom - 1), hi + std::abs(hi) * (kRoom - 1)};
}

Interval product(const Interval& a, const Interval& b) {
    const double w = a.lo * b.lo, x = a.lo * b.hi, y = a.hi * b.lo, z = a.hi * b.hi;
    const double lo = std::min(std::min(w, x), std::min(y, z)), hi = std::max(std::max(w, x), std::max(y, z));
    return {lo - std::abs(lo) * (kRoom - 1), hi + std::abs(hi) * (kRoom - 1)};
}

// Of the t at which a surface is met, where the tile tells on which side it begins.
struct Range {
    Interval t;
    bool entering = false, leaving = false;
};

// One cell's surfaces as they gather.
class CellFolder {
public:
    CellFolder(const Program& program, const TileScope& scope, std::vector<TileSurface>& surfaces, std::vector<CoarseSurface>& coarse)
        : program_(program), scope_(scope), surfaces_(surfaces), coarse_(coarse), first_(surfaces.size()) {}

    // False: some kind that packets do not know.
    bool add(const HalfSpace& h) {
        const Support& s = program_.classes[h.id()];
        TileSurface t;
        t.support = &s;
        t.inverted = h.inverted();
        t.id = std::uint64_t{h.id()} << 1;
        t.axis = s.axis;
        t.frame = s.frame;
        if (program_.frames[s.frame].motion != 0) return false;
        if (s.kind == SupportKind::kAxisPlane && s.frame == 0) return add_axis_plane(t);
        const TileLine& line = line_of(s.frame);
        if (is_plane(s.kind)) return add_plane(t, line);
        if (s.kind == SupportKind::kBall) return add_round(t, line, {s.p[0], s.p[1], s.p[2]}, s.p[3]);
        if (s.kind != SupportKind::kCylinder) return degree_of(s.kind) == 2 && add_quadric(t);
        std::array<double, 3> centre{};
        centre[(s.axis + 1u) % 3] = s.p[0];
        centre[(s.axis + 2u) % 3] = s.p[1];
        return add_round(t, line, centre, s.p[2]);
    }

    // The sides of a cell; of many planes those that the tile can feel. False: some kind that packets do not know. `met`: false if the tile misses the cell.
    bool add(const Leaf& leaf, bool& met) {
        std::uint32_t k = 0;
        if (leaf.facets != Leaf::kNoFacets) {
            const FacetTree& tree = program_.facet_trees[leaf.facets];
            const TileLine& root = scope_.root;
            FacetSearch search;
            met = search.run(program_.facet_chunks, tree, facet_lines(tree, root.o_lo, root.o_hi, root.d_lo, root.d_hi));
            if (!met) return true;
            for (const std::uint32_t plane : search.found())
                if (!add(program_.half_spaces[leaf.first + plane])) return false;
            k = tree.planes;
        }
        for (; k < leaf.count; ++k)
            if (!add(program_.half_spaces[leaf.first + k])) return false;
        return true;
    }

    // Drops the planes that others always come behind (on the way in) or before (on the way out). False: the tile leaves before it enters.
    bool finish(double& near, double& far) {
        if (last_in_ > first_out_) return false;
        std::size_t kept = first_;
        for (std::size_t i = first_; i < surfaces_.size() && i - first_ < ranged_; ++i) {
            const Range& range = ranges_[i - first_];
            if ((range.entering && range.t.hi < last_in_) || (range.leaving && range.t.lo > first_out_)) continue;
            surfaces_[kept++] = surfaces_[i];
        }
        for (std::size_t i = first_ + ranged_; i < surfaces_.size(); ++i) surfaces_[kept++] = surfaces_[i];
        surfaces_.resize(kept);
        near = std::max(near, last_in_);
        far = std::min(far, first_out_);
        return near <= far;
    }

    double error() const { return error_; }

private:
    const Thresholds& thresholds() const { return scope_.coarse ? kCoarse : kFine; }

    // The form v + t s of a plane in float; ev and es grow by what that rounds, in the form's own units. Returns 1 over the largest coefficient, by which the
    // form in float is smaller.
    double make_coarse(TileSurface& t, const PlaneNumbers& p, const Interval& v, double& ev, double& es) {
        std::array<double, 3> n = p.n;
        if (t.frame != 0) {
            const auto& rows = program_.frames[t.frame].inverse;
            for (std::size_t j = 0; j < 3; ++j) n[j] = rows[j] * p.n[0] + rows[3 + j] * p.n[1] + rows[6 + j] * p.n[2];
        }
        const double scale = 1 / std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])}), value = 0.5 * (v.lo + v.hi);
        CoarseSurface& c = coarse_.emplace_back();
        t.coarse = static_cast<std::uint32_t>(coarse_.size() - 1);
        double slope = 0, off = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            const double lo = scope_.root.d_lo[j], hi = scope_.root.d_hi[j];
            slope += n[j] * (0.5 * (lo + hi));
            off += std::abs(n[j]) * (0.5 * (hi - lo) + kFineUnit * largest(lo, hi));
            c.normal[j] = static_cast<float>(n[j] * scale);
        }
        c.slope = static_cast<float>(slope * scale);
        c.value = static_cast<float>(value * scale);
        ev += 0.5 * (v.hi - v.lo) + 2 * kCoarseUnit * std::abs(value);
        es += kCoarseUnit * (2 * std::abs(slope) + 7 * off) * kRoom;
        return scale;
    }

    RoundLimits make_coarse(TileSurface& t, const TileLine& line, const std::array<double, 3>& centre, double r, bool ball) {
        t.coarse = static_cast<std::uint32_t>(coarse_.size());
        CoarseSurface& c = coarse_.emplace_back();
        const double* rows = t.frame == 0 ? nullptr : program_.frames[t.frame].inverse.data();
        const CoarseView view = coarse_view(scope_.root, line, ball, t.axis, rows);
        for (std::size_t k = 0; rows && k < view.count; ++k)
            for (std::size_t j = 0; j < 3; ++j) c.rows[3 * k + j] = static_cast<float>(rows[3 * view.index[k] + j]);
        return coarse_round(view, centre, r, scope_.horizon, c.round);
    }

    const TileLine& line_of(FrameId id) {
        if (id == 0) return scope_.root;
        if (in_local_ != id) {
            local_ = line_in_frame(scope_.root, program_.frames[id]);
            in_local_ = id;
        }
        return local_;
    }

    bool add_axis_plane(TileSurface& t) {
        t.value = t.support->p[0];
        const std::size_t i = t.axis;
        const double d_lo = scope_.root.d_lo[i], d_hi = scope_.root.d_hi[i];
        Range range;
        if (d_lo > 0 || d_hi < 0) {
            range.leaving = (d_lo > 0) != t.inverted;
            range.entering = !range.leaving;
            range.t = quotient({lower(t.value - scope_.root.o_hi[i]), upper(t.value - scope_.root.o_lo[i])}, {d_lo, d_hi});
        }
        t.kind = range.entering ? TileSurface::Kind::kEntering : range.leaving ? TileSurface::Kind::kLeaving : TileSurface::Kind::kCrossing;
        if (scope_.coarse) t.value -= scope_.root.o_lo[i];
        take(t, range, scope_.axis_plane_error());
        return true;
    }

    bool add_plane(TileSurface& t, const TileLine& line) {
        const PlaneNumbers p = plane_numbers(*t.support);
        Interval v{-p.d, -p.d}, s;
        double size = std::abs(p.d), slope = 0, ev = 0, es = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double q_lo = line.o_lo[i] - p.a[i], q_hi = line.o_hi[i] - p.a[i], q = largest(q_lo, q_hi), d = largest(line.d_lo[i], line.d_hi[i]);
            const double n = std::abs(p.n[i]), most = n + p.en[i];
            v.lo += std::min(p.n[i] * q_lo, p.n[i] * q_hi), v.hi += std::max(p.n[i] * q_lo, p.n[i] * q_hi);
            s.lo += std::min(p.n[i] * line.d_lo[i], p.n[i] * line.d_hi[i]), s.hi += std::max(p.n[i] * line.d_lo[i], p.n[i] * line.d_hi[i]);
            size += n * q;
            slope += n * d;
            ev += p.en[i] * q + most * line.eo[i];
            es += p.en[i] * d + most * line.ed[i];
        }
        ev = (ev + 8 * u * size) * kRoom;
        es = (es + 8 * u * slope) * kRoom;
        const double scale = scope_.coarse ? make_coarse(t, p, v, ev, es) : 1;
        if (!(scale < HUGE_VAL)) return false;
        v.lo -= ev, v.hi += ev, s.lo -= es, s.hi += es;
        t.kind = TileSurface::Kind::kPlane;
        const double off = 1.5 * (ev + scope_.horizon * es);
        t.least_slope = std::max({smallest(s.lo, s.hi), thresholds().least_slope * largest(s.lo, s.hi), off / (thresholds().most_error * scope_.horizon)});
        if (!(t.least_slope > 4 * es)) return false;
        t.clear = ((t.least_slope + es) * scope_.horizon + 2 * ev) * kRoom;
        Range range;
        if (smallest(s.lo, s.hi) >= t.least_slope) {
            range.leaving = (s.lo > 0) != t.inverted;
            range.entering = !range.leaving;
            range.t = quotient({-v.hi, -v.lo}, s);
        }
        // (ev + |t| es) / (|s| - es), as a ray's own bound.
        const double error = off / t.least_slope + 4 * scope_.unit() * scope_.horizon;
        if (scope_.coarse) t.least_slope *= scale / kCoarseRoom, t.clear *= scale * kCoarseRoom;  // `off` has room for a little less
        take(t, range, error);
        return true;
    }

    bool add_round(TileSurface& t, const TileLine& line, const std::array<double, 3>& centre, double r) {
        const bool ball = t.support->kind == SupportKind::kBall;
        t.kind = ball ? TileSurface::Kind::kBall : TileSurface::Kind::kCylinder;
        t.round = scope_.coarse ? make_coarse(t, line, centre, r, ball) : round_limits(line, centre, r, ball, t.axis);
        const std::size_t i = (t.axis + 1u) % 3, j = (t.axis + 2u) % 3;
        t.still = !ball && largest(line.d_lo[i], line.d_hi[i]) == 0 && largest(line.d_lo[j], line.d_hi[j]) == 0;
        if (!(t.round.missed < HUGE_VAL) || (t.still && scope_.coarse)) return false;
        if (!(t.round.error <= thresholds().most_round_error * scope_.horizon)) t.round.met = HUGE_VAL, t.round.error = 0;
        const double error = t.still ? 0 : t.round.error + 3 * scope_.unit() * scope_.horizon;
        take(t, {}, error);
        if (!t.inverted && !t.still) bound_round(line, centre, r, ball, t.axis, 4 * error + kDepartureRoom * scope_.horizon);
        return true;
    }

    // The tile's rays are inside the surface within [last_in_, first_out_] only; nowhere, if all pass it by. A ray's distance from the centre is its cross
    // product's with the way there, over the length of its direction.
    void bound_round(const TileLine& line, const std::array<double, 3>& centre, double r, bool ball, std::size_t axis, double room) {
        std::array<Interval, 3> o, d;
        Interval a{0, 0}, along{0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            if (!ball && i == axis) continue;
            o[i] = {lower(line.o_lo[i] - centre[i]), upper(line.o_hi[i] - centre[i])};
            d[i] = {line.d_lo[i], line.d_hi[i]};
            const double least = smallest(d[i].lo, d[i].hi), most = largest(d[i].lo, d[i].hi);
            a.lo += least * least, a.hi += most * most;
            const Interval step = product(o[i], d[i]);
            along.lo += step.lo, along.hi += step.hi;
        }
        double passed = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!ball && i != axis) continue;
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const Interval x = product(o[j], d[k]), y = product(o[k], d[j]);
            const double least = smallest(lower(x.lo - y.hi), upper(x.hi - y.lo));
            passed += least * least;
        }
        const double left = a.hi * r * r * kRoom - passed / kRoom;
        if (left < 0) {
            first_out_ = -HUGE_VAL;
            last_in_ = HUGE_VAL;
        }
        if (!(left >= 0) || !(a.lo > 0)) return;
        const double half = std::sqrt(left) / a.lo * kRoom + room;
        const Interval closest = quotient({-along.hi, -along.lo}, a);
        last_in_ = std::max(last_in_, lower(closest.lo - half));
        first_out_ = std::min(first_out_, upper(closest.hi + half));
    }

    bool add_quadric(TileSurface& t) {
        if (scope_.coarse) return false;
        t.kind = TileSurface::Kind::kQuadric;
        t.error = kMostQuadricError * scope_.horizon;
        take(t, {}, t.error);
        return true;
    }

    void take(const TileSurface& t, Range range, double error) {
        surfaces_.push_back(t);
        error_ = std::max(error_, error);
        // Two crossings in this order are certain where their ranges, with the errors of both, lie apart.
        range.t.lo -= 4 * error, range.t.hi += 4 * error;
        if (range.entering) last_in_ = std::max(last_in_, range.t.lo);
        if (range.leaving) first_out_ = std::min(first_out_, range.t.hi);
        if (ranged_ < ranges_.size()) ranges_[ranged_++] = range;
    }

    static double lower(double x) { return x - std::abs(x) * (kRoom - 1); }
    static double upper(double x) { return x + std::abs(x) * (kRoom - 1); }

    const Program& program_;
    const TileScope& scope_;
    std::vector<TileSurface>& surfaces_;
    std::vector<CoarseSurface>& coarse_;
    std::size_t first_;
    std::array<Range, 32> ranges_;  // of the first so many surfaces; further ones stay
    std::size_t ranged_ = 0;
    TileLine local_;
    FrameId in_local_ = 0;
    double error_ = 0, last_in_ = -HUGE_VAL, first_out_ = HUGE_VAL;
};

// Opposite planes across an axis side by side.
void pair_slabs(std::vector<TileSurface>& surfaces, std::size_t first) {
    const auto crossed = [&](std::size_t k) { return surfaces[k].kind == TileSurface::Kind::kCrossing; };
    for (std::size_t k = first; k + 1 < surfaces.size(); ++k) {
        if (!crossed(k)) continue;
        for (std::size_t other = k + 1; other < surfaces.size(); ++other) {
            if (!crossed(other) || surfaces[other].axis != surfaces[k].axis || surfaces[other].inverted == surfaces[k].inverted) continue;
            std::swap(surfaces[k + 1], surfaces[other]);
            if (!surfaces[k].inverted) std::swap(surfaces[k], surfaces[k + 1]);
            surfaces[k].kind = TileSurface::Kind::kSlab;
            ++k;
            break;
        }
    }
}

}  // namespace

bool fold_cell(const Program& program, const TileScope& scope, const Leaf& leaf, std::vector<TileSurface>& surfaces, std::vector<CoarseSurface>& coarse,
               TileCell& cell, double& error, double& near, double& far) {
    cell.first = static_cast<std::uint32_t>(surfaces.size());
    CellFolder folder(program, scope, surfaces, coarse);
    bool met = true;
    cell.known = leaf.kind == FormulaKind::kCell && folder.add(leaf, met);
    if (cell.known && met) {
        met = folder.finish(near, far);
        error = std::max(error, folder.error());
    }
    if (!cell.known || !met) surfaces.resize(cell.first);
    if (!scope.coarse) pair_slabs(surfaces, cell.first);
    cell.count = static_cast<std::uint32_t>(surfaces.size()) - cell.first;
    return met;
}

}  // namespace whittle
