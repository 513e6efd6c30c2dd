// coarse_view.cpp — what float makes of a tile's lines, bounded (docs/numerics.md, bounds of a tile).
#include "tracer/engine/coarse_view.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

constexpr double kRoom = 1 + 0x1p-40;  // over the roundings of the bounds themselves

}  // namespace

CoarseView coarse_view(const TileLine& root, const TileLine& line, bool ball, std::size_t axis, const double* rows) {
    CoarseView view;
    view.count = ball ? 3 : 2;
    view.roundings = rows ? 7 : 3;
    TileLine coarse = line;
    double square = 0;
    for (std::size_t k = 0; k < view.count; ++k) {
        const std::size_t i = ball ? k : (axis + 1 + k) % 3;
        double size = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            if (!rows && j != i) continue;
            const double weight = rows ? rows[3 * i + j] : 1, lo = root.d_lo[j], hi = root.d_hi[j], most = std::max(std::abs(lo), std::abs(hi));
            view.middle[k] += weight * (0.5 * (lo + hi));
            view.off += std::abs(weight) * (0.5 * (hi - lo) + kFineUnit * most);
            size += std::abs(weight) * most;
        }
        view.index[k] = i;
        view.eye[k] = 0.5 * (line.o_lo[i] + line.o_hi[i]);
        view.size += size;
        view.eo += line.eo[i];
        square += view.middle[k] * view.middle[k];
        const double error = (rows ? 6 : 1) * kCoarseUnit * size * kRoom;
        coarse.ed[i] += error;
        coarse.d_lo[i] -= error, coarse.d_hi[i] += error;
    }
    view.inverse_square = square > 0 ? 1 / square : 0;
    view.way = round_directions(coarse, ball, axis, kCoarseUnit);
    return view;
}

RoundLimits coarse_round(const CoarseView& view, const std::array<double, 3>& centre, double r, double horizon, CoarseRound& round) {
    std::array<double, 3> from{};
    double along = 0, far = 0, near = 0;
    for (std::size_t k = 0; k < view.count; ++k) {
        from[k] = view.eye[k] - centre[view.index[k]];
        along += from[k] * view.middle[k];
        far += std::abs(from[k]);
    }
    round.at = static_cast<float>(-along * view.inverse_square);
    round.square = static_cast<float>(r * r);
    const double at = round.at;
    for (std::size_t k = 0; k < view.count; ++k) {
        const double x = from[k] + at * view.middle[k];
        round.near[k] = static_cast<float>(x);
        near += std::abs(x);
    }
    // `near` cancels in double; what float makes of it, and of `at` times the way off the middle.
    const double reach = std::abs(at) * view.off;
    const double eo = (view.eo + kCoarseUnit * (near + view.roundings * reach) + 32 * kFineUnit * (far + std::abs(at) * view.size)) * kRoom;
    return round_limits(view.way, near + reach + eo, eo, r, horizon);
}

}  // namespace whittle
