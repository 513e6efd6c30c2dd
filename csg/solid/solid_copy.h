// solid_copy.h — copies nodes of one solid into another: for what divides a solid into parts.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

class SolidCopy {
public:
    explicit SolidCopy(const Solid& from) : from_(from) {}

    SolidBuilder builder;

    // Begins another copy.
    void restart() {
        builder = SolidBuilder();
        copied_.clear();
    }

    // The use, of a node of the copy.
    Use use(const Use& use, NodeId node) {
        Use copy = use;
        copy.node = node;
        copy.label = use.label == kNoLabel ? kNoLabel : builder.label(from_.label(use.label));
        copy.motion = use.motion == 0 ? 0 : builder.motion(from_.motion(use.motion));
        return copy;
    }

    // The node with all below it, once.
    NodeId whole(NodeId id) {
        if (const auto found = copied_.find(id); found != copied_.end()) return found->second;
        NodeId copy = kEmptyNode;
        if (const auto* c = std::get_if<Combination>(&from_.node(id))) {
            std::vector<Use> operands;
            for (const Use& each : c->operands) operands.push_back(use(each, whole(each.node)));
            copy = operands.empty() ? kEmptyNode : builder.combine(c->op, std::move(operands));
        } else if (const NodeId part = part_of(id)) {
            copy = made_of(id, whole(part));
        } else {
            copy = builder.shape(std::get<Shape>(from_.node(id)));
        }
        return copied_[id] = copy;
    }

    // The node that a shape is made of: what it sweeps, or is the section of; kEmptyNode where there is none.
    NodeId part_of(NodeId shape) const {
        const Shape& s = std::get<Shape>(from_.node(shape));
        if (const auto* e = std::get_if<shape::Extrusion>(&s)) return e->profile;
        if (const auto* r = std::get_if<shape::Revolution>(&s)) return r->profile;
        if (const auto* p = std::get_if<shape::Polygon>(&s)) return p->section;
        return kEmptyNode;
    }

    // The shape, made of a node of the copy.
    NodeId made_of(NodeId shape, NodeId part) {
        if (part == kEmptyNode) return kEmptyNode;
        Shape s = std::get<Shape>(from_.node(shape));
        if (auto* e = std::get_if<shape::Extrusion>(&s)) e->profile = part;
        if (auto* r = std::get_if<shape::Revolution>(&s)) r->profile = part;
        if (auto* p = std::get_if<shape::Polygon>(&s)) p->section = part;
        return builder.shape(std::move(s));
    }

private:
    const Solid& from_;
    std::map<NodeId, NodeId> copied_;
};

}  // namespace whittle
