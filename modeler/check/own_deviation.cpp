#include "modeler/check/own_deviation.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/profile.h"
#include "modeler/mesh/stretch.h"
#include "tracer/engine/turned_chords.h"

namespace whittle {
namespace {

bool keeps_discs(const Placement& p) {
    const Vec2 x{p.linear(0, 0), p.linear(1, 0)}, y{p.linear(0, 1), p.linear(1, 1)};
    constexpr double kRounding = 0x1p-48;
    const double size = glm::dot(x, x) + glm::dot(y, y);
    return std::fabs(glm::dot(x, x) - glm::dot(y, y)) <= kRounding * size && std::fabs(glm::dot(x, y)) <= kRounding * size;
}

class Survey {
public:
    explicit Survey(const Solid& solid) : solid_(solid) {}

    double of(const Use& use, const Placement& outer) {
        Placement placement = outer * use.placement;
        if (use.motion != 0) placement = outer * solid_.motion(use.motion).start * use.placement;
        double most = 0;
        if (const auto* c = std::get_if<Combination>(&solid_.node(use.node))) {
            for (const Use& operand : c->operands) most = std::max(most, of(operand, placement));
            return most;
        }
        const double own = of_shape(use.node);
        return own > 0 ? own * largest_stretch(placement) : 0;
    }

private:
    double of_shape(NodeId id) {
        const auto& shape = std::get<Shape>(solid_.node(id));
        if (const auto* r = std::get_if<shape::Revolution>(&shape); r && r->fragments == 0) return kTurnedTolerance * largest_chorded(r->profile, {}, Discs::kStayTrue);
        if (const auto* e = std::get_if<shape::Extrusion>(&shape); e && e->slices > 0) return kProfileTolerance * largest_chorded(e->profile, {}, Discs::kCut);
        return 0;
    }

    enum class Discs { kStayTrue, kCut };
    // The size of the largest shape in a profile of which chords are taken; 0: there is none.
    double largest_chorded(NodeId id, const Placement& outer, Discs discs) const {
        if (const auto* c = std::get_if<Combination>(&solid_.node(id))) {
            double most = 0;
            for (const Use& operand : c->operands) most = std::max(most, largest_chorded(operand.node, outer * operand.placement, discs));
            return most;
        }
        const auto& shape = std::get<Shape>(solid_.node(id));
        if (!is_curved_2d(shape) || std::holds_alternative<shape::Polygon>(shape)) return 0;  // of a section the mesh takes the same chords
        if (discs == Discs::kStayTrue && std::holds_alternative<shape::Disc>(shape) && keeps_discs(outer)) return 0;
        const auto* disc = std::get_if<shape::Disc>(&shape);
        const Bounds& box = solid_.bounds(id);
        return (disc && discs == Discs::kStayTrue ? disc->r : glm::length(box.hi - box.lo)) * largest_stretch(outer);
    }

    const Solid& solid_;
};

}  // namespace

double own_deviation(const Solid& solid) { return solid.root().node == kEmptyNode ? 0 : Survey(solid).of(solid.root(), Placement{}); }

}  // namespace whittle
