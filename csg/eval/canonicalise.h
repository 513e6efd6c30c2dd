// canonicalise.h — scene → solid: drops what is nothing, resolves colours and matter to labels, picks true curves or facets.
#pragma once

#include "csg/eval/scene.h"
#include "csg/lang/diagnostics.h"
#include "csg/solid/outside.h"
#include "csg/solid/solid.h"

namespace whittle {

// --curves: when does a round thing become OpenSCAD's facets?
enum class Curves { kAuto, kExact, kFaceted };

struct CanonicaliseOptions {
    Curves curves = Curves::kAuto;
    int exact_threshold = 32;  // --curves=exact:N
    bool preview = false;      // draw # and %
    SolidPasses passes;
};

struct Canonical {
    Solid solid;
    bool is_2d = false;
    bool something_left_out = false;  // a module not there yet, mixed dimensions, dropped geometry: exit code 1
    SkipCounts skipped;
    std::uint64_t mesh_fallbacks = 0;  // operands that became meshes for want of an exact form
};

// Never fails: what cannot be made is left out with a diagnostic and `something_left_out`. `outside` may be null.
Canonical canonicalise(const Scene& scene, const CanonicaliseOptions& options, Outside* outside, Diagnostics& diagnostics);

}  // namespace whittle
