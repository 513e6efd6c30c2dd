// ordered_set.h — a set of numbers below a known bound that grows one by one and is walked in order: 64 bits a word, in levels. Private to the engine.
//
// Source: van Emde Boas, Preserving order in a forest in less than logarithmic time (1975), in its flat form with words of 64 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace whittle {

class OrderedSet {
public:
    // Of numbers in [0, bound).
    explicit OrderedSet(std::size_t bound) : bound_(bound) {
        do {
            bound = (bound + 63) / 64;
            levels_.emplace_back(bound);
        } while (bound > 1);
    }

    void insert(std::size_t x) {
        for (auto& level : levels_) {
            level[x / 64] |= std::uint64_t{1} << x % 64;
            x /= 64;
        }
    }

    // The least member that is not less than x; the bound if there is none.
    std::size_t next(std::size_t x) const {
        for (std::size_t k = 0; k < levels_.size(); ++k, x = x / 64 + 1) {
            if (x / 64 >= levels_[k].size()) return bound_;
            const std::uint64_t left = levels_[k][x / 64] >> x % 64;
            if (left == 0) continue;
            x += static_cast<std::size_t>(__builtin_ctzll(left));
            while (k-- > 0) x = 64 * x + static_cast<std::size_t>(__builtin_ctzll(levels_[k][x]));
            return x;
        }
        return bound_;
    }

private:
    std::size_t bound_;
    std::vector<std::vector<std::uint64_t>> levels_;  // a bit a number; then a bit a word of the level before
};

}  // namespace whittle
