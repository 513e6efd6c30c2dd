// memo.h — remembers the last answers of a function of a number.
//
// Scripts turn points by the same angle again and again, and ask sine and cosine of it once a coordinate.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace whittle {

template <double (*F)(double)>
class Memo {
public:
    double operator()(double x) {
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
        Entry& entry = entries_[(bits * 0x9E3779B97F4A7C15u) >> (64 - kBits)];
        if (entry.bits != bits || !entry.known) entry = {bits, F(x), true};
        return entry.answer;
    }

private:
    static constexpr int kBits = 8;
    struct Entry {
        std::uint64_t bits = 0;
        double answer = 0;
        bool known = false;
    };
    std::array<Entry, std::size_t{1} << kBits> entries_{};
};

}  // namespace whittle
