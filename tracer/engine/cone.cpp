#include "tracer/engine/cone.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <sleef.h>

#include "tracer/engine/cone_formula.h"

namespace whittle {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Where the classes of the hit are not known, a root this near to it, relative to it, is the hit.
constexpr double kSameDepth = 1e-9;

// Roots of the polynomial, and where it turns around (a quadratic's vertex). Of a quartic neither: tori have no edges here.
struct Places {
    std::array<double, 2> roots{kInfinity, kInfinity};
    double turn = kInfinity;
    bool turns() const { return turn > 0 && turn < kInfinity; }
    double nearest_to(double t) const { return std::abs(roots[1] - t) < std::abs(roots[0] - t) ? roots[1] : roots[0]; }
};

Places places_of(const LinePolynomial<double>& p) {
    Places places;
    if (p.degree == 1 && p.c[1] != 0) places.roots[0] = -p.c[0] / p.c[1];
    if (p.degree != 2 || p.c[2] == 0) return places;
    places.turn = -0.5 * p.c[1] / p.c[2];
    const double rest = places.turn * places.turn - p.c[0] / p.c[2];
    if (rest < 0) return places;
    const double half = std::sqrt(rest);
    places.roots = {places.turn - half, places.turn + half};
    return places;
}

// Of the disc: the points where a face is met about t.
struct Face {
    double t;
    std::uint64_t mask;
};

// The one of some points that is nearest to their middle, which itself may lie among others.
DiscPoint middle_of(std::uint64_t mask) {
    const auto& points = disc_points();
    const auto each = [&](auto use) {
        for (std::uint64_t left = mask; left != 0; left &= left - 1) use(points[static_cast<std::size_t>(std::countr_zero(left))]);
    };
    DiscPoint sum, nearest;
    each([&](const DiscPoint& p) { sum.x += p.x, sum.y += p.y; });
    const int count = std::popcount(mask);
    double least = kInfinity;
    each([&](const DiscPoint& p) {
        const double away = std::hypot(p.x - sum.x / count, p.y - sum.y / count);
        if (away < least) least = away, nearest = p;
    });
    return nearest;
}

}  // namespace

DiscCut cut_disc(double offset) {
    const double a = std::clamp(offset, 0.0, 1.0), half = std::sqrt(1 - a * a);
    const double area = Sleef_cinz_acosd1_u10purec(a) - a * half;
    if (!(area > 0)) return {0, 1};
    return {area / kPi, 2.0 / 3 * half * half * half / area};
}

namespace {

struct DiscPart {
    double share;
    DiscPoint middle;
};

// The part inside the edge, or the one outside.
DiscPart cut_by(const ConeEdge& edge, bool inner) {
    const bool larger = inner == (edge.offset >= 0);
    const DiscCut cut = cut_disc(std::abs(edge.offset));
    const double out = (inner ? -1 : 1) * (larger ? cut.centroid * cut.share / (1 - cut.share) : cut.centroid);
    return {larger ? 1 - cut.share : cut.share, {out * edge.u, out * edge.v}};
}

}  // namespace

// The faces about the axis, and which points of the disc meet which of them first.
class ConeSplitter::Search {
public:
    // False: nothing divides the cone.
    bool look(const Program& program, const Cone& cone, double t_hit, const Departure* hit) {
        faces_.clear();
        t_hit_ = hit ? t_hit : t_hit * (1 + kSameDepth);
        hit_ = hit;
        if (program.empty || program.everything || !formula_.read(program, cone, t_hit)) return false;
        for (std::size_t own = 0; own < formula_.sides.size(); ++own)
            if (!formula_.sides[own].departs) look_at(own);
        std::stable_sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.t < b.t; });
        return !formula_.edges.empty();
    }

    std::span<const Face> faces() const { return faces_; }

    // The edge that tells exactly these points from the others; null: there is none.
    const ConeEdge* edge_of(std::uint64_t mask) const {
        const ConeEdge* nearest = nullptr;
        for (const ConeEdge& e : formula_.edges)
            if ((e.mask == mask || e.mask == ~mask) && (!nearest || e.t < nearest->t)) nearest = &e;
        return nearest;
    }

    // The place (x, y) of the disc in the section at t.
    Vec3 in_section(double t, const DiscPoint& at) const {
        const ConeSection s = formula_.section(t);
        return (s.uu * at.x + s.uv * at.y) * formula_.u + (s.uv * at.x + s.vv * at.y) * formula_.v;
    }

private:
    void look_at(std::size_t own) {
        const ConeSide& side = formula_.sides[own];
        const Places places = places_of(side.axis);
        const bool met = places.roots[0] < kInfinity;
        // The root of what is hit is the hit, whatever rounding made of it.
        const double own_hit = names(hit_, side.class_id()) ? places.nearest_to(t_hit_) : kInfinity;
        const auto reached = [&](double t) { return t <= t_hit_ || (t == own_hit && t < kInfinity); };
        // Of what bends away only the points within its silhouette meet the face.
        std::uint64_t within = ~std::uint64_t{0};
        if (places.turns() && reached(met ? places.roots[0] : places.turn)) {
            const ConeEdge silhouette = formula_.edge(own, formula_.section(places.turn), {places.turn, 0, 0});
            within = bends_around(own) ? silhouette.mask : ~silhouette.mask;
            if (std::abs(silhouette.offset) < 1) formula_.edges.push_back(silhouette);
            if (!met) add(own, {places.turn, 0, 0}, within);
        }
        for (double t : places.roots)
            if (t > 0 && t < kInfinity && reached(t)) add(own, touching(side, t, std::abs(places.turn - t)), within);
    }

    // The plane that touches the side at t. Where it leans steeply the side bends away before: never by more than `most` within the disc.
    ConeFormula::Leaning touching(const ConeSide& side, double t, double most) const {
        const double along = slope_at(side.axis, t);
        if (along == 0) return {t, 0, 0};
        ConeFormula::Leaning plane{t, -value_at(side.along_u, t) / along, -value_at(side.along_v, t) / along};
        const ConeSection s = formula_.section(t);
        const double lean = std::hypot(s.uu * plane.u + s.uv * plane.v, s.uv * plane.u + s.vv * plane.v);
        if (lean > most) plane.u *= most / lean, plane.v *= most / lean;
        return plane;
    }

    // Is the axis inside the side between the roots, as it is inside a ball?
    bool bends_around(std::size_t own) const { return formula_.sides[own].inside_sign() * formula_.sides[own].axis.c[2] > 0; }

    void add(std::size_t own, const ConeFormula::Leaning& plane, std::uint64_t within) {
        if (within == 0) return;
        const std::uint64_t mask = formula_.face(own, plane) & within;
        if (mask != 0) faces_.push_back({plane.t, mask});
    }

    ConeFormula formula_;
    std::vector<Face> faces_;
    double t_hit_ = 0;
    const Departure* hit_ = nullptr;
};

ConeSplitter::ConeSplitter() : search_(std::make_unique<Search>()) {}
ConeSplitter::~ConeSplitter() = default;

ConeParts ConeSplitter::split(const Program& program, const Cone& cone, double t_hit, const Departure* hit) {
    ConeParts parts;
    if (!search_->look(program, cone, t_hit, hit)) return parts;
    // Each point to the face that it meets first, the rest to none.
    std::uint64_t left = ~std::uint64_t{0};
    std::array<Face, ConeParts::kMost> groups;
    std::size_t count = 0;
    Face largest{0, 0};
    for (const Face& face : search_->faces()) {
        const Face first{face.t, face.mask & left};
        if (first.mask == 0 || count + 1 == groups.size()) continue;
        groups[count++] = first;
        left &= ~first.mask;
        if (std::popcount(first.mask) > std::popcount(largest.mask)) largest = first;
    }
    if (count == 0) return parts;
    if (left != 0) groups[count++] = {largest.t, left};
    if (count < 2) return parts;
    const ConeEdge* edge = count == 2 ? search_->edge_of(groups[0].mask) : nullptr;
    for (std::size_t k = 0; k < count; ++k) {
        ConePart& part = parts.part[parts.count++];
        const DiscPart disc = edge ? cut_by(*edge, groups[k].mask == edge->mask) : DiscPart{std::popcount(groups[k].mask) / double{kDiscPoints}, middle_of(groups[k].mask)};
        part = {disc.share, groups[k].t, search_->in_section(groups[k].t, disc.middle)};
    }
    return parts;
}

}  // namespace whittle
