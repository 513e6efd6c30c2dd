#include "modeler/export/pov_growth.h"

#include <algorithm>
#include <cmath>

namespace whittle {
namespace {

constexpr double kStepShare = 0x1p-20;
// Operands of a union among which colours are compared pair by pair.
constexpr std::size_t kMostCompared = 256;

double axis_length(const Placement& p, int column) { return glm::length(Vec3(p.linear(0, column), p.linear(1, column), p.linear(2, column))); }

bool touch(const Bounds& a, const Bounds& b) {
    return !a.empty() && !b.empty() && glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

bool finite(double x) { return std::isfinite(x); }

}  // namespace

PovGrowth::PovGrowth(const Solid& solid) : solid_(solid), step_mm_(0) {
    const Bounds box = solid.root_bounds();
    if (box.empty()) return;
    const double diagonal = glm::length(box.hi - box.lo);
    if (finite(diagonal)) step_mm_ = diagonal * kStepShare;
}

std::vector<int> PovGrowth::steps_of_operands(const Combination& c) {
    std::vector<int> steps(c.operands.size(), 0);
    if (c.op != SetOp::kUnion) {
        int most = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            // Subtracted operands are as large as each other: among them nothing shows but their union.
            steps[i] = i == 0 ? 0 : c.op == SetOp::kDifference ? most_within(c.operands[0].node) + 1 : most + 1;
            most = std::max(most, steps[i] + most_within(c.operands[i].node));
        }
        return steps;
    }
    if (steps.size() > kMostCompared) return steps;
    std::vector<Bounds> boxes;
    for (const Use& use : c.operands) boxes.push_back(use_bounds(solid_.bounds(use.node), use, solid_.motion(use.motion)));
    for (std::size_t i = steps.size(); i-- > 0;)
        for (std::size_t j = i + 1; j < steps.size(); ++j)
            if (solid_.label(c.operands[i].label).material != solid_.label(c.operands[j].label).material && touch(boxes[i], boxes[j]))
                steps[i] = std::max(steps[i], steps[j] + most_within(c.operands[j].node) + 1);
    return steps;
}

int PovGrowth::most_within(NodeId node) {
    if (const auto known = most_within_.find(node); known != most_within_.end()) return known->second;
    int most = 0;
    if (const auto* c = std::get_if<Combination>(&solid_.node(node))) {
        const std::vector<int> steps = steps_of_operands(*c);
        for (std::size_t i = 0; i < steps.size(); ++i) most = std::max(most, steps[i] + most_within(c->operands[i].node));
    }
    return most_within_[node] = most;
}

PovGrowth::Key PovGrowth::key(const PovPlace& place) const {
    if (place.steps == 0) return {};
    const auto rounded = [&](int axis) { return static_cast<int>(std::lround(std::log2(std::max(axis_length(place.frame, axis), 0x1p-100)) * 256)); };
    return {place.steps, rounded(0), rounded(1), rounded(2)};
}

Placement PovGrowth::grown(const Bounds& leaf, const PovPlace& place) const {
    if (place.steps == 0 || leaf.empty()) return {};
    Placement out;
    for (int axis = 0; axis < 3; ++axis) {
        const double half = (leaf.hi[axis] - leaf.lo[axis]) / 2, middle = (leaf.hi[axis] + leaf.lo[axis]) / 2;
        const double by = place.steps * step_mm_ / (half * axis_length(place.frame, axis));
        if (!finite(half) || !finite(by) || !(by > 0)) continue;
        out.m[static_cast<std::size_t>(5 * axis)] = 1 + by;
        out.m[static_cast<std::size_t>(4 * axis + 3)] = -middle * by;
    }
    return out;
}

}  // namespace whittle
