// line_comparison.cpp — walks the ends of both sets along the line; pieces in one and not the other are measured against the leaves.
#include "modeler/check/line_comparison.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

// Points of a piece that are measured, ends included. A sliver between an arc and its chord is thickest near its middle.
constexpr int kSamples = 5;
// A leaf farther than so many bounds explains nothing; its distance is then looked up without the grid.
constexpr double kReach = 4;
// A crossing without a piece must have a change of exact membership within so many bounds, along some direction of kProbes or its facet's normal.
constexpr double kProbeReach = 2;
constexpr std::size_t kMostKept = 1000;

double ratio_of(const Disagreement& d) { return d.bound > 0 ? d.distance / d.bound : 0; }

void keep_worst(std::vector<Disagreement>& list, std::size_t keep) {
    std::stable_sort(list.begin(), list.end(), [](const Disagreement& a, const Disagreement& b) { return ratio_of(a) > ratio_of(b); });
    if (list.size() > keep) list.resize(keep);
}

class Line {
public:
    Line(const Comparison& comparison, const Ray& ray, ComparisonScratch& scratch, ComparisonSums& sums)
        : c_(comparison), ray_(ray), scratch_(scratch), sums_(sums) {}

    void run() {
        all_spans(c_.program, ray_, scratch_.engine, scratch_.spans);
        c_.mesh_rays.crossings(ray_, scratch_.crossings);
        for (const Span& span : scratch_.spans) {
            if (!span.in || !span.out) {
                sums_.unbounded = true;
                return;
            }
            sums_.chord_spans += span.out->t - span.in->t;
            ends_.push_back(span.in->t);
            ends_.push_back(span.out->t);
        }
        explained_.assign(scratch_.crossings.size(), false);
        walk();
        for (std::size_t i = 0; i < scratch_.crossings.size(); ++i)
            if (!explained_[i] && !is_beside_end(scratch_.crossings[i])) judge_crossing(scratch_.crossings[i]);
    }

private:
    // Visits the intervals between neighbouring ends of either set.
    void walk() {
        const std::vector<MeshCrossing>& crossings = scratch_.crossings;
        std::size_t e = 0, m = 0;
        int winding = 0;
        double t = 0;
        bool from_mesh = false;
        while (e < ends_.size() || m < crossings.size()) {
            const bool is_mesh = e == ends_.size() || (m < crossings.size() && crossings[m].t < ends_[e]);
            const double next = is_mesh ? crossings[m].t : ends_[e];
            interval(t, next, {e % 2 == 1, winding > 0}, {from_mesh ? m : 0, is_mesh ? m + 1 : 0});
            t = next;
            from_mesh = is_mesh;
            if (is_mesh) winding += crossings[m++].entering ? 1 : -1;
            else ++e;
        }
        if (winding != 0) report({DisagreementKind::kOddLine, ray_, 0, t, winding > 0, t, c_.flat_bound, {}});
    }

    struct Inside { bool exact, mesh; };
    struct Borders { std::size_t first, last; };  // one more than the index of the crossing at each end; 0: an exact end

    void interval(double t0, double t1, Inside inside, Borders borders) {
        if (inside.mesh) sums_.chord_mesh += t1 - t0;
        if (inside.exact == inside.mesh) return;
        sums_.difference += t1 - t0;
        const bool is_short = t1 - t0 <= c_.flat_bound + place_error(borders.first) + place_error(borders.last);
        if (is_short && (t1 == t0 || !lies_at_leaf(point_at(ray_, t0)))) return;  // its borders are judged by themselves
        if (borders.first > 0) explained_[borders.first - 1] = true;
        if (borders.last > 0) explained_[borders.last - 1] = true;
        if (!is_short) judge_piece(t0, t1, inside.mesh);
    }

    bool lies_at_leaf(Vec3 p) const { return c_.leaves.nearest(p, c_.curved_bound, c_.flat_bound, kReach).ratio <= 1; }

    // What the place of a crossing may be off by: much where the ray grazes a sliver.
    double place_error(std::size_t border) const { return border > 0 ? scratch_.crossings[border - 1].t_error : 0; }

    void judge_piece(double t0, double t1, bool in_mesh) {
        LeafDistances::Nearest worst;
        worst.ratio = -1;
        for (int k = 0; k < kSamples; ++k) {
            const LeafDistances::Nearest n = c_.leaves.nearest(point_at(ray_, t0 + (t1 - t0) * k / (kSamples - 1)), c_.curved_bound, c_.flat_bound, kReach);
            if (n.ratio > worst.ratio) worst = n;
        }
        const Disagreement d{DisagreementKind::kPiece, ray_, t0, t1, in_mesh, worst.distance, worst.bound, worst.place};
        if (ratio_of(d) > ratio_of(sums_.worst)) sums_.worst = d;
        if (worst.ratio > 1) report(d);
    }

    bool is_beside_end(const MeshCrossing& crossing) const {
        const double reach = c_.flat_bound + crossing.t_error;
        const auto after = std::lower_bound(ends_.begin(), ends_.end(), crossing.t - reach);
        return after != ends_.end() && *after <= crossing.t + reach;
    }

    // The mesh has a facet here, and neither a piece nor an exact end goes with it.
    void judge_crossing(const MeshCrossing& crossing) {
        const Vec3 p = point_at(ray_, crossing.t);
        const LeafDistances::Nearest n = c_.leaves.nearest(p, c_.curved_bound, c_.flat_bound, kReach);
        if (n.ratio <= 1 && membership_changes_near(p, crossing.triangle)) return;
        const double distance = n.ratio <= 1 ? kProbeReach * n.bound : n.distance;
        report({DisagreementKind::kCrossing, ray_, crossing.t, crossing.t, false, distance, n.bound, n.place});
    }

    bool membership_changes_near(Vec3 p, std::uint32_t triangle) {
        const Triangle& corners = c_.mesh.triangles[triangle];
        const Vec3 a = c_.mesh.points[corners[0]], b = c_.mesh.points[corners[1]], c = c_.mesh.points[corners[2]];
        const Vec3 normal = glm::cross(b - a, c - a);
        if (glm::length(normal) > 0 && ends_near(p, glm::normalize(normal))) return true;
        for (int k = 0; k < 27; ++k) {
            const Vec3 direction(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
            if (k > 13 && ends_near(p, glm::normalize(direction))) return true;
        }
        return false;
    }
    bool ends_near(Vec3 p, Vec3 direction) {
        const double reach = kProbeReach * (c_.curved_bound > 0 ? c_.curved_bound : c_.flat_bound);
        Ray probe;
        probe.origin = p - reach * direction;
        probe.direction = direction;
        all_spans(c_.program, probe, scratch_.engine, scratch_.probe);
        return std::any_of(scratch_.probe.begin(), scratch_.probe.end(), [&](const Span& s) {
            return (s.in && s.in->t <= 2 * reach) || (s.out && s.out->t <= 2 * reach);
        });
    }

    void report(const Disagreement& d) {
        ++sums_.disagreements_in_all;
        sums_.disagreements.push_back(d);
        if (ratio_of(d) > ratio_of(sums_.worst)) sums_.worst = d;
        if (sums_.disagreements.size() >= 2 * c_.keep + kMostKept) keep_worst(sums_.disagreements, c_.keep);
    }

    const Comparison& c_;
    const Ray& ray_;
    ComparisonScratch& scratch_;
    ComparisonSums& sums_;
    std::vector<double> ends_;
    std::vector<bool> explained_;
};

}  // namespace

ComparisonSums& ComparisonSums::operator+=(const ComparisonSums& o) {
    chord_spans += o.chord_spans;
    chord_mesh += o.chord_mesh;
    difference += o.difference;
    unbounded = unbounded || o.unbounded;
    disagreements_in_all += o.disagreements_in_all;
    disagreements.insert(disagreements.end(), o.disagreements.begin(), o.disagreements.end());
    keep_worst(disagreements, kMostKept);
    if (ratio_of(o.worst) > ratio_of(worst)) worst = o.worst;
    return *this;
}

void compare_on_line(const Comparison& comparison, const Ray& ray, ComparisonScratch& scratch, ComparisonSums& sums) {
    Line(comparison, ray, scratch, sums).run();
}

}  // namespace whittle
