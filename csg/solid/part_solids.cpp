#include "csg/solid/part_solids.h"

#include <algorithm>
#include <map>

#include "csg/solid/solid_copy.h"

namespace whittle {
namespace {

// Finds the parts, and copies what belongs to one.
class Divider {
public:
    explicit Divider(const Solid& solid) : solid_(solid), copy_(solid) { collect(solid.root(), {}); }

    const std::vector<std::string>& names() const { return names_; }

    Solid part(const std::string& name) {
        copy_.restart();
        restricted_.clear();
        wanted_ = name;
        return copy_.builder.finish(restricted(solid_.root(), {}));
    }

private:
    // The outermost part() wins.
    std::string part_of(const Use& use, const std::string& outer) const {
        return outer.empty() && use.label != kNoLabel ? solid_.label(use.label).part : outer;
    }

    void collect(const Use& use, const std::string& outer) {
        const std::string part = part_of(use, outer);
        if (!visited_.emplace(std::pair(use.node, part), true).second) return;
        if (const auto* c = std::get_if<Combination>(&solid_.node(use.node))) {
            const std::size_t count = c->op == SetOp::kUnion ? c->operands.size() : std::min<std::size_t>(1, c->operands.size());
            for (std::size_t i = 0; i < count; ++i) collect(c->operands[i], part);
        } else if (std::find(names_.begin(), names_.end(), part) == names_.end()) {
            names_.push_back(part);
        }
    }

    // What of the use belongs to the wanted part; an empty use where nothing does.
    Use restricted(const Use& use, const std::string& outer) {
        const std::string part = part_of(use, outer);
        const auto key = std::pair(use.node, part);
        auto known = restricted_.find(key);
        if (known == restricted_.end()) known = restricted_.emplace(key, restricted_node(use.node, part)).first;
        return known->second == kEmptyNode ? Use{} : copy_.use(use, known->second);
    }

    NodeId restricted_node(NodeId id, const std::string& part) {
        const auto* c = std::get_if<Combination>(&solid_.node(id));
        if (!c) return part == wanted_ ? copy_.whole(id) : kEmptyNode;
        std::vector<Use> operands;
        for (std::size_t i = 0; i < c->operands.size(); ++i) {
            if (c->op == SetOp::kUnion || i == 0) operands.push_back(restricted(c->operands[i], part));
            else operands.push_back(copy_.use(c->operands[i], copy_.whole(c->operands[i].node)));
            if (c->op == SetOp::kUnion && operands.back().node == kEmptyNode) operands.pop_back();
            else if (i == 0 && c->op != SetOp::kUnion && operands.back().node == kEmptyNode) return kEmptyNode;
        }
        return operands.empty() ? kEmptyNode : copy_.builder.combine(c->op, std::move(operands));
    }

    const Solid& solid_;
    SolidCopy copy_;
    std::string wanted_;
    std::vector<std::string> names_;
    std::map<std::pair<NodeId, std::string>, bool> visited_;
    std::map<std::pair<NodeId, std::string>, NodeId> restricted_;
};

}  // namespace

std::vector<NamedSolid> divided_by_part(const Solid& solid) {
    Divider divider(solid);
    std::vector<NamedSolid> out;
    for (const std::string& name : divider.names()) {
        NamedSolid part{name, divider.part(name)};
        if (part.solid.root().node != kEmptyNode) out.push_back(std::move(part));
    }
    return out;
}

}  // namespace whittle
