#include "csg/solid/look_alike.h"

#include <algorithm>

namespace whittle {

namespace {

bool same_matter(const Solid& a, LabelId x, const Solid& b, LabelId y) {
    if (x == kNoLabel || y == kNoLabel) return x == y;
    return a.label(x).material == b.label(y).material;
}

bool same_use(const Solid& a, const Use& x, const Solid& b, const Use& y) {
    const bool motion = x.motion == 0 || y.motion == 0 ? x.motion == y.motion : a.motion(x.motion) == b.motion(y.motion);
    return x.node == y.node && motion && x.placement == y.placement && same_matter(a, x.label, b, y.label);
}

bool same_node(const Solid& a, const Solid& b, NodeId id) {
    const auto *x = std::get_if<Combination>(&a.node(id)), *y = std::get_if<Combination>(&b.node(id));
    if (!x || !y) return !x && !y && a.node(id) == b.node(id);
    return x->op == y->op && std::equal(x->operands.begin(), x->operands.end(), y->operands.begin(), y->operands.end(),
                                        [&](const Use& u, const Use& v) { return same_use(a, u, b, v); });
}

}  // namespace

bool look_alike(const Solid& a, const Solid& b) {
    if (a.node_count() != b.node_count() || !same_use(a, a.root(), b, b.root())) return false;
    for (NodeId id = 0; id < a.node_count(); ++id)
        if (!same_node(a, b, id)) return false;
    return true;
}

}  // namespace whittle
