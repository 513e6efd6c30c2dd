#include "modeler/mesh/grid_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace whittle {
namespace {

// Rotations that differ by less are one: a few roundings of products of a few rotations.
constexpr double kRotationError = 0x1p-44;

Vec3 column(const Placement& p, int j) { return {p.linear(0, j), p.linear(1, j), p.linear(2, j)}; }

// The rotation in a placement that keeps right angles; nothing where it does not, or where the grid's axes are its own up to their order and signs.
std::optional<Placement> rotation_of(const Placement& p) {
    Placement out;
    for (int j = 0; j < 3; ++j) {
        const Vec3 c = column(p, j);
        const double length = glm::length(c);
        if (!(length > 0)) return std::nullopt;
        for (int i = 0; i < 3; ++i) out.m[static_cast<std::size_t>(4 * i + j)] = c[i] / length;
    }
    if (determinant(out) < 0)
        for (int i = 0; i < 3; ++i) out.m[static_cast<std::size_t>(4 * i + 2)] *= -1;
    bool turned = false;
    for (int j = 0; j < 3; ++j) {
        if (std::fabs(glm::dot(column(out, j), column(out, (j + 1) % 3))) > kRotationError) return std::nullopt;
        for (int i = 0; i < 3; ++i) {
            const double x = std::fabs(out.linear(i, j));
            turned = turned || (x > kRotationError && x < 1 - kRotationError);
        }
    }
    return turned ? std::optional(out) : std::nullopt;
}

class Survey {
public:
    explicit Survey(const Solid& solid) : solid_(solid) {}

    // Leaves below the use.
    std::uint64_t visit(const Use& use, const Placement& outer, bool within_turned) {
        Placement placement = outer * use.placement;
        if (use.motion != 0) placement = placement * solid_.motion(use.motion).start;
        std::optional<Placement> rotation;
        if (!within_turned) rotation = rotation_of(placement);
        std::uint64_t leaves = 1;
        if (const auto* c = std::get_if<Combination>(&solid_.node(use.node))) {
            leaves = 0;
            for (const Use& operand : c->operands) leaves += visit(operand, placement, within_turned || rotation);
        }
        if (rotation && leaves > most_) most_ = leaves, best_ = *rotation;
        return leaves;
    }
    Placement most_common(std::uint64_t all_leaves) const { return 2 * most_ > all_leaves ? best_ : Placement{}; }

private:
    const Solid& solid_;
    std::uint64_t most_ = 0;
    Placement best_;
};

}  // namespace

bool keeps_axes(const Placement& p) {
    for (int j = 0; j < 3; ++j) {
        const Vec3 c = glm::abs(column(p, j));
        const double most = std::max({c.x, c.y, c.z});
        if (c.x + c.y + c.z - most > kRotationError * most) return false;
    }
    return true;
}

Placement grid_frame(const Solid& solid, const Use& root) {
    Survey survey(solid);
    const std::uint64_t leaves = survey.visit(root, Placement{}, false);
    return survey.most_common(leaves);
}

Placement turned_back(const Placement& rotation) {
    Placement out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out.m[static_cast<std::size_t>(4 * i + j)] = rotation.linear(j, i);
    return out;
}

}  // namespace whittle
