// cut_faces.h — which surfaces only cutters have, for pictures that show cuts.
#pragma once

#include <vector>

namespace whittle {

class Program;

// By class: do leaves have it that are subtracted (an odd number of times: c in a - (b - c) is not), and no others?
std::vector<bool> classes_of_cutters(const Program& program);

}  // namespace whittle
