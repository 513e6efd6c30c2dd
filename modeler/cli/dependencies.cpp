// dependencies.cpp — see dependencies.h.
#include "modeler/cli/dependencies.h"

#include "csg/base/file.h"

namespace whittle {

namespace {

std::string escaped(const std::string& path) {
    std::string result;
    for (const char c : path) {
        if (c == ' ' || c == '#') result += '\\';
        if (c == '$') result += '$';
        result += c;
    }
    return result;
}

}  // namespace

std::string dependency_rule(const std::vector<std::string>& targets, const std::vector<std::string>& files_read) {
    std::string rule;
    for (const auto& target : targets) rule += (rule.empty() ? "" : " ") + escaped(target);
    rule += ":";
    for (const auto& file : files_read) rule += " \\\n\t" + escaped(file);
    return rule + "\n";
}

Result<void> write_dependencies(const Request& request, const std::vector<std::string>& files_read) {
    if (request.common.dependency_file.empty()) return {};
    return write_file_atomically(request.common.dependency_file, dependency_rule(request.outputs, files_read));
}

}  // namespace whittle
