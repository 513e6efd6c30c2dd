// true_outlines.h — random solids hold sections whose polygons are made up: these are replaced by the outlines that a scene would have been given.
#pragma once

#include <map>
#include <memory>

#include <catch2/catch.hpp>

#include "csg/solid/solid_copy.h"
#include "modeler/mesh/outside_mesh.h"

namespace whittle::test {

class TrueOutlines {
public:
    explicit TrueOutlines(const Solid& from) : from_(from), copy_(from) {}

    Solid run() { return copy_.builder.finish(copy_.use(from_.root(), node(from_.root().node))); }

private:
    NodeId node(NodeId id) {
        if (const auto found = known_.find(id); found != known_.end()) return found->second;
        return known_[id] = made(id);
    }
    NodeId made(NodeId id) {
        if (const auto* c = std::get_if<Combination>(&from_.node(id))) {
            std::vector<Use> operands;
            for (const Use& each : c->operands) operands.push_back(copy_.use(each, node(each.node)));
            return operands.empty() ? kEmptyNode : copy_.builder.combine(c->op, std::move(operands));
        }
        const auto* polygon = std::get_if<shape::Polygon>(&std::get<Shape>(from_.node(id)));
        if (polygon && polygon->section != kEmptyNode) return outlined(polygon->section);
        return copy_.part_of(id) == kEmptyNode ? copy_.whole(id) : copy_.made_of(id, node(copy_.part_of(id)));
    }
    NodeId outlined(NodeId section) {
        Use whole;
        whole.node = section;
        const auto outline = section_by_mesh(from_, whole);
        REQUIRE(outline);
        if (outline->contours.empty()) return kEmptyNode;
        return copy_.builder.shape(shape::Polygon{std::make_shared<const FlatContours>(outline->contours), node(section), outline->deviation});
    }

    const Solid& from_;
    SolidCopy copy_;
    std::map<NodeId, NodeId> known_;
};

inline Solid with_true_outlines(const Solid& solid) { return TrueOutlines(solid).run(); }

}  // namespace whittle::test
