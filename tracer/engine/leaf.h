// leaf.h — where a leaf's membership changes along a ray. Private to the engine.
#pragma once

#include <vector>

#include "tracer/engine/ray_context.h"

namespace whittle {

// Appends the leaf's changes, ascending and without zero-length spans; returns its membership before the first. The leaf's `negated` is not applied.
bool leaf_events(const Leaf& leaf, RayContext& context, std::vector<Event>& out);

// The kinds behind it.
bool cell_events(const Leaf& leaf, RayContext& context, std::vector<Event>& out);
bool prism_events(const PrismLeaf& prism, RayContext& context, std::vector<Event>& out);
bool mesh_events(const ParityMesh& mesh, RayContext& context, std::vector<Event>& out);

// Sorts events from `first` on and drops pairs at one place: what is left are changes by parity.
void sort_by_parity(RayContext& context, std::vector<Event>& events, std::size_t first);

}  // namespace whittle
