// facts.cpp — line by line; a line that begins like a fact and cannot be read is reported, never skipped.
#include "modeler/check/facts.h"

#include <regex>
#include <sstream>

namespace whittle {

namespace {

const std::regex& fact_line() {
    static const std::regex pattern(R"(// fact: (volume|area|genus|components) = ([-+.0-9e]+)( within ([-+.0-9e]+))?; (\S.*))");
    return pattern;
}

const std::regex& perturb_line() {
    static const std::regex pattern(R"(// perturb: (\w+ = \S.*))");
    return pattern;
}

}  // namespace

std::optional<Fact> Facts::find(const std::string& name) const {
    for (const Fact& f : facts)
        if (f.name == name) return f;
    return {};
}

Facts facts_of(const std::string& text) {
    Facts r;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::smatch m;
        if (std::regex_match(line, m, fact_line())) {
            r.facts.push_back({m[1], std::stod(m[2]), m[4].matched ? std::stod(m[4]) : 0, m[5]});
        } else if (std::regex_match(line, m, perturb_line())) {
            r.perturbation = m[1];
        } else if (line.find("fact:") != std::string::npos || line.find("perturb:") != std::string::npos) {
            r.malformed.push_back(line);
        }
    }
    return r;
}

}  // namespace whittle
