// rays.h — whittle-bench rays: million rays a second of each query on each scene, against peers, in one run.
#pragma once

#include <string>
#include <vector>

#include "bench/race.h"

namespace whittle::bench {

struct RaysOptions {
    std::vector<std::string> scenes{"S1", "S2", "S3", "S4", "S5", "S6"};  // names of make_scene()
    std::vector<std::string> files;                                       // scene files instead
    bool faceted = false, twins = false;                                  // files: OpenSCAD's facets; both, one after the other
    std::vector<std::string> queries{"first", "any", "spans"};
    std::vector<std::string> rays{"camera", "incoherent"};
    std::string only;                     // subjects whose name holds this
    std::vector<std::string> disabled;    // passes that Whittle's subjects do without
    RaceOptions race;
    std::string csv, json;
};

// Prints a table; returns the program's exit code.
int time_rays(const RaysOptions& options);

}  // namespace whittle::bench
