// stats.cpp — see stats.h.
#include "modeler/cli/stats.h"

#include <chrono>

#include <sys/resource.h>

#include "modeler/cli/json.h"

namespace whittle {

namespace {

constexpr const char* kNames[] = {
    "rays.camera", "rays.shadow", "rays.reflection", "rays.refraction", "rays.diffuse", "photons", "media_stack", "normals", "wavelengths",
    "solids.in_scene", "solids.kept", "solids.distinct", "primitives.tests", "primitives.folded", "spans.evaluated", "spans.escalated.double_double",
    "spans.escalated.exact", "spans.uncertified", "snap.fused", "snap.largest", "reading.largest_displacement", "mesh.booleans", "mesh.fallback",
    "loaded.cgal", "loaded.image", "loaded.font", "seconds.parse", "seconds.evaluate", "seconds.compile", "seconds.render", "seconds.mesh", "bytes.peak"};

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

Stats::Stats() {
    for (const char* name : kNames) values_[name] = 0;
}

double Stats::get(std::string_view name) const {
    const auto found = values_.find(std::string(name));
    return found == values_.end() ? 0 : found->second;
}

void Stats::add(const EngineCounters& counters) {
    add("primitives.tests", static_cast<double>(counters.primitive_tests));
    add("spans.evaluated", static_cast<double>(counters.spans_evaluated));
    add("spans.escalated.double_double", static_cast<double>(counters.escalated_double_double));
    add("spans.escalated.exact", static_cast<double>(counters.escalated_exact));
    add("spans.uncertified", static_cast<double>(counters.uncertified));
    add("primitives.folded", static_cast<double>(counters.folded));
    for (std::size_t i = 0; i < kEnginePasses; ++i) add(std::string("skip.") + name_of(static_cast<EnginePass>(i)), static_cast<double>(counters.skipped[i]));
}

void Stats::set(const BuildReport& report) {
    set("solids.in_scene", static_cast<double>(report.leaves));
    set("solids.kept", static_cast<double>(report.kept));
    set("snap.fused", static_cast<double>(report.snap_fused));
    set("snap.largest", report.snap_largest);
    set("reading.largest_displacement", report.largest_displacement);
}

std::string Stats::text() const {
    json::Buffer out;
    const char* before = "{\n  ";
    for (const auto& [name, value] : values_) {
        json::raw(out, before);
        json::string(out, name);
        json::raw(out, ": ");
        json::number(out, value);
        before = ",\n  ";
    }
    json::raw(out, "\n}\n");
    return fmt::to_string(out);
}

Stopwatch::Stopwatch() : begin_(now_s()) {}

double Stopwatch::lap() {
    const double end = now_s(), elapsed = end - begin_;
    begin_ = end;
    return elapsed;
}

double peak_bytes() {
    rusage usage{};
    return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<double>(usage.ru_maxrss) * 1024 : 0;
}

}  // namespace whittle
