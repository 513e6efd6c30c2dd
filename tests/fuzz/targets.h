// targets.h — what is thrown arbitrary bytes at: each reader of text that comes from outside. Nothing may crash, hang or read beyond its input.
//
// The same functions run under libFuzzer (engine/libfuzzer.cpp, with -DWHITTLE_FUZZ=ON and clang) and over the kept seeds in the tests (replay_test.cpp).
#pragma once

#include <span>
#include <string_view>

namespace whittle::fuzz {

struct Target {
    std::string_view name;
    void (*run)(std::string_view bytes);
};

std::span<const Target> targets();

}  // namespace whittle::fuzz
