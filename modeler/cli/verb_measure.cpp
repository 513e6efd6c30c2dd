// verb_measure.cpp — whittle measure: volume, area, centroid, inertia and bounds, each with its error.
#include <fmt/core.h>

#include "modeler/check/measure.h"
#include "modeler/cli/answers.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

template <std::size_t N>
std::string list(const std::array<Measured, N>& values, std::size_t begin, std::size_t count) {
    std::vector<std::string> texts;
    for (std::size_t i = begin; i < begin + count; ++i) texts.push_back(json::of(values[i]));
    return json::array(texts);
}

void print_json(const Measurement& m) {
    json::Object object;
    object.measured("volume", m.volume).measured("area", m.area).raw("centroid", list(m.centroid, 0, 3));
    object.raw("inertia", json::array({list(m.inertia, 0, 3), list(m.inertia, 3, 3), list(m.inertia, 6, 3)}));
    object.raw("bounds", json::Object().raw("min", list(m.lo, 0, 3)).raw("max", list(m.hi, 0, 3)).str());
    object.count("rays", m.lines).count("seed", m.seed).string("method", m.method).count("uncertified", m.counters.uncertified);
    fmt::print("{}\n", object.str());
}

std::string shown(const Measured& m) {
    if (m.error == 0) return fmt::format("{}", m.value);
    return fmt::format("{:.9g} +- {:.1e}", m.value, m.error);
}

template <std::size_t N>
std::string shown(const std::array<Measured, N>& m, std::size_t begin = 0) {
    return fmt::format("{}, {}, {}", shown(m[begin]), shown(m[begin + 1]), shown(m[begin + 2]));
}

void print_table(const Measurement& m) {
    fmt::print("volume    {} mm3\narea      {} mm2\n", shown(m.volume), shown(m.area));
    fmt::print("centroid  {} mm\n", shown(m.centroid));
    fmt::print("inertia   {} mm5\n          {}\n          {}\n", shown(m.inertia), shown(m.inertia, 3), shown(m.inertia, 6));
    fmt::print("bounds    {} to\n          {}\n", shown(m.lo), shown(m.hi));
    const bool certain = m.volume.kind == ErrorKind::kBound;
    fmt::print("by {} ({} rays); errors are {}\n", m.method, m.lines, certain ? "bounds" : "99 % confidence intervals");
    if (m.counters.uncertified > 0)
        fmt::print("{} crossings are not certified, most where facets stand for a smooth surface: the errors leave out how far those stray\n", m.counters.uncertified);
}

}  // namespace

Exit run_measure(Session& session) {
    const auto scene = read_whole_solid(session);
    if (!scene) return give_up(session, scene.error());
    const auto program = compile_scene(session, scene->canonical.solid);
    if (!program) return give_up(session, program.error());
    MeasureOptions options;
    options.seed = session.request.common.seed;
    options.cancel = &session.watchdog.interrupted();
    const auto measured = measure(scene->canonical.solid, **program, options);
    if (!measured) return give_up(session, measured.error());
    session.stats.add(measured->counters);
    if (session.request.common.json)
        print_json(*measured);
    else
        print_table(*measured);
    return scene->verdict;
}

}  // namespace whittle
