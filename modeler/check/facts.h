// facts.h — what a scene says about itself, in comments that a program can read.
//
//     // fact: volume = 113.097335529; 4/3 pi r^3
//     // fact: volume = 67402.6921629 within 1e-8; by quadrature
//     // fact: genus = 1; the handle
//     // perturb: r = 3.01
//
// Names: volume (mm^3), area (mm^2), genus (summed over the boundary's shells), components (shells). `within` is the relative error of the number
// itself, where it is no closed form. After the semicolon: how the number follows. `perturb` names a variable and a value under which some fact must fail.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace whittle {

struct Fact {
    std::string name;
    double value = 0;
    double within = 0;
    std::string reason;
};

struct Facts {
    std::vector<Fact> facts;
    std::string perturbation;            // "r = 3.01"; empty: none
    std::vector<std::string> malformed;  // lines that look like a fact and are none

    std::optional<Fact> find(const std::string& name) const;
};

Facts facts_of(const std::string& text);

}  // namespace whittle
