// random_solid.cpp — see random_solid.h.
#include "tests/support/random_solid.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "tests/support/random_shape.h"

namespace whittle::support {

namespace {

// A node with the points and directions it is known by, in its own frame.
struct Known {
    NodeId node = kEmptyNode;
    std::vector<Vec3> points, directions;
    bool bounded = true;
};

constexpr std::size_t kMostPoints = 24;

class Maker {
public:
    Maker(Theme theme, std::uint64_t seed, const SolidPasses& passes) : theme_(theme), dice_(seed), builder_(passes) {}

    RandomSolid make(const Placement& outer) {
        dice_.pool(theme_ == Theme::kStack || dice_.one_in(2));
        Known whole = recipe();
        if (!whole.bounded) whole = combined(SetOp::kIntersection, {{bounding_box(), {}}, {whole, {}}});
        Use root;
        root.node = whole.node;
        if (theme_ == Theme::kFar) root.placement = far_placement();
        RandomSolid r;
        for (const Vec3& p : whole.points) r.points.push_back(apply_to_point(root.placement, p));
        for (const Vec3& d : whole.directions) r.directions.push_back(apply_to_direction(root.placement, d));
        r.size = theme_ == Theme::kFar ? scale_ * 4 : 4;
        root.placement = outer * root.placement;
        r.solid = builder_.finish(root);
        return r;
    }

private:
    Known recipe() {
        switch (theme_) {
            case Theme::kChain: return chain();
            case Theme::kThin: return thin();
            case Theme::kWedge: return wedge();
            case Theme::kLadder: return ladder();
            case Theme::kConvex: return among_convex();
            default: return tree(leaf_count());
        }
    }

    // Thin things among them seldom: without an exact tier those are left undecided.
    Known among_convex() {
        const int kind = dice_.integer(0, 11);
        if (kind < 7) return tree(dice_.one_in(16) ? dice_.integer(60, 120) : dice_.integer(1, 30));
        return kind < 10 ? chain() : kind < 11 ? thin() : ladder();
    }

    struct Placed {
        Known what;
        Placement placement;
    };

    int leaf_count() {
        if (dice_.one_in(16)) return dice_.integer(60, 200);
        return dice_.one_in(4) ? dice_.integer(1, 6) : dice_.integer(6, 50);
    }

    Known leaf() {
        if (theme_ == Theme::kConvex && dice_.one_in(2)) {
            Sketch s = random_convex(dice_);
            return {builder_.shape(s.shape), std::move(s.points), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true};
        }
        const bool planes = theme_ == Theme::kPlanes || (theme_ == Theme::kStack && dice_.one_in(2));
        const bool round = theme_ == Theme::kRound;
        Sketch s = random_shape(builder_, dice_, planes ? Repertoire::kPlanes : round ? Repertoire::kRound : Repertoire::kAll);
        Known k{builder_.shape(s.shape), std::move(s.points), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, s.bounded};
        return k;
    }

    Placement placement() {
        if (theme_ == Theme::kStack) return Placement::translation(dice_.vector());
        switch (dice_.integer(0, 9)) {
            case 0: case 1: return {};
            case 2: case 3: case 4: return Placement::translation(dice_.vector());
            case 5: return turn(dice_.integer(0, 2), dice_.pick<double>({30, 45, 60, 90, 180, -30}));
            case 6: return turn(dice_.integer(0, 2), dice_.real(0, 360)) * turn(dice_.integer(0, 2), dice_.real(0, 360));
            case 7: return Placement::translation(dice_.vector()) * turn(2, dice_.pick<double>({30, 60, 90}));
            case 8: return mirror(dice_.integer(0, 2));
            default: return stretch();
        }
    }

    static Placement turn(int axis, double deg) {
        Placement p;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double c = cosd(deg), s = sind(deg);
        p.m[static_cast<std::size_t>(5 * u)] = p.m[static_cast<std::size_t>(5 * v)] = c;
        p.m[static_cast<std::size_t>(4 * u + v)] = -s;
        p.m[static_cast<std::size_t>(4 * v + u)] = s;
        return p;
    }
    static Placement mirror(int axis) {
        Placement p;
        p.m[static_cast<std::size_t>(5 * axis)] = -1;
        return p;
    }
    Placement stretch() {
        Placement p;
        for (int i = 0; i < 3; ++i) p.m[static_cast<std::size_t>(5 * i)] = dice_.pick<double>({1, 2, 0.5, 1.5, 0.75, 1.1});
        if (dice_.one_in(3)) p.m[1] = dice_.pick<double>({0.5, -0.25, 0.3});
        return p;
    }
    Placement far_placement() {
        scale_ = std::pow(10.0, dice_.integer(-6, 6));
        Placement p = dice_.one_in(2) ? Placement{} : turn(2, dice_.real(0, 360)) * turn(0, dice_.real(0, 360));
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) p.m[static_cast<std::size_t>(4 * i + j)] *= scale_;
        for (int i = 0; i < 3; ++i) p.m[static_cast<std::size_t>(4 * i + 3)] = dice_.real(-1, 1) * scale_ * std::pow(10.0, dice_.integer(0, 6));
        return p;
    }

    Known combined(SetOp op, std::vector<Placed> operands) {
        std::vector<Use> uses;
        Known r;
        r.bounded = op != SetOp::kUnion;
        bool some_bounded = false, all_bounded = true;
        for (const Placed& o : operands) {
            Use use;
            use.node = o.what.node;
            use.placement = o.placement;
            uses.push_back(use);
            some_bounded = some_bounded || o.what.bounded;
            all_bounded = all_bounded && o.what.bounded;
            for (const Vec3& p : o.what.points) r.points.push_back(apply_to_point(o.placement, p));
            for (const Vec3& d : o.what.directions) r.directions.push_back(apply_to_direction(o.placement, d));
        }
        r.bounded = op == SetOp::kUnion ? all_bounded : op == SetOp::kIntersection ? some_bounded : operands[0].what.bounded;
        for (auto* list : {&r.points, &r.directions}) {
            std::shuffle(list->begin(), list->end(), dice_.engine());
            if (list->size() > kMostPoints) list->resize(kMostPoints);
        }
        r.node = builder_.combine(op, std::move(uses));
        return r;
    }

    Known bounding_box() { return {builder_.shape(shape::Box{{-3, -3, -3}, {3, 3, 3}}), {{3, 3, 3}, {-3, 0, 0}}, {{1, 0, 0}}, true}; }

    SetOp operation() {
        const int k = dice_.integer(0, 9);
        return k < 5 ? SetOp::kUnion : k < 8 ? SetOp::kDifference : SetOp::kIntersection;
    }

    // Leaves, some of them used again, joined a few at a time until one is left.
    Known tree(int leaves) {
        std::vector<Known> open;
        const int distinct = theme_ == Theme::kInstances ? std::max(1, leaves / 6) : leaves;
        for (int i = 0; i < distinct; ++i) open.push_back(leaf());
        for (int i = distinct; i < leaves; ++i) open.push_back(open[static_cast<std::size_t>(dice_.integer(0, distinct - 1))]);
        std::shuffle(open.begin(), open.end(), dice_.engine());
        while (open.size() > 1) {
            const std::size_t n = std::min(open.size(), static_cast<std::size_t>(dice_.integer(2, 5)));
            std::vector<Placed> operands;
            const bool same_turn = theme_ == Theme::kInstances && dice_.one_in(2);
            const Placement common = same_turn ? placement() : Placement{};
            for (std::size_t i = 0; i < n; ++i) {
                operands.push_back({open.back(), same_turn ? common : placement()});
                open.pop_back();
            }
            if (dice_.one_in(8)) operands.push_back(twin(operands[0]));
            const auto at = open.begin() + dice_.integer(0, static_cast<int>(open.size()));
            open.insert(at, combined(operation(), std::move(operands)));
        }
        return std::move(open[0]);
    }

    // The same set, written differently: through two half turns, or a union of itself.
    Placed twin(const Placed& of) {
        const Known wrapped = combined(SetOp::kUnion, {{of.what, of.placement}});
        const double deg = dice_.pick<double>({30, 45, 90});
        const Known once = combined(SetOp::kUnion, {{wrapped, turn(2, deg)}});
        return {once, turn(2, -deg)};
    }

    Known chain() {
        Known k = leaf();
        const int depth = dice_.integer(5, 30);
        for (int i = 0; i < depth; ++i) {
            const SetOp op = i % 2 == 0 ? SetOp::kDifference : operation();
            std::vector<Placed> operands{{leaf(), placement()}, {std::move(k), placement()}};
            if (dice_.one_in(3)) std::swap(operands[0], operands[1]);
            k = combined(op, std::move(operands));
        }
        return k;
    }

    // A leaf less the same leaf, moved or scaled by very little; then cut.
    Known thin() {
        std::vector<Placed> parts;
        const int n = dice_.integer(1, 4);
        for (int i = 0; i < n; ++i) {
            const Known k = leaf();
            const double film = std::pow(10.0, -dice_.real(3, 15));
            Placement nearly = Placement::translation({dice_.one_in(2) ? film : 0, 0, dice_.one_in(2) ? film : -film});
            if (dice_.one_in(2))
                for (std::size_t j : {0u, 5u, 10u}) nearly.m[j] = 1 - film;
            if (dice_.one_in(4)) nearly = turn(dice_.integer(0, 2), film * 57.3);
            parts.push_back({combined(dice_.one_in(6) ? SetOp::kUnion : SetOp::kDifference, {{k, {}}, {k, nearly}}), placement()});
        }
        if (dice_.one_in(2)) parts.push_back({leaf(), placement()});
        return combined(operation(), std::move(parts));
    }

    // A leaf and another (or itself) turned by very little about an axis through a common face, edge or corner.
    Known wedge() {
        const double deg = std::pow(10.0, -dice_.real(4, 11)) * 57.29577951308232;
        const Known a = leaf(), b = dice_.one_in(2) ? a : leaf();
        const Known flipped = combined(SetOp::kUnion, {{b, dice_.one_in(2) ? mirror(dice_.integer(0, 2)) : Placement{}}});
        std::vector<Placed> parts{{a, {}}, {flipped, turn(dice_.integer(0, 2), dice_.one_in(2) ? deg : -deg)}};
        if (dice_.one_in(3)) parts.push_back({leaf(), placement()});
        return combined(operation(), std::move(parts));
    }

    Known ladder() {
        const double step = 0.6 * std::pow(10.0, -dice_.integer(3, 15));
        const Known rung = leaf(), other = leaf();
        const Vec3 way = dice_.one_in(2) ? Vec3(0, 0, 1) : dice_.vector();
        const bool grows = dice_.one_in(3);
        Known k = rung;
        const int n = dice_.integer(2, 12);
        for (int i = 1; i <= n; ++i) {
            Placement p = Placement::translation(way * (step * i));
            if (grows)
                for (std::size_t j : {0u, 5u, 10u}) p.m[j] = 1 + step * i;
            std::vector<Placed> operands{{k, {}}, {dice_.one_in(5) ? other : rung, p}};
            if (dice_.one_in(2)) std::swap(operands[0], operands[1]);
            k = combined(dice_.one_in(2) ? SetOp::kDifference : operation(), std::move(operands));
        }
        return dice_.one_in(2) ? k : combined(SetOp::kUnion, {{k, placement()}, {other, {}}});
    }

    Theme theme_;
    Dice dice_;
    SolidBuilder builder_;
    double scale_ = 1;
};

}  // namespace

const char* name_of(Theme theme) {
    constexpr const char* names[kThemes] = {"planes", "round", "everything", "stack", "instances", "chain", "thin", "wedge", "ladder", "far", "convex"};
    return names[static_cast<int>(theme)];
}

RandomSolid random_solid(Theme theme, std::uint64_t seed, const SolidPasses& passes, const Placement& outer) { return Maker(theme, seed, passes).make(outer); }

Ray random_ray(const RandomSolid& solid, std::mt19937_64& random) {
    Dice dice(random());
    const auto at = [&](const std::vector<Vec3>& list, Vec3 otherwise) {
        return list.empty() ? otherwise : list[static_cast<std::size_t>(dice.integer(0, static_cast<int>(list.size()) - 1))];
    };
    const auto anywhere = [&] { return Vec3(dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)) * solid.size + at(solid.points, Vec3(0)) * 0.5; };
    const Vec3 p = at(solid.points, Vec3(0)), q = at(solid.points, Vec3(1));
    Ray r;
    const int kind = dice.integer(0, 9);
    if (kind < 2) r.direction = anywhere() - (r.origin = anywhere());                                  // anywhere
    else if (kind < 4) r.direction = p - (r.origin = anywhere());                                       // through a point
    else if (kind < 6) r.direction = q - p, r.origin = p - r.direction * dice.pick<double>({0, 1, 0.5, -0.5, 2});  // through two
    else if (kind < 9) r.direction = at(solid.directions, Vec3(1, 0, 0)), r.origin = p - r.direction * dice.pick<double>({0, 8, 1, 0.5, -0.25});
    else r.origin = p, r.direction = Vec3(dice.integer(-2, 2), dice.integer(-2, 2), dice.integer(-2, 2));
    if (dice.one_in(12)) r.direction = -r.direction;
    if (dice.one_in(12)) r.direction *= dice.real(0.01, 100);
    // Corners that were moved by rounding, and their differences, may be smaller than may be asked.
    for (Vec3* v : {&r.origin, &r.direction})
        for (int k = 0; k < 3; ++k)
            if (std::fabs((*v)[k]) < 0x1p-300) (*v)[k] = 0;
    if (r.direction == Vec3(0)) r.direction = Vec3(0, 0, 1);
    return r;
}

std::string to_text(const Ray& r) {
    return fmt::format("{{{:a}, {:a}, {:a}}}, {{{:a}, {:a}, {:a}}}", r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z);
}

}  // namespace whittle::support
