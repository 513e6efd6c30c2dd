// result.h — faults of the world, returned as values. Faults in the author's text are diagnostics (csg/lang/diagnostics.h) instead.
#pragma once

#include <string>

#include <tl/expected.hpp>

namespace whittle {

// What the program's exit code will say (docs: command line).
enum class Fault {
    kScene = 1,    // the scene is wrong
    kCommand = 2,  // the command line is wrong
    kWorld = 3,    // a file, the memory, the time or the installation is wrong
    kInterrupted = 130
};

struct Error {
    Fault fault = Fault::kWorld;
    std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(Fault fault, std::string message) { return tl::unexpected<Error>(Error{fault, std::move(message)}); }

}  // namespace whittle
