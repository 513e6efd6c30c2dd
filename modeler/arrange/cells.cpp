#include "modeler/arrange/cells.h"

#include <cmath>

#include "modeler/arrange/edge_order.h"
#include "modeler/arrange/sets.h"
#include "modeler/arrange/shown.h"

namespace whittle {
namespace {

struct FaceEdge {
    PointId lo, hi;
    std::uint32_t face;
    bool forward;  // the face runs from lo to hi
};

std::vector<FaceEdge> edges_of(const std::vector<SmallFace>& faces, std::size_t points) {
    std::vector<FaceEdge> edges;
    edges.reserve(faces.size() * 3);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const PointId a = faces[f].v[k], b = faces[f].v[k == 2 ? 0 : k + 1];
            edges.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    sort_edges(edges, points, [](const FaceEdge& e) { return e.lo; }, [](const FaceEdge& a, const FaceEdge& b) { return a.hi != b.hi ? a.hi < b.hi : a.face < b.face; });
    return edges;
}

// Orders the faces at an edge by the angle of their normals about it, each normal turned to the side that comes next counter-clockwise.
class RoundAnEdge {
public:
    RoundAnEdge(const Patches& patches, const SmallFaces& small) : patches_(patches), small_(small) {}

    void sort(std::vector<FaceEdge>& round) {
        const PointId from = round.front().lo, to = round.front().hi;
        const Approximate &p = patches_.points.near(from), &q = patches_.points.near(to);
        axis_ = 0;
        for (int k = 1; k < 3; ++k)
            if (std::fabs(q[at(k)] - p[at(k)]) > std::fabs(q[at(axis_)] - p[at(axis_)])) axis_ = k;
        direction_ = patches_.points.compare(to, from, axis_);
        for (int k = 0; direction_ == 0 && k < 3; ++k) axis_ = k, direction_ = patches_.points.compare(to, from, k);
        first_ = round.front();
        std::sort(round.begin() + 1, round.end(), [&](const FaceEdge& a, const FaceEdge& b) {
            const int half_a = half(a), half_b = half(b);
            if (half_a != half_b) return half_a < half_b;
            const int c = cross(a, b);
            return c != 0 ? c > 0 : a.face < b.face;
        });
    }

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    const ExactPlane& plane(const FaceEdge& e) const { return small_.planes[small_.faces[e.face].plane]; }

    // 0: in the direction of the first, 1: less than half a turn on, 2: half a turn, 3: more.
    int half(const FaceEdge& e) const {
        const int c = cross(first_, e);
        if (c != 0) return c > 0 ? 1 : 3;
        return same_way(e) ? 0 : 2;
    }
    // Sign of (normal of a) x (normal of b) along the edge.
    int cross(const FaceEdge& a, const FaceEdge& b) const {
        const ExactPlane &p = plane(a), &q = plane(b);
        const std::size_t j = at((axis_ + 1) % 3), k = at((axis_ + 2) % 3);
        const double one = p.nd[j] * q.nd[k], two = p.nd[k] * q.nd[j], det = one - two;
        constexpr double kProductError = 0x1p-50;
        int sign = 0;
        if (std::fabs(det) > kProductError * (std::fabs(one) + std::fabs(two))) {
            sign = det > 0 ? 1 : -1;
        } else {
            sign = (Wide<2>(p.n[j]) * Wide<2>(q.n[k]) - Wide<2>(p.n[k]) * Wide<2>(q.n[j])).sign();
        }
        return sign * direction_ * (a.forward == b.forward ? 1 : -1);
    }
    // Normals are parallel.
    bool same_way(const FaceEdge& e) const {
        const ExactPlane &p = plane(first_), &q = plane(e);
        const std::size_t k = at(p.largest_axis());
        return ((p.n[k] > 0) == (q.n[k] > 0)) == (first_.forward == e.forward);
    }

    const Patches& patches_;
    const SmallFaces& small_;
    int axis_ = 0, direction_ = 1;
    FaceEdge first_{};
};

// Sides are 2 * face (front) and 2 * face + 1 (back).
std::uint32_t side_after(const FaceEdge& e) { return 2 * e.face + (e.forward ? 0 : 1); }
std::uint32_t side_before(const FaceEdge& e) { return 2 * e.face + (e.forward ? 1 : 0); }

// What an edge with one face means.
enum class LoneEdge {
    kFault,   // the surface is not closed
    kJoins,   // facets were left out: regions are joined that are not one, but only regions whose value is settled
    kBorder,  // of a piece of surface: nothing is known of what goes on there
};

bool join_sides(const Patches& patches, const SmallFaces& small, LoneEdge lone, DisjointSets& sides) {
    const std::vector<FaceEdge> edges = edges_of(small.faces, patches.points.size());
    RoundAnEdge sorter(patches, small);
    std::vector<FaceEdge> round;
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        for (j = i + 1; j < edges.size() && edges[j].lo == edges[i].lo && edges[j].hi == edges[i].hi; ++j) {}
        if (j - i == 1) {
            if (lone == LoneEdge::kFault) return false;
            if (lone == LoneEdge::kJoins) sides.join(side_after(edges[i]), side_before(edges[i]));
            continue;
        }
        if (j - i == 2) {
            sides.join(side_after(edges[i]), side_before(edges[i + 1]));
            sides.join(side_after(edges[i + 1]), side_before(edges[i]));
            continue;
        }
        round.assign(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.begin() + static_cast<std::ptrdiff_t>(j));
        sorter.sort(round);
        for (std::size_t k = 0; k < round.size(); ++k) sides.join(side_after(round[k]), side_before(round[k + 1 == round.size() ? 0 : k + 1]));
    }
    return true;
}

// Regions, and the faces around each.
struct Regions {
    std::vector<std::uint32_t> of_side;
    std::vector<std::uint32_t> first, faces;  // faces[first[r] .. first[r + 1])
    std::size_t count() const { return first.size() - 1; }
};

Regions regions_of(DisjointSets& sides, std::size_t face_count) {
    Regions out;
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    std::vector<std::uint32_t> number(face_count * 2, kNone);
    std::uint32_t count = 0;
    out.of_side.resize(face_count * 2);
    for (std::uint32_t s = 0; s < face_count * 2; ++s) {
        std::uint32_t& n = number[sides.find(s)];
        if (n == kNone) n = count++;
        out.of_side[s] = n;
    }
    out.first.assign(count + 1, 0);
    for (const std::uint32_t r : out.of_side) ++out.first[r + 1];
    for (std::uint32_t r = 0; r < count; ++r) out.first[r + 1] += out.first[r];
    out.faces.resize(face_count * 2);
    std::vector<std::uint32_t> fill(out.first.begin(), out.first.end() - 1);
    for (std::uint32_t s = 0; s < face_count * 2; ++s) out.faces[fill[out.of_side[s]]++] = s / 2;
    return out;
}

double area_of(const PointTable& points, const SmallFace& f) {
    const Approximate &a = points.near(f.v[0]), &b = points.near(f.v[1]), &c = points.near(f.v[2]);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double n = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        sum += n * n;
    }
    return sum;
}

// Walks over the regions of one connected piece of surface, switching operands.
class Walker {
public:
    Walker(const Patches& patches, const SmallFaces& small, const Regions& regions, const Buried& buried, std::span<const Operand> operands, Matters matters,
           Expression& expression)
        : patches_(patches), small_(small), regions_(regions), buried_(buried), operands_(operands), expression_(expression),
          winding_(expression.operand_count(), 0), inside_(regions.count(), kUnknown) {
        if (matters == Matters::kTell) here_.resize(regions.count());
    }

    bool known(std::uint32_t region) const { return inside_[region] != kUnknown; }
    bool inside(std::uint32_t region) const { return inside_[region] == 1; }
    // What is told of a region: the matter that fills it, the operands around it, and whether some of them settle the expression, so that others may lack.
    struct Told {
        std::uint32_t filled = OperandMatter::kNone;
        bool settled = false;
        std::vector<std::uint32_t> around;
    };
    const Told& told(std::uint32_t region) const { return here_[region]; }

    // From both sides of a face, given the windings in front of it.
    void walk_from(std::uint32_t face, const std::vector<std::pair<std::uint32_t, int>>& windings) {
        for (const auto& [operand, by] : windings) turn(operand, by);
        walk(regions_.of_side[2 * face]);
        cross(face, 1);
        walk(regions_.of_side[2 * face + 1]);
        cross(face, -1);
        for (const auto& [operand, by] : windings) turn(operand, -by);
    }

private:
    static constexpr std::uint8_t kUnknown = 2;
    static constexpr std::uint32_t kNoFace = 0xFFFFFFFF;
    struct Stop {
        std::uint32_t region, next, through;
        int direction;
    };

    // To all regions that are reached without passing through what is settled. The windings are the region's.
    void walk(std::uint32_t region) {
        if (known(region)) return;
        enter(region, kNoFace);
        while (!way_.empty()) {
            Stop& stop = way_.back();
            if (stop.next == regions_.first[stop.region + 1]) {
                if (stop.through != kNoFace) cross(stop.through, -stop.direction);
                way_.pop_back();
                continue;
            }
            const std::uint32_t face = regions_.faces[stop.next++];
            const std::uint32_t front = regions_.of_side[2 * face], back = regions_.of_side[2 * face + 1];
            const std::uint32_t other = front == stop.region ? back : front;
            if (inside_[other] != kUnknown) continue;
            const int direction = other == back ? 1 : -1;
            cross(face, direction);
            enter(other, face, direction);
        }
    }

    void enter(std::uint32_t region, std::uint32_t through, int direction = 0) {
        inside_[region] = expression_.value() ? 1 : 0;
        if (!here_.empty()) here_[region] = {expression_.value() ? matter_here() : OperandMatter::kNone, settled_ > 0, around_};
        way_.push_back({region, regions_.first[settled_ > 0 ? region + 1 : region], through, direction});
    }
    // direction 1: from the front to the back.
    void cross(std::uint32_t face, int direction) {
        for (const CoverEntry& e : small_.covers[small_.faces[face].cover]) turn(patches_.facets[e.facet].operand, e.sign * direction);
    }
    void turn(std::uint32_t operand, int by) {
        int& w = winding_[operand];
        const bool was = w != 0;
        w += by;
        if (was == (w != 0)) return;
        expression_.set(operand, w != 0);
        if (!here_.empty()) note(operand, w != 0);
        if (buried_.operands[operand]) settled_ += was ? -1 : 1;
    }

    void note(std::uint32_t operand, bool on) {
        if (on) around_.push_back(operand);
        else std::erase(around_, operand);
    }

    // Of the operands around the present place, which is in the result, the matter of the one that fills it.
    std::uint32_t matter_here() const {
        const Operand* best = nullptr;
        for (const std::uint32_t i : around_) {
            const Operand& o = operands_[i];
            if (o.matter.subtractions > 0 || !expression_.is_held_by(i)) continue;
            const bool prior = !best || o.matter.priority > best->matter.priority || (o.matter.priority == best->matter.priority && o.number < best->number);
            if (prior) best = &o;
        }
        return best ? best->matter.fills : OperandMatter::kNone;
    }

    const Patches& patches_;
    const SmallFaces& small_;
    const Regions& regions_;
    const Buried& buried_;
    std::span<const Operand> operands_;
    Expression& expression_;
    int settled_ = 0;  // operands around the present place that settle the expression
    std::vector<int> winding_;
    std::vector<std::uint8_t> inside_;
    std::vector<Told> here_;              // of each region, where asked for
    std::vector<std::uint32_t> around_;  // operands that are on
    std::vector<Stop> way_;
};

// The largest faces of every connected piece, largest first.
std::vector<std::vector<std::uint32_t>> largest_faces(const Patches& patches, const SmallFaces& small, const Regions& regions) {
    DisjointSets pieces(regions.count());
    for (std::uint32_t f = 0; f < small.faces.size(); ++f) pieces.join(regions.of_side[2 * f], regions.of_side[2 * f + 1]);
    constexpr std::size_t kFew = 8;
    std::vector<std::vector<std::pair<double, std::uint32_t>>> best(regions.count());
    for (std::uint32_t f = 0; f < small.faces.size(); ++f) {
        auto& list = best[pieces.find(regions.of_side[2 * f])];
        const double area = area_of(patches.points, small.faces[f]);
        if (list.size() == kFew && area <= list.back().first) continue;
        if (list.size() == kFew) list.pop_back();
        list.emplace_back(area, f);
        std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    }
    std::vector<std::vector<std::uint32_t>> out;
    for (const auto& list : best) {
        if (list.empty()) continue;
        out.emplace_back();
        for (const auto& [area, f] : list) out.back().push_back(f);
    }
    return out;
}

}  // namespace

Result<std::vector<FaceSides>> classify(const Patches& patches, const BoxTree& tree, const SmallFaces& small, const Buried& buried,
                                        std::span<const Operand> operands, Matters matters, Expression& expression) {
    const Expression nothing_on = expression;
    DisjointSets sides(small.faces.size() * 2);
    if (!join_sides(patches, small, buried.count > 0 ? LoneEdge::kJoins : LoneEdge::kFault, sides)) return fail(Fault::kScene, "solids cannot be combined: a surface is not closed where they meet");
    const Regions regions = regions_of(sides, small.faces.size());
    Walker walker(patches, small, regions, buried, operands, matters, expression);
    const auto begin_at = [&](std::uint32_t face) {
        const auto windings = windings_in_front(patches, tree, small, small.faces[face]);
        if (windings) walker.walk_from(face, *windings);
        return windings.has_value();
    };
    for (const auto& faces : largest_faces(patches, small, regions)) static_cast<void>(std::any_of(faces.begin(), faces.end(), begin_at));
    const auto is_known = [&](std::uint32_t region) { return walker.known(region); };
    if (buried.count > 0)  // what lies behind something settled, or within it
        for (std::uint32_t side = 0; side < regions.of_side.size(); ++side)
            if (!is_known(regions.of_side[side])) begin_at(side / 2);
    if (!std::all_of(regions.of_side.begin(), regions.of_side.end(), is_known))
        return fail(Fault::kScene, "solids cannot be combined: a piece is too thin to be told inside from outside");
    std::vector<FaceSides> out(small.faces.size());
    ShownFacets shown(patches, operands, nothing_on);
    for (std::size_t f = 0; f < out.size(); ++f) {
        const std::uint32_t front = regions.of_side[2 * f], back = regions.of_side[2 * f + 1];
        out[f].front = walker.inside(front), out[f].back = walker.inside(back);
        if (matters == Matters::kLeaveOut || out[f].front == out[f].back) continue;
        out[f].filled = walker.told(out[f].front ? front : back).filled;
        if (const Cover& cover = small.covers[small.faces[f].cover]; cover.size() > 1)
            out[f].shown = shown.among(cover, walker.told(walker.told(front).settled ? back : front).around);
    }
    return out;
}

Result<std::vector<FaceSides>> classify_piece(const Patches& patches, const SmallFaces& small, std::span<const Operand> operands, const std::vector<bool>& sound,
                                              Expression& expression) {
    DisjointSets sides(small.faces.size() * 2);
    join_sides(patches, small, LoneEdge::kBorder, sides);
    const Regions regions = regions_of(sides, small.faces.size());
    const Buried buried = nothing_buried(patches, operands);
    Walker walker(patches, small, regions, buried, operands, Matters::kLeaveOut, expression);
    for (std::uint32_t f = 0; f < small.faces.size(); ++f) {
        const Cover& cover = small.covers[small.faces[f].cover];
        if (cover.size() != 1 || !sound[patches.facets[cover.front().facet].tag]) continue;
        if (cover.front().sign > 0) walker.walk_from(f, {});
        else walker.walk_from(f, {{0, 1}});
    }
    std::vector<FaceSides> out(small.faces.size());
    for (std::size_t f = 0; f < out.size(); ++f) {
        const std::uint32_t front = regions.of_side[2 * f], back = regions.of_side[2 * f + 1];
        if (!walker.known(front) || !walker.known(back)) return fail(Fault::kScene, "a piece of surface has nothing sound");
        out[f].front = walker.inside(front), out[f].back = walker.inside(back);
    }
    return out;
}

}  // namespace whittle
