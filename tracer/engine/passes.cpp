// passes.cpp — the engine's passes by name, and sums of its counters.
#include "csg/base/passes.h"
#include "tracer/engine/program.h"

namespace whittle {

namespace {

constexpr std::array<const char*, kEnginePasses> kNames{"boxes", "hierarchy", "occlusion", "first", "any", "filter", "frustum", "windows", "masks", "cells",
                                                         "coarse"};

}  // namespace

const char* name_of(EnginePass pass) { return kNames[static_cast<std::size_t>(pass)]; }

std::array<bool, kEnginePasses> passes_made(const std::vector<std::string>& disabled) {
    std::array<bool, kEnginePasses> made;
    for (std::size_t i = 0; i < kEnginePasses; ++i) made[i] = !is_disabled(disabled, kNames[i]);
    return made;
}

EngineCounters& EngineCounters::operator+=(const EngineCounters& o) {
    primitive_tests += o.primitive_tests;
    spans_evaluated += o.spans_evaluated;
    escalated_double_double += o.escalated_double_double;
    escalated_exact += o.escalated_exact;
    uncertified += o.uncertified;
    packet_rays += o.packet_rays;
    packet_deferred += o.packet_deferred;
    folded += o.folded;
    for (std::size_t i = 0; i < kEnginePasses; ++i) skipped[i] += o.skipped[i];
    return *this;
}

}  // namespace whittle
