// measured_area.h — the area of a 2D scene by the program, and that no mesh or chord stood in for it.
#pragma once

#include <cstdlib>
#include <string>

#include <catch2/catch.hpp>

#include "run_program.h"

// Swept by 1 and measured by lines.
inline double measured_area(const std::string& flat) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("part.scad", "linear_extrude(1) " + flat);
    const Outcome out = run_whittle({"measure", scene, "--json", "--stats", folder.name("counted.json")});
    INFO(flat << "\n" << out.err);
    REQUIRE(out.code == 0);
    CHECK(contains(folder.read("counted.json"), "\"mesh.fallback\": 0"));
    const std::string what = "\"volume\":{\"value\":";
    const std::size_t at = out.out.find(what);
    REQUIRE(at != std::string::npos);
    return std::strtod(out.out.c_str() + at + what.size(), nullptr);
}
