// type_names.cpp — see type_names.h.
#include "type_names.h"

#include <regex>
#include <sstream>

std::vector<std::string> types_defined_in(const std::string& text) {
    static const std::regex kOpens(R"(^(?:inline )?namespace *([\w:]*) *\{$)"), kCloses(R"(^\} *// namespace)"),
        kType(R"(^(?:struct|class|union|enum class|enum) +(?:alignas\([^)]*\) +)?([\w:]*\w)\b[^;]*\{)");
    std::vector<std::string> found, within;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, kOpens)) {
            within.push_back(match[1]);
        } else if (std::regex_search(line, kCloses)) {
            if (!within.empty()) within.pop_back();
        } else if (std::regex_search(line, match, kType)) {
            std::string name;
            bool hidden = false;
            for (const std::string& space : within) hidden = hidden || space.empty(), name += space + "::";
            if (!hidden) found.push_back(name + match[1].str());
        }
    }
    return found;
}
