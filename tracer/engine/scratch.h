// scratch.h — what a Scratch holds. Private to the engine.
#pragma once

#include "tracer/engine/packet.h"
#include "tracer/engine/walker.h"

namespace whittle {

struct Scratch::Impl {
    Walker walker;
    std::vector<Walker::Cause> causes;
    TileMemory tile;
};

}  // namespace whittle
