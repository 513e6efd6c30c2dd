// passes.h — the passes that only save work: the one table of their names, which `--disable` takes.
//
// With a pass switched off the answers keep their bytes and the counters of work rise; skip.<name> (--stats) counts what the pass saved. A pass gets its row
// here, and asks is_disabled() where it is made.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace whittle {

struct PassInfo {
    std::string_view name;
    std::string_view saves;  // half a sentence for --help and the manual
};

// By floor, in the order a scene goes through them.
std::span<const PassInfo> known_passes();

inline bool is_disabled(const std::vector<std::string>& disabled, std::string_view name) {
    for (const auto& each : disabled)
        if (each == name) return true;
    return false;
}

}  // namespace whittle
