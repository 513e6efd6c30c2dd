// random.h — the numbers of rands(): the 32-bit Mersenne Twister, two draws a number, as OpenSCAD's on Linux.
//
// Source: Matsumoto, Nishimura (1998), by std::mt19937; the conversion is libstdc++'s generate_canonical, written out so that it is the same everywhere.
#pragma once

#include <random>

namespace whittle {

class RandomNumbers {
public:
    void seed(std::uint32_t value) { engine_.seed(value); }
    // In [low, high).
    double next(double low, double high) {
        const double a = static_cast<double>(engine_());
        const double b = static_cast<double>(engine_());
        double unit = (a + b * 4294967296.0) / 18446744073709551616.0;
        if (unit >= 1) unit = 0x1.fffffffffffffp-1;
        return unit * (high - low) + low;
    }

private:
    std::mt19937 engine_;  // unseeded it starts from its standard state: the same scene gives the same bytes
};

}  // namespace whittle
