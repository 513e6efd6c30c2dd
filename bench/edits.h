// edits.h — whittle-bench edits: what a change of the text costs to take in, part by part.
#pragma once

#include <string>

namespace whittle::bench {

struct EditOptions {
    int primitives = 10'000;  // in hundreds
    int rounds = 7;
    std::string csv;
};

// A plate less turned pins, as text: read, canonicalised and compiled; then the same after a change of the camera and after a change of one pin's radius,
// as `render --watch` takes them in. Median processor seconds of each step. Prints a table; returns the program's exit code.
int time_edits(const EditOptions& options);

}  // namespace whittle::bench
