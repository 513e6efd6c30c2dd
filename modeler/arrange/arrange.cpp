#include "modeler/arrange/arrange.h"

#include <chrono>

#include "modeler/arrange/cells.h"
#include "modeler/arrange/surface.h"

namespace whittle {
namespace {

class Lap {
public:
    double seconds() {
        const auto now = std::chrono::steady_clock::now();
        const double passed = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return passed;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Result<ArrangedMesh> arranged(std::span<const Operand> operands, Expression& expression, const ArrangeOptions& options, ArrangeStats& stats) {
    Lap lap;
    Patches patches = patches_of(operands);
    const BoxTree tree(patches.boxes, patches.owner);
    const Buried buried = options.bury ? buried_facets(patches, operands, expression) : nothing_buried(patches, operands);
    const auto small = small_faces_of(patches, tree, buried, options.cancelled);
    if (!small) return tl::unexpected(small.error());
    stats.buried += buried.count;
    stats.pairs += small->pairs;
    stats.small_faces += small->faces.size();
    stats.seconds_cut += lap.seconds();
    const auto sides = classify(patches, tree, *small, buried, operands, options.matters ? Matters::kTell : Matters::kLeaveOut, expression);
    if (!sides) return tl::unexpected(sides.error());
    stats.seconds_classify += lap.seconds();
    ArrangedMesh mesh = surface_of(patches, operands, *small, *sides, options, stats);
    stats.seconds_join += lap.seconds();
    return mesh;
}

}  // namespace

Result<ArrangedMesh> arrange(std::span<const Operand> operands, Expression& expression, const ArrangeOptions& options, ArrangeStats& stats) {
    if (options.bury) {
        // Missing walls leave more pieces to be told inside from outside by a line, and one may be too thin for that.
        ArrangeStats tried;
        auto made = arranged(operands, expression, options, tried);
        if (made || tried.buried == 0 || made.error().fault == Fault::kInterrupted) {
            stats += tried;
            return made;
        }
    }
    ArrangeOptions whole = options;
    whole.bury = false;
    return arranged(operands, expression, whole, stats);
}

Result<ArrangedMesh> arrange_piece(const GridMesh& piece, const std::vector<bool>& sound, const std::function<bool()>& cancelled) {
    const Operand operand{&piece, {}, 0, 0, true};
    const std::span<const Operand> operands(&operand, 1);
    Expression alone;
    alone.finish(alone.operand());
    Patches patches = patches_of(operands);
    const BoxTree tree(patches.boxes, patches.owner);
    const auto small = small_faces_of(patches, tree, nothing_buried(patches, operands), cancelled);
    if (!small) return tl::unexpected(small.error());
    const auto sides = classify_piece(patches, *small, operands, sound, alone);
    if (!sides) return tl::unexpected(sides.error());
    ArrangeOptions options;
    options.join = false;  // a corner of the border may be one of the rest too
    ArrangeStats stats;
    return surface_of(patches, operands, *small, *sides, options, stats);
}

}  // namespace whittle
