#include "tracer/light/sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace whittle {

namespace {

constexpr std::array<std::string_view, 3> kNames{"sobol", "stratified", "independent"};

constexpr int kRounds = 4;

// The place of `i` < `n` in an order of 0 .. n - 1 that `key` picks: steps that can be undone on the least power of two not below n, until one lands below n.
std::uint32_t place_in_order(std::uint32_t i, std::uint32_t n, std::uint32_t key) {
    const int bits = std::bit_width(n - 1);
    if (bits == 0) return 0;
    const std::uint32_t mask = 0xffffffffU >> (32 - bits);
    const int half = std::max(1, bits / 2);
    do {
        for (std::uint32_t round = 0; round < kRounds; ++round) {
            const std::uint32_t own = sobol::hash(key, round);
            i = (i + (own >> 5)) & mask;
            i = (i * (own | 1U)) & mask;
            i ^= i >> half;
        }
    } while (i >= n);
    // Turned by chance, so that each place is as likely as any other however small n is.
    return static_cast<std::uint32_t>((i + static_cast<std::uint64_t>(sobol::hash(key, kRounds))) % n);
}

// Column `column` of `columns`, and a place in it by chance.
std::uint32_t in_column(std::uint32_t column, std::uint32_t columns, std::uint32_t chance) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(column) << 32 | chance) / columns);
}

}  // namespace

std::string_view sampler_name(SamplerKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<SamplerKind> sampler_named(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<SamplerKind>(found - kNames.begin());
}

std::array<std::uint32_t, 2> Sampler::unlike_sobol(const PairOf& draw) const {
    const std::uint32_t key = sobol::hash(key_, draw.which()), number = index_ * draw.parts + draw.part, own = sobol::hash(key, number);
    const std::uint32_t x = sobol::hash(own, 1), y = sobol::hash(own, 2);
    if (sequence_.kind == SamplerKind::kIndependent) return {x, y};
    const std::uint64_t count = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(sequence_.count) * draw.parts, 1, 0x7fffffff);
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const auto rows = static_cast<std::uint32_t>((count + columns - 1) / columns), cells = columns * rows;
    // Samples beyond those that the grid was laid out for fill it again in another order.
    const std::uint32_t cell = place_in_order(number % cells, cells, sobol::hash(key, number / cells));
    return {in_column(cell % columns, columns, x), in_column(cell / columns, rows, y)};
}

}  // namespace whittle
