// use_of.h — a use of a node without label or motion.
#pragma once

#include "csg/solid/solid.h"

namespace whittle {

inline Use use_of(NodeId node, const Placement& placement = {}) {
    Use use;
    use.node = node;
    use.placement = placement;
    return use;
}

}  // namespace whittle
