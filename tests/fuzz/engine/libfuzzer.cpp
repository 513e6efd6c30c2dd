// libfuzzer.cpp — a target of tests/fuzz under libFuzzer: WHITTLE_FUZZ_TARGET=dxf whittle_fuzz FOLDER -max_total_time=600
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.h"

namespace {

// The target that the environment names; null: none of that name.
const whittle::fuzz::Target* chosen() {
    const char* name = std::getenv("WHITTLE_FUZZ_TARGET");
    for (const whittle::fuzz::Target& target : whittle::fuzz::targets())
        if (name && target.name == name) return &target;
    std::fprintf(stderr, "WHITTLE_FUZZ_TARGET names none of the targets:");
    for (const whittle::fuzz::Target& target : whittle::fuzz::targets()) std::fprintf(stderr, " %s", target.name.data());
    std::fprintf(stderr, "\n");
    return nullptr;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const whittle::fuzz::Target* const target = chosen();
    if (!target) std::exit(2);
    target->run({reinterpret_cast<const char*>(data), size});
    return 0;
}
