#include "tracer/light/matter_parts.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "csg/solid/solid_copy.h"

namespace whittle {

namespace {

// What decides where light goes inside. What is opaque is of one kind as far as no clear matter begins in between: of equal priority the first in the
// author's order wins, so it matters which of the clear ones a solid stands behind.
struct Kind {
    Material material;
    bool clear;
    std::size_t behind = 0;  // opaque: clear kinds that begin before it
    bool operator==(const Kind&) const = default;
};

// Walks the solid with the materials of the path, the outermost first.
class Divider {
public:
    explicit Divider(const Solid& solid) : solid_(solid), copy_(solid) { collect(solid.root(), Material{}); }

    const std::vector<Kind>& kinds() const { return kinds_; }

    Solid part(std::size_t kind) {
        copy_.restart();
        restricted_.clear();
        kind_ = kind;
        clears_begun_ = 0;
        return copy_.builder.finish(restricted(solid_.root(), Material{}));
    }

private:
    Material inside(const Use& use, const Material& outer) const { return use.label == kNoLabel ? outer : nested(outer, solid_.label(use.label).material); }

    // Of a leaf at this place of a walk in author's order, which counts the clear kinds it met.
    Kind kind_here(const Material& material) {
        if (!is_clear(material)) return {Material{}, false, clears_begun_};
        const auto found = std::find(clears_.begin(), clears_.end(), material);
        clears_begun_ = std::max(clears_begun_, static_cast<std::size_t>(found - clears_.begin()) + 1);
        if (found == clears_.end()) clears_.push_back(material);
        return {material, true};
    }

    // Lists the kinds in author's order; cutters have none. What was walked before brings no clear kind that is new.
    void collect(const Use& use, const Material& outer) {
        const Material material = inside(use, outer);
        if (!visited_.insert({use.node, number_of(material), clears_begun_}).second) return;
        if (const auto* combination = std::get_if<Combination>(&solid_.node(use.node))) {
            const std::size_t count = combination->op == SetOp::kDifference ? 1 : combination->operands.size();
            for (std::size_t i = 0; i < std::min(count, combination->operands.size()); ++i) collect(combination->operands[i], material);
            return;
        }
        if (const NodeId part = copy_.part_of(use.node)) return collect(Use{part, kNoLabel, 0, {}}, material);
        const Kind kind = kind_here(material);
        if (std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end()) kinds_.push_back(kind);
    }

    // Distinct materials of paths, numbered.
    std::size_t number_of(const Material& material) {
        const auto found = std::find(materials_.begin(), materials_.end(), material);
        if (found != materials_.end()) return static_cast<std::size_t>(found - materials_.begin());
        materials_.push_back(material);
        return materials_.size() - 1;
    }

    Use restricted(const Use& use, const Material& outer) {
        const Material material = inside(use, outer);
        return copy_.use(use, restricted(use.node, material));
    }

    // The node where its matter is of the wanted kind.
    NodeId restricted(NodeId id, const Material& material) {
        const Place key{id, number_of(material), clears_begun_};
        if (const auto found = restricted_.find(key); found != restricted_.end()) {
            clears_begun_ = found->second.clears_begun;
            return found->second.node;
        }
        NodeId result = kEmptyNode;
        if (const auto* combination = std::get_if<Combination>(&solid_.node(id))) {
            result = restricted_combination(*combination, material);
        } else if (const NodeId part = copy_.part_of(id)) {
            result = copy_.made_of(id, restricted(part, material));
        } else if (kind_here(material) == kinds_[kind_]) {
            result = copy_.whole(id);
        }
        restricted_[key] = {result, clears_begun_};
        return result;
    }

    NodeId restricted_combination(const Combination& c, const Material& material) {
        if (c.operands.empty()) return kEmptyNode;
        std::vector<Use> wanted;
        for (std::size_t i = 0; i < c.operands.size(); ++i) {
            if (c.op == SetOp::kDifference && i > 0) break;
            const Use own = restricted(c.operands[i], material);
            if (own.node == kEmptyNode) continue;
            wanted.push_back(c.op == SetOp::kUnion ? own : beside_the_others(c, i, own));
        }
        if (wanted.empty()) return kEmptyNode;
        return copy_.builder.combine(SetOp::kUnion, std::move(wanted));
    }

    // Operand `i` of an intersection or difference cut down to `own`, with the other operands whole.
    Use beside_the_others(const Combination& c, std::size_t i, const Use& own) {
        std::vector<Use> operands;
        for (std::size_t k = 0; k < c.operands.size(); ++k) operands.push_back(k == i ? own : copy_.use(c.operands[k], copy_.whole(c.operands[k].node)));
        Use use;
        use.node = copy_.builder.combine(c.op, std::move(operands));
        return use;
    }

    // A node, its material's number, and the clear kinds that began before it.
    using Place = std::tuple<NodeId, std::size_t, std::size_t>;
    struct Restricted {
        NodeId node;
        std::size_t clears_begun;
    };

    const Solid& solid_;
    SolidCopy copy_;
    std::vector<Kind> kinds_;
    std::vector<Material> clears_;
    std::vector<Material> materials_;
    std::set<Place> visited_;
    std::map<Place, Restricted> restricted_;
    std::size_t kind_ = 0;
    std::size_t clears_begun_ = 0;
};

}  // namespace

std::vector<MatterPart> divided_by_matter(const Solid& solid) {
    Divider divider(solid);
    const bool clear = std::any_of(divider.kinds().begin(), divider.kinds().end(), [](const Kind& k) { return k.clear; });
    std::vector<MatterPart> parts;
    if (!clear) return parts;
    if (divider.kinds().size() == 1) {
        const Kind& only = divider.kinds()[0];
        parts.push_back({Solid{}, only.material, true, 0});
        return parts;
    }
    for (std::size_t k = 0; k < divider.kinds().size(); ++k) {
        const Kind& kind = divider.kinds()[k];
        parts.push_back({divider.part(k), kind.material, kind.clear, kind.material.priority.value_or(0)});
    }
    return parts;
}

}  // namespace whittle
