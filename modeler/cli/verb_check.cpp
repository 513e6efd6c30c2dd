// verb_check.cpp — whittle check: do the exact solid and its mesh agree? Exit code 4 if not.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "modeler/check/agreement.h"
#include "modeler/check/facts.h"
#include "modeler/check/heat_map.h"
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

void print_json(const Agreement& a, const std::vector<std::string>& false_facts) {
    json::Object object;
    object.boolean("agree", a.agree && false_facts.empty()).count("lines", a.lines).count("seed", a.seed).number("tolerance", a.tolerance).number("rounding", a.rounding);
    object.number("own_deviation", a.own_deviation);
    object.raw("volume", both(json::of(a.volume_spans), json::of(a.volume_mesh))).raw("area", both(json::of(a.area_spans), json::of(a.area_mesh)));
    object.raw("centroid", both(centroid_json(a.centroid_spans), centroid_json(a.centroid_mesh)));
    object.number("genus", a.genus).number("components", a.components);
    object.raw("symmetric_difference", json::Object().measured("volume", a.difference_volume).number("bound", a.difference_bound).str());
    object.raw("worst", disagreement_json(a.worst));
    std::vector<std::string> list;
    for (const auto& d : a.disagreements) list.push_back(disagreement_json(d));
    object.raw("disagreements", json::array(list)).count("disagreements_in_all", a.disagreements_in_all).strings("false_facts", false_facts);
    fmt::print("{}\n", object.str());
}

void print_table(const Agreement& a, const SourceTable& sources) {
    fmt::print("{} on {} lines (tolerance {:.3g} mm, fixed beforehand)\n", a.agree ? "agree" : "DISAGREE", a.lines, a.tolerance);
    if (a.own_deviation > 0) fmt::print("  of it   {:.3g} mm, within which rays meet turned or sliced arcs as chords\n", a.own_deviation);
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

namespace {

struct Checked {
    ReadScene scene;
    Agreement agreement;
    std::vector<std::string> false_facts;
    bool good() const { return agreement.agree && false_facts.empty(); }
};

// What the scene's text states about itself (facts.h) and is not so.
std::vector<std::string> false_facts(const std::string& text, const Agreement& a) {
    constexpr double kIntervals = 3;  // of the sampled values, as in check_agreement
    std::vector<std::string> out;
    const Facts facts = facts_of(text);
    for (const std::string& line : facts.malformed) out.push_back(fmt::format("not a fact: {}", line));
    for (const Fact& f : facts.facts) {
        const bool whole = f.name == "genus" || f.name == "components";
        const Measured& m = f.name == "volume" ? a.volume_spans : a.area_spans;
        const double value = f.name == "genus" ? a.genus : f.name == "components" ? a.components : m.value;
        const double allowed = whole ? 0 : kIntervals * m.error + f.within * std::fabs(f.value);
        if (std::fabs(value - f.value) > allowed) out.push_back(fmt::format("{} = {:.9g} is stated, it is {:.9g}", f.name, f.value, value));
    }
    return out;
}

Result<void> write_heat_map(Session& session, const Solid& solid, const MeshResult& mesh) {
    const std::string& path = session.request.check.heat_file;
    const auto format = mesh_format(path, false);
    if (!format) return tl::unexpected<Error>(format.error());
    if (*format == MeshFormat::kStlBinary || *format == MeshFormat::kStlAscii) return fail(Fault::kCommand, path + ": STL has no colours; ply, off and 3mf have");
    const auto map = heat_map(solid, mesh);
    if (!map) return tl::unexpected<Error>(map.error());
    const auto file = write_mesh(map->result, *format);
    if (!file) return tl::unexpected<Error>(file.error());
    if (auto written = write_output(path, file->bytes); !written) return written;
    session.console.line(fmt::format("{}: facets stray by {:.3g} mm at most, {:.3g} allowed, {} beyond", path, map->most_mm, map->allowed_mm, map->beyond));
    return {};
}

Result<Checked> check_scene(Session& session) {
    auto scene = read_whole_solid(session);
    if (!scene) return tl::unexpected<Error>(scene.error());
    const Solid& solid = scene->canonical.solid;
    const auto program = compile_scene(session, solid);
    if (!program) return tl::unexpected<Error>(program.error());
    const auto mesh = make_mesh(session, solid);
    if (!mesh) return tl::unexpected<Error>(mesh.error());
    if (!session.request.check.heat_file.empty())
        if (auto written = write_heat_map(session, solid, *mesh); !written) return tl::unexpected<Error>(written.error());
    AgreementOptions options;
    options.tolerance = mesh->tolerance_mm;
    options.rounding = mesh->grid_mm;
    options.lines = session.request.check.lines;
    options.seed = session.request.common.seed;
    options.cancel = &session.watchdog.interrupted();
    Progress progress("Checking", session.request.common.progress, session.console.on_terminal(), session.console.quiet());
    options.progress = [&progress](double share) { progress.report(share); };
    auto agreement = check_agreement(solid, **program, mesh->mesh, options);
    if (!agreement) return tl::unexpected<Error>(agreement.error());
    session.stats.add(agreement->counters);
    auto faults = scene->evaluated.sources.files.empty() ? std::vector<std::string>{} : false_facts(scene->evaluated.sources.files.front().text, *agreement);
    return Checked{std::move(*scene), std::move(*agreement), std::move(faults)};
}

Exit check_one(Session& session) {
    const auto checked = check_scene(session);
    if (!checked) return give_up(session, checked.error());
    if (session.request.common.json)
        print_json(checked->agreement, checked->false_facts);
    else
        print_table(checked->agreement, checked->scene.evaluated.sources);
    for (const std::string& fault : checked->false_facts) session.console.warning("a fact of the scene is false: " + fault);
    return checked->good() ? checked->scene.verdict : worse(Exit::kDisagree, checked->scene.verdict);
}

// Files as named, and the scenes in folders, by name.
std::vector<std::string> scenes_of(const std::vector<std::string>& paths) {
    namespace fs = std::filesystem;
    std::vector<std::string> out;
    for (const std::string& path : paths) {
        std::error_code ignored;
        if (!fs::is_directory(path, ignored)) {
            out.push_back(path);
            continue;
        }
        const std::size_t first = out.size();
        for (const auto& entry : fs::directory_iterator(path, ignored))
            if (entry.path().extension() == ".scad") out.push_back(entry.path().string());
        std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
    }
    return out;
}

// What to say of folders that hold no scenes themselves.
std::string no_scenes(const std::vector<std::string>& paths) {
    namespace fs = std::filesystem;
    std::vector<std::string> below;
    for (const std::string& path : paths) {
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(path, ignored))
            if (entry.is_directory(ignored) && !scenes_of({entry.path().string()}).empty()) below.push_back(entry.path().string());
    }
    std::sort(below.begin(), below.end());
    const std::string none = "--suite: there is no .scad file in the folders named";
    return below.empty() ? none : fmt::format("{}; folders in them have some: {}", none, fmt::join(below, " "));
}

// A row a scene; what cannot be meshed is told and is no disagreement.
Exit check_suite(Session& session) {
    std::size_t agreed = 0, disagreed = 0, refused = 0;
    std::vector<std::string> rows;
    const std::vector<std::string> scenes = scenes_of(session.request.inputs);
    if (scenes.empty()) return give_up(session, {Fault::kScene, no_scenes(session.request.inputs)});
    for (const std::string& path : scenes) {
        Request request = session.request;
        request.inputs = {path};
        Session one{request, session.console, session.stats, session.watchdog, session.summary};
        Stopwatch watch;
        const auto checked = check_scene(one);
        if (!checked && checked.error().fault == Fault::kInterrupted) return give_up(session, checked.error());
        (checked ? checked->good() ? agreed : disagreed : refused) += 1;
        const std::string verdict = !checked ? "refused" : checked->good() ? "agree" : "DISAGREE";
        const double seconds = watch.lap();
        if (session.request.common.json) {
            json::Object row;
            row.string("file", path).string("verdict", verdict).number("seconds", seconds);
            if (checked) row.number("worst", checked->agreement.worst.bound > 0 ? checked->agreement.worst.distance / checked->agreement.worst.bound : 0);
            if (!checked) row.string("reason", checked.error().message);
            rows.push_back(row.str());
            continue;
        }
        if (!checked) fmt::print("{:8}  {}: {}\n", verdict, path, checked.error().message);
        else fmt::print("{:8}  {}: volume {:.9g} +- {:.1e}, mesh {:.9g}; worst {:.3g} of {:.3g} mm; genus {}, {} shells; {:.2f} s\n", verdict, path,
                        checked->agreement.volume_spans.value, checked->agreement.volume_spans.error, checked->agreement.volume_mesh.value,
                        checked->agreement.worst.distance, checked->agreement.worst.bound, checked->agreement.genus, checked->agreement.components, seconds);
        if (checked)
            for (const std::string& fault : checked->false_facts) fmt::print("          a fact is false: {}\n", fault);
    }
    if (session.request.common.json) {
        fmt::print("{}\n", json::Object().count("agree", agreed).count("disagree", disagreed).count("refused", refused).raw("scenes", json::array(rows)).str());
    } else {
        fmt::print("{} agree, {} disagree, {} refused\n", agreed, disagreed, refused);
    }
    return disagreed > 0 ? Exit::kDisagree : Exit::kDone;
}

}  // namespace

Exit run_check(Session& session) { return session.request.check.suite ? check_suite(session) : check_one(session); }

}  // namespace whittle
