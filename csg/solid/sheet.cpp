#include "csg/solid/sheet.h"

#include <map>

namespace whittle {
namespace {

class Raiser {
public:
    Raiser(const Solid& flat, double z0, double z1) : flat_(flat), z0_(z0), z1_(z1) {}
    Solid run() { return builder_.finish(raised(flat_.root())); }

private:
    Use raised(const Use& use) {
        Use out = use;
        out.node = raised(use.node);
        out.label = use.label == kNoLabel ? kNoLabel : builder_.label(flat_.label(use.label));
        out.motion = use.motion == 0 ? 0 : builder_.motion(flat_.motion(use.motion));
        return out;
    }

    NodeId raised(NodeId id) {
        if (id == kEmptyNode) return kEmptyNode;
        if (const auto found = known_.find(id); found != known_.end()) return found->second;
        NodeId made = kEmptyNode;
        if (const auto* c = std::get_if<Combination>(&flat_.node(id))) {
            std::vector<Use> operands;
            for (const Use& use : c->operands) operands.push_back(raised(use));
            made = builder_.combine(c->op, std::move(operands));
        } else {
            made = builder_.shape(raised(std::get<Shape>(flat_.node(id))));
        }
        return known_[id] = made;
    }

    Shape raised(const Shape& shape) {
        if (const auto* r = std::get_if<shape::Rectangle>(&shape)) return shape::Box{{r->lo, z0_}, {r->hi, z1_}};
        if (const auto* d = std::get_if<shape::Disc>(&shape)) return shape::Frustum{z0_, z1_, d->r, d->r};
        return shape::Extrusion{builder_.shape(shape), z0_, z1_, 0, Vec2(1), 0};
    }

    const Solid& flat_;
    double z0_, z1_;
    SolidBuilder builder_;
    std::map<NodeId, NodeId> known_;
};

}  // namespace

Solid as_sheet(const Solid& flat, double z0, double z1) { return Raiser(flat, z0, z1).run(); }

}  // namespace whittle
