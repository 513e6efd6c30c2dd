// test_facts.cpp — the reader of facts reads what it should and lets nothing slip.
#include <catch2/catch.hpp>

#include "modeler/check/facts.h"

using namespace whittle;

TEST_CASE("facts are read with their value, error and reason") {
    const Facts f = facts_of("cube(2);\n// fact: volume = 8; a^3\n// fact: area = 2.4e1 within 1e-6; six faces\n// perturb: a = 2.01\n");
    REQUIRE(f.facts.size() == 2);
    CHECK(f.find("volume")->value == 8);
    CHECK(f.find("volume")->within == 0);
    CHECK(f.find("area")->within == 1e-6);
    CHECK(f.find("area")->reason == "six faces");
    CHECK_FALSE(f.find("genus"));
    CHECK(f.perturbation == "a = 2.01");
    CHECK(f.malformed.empty());
}

TEST_CASE("a fact without a reason, with an unknown name or out of form is malformed") {
    for (const char* line : {"// fact: volume = 8", "// fact: mass = 8; heavy", "//fact: volume = 8; a^3", "// fact: volume 8; a^3", "// perturb: a"})
        CHECK(facts_of(line).malformed.size() == 1);
}
