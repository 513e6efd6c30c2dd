// packet_coarse.h — packets in float. Private to the engine.
#pragma once

#include "tracer/engine/packet.h"

namespace whittle {

// First hits of a tile's rays into the rows of `memory`; where float cannot tell, the ray is deferred. False: too many are, or the tile is none for float;
// nothing is told then, and the tree stands where it stood. Requires: rays that go together, and a tree that has begun.
bool hits_in_float(const Program& program, const TileBounds& bounds, std::size_t rays, TileMemory& memory, EngineCounters& counters);

// Which rays of a tile are blocked before `memory.t`, which becomes -inf there, as packets in double tell; the rest as above. Rays that leave a surface are none for
// float.
bool blocked_in_float(const Program& program, const TileBounds& bounds, std::size_t rays, TileMemory& memory, EngineCounters& counters);

// What packets in float have found into the tile's own rows, with t, bounds and normals; defers rays whose border's use is not told (packet.cpp).
void finish_hits_in_float(const Program& program, std::size_t rays, TileMemory& memory);

}  // namespace whittle
