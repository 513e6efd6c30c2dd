// interfaces.h — where, inside the solid, one matter ends and another begins.
//
// A place belongs to the use that holds it and is not subtracted; of several to the one of the highest priority, then to the first in the author's order
// (docs/numerics.md, labels). Spans go on where only that changes; these places are what a section by matter, or light in a glass of water, needs beside them.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/engine/engine.h"

namespace whittle {

// At `at` matter changes from that of use `from` to that of use `at.use`, and their materials differ. at.normal faces the ray.
struct Interface {
    End at;
    std::uint32_t from = 0;
};

using Interfaces = std::vector<Interface>;

// all_spans(), and the interfaces of t >= 0 in order; none lies at an end of a span.
void all_spans(const Program& program, const Ray& ray, Scratch& scratch, Spans& spans, Interfaces& interfaces);

}  // namespace whittle
