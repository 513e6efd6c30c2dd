#include "csg/solid/part_solids.h"

#include <algorithm>
#include <map>

namespace whittle {
namespace {

// Copies nodes of one solid into another, whole or only what belongs to a part.
class Divider {
public:
    explicit Divider(const Solid& solid) : solid_(solid) { collect(solid.root(), {}); }

    const std::vector<std::string>& names() const { return names_; }

    Solid part(const std::string& name) {
        builder_ = SolidBuilder();
        copied_.clear();
        restricted_.clear();
        wanted_ = name;
        return builder_.finish(restricted(solid_.root(), {}));
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

    Use copied_use(const Use& use, NodeId node) {
        Use copy = use;
        copy.node = node;
        copy.label = use.label == kNoLabel ? kNoLabel : builder_.label(solid_.label(use.label));
        copy.motion = use.motion == 0 ? 0 : builder_.motion(solid_.motion(use.motion));
        return copy;
    }

    NodeId copied(NodeId id) {
        if (const auto found = copied_.find(id); found != copied_.end()) return found->second;
        NodeId copy = kEmptyNode;
        if (const auto* c = std::get_if<Combination>(&solid_.node(id))) {
            std::vector<Use> operands;
            for (const Use& use : c->operands) operands.push_back(copied_use(use, copied(use.node)));
            copy = operands.empty() ? kEmptyNode : builder_.combine(c->op, std::move(operands));
        } else {
            Shape shape = std::get<Shape>(solid_.node(id));
            if (auto* e = std::get_if<shape::Extrusion>(&shape)) e->profile = copied(e->profile);
            if (auto* r = std::get_if<shape::Revolution>(&shape)) r->profile = copied(r->profile);
            copy = builder_.shape(std::move(shape));
        }
        return copied_[id] = copy;
    }

    // What of the use belongs to the wanted part; an empty use where nothing does.
    Use restricted(const Use& use, const std::string& outer) {
        const std::string part = part_of(use, outer);
        const auto key = std::pair(use.node, part);
        auto known = restricted_.find(key);
        if (known == restricted_.end()) known = restricted_.emplace(key, restricted_node(use.node, part)).first;
        return known->second == kEmptyNode ? Use{} : copied_use(use, known->second);
    }

    NodeId restricted_node(NodeId id, const std::string& part) {
        const auto* c = std::get_if<Combination>(&solid_.node(id));
        if (!c) return part == wanted_ ? copied(id) : kEmptyNode;
        std::vector<Use> operands;
        for (std::size_t i = 0; i < c->operands.size(); ++i) {
            if (c->op == SetOp::kUnion || i == 0) operands.push_back(restricted(c->operands[i], part));
            else operands.push_back(copied_use(c->operands[i], copied(c->operands[i].node)));
            if (c->op == SetOp::kUnion && operands.back().node == kEmptyNode) operands.pop_back();
            else if (i == 0 && c->op != SetOp::kUnion && operands.back().node == kEmptyNode) return kEmptyNode;
        }
        return operands.empty() ? kEmptyNode : builder_.combine(c->op, std::move(operands));
    }

    const Solid& solid_;
    SolidBuilder builder_;
    std::string wanted_;
    std::vector<std::string> names_;
    std::map<std::pair<NodeId, std::string>, bool> visited_;
    std::map<NodeId, NodeId> copied_;
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
