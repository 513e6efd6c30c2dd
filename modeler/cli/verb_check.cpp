// verb_check.cpp — whittle check: do the exact solid and its mesh agree? Exit code 4 if not.
#include <algorithm>

#include <fmt/core.h>

#include "modeler/check/agreement.h"
#include "modeler/cli/answers.h"
#include "modeler/cli/job_mesh.h"
#include "modeler/cli/progress.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

std::vector<double> ray_numbers(const Ray& ray) {
    return {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z};
}

std::string disagreement_json(const Disagreement& d) {
    json::Object object;
    object.string("kind", name_of(d.kind)).number("distance", d.distance).number("bound", d.bound).numbers("ray", ray_numbers(d.ray));
    object.number("t0", d.t0).number("t1", d.t1).boolean("in_mesh", d.in_mesh).count("line", d.place.line);
    return object.str();
}

std::string centroid_json(const std::array<Measured, 3>& c) { return json::array({json::of(c[0]), json::of(c[1]), json::of(c[2])}); }

std::string both(const std::string& spans, const std::string& mesh) { return json::Object().raw("spans", spans).raw("mesh", mesh).str(); }

void print_json(const Agreement& a) {
    json::Object object;
    object.boolean("agree", a.agree).count("lines", a.lines).count("seed", a.seed).number("tolerance", a.tolerance).number("rounding", a.rounding);
    object.raw("volume", both(json::of(a.volume_spans), json::of(a.volume_mesh))).raw("area", both(json::of(a.area_spans), json::of(a.area_mesh)));
    object.raw("centroid", both(centroid_json(a.centroid_spans), centroid_json(a.centroid_mesh)));
    object.number("genus", a.genus).number("components", a.components);
    object.raw("symmetric_difference", json::Object().measured("volume", a.difference_volume).number("bound", a.difference_bound).str());
    object.raw("worst", disagreement_json(a.worst));
    std::vector<std::string> list;
    for (const auto& d : a.disagreements) list.push_back(disagreement_json(d));
    object.raw("disagreements", json::array(list)).count("disagreements_in_all", a.disagreements_in_all);
    fmt::print("{}\n", object.str());
}

void print_table(const Agreement& a, const SourceTable& sources) {
    fmt::print("{} on {} lines (tolerance {:.3g} mm, fixed beforehand)\n", a.agree ? "agree" : "DISAGREE", a.lines, a.tolerance);
    fmt::print("  volume  exact {:.9g} +- {:.1e}, mesh {:.9g}\n", a.volume_spans.value, a.volume_spans.error, a.volume_mesh.value);
    fmt::print("  area    exact {:.9g} +- {:.1e}, mesh {:.9g}\n", a.area_spans.value, a.area_spans.error, a.area_mesh.value);
    fmt::print("  mesh    genus {}, {} shells\n", a.genus, a.components);
    fmt::print("  worst   {:.3g} of {:.3g} mm allowed\n", a.worst.distance, a.worst.bound);
    for (const auto& d : a.disagreements) {
        const bool placed = d.place.line != 0 && d.place.file < sources.files.size();
        fmt::print("  {}: {:.3g} mm off, {:.3g} allowed{}; whittle spans --ray={}\n", name_of(d.kind), d.distance, d.bound,
                   placed ? fmt::format(", near {}:{}", sources.files[d.place.file].name, d.place.line) : "", fmt::join(ray_numbers(d.ray), ","));
    }
    if (a.disagreements_in_all > a.disagreements.size()) fmt::print("  ... {} in all\n", a.disagreements_in_all);
}

}  // namespace

Exit run_check(Session& session) {
    const auto scene = read_whole_solid(session);
    if (!scene) return give_up(session, scene.error());
    const Solid& solid = scene->canonical.solid;
    const auto program = compile_scene(session, solid);
    if (!program) return give_up(session, program.error());
    const auto mesh = make_mesh(session, solid);
    if (!mesh) return give_up(session, mesh.error());
    AgreementOptions options;
    options.tolerance = mesh->tolerance_mm;
    options.rounding = mesh->grid_mm;
    options.lines = session.request.check.lines;
    options.seed = session.request.common.seed;
    options.cancel = &session.watchdog.interrupted();
    Progress progress("Checking", session.request.common.progress, session.console.on_terminal(), session.console.quiet());
    options.progress = [&progress](double share) { progress.report(share); };
    const auto agreement = check_agreement(solid, **program, mesh->mesh, options);
    if (!agreement) return give_up(session, agreement.error());
    session.stats.add(agreement->counters);
    if (session.request.common.json)
        print_json(*agreement);
    else
        print_table(*agreement, scene->evaluated.sources);
    return agreement->agree ? scene->verdict : worse(Exit::kDisagree, scene->verdict);
}

}  // namespace whittle
