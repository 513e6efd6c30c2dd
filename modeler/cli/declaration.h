// declaration.h — the options of every verb, declared once: from this come parsing, --help and the names that completions are tested against.
//
// CLI11 splits the words; what a word means (numbers, sizes, names of planes) is read by words.h, so that every message can say what the option wants.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "modeler/cli/numbers.h"
#include "modeler/cli/request.h"

namespace whittle {

struct VerbInfo {
    const char* name;
    Verb verb;
    const char* usage;
    const char* summary;
};

inline constexpr VerbInfo kVerbs[] = {
    {"render", Verb::kRender, "FILE.scad [-o picture.png|.exr|.jpg|.tif]", "Draws the exact solid."},
    {"mesh", Verb::kMesh, "FILE.scad [-o part.stl|.3mf|.off|.obj|.ply|.amf|.glb|.om]", "Writes the solid as a closed triangle mesh (exact booleans)."},
    {"check", Verb::kCheck, "FILE.scad", "Do the exact solid and its mesh agree, within a bound fixed beforehand? Exit code 4 if not."},
    {"measure", Verb::kMeasure, "FILE.scad", "Volume, area, centroid, inertia and bounds, each with its error."},
    {"spans", Verb::kSpans, "FILE.scad --ray ox,oy,oz,dx,dy,dz", "What a ray meets: where, on which surface, of which line of the scene."},
    {"merge", Verb::kMerge, "A.exr B.exr ... -o all.exr", "Puts the shards of one render together."},
    {"bench", Verb::kBench, "[NAME]", "Run time against error and against peers (needs the program whittle-bench)."},
};

// Null: no verb has that name.
inline const VerbInfo* verb_named(std::string_view name) {
    for (const auto& info : kVerbs)
        if (name == info.name) return &info;
    return nullptr;
}

// One command line in the making: the options being declared, and what they set.
class Declaration {
public:
    Declaration(const VerbInfo* verb, Request& request) : verb_(verb), request_(request) {
        app_.name("whittle");
        app_.allow_extras(true);
        app_.set_help_flag("-h,--help", "Print this and exit");
        app_.add_flag("-v,--version", version_, "Print the version and exit");
        if (!verb_ || (verb_->verb != Verb::kBench && verb_->verb != Verb::kMerge)) declare_scene();
        declare_common();
        if (!verb_) declare_openscad();
        if (!verb_ || verb_->verb == Verb::kRender) declare_render();
        if (!verb_ || verb_->verb == Verb::kMesh || verb_->verb == Verb::kCheck) declare_mesh();
        if (verb_ && verb_->verb == Verb::kCheck) declare_check();
        if (verb_ && verb_->verb == Verb::kSpans) declare_spans();
        const bool writes = !verb_ || verb_->verb == Verb::kRender || verb_->verb == Verb::kMesh || verb_->verb == Verb::kMerge;
        if (writes) list("-o", "FILE", "Output; its suffix chooses the format. May be given more than once", request_.outputs, "Files");
        app_.add_option("FILE", request_.inputs, "The scene; - is standard input")->type_name("")->group("Files");
    }

    CLI::App& app() { return app_; }
    bool wants_version() const { return version_; }
    const std::string& refused() const { return refused_; }

private:
    using Reader = std::function<bool(const std::string&)>;

    // An option with one value, which may be given again; `read` returns false where the value is not what `wants` says.
    void value(const char* name, const char* wants, const char* help, const char* group, Reader read) {
        const std::string shown = name, expected = wants;
        const auto read_all = [=](const std::vector<std::string>& texts) {
            for (const auto& text : texts)
                if (!read(text)) throw CLI::ValidationError(shown, fmt::format("{} wants {}, not '{}'", shown, expected, text));
        };
        app_.add_option_function<std::vector<std::string>>(name, read_all, help)->type_name(wants)->group(group)->allow_extra_args(false);
    }
    void text(const char* name, const char* wants, const char* help, std::string& target, const char* group) {
        value(name, wants, help, group, [&target](const std::string& t) { return target = t, !t.empty(); });
    }
    void list(const char* name, const char* wants, const char* help, std::vector<std::string>& target, const char* group) {
        app_.add_option(name, target, help)->type_name(wants)->group(group)->allow_extra_args(false);
    }
    void flag(const char* name, const char* help, bool& target, const char* group, bool value = true) {
        app_.add_flag_callback(name, [&target, value] { target = value; }, help)->group(group);
    }
    // A number in [least, most].
    template <class Number>
    void number(const char* name, const char* wants, const char* help, Number& target, double least, double most, const char* group) {
        value(name, wants, help, group, [&target, least, most](const std::string& t) {
            const auto n = number_in(t);
            if (!n || *n < least || *n > most) return false;
            if (std::is_integral_v<Number> && *n != std::floor(*n)) return false;
            target = static_cast<Number>(*n);
            return true;
        });
    }
    // Names of passes, all of which must be known.
    void passes(const char* name, const char* group, std::vector<std::string>& target);
    // An option of OpenSCAD's that chooses what Whittle does not have two of: taken, so that a Makefile works with the name changed.
    void passed_over(const char* name, bool takes_value, const char* why, const char* group) {
        const std::string help = fmt::format("Taken and passed over: {}", why);
        if (takes_value) app_.add_option_function<std::string>(name, [](const std::string&) {}, help)->type_name("X")->group(group);
        else app_.add_flag_callback(name, [] {}, help)->group(group);
    }
    // Named by docs/command-line, its function not there yet: known, so that the message says so instead of "unknown".
    void not_yet(const char* name, bool takes_value, const char* group) {
        const std::string shown = name;
        if (takes_value)
            app_.add_option_function<std::string>(name, [=, this](const std::string&) { refused_ = shown; }, "(not supported yet)")->group(group);
        else
            app_.add_flag_callback(name, [=, this] { refused_ = shown; }, "(not supported yet)")->group(group);
    }

    void declare_scene();
    void declare_common();
    void declare_openscad();
    void declare_render();
    void declare_picture();
    void declare_mesh();
    void declare_check();
    void declare_spans();

    const VerbInfo* verb_;
    Request& request_;
    CLI::App app_;
    bool version_ = false;
    std::string refused_;
};

}  // namespace whittle
