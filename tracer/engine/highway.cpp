// highway.cpp — the two functions of Highway's library that the dispatch to SIMD targets calls; the library itself is opened when a packet of rays first asks.
//
// Loading libhwy runs its clock calibration, 1 to 2 ms: two fifths of the processor time of a start of the program, which most of its uses never need.
#include <cstdint>

#include <dlfcn.h>

#include <hwy/highway.h>
#include <hwy/targets.h>

#ifndef WHITTLE_HIGHWAY_LIBRARY
#error "the build names the library"
#endif

namespace hwy {
namespace {

using Ask = std::int64_t (*)();

// The library's own answer; null where it is not installed.
Ask library_answer() {
    void* library = dlopen(WHITTLE_HIGHWAY_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    return library ? reinterpret_cast<Ask>(dlsym(library, "_ZN3hwy16SupportedTargetsEv")) : nullptr;
}

}  // namespace

// Without the library, the target that every machine of this architecture has: the same bits, more slowly.
std::int64_t SupportedTargets() {
    static const Ask ask = library_answer();
    return ask ? ask() : HWY_STATIC_TARGET;
}

ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

}  // namespace hwy
