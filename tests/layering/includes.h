// includes.h — the #include lines of a file of the project, as text: what the layering rules are applied to.
#pragma once

#include <string>
#include <vector>

struct Include {
    std::string file;    // who includes, relative to the root: "csg/lang/lexer.cpp"
    std::string header;  // what stands between the quotes or brackets
    int line = 0;
};

// A rule that one include breaks; empty text: none.
struct Rule {
    std::string name;
    bool (*broken)(const Include&);
};

// The include lines of `text`, in order. Commented lines (`// #include ...`) are none.
std::vector<Include> includes_in(const std::string& file, const std::string& text);

// Every rule of the floors (docs/architecture.md).
const std::vector<Rule>& layering_rules();

// Names of the rules that `include` breaks.
std::vector<std::string> broken_rules(const Include& include);
