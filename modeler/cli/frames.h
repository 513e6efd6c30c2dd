// frames.h — an animation as what it is: the same request once a frame, with its time and its file names.
#pragma once

#include <vector>

#include "modeler/cli/request.h"

namespace whittle {

// The requests of --animate N: frame i sees $t = i / N, and its number stands before the suffix of each output in five digits (part00007.png), as with
// OpenSCAD. An output nobody named is named here. Without --animate: the request itself.
std::vector<Request> frames_of(const Request& request);

}  // namespace whittle
