// verb_info.h — the verbs, what is said of them, and what makes a command line whole.
#pragma once

#include <string>
#include <string_view>

#include "csg/base/result.h"
#include "modeler/cli/request.h"

namespace whittle {

struct VerbInfo {
    const char* name;
    Verb verb;
    const char* usage;
    const char* summary;
};

// Null where there is none of that name.
const VerbInfo* verb_named(std::string_view name);

// The head of `whittle --help`, and the answer to --info.
std::string overview();
std::string info_text();

// A kCommand fault where options contradict each other or something is missing. `verb`: null for the form without one.
Result<void> validate(const VerbInfo* verb, const Request& request);

// Seed, threads and passes belong to every part that knows them.
void spread_common(Request& request);

}  // namespace whittle
