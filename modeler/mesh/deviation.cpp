#include "modeler/mesh/deviation.h"

#include <algorithm>
#include <cmath>

#include "modeler/arrange/box_tree.h"

namespace whittle {
namespace {

using Piece = std::array<Vec3, 3>;

// Pieces beyond which the answer is not awaited: some ten seconds.
constexpr std::uint64_t kMostPieces = 10'000'000;

Piece piece_of(const Mesh& mesh, std::size_t i) {
    const Triangle& t = mesh.triangles[i];
    return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

double distance_to_side(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double l2 = glm::dot(ab, ab), t = l2 > 0 ? std::clamp(glm::dot(p - a, ab) / l2, 0.0, 1.0) : 0;
    return glm::length(p - a - t * ab);
}

// A needle's sides stand for it: rounding decides where its normal points.
double distance_to(const Vec3& p, const Piece& t) {
    constexpr double kNeedle = 0x1p-30;
    const Vec3 u = t[1] - t[0], v = t[2] - t[0], n = glm::cross(u, v);
    const double length = glm::length(n);
    bool over = length > kNeedle * (glm::dot(u, u) + glm::dot(v, v));
    for (std::size_t k = 0; over && k < 3; ++k) over = glm::dot(glm::cross(t[(k + 1) % 3] - t[k], p - t[k]), n) >= 0;
    const double sides = std::min({distance_to_side(p, t[0], t[1]), distance_to_side(p, t[1], t[2]), distance_to_side(p, t[2], t[0])});
    return over ? std::min(sides, std::fabs(glm::dot(p - t[0], n)) / length) : sides;
}

DoubleBox box_of(const Piece& p) {
    DoubleBox box = DoubleBox::at({p[0].x, p[0].y, p[0].z});
    box.include(DoubleBox::at({p[1].x, p[1].y, p[1].z}));
    box.include(DoubleBox::at({p[2].x, p[2].y, p[2].z}));
    return box;
}

BoxTree tree_of(const Mesh& mesh, std::vector<Piece>& pieces) {
    std::vector<DoubleBox> boxes;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        pieces.push_back(piece_of(mesh, i));
        boxes.push_back(box_of(pieces.back()));
    }
    std::vector<std::uint32_t> owners(boxes.size(), BoxTree::kMixed);
    return {std::move(boxes), std::move(owners)};
}

class Deviation {
public:
    Deviation(const Mesh& b, double most) : most_(most), tree_(tree_of(b, others_)) {}

    std::optional<double> of(const Mesh& a) {
        for (std::size_t i = 0; i < a.triangles.size(); ++i) {
            todo_.assign(1, piece_of(a, i));
            while (!todo_.empty()) {
                const Piece piece = todo_.back();
                todo_.pop_back();
                if (++pieces_ > kMostPieces || !shown(piece)) return std::nullopt;
            }
        }
        return bound_;
    }

private:
    // False where a corner is farther than `most`, so that no halving helps.
    bool shown(const Piece& piece) {
        double best = HUGE_VAL;
        std::array<double, 3> nearest{HUGE_VAL, HUGE_VAL, HUGE_VAL};
        DoubleBox room = box_of(piece);
        for (std::size_t k = 0; k < 3; ++k) room.lo[k] -= most_, room.hi[k] += most_;
        tree_.touching(room, [&](std::uint32_t i) {
            if (best <= bound_) return;
            double farthest = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double d = distance_to(piece[k], others_[i]);
                nearest[k] = std::min(nearest[k], d);
                farthest = std::max(farthest, d);
            }
            best = std::min(best, farthest);
        });
        if (best <= most_) {
            bound_ = std::max(bound_, best);
            return true;
        }
        if (*std::max_element(nearest.begin(), nearest.end()) > most_) return false;
        halve(piece);
        return true;
    }

    void halve(const Piece& p) {
        std::size_t k = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (glm::distance(p[i], p[(i + 1) % 3]) > glm::distance(p[k], p[(k + 1) % 3])) k = i;
        const Vec3 middle = (p[k] + p[(k + 1) % 3]) * 0.5;
        todo_.push_back({p[k], middle, p[(k + 2) % 3]});
        todo_.push_back({middle, p[(k + 1) % 3], p[(k + 2) % 3]});
    }

    double most_, bound_ = 0;
    std::uint64_t pieces_ = 0;
    std::vector<Piece> others_, todo_;
    BoxTree tree_;
};

}  // namespace

std::optional<double> deviation_within(const Mesh& a, const Mesh& b, double most) { return Deviation(b, most).of(a); }

std::optional<double> hausdorff_within(const Mesh& a, const Mesh& b, double most) {
    const auto there = deviation_within(a, b, most);
    if (!there) return std::nullopt;
    const auto back = deviation_within(b, a, most);
    if (!back) return std::nullopt;
    return std::max(*there, *back);
}

struct Nearness::Facets {
    explicit Facets(const Mesh& mesh) : tree(tree_of(mesh, pieces)) {}
    std::vector<Piece> pieces;
    BoxTree tree;
};

Nearness::Nearness(const Mesh& surface) : facets_(std::make_unique<const Facets>(surface)) {}
Nearness::~Nearness() = default;

bool Nearness::within(const Vec3& p, double distance) const {
    DoubleBox room = DoubleBox::at({p.x, p.y, p.z});
    for (std::size_t k = 0; k < 3; ++k) room.lo[k] -= distance, room.hi[k] += distance;
    bool found = false;
    facets_->tree.touching(room, [&](std::uint32_t i) { found = found || distance_to(p, facets_->pieces[i]) <= distance; });
    return found;
}

}  // namespace whittle
