// includes.cpp — reads include lines and holds the rules of the floors against them.
#include "includes.h"

#include <regex>
#include <sstream>
#include <string_view>

namespace {

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> prefixes) {
    for (const auto prefix : prefixes)
        if (text.substr(0, prefix.size()) == prefix) return true;
    return false;
}

bool in_csg(const Include& i) { return starts_with_any(i.file, {"csg/"}); }
bool in_tracer(const Include& i) { return starts_with_any(i.file, {"tracer/"}); }
bool outside_tests(const Include& i) { return starts_with_any(i.file, {"csg/", "tracer/", "modeler/"}); }

bool csg_looks_up(const Include& i) { return in_csg(i) && starts_with_any(i.header, {"tracer/", "modeler/"}); }
bool tracer_looks_up(const Include& i) { return in_tracer(i) && starts_with_any(i.header, {"modeler/"}); }
bool mesh_looks_at_tracer(const Include& i) { return starts_with_any(i.file, {"modeler/mesh/"}) && starts_with_any(i.header, {"tracer/"}); }
// Within csg: text knows no solid, a ray knows no solid, a solid knows no evaluator (but for the author's matter, which its labels hold).
bool language_looks_up(const Include& i) {
    return starts_with_any(i.file, {"csg/lang/", "csg/base/", "csg/span/"}) && starts_with_any(i.header, {"csg/eval/", "csg/solid/"});
}
bool solid_looks_up(const Include& i) {
    return starts_with_any(i.file, {"csg/solid/"}) && starts_with_any(i.header, {"csg/eval/"}) && i.header != "csg/eval/matter.h";
}
bool engine_looks_at_light(const Include& i) {
    return starts_with_any(i.file, {"tracer/engine/"}) && starts_with_any(i.header, {"tracer/light/", "tracer/image/", "csg/eval/evaluate.h"});
}
bool library_looks_at_program(const Include& i) {
    return outside_tests(i) && !starts_with_any(i.file, {"modeler/cli/"}) && starts_with_any(i.header, {"modeler/cli/"});
}
bool parent_folder(const Include& i) { return i.header.find("..") != std::string::npos; }
bool heavy_in_header(const Include& i) {
    const bool header = i.file.size() > 2 && i.file.compare(i.file.size() - 2, 2, ".h") == 0;
    return header && outside_tests(i) && starts_with_any(i.header, {"OpenMesh/", "OpenImageIO/", "CLI/", "nlohmann/"});
}
bool cgal_misplaced(const Include& i) {
    return outside_tests(i) && starts_with_any(i.header, {"CGAL/"}) && !starts_with_any(i.file, {"modeler/mesh/", "modeler/check/"});
}
bool openmesh_misplaced(const Include& i) {
    return outside_tests(i) && starts_with_any(i.header, {"OpenMesh/"}) && !starts_with_any(i.file, {"modeler/mesh/"});
}
bool image_library_misplaced(const Include& i) {
    return outside_tests(i) && starts_with_any(i.header, {"OpenImageIO/"}) && !starts_with_any(i.file, {"tracer/image/", "modeler/io/"});
}
bool command_line_library_misplaced(const Include& i) {
    return starts_with_any(i.header, {"CLI/"}) && i.file != "modeler/cli/parse.cpp" && i.file != "bench/main.cpp";  // a door for each program
}
bool peers_misplaced(const Include& i) {
    return starts_with_any(i.header, {"embree3/", "manifold/", "lib3mf"}) && !starts_with_any(i.file, {"bench/", "tests/"});
}
bool test_framework_misplaced(const Include& i) { return outside_tests(i) && starts_with_any(i.header, {"catch2/", "rapidcheck", "benchmark/"}); }

}  // namespace

std::vector<Include> includes_in(const std::string& file, const std::string& text) {
    static const std::regex kInclude(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<Include> found;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (line.find('#') != std::string::npos && std::regex_search(line, match, kInclude)) found.push_back({file, match[1], number});
    }
    return found;
}

const std::vector<Rule>& layering_rules() {
    static const std::vector<Rule> rules{
        {"csg includes nothing of tracer or modeler", csg_looks_up},
        {"tracer includes nothing of modeler", tracer_looks_up},
        {"modeler/mesh includes nothing of tracer: the check compares two independent answers", mesh_looks_at_tracer},
        {"csg/base, csg/lang and csg/span include nothing of csg/eval or csg/solid", language_looks_up},
        {"csg/solid includes nothing of csg/eval but matter.h", solid_looks_up},
        {"tracer/engine includes nothing of light, image or the evaluator", engine_looks_at_light},
        {"only modeler/cli includes modeler/cli", library_looks_at_program},
        {"includes are written from the root, never through ..", parent_folder},
        {"no header includes OpenMesh, OpenImageIO, CLI11 or nlohmann-json", heavy_in_header},
        {"CGAL stands in modeler/mesh and modeler/check", cgal_misplaced},
        {"OpenMesh stands in modeler/mesh", openmesh_misplaced},
        {"OpenImageIO stands in tracer/image or modeler/io", image_library_misplaced},
        {"CLI11 stands in one file of each program", command_line_library_misplaced},
        {"peers stand in bench and tests", peers_misplaced},
        {"test and benchmark frameworks stand in tests and bench", test_framework_misplaced},
    };
    return rules;
}

std::vector<std::string> broken_rules(const Include& include) {
    std::vector<std::string> names;
    for (const auto& rule : layering_rules())
        if (rule.broken(include)) names.push_back(rule.name);
    return names;
}
