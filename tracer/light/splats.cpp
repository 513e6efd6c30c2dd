#include "tracer/light/splats.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

// Rows above and below the picture that filters reach.
constexpr int kMargin = 2;

}  // namespace

SplatFilter::SplatFilter(FilterKind kind, bool alone) : kind_(kind), alone_(alone), radius_(alone ? 0.5 : filter_radius(kind)), scale_(1) {
    constexpr int kSteps = 512;
    if (alone) return;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += std::abs(filter_profile(kind, radius_ * ((i + 0.5) / kSteps)));
    scale_ = kSteps / (2 * radius_ * sum);
}

double SplatFilter::weight(double off) const { return alone_ ? 1 : filter_profile(kind_, off) * scale_; }

bool Splats::shows(Vec2 at) const {
    const double reach = filter_.radius() - 0.5;
    return at.x >= -reach && at.x < width_ + reach && at.y >= -reach && at.y < height_ + reach;
}

int Splats::row_of(const Splat& s) const { return static_cast<int>(std::floor(s.at.y)) + kMargin; }

void Splats::take(std::vector<Splat> splats) {
    splats_ = std::move(splats);
    std::stable_sort(splats_.begin(), splats_.end(), [this](const Splat& a, const Splat& b) {
        const int left = row_of(a), right = row_of(b);
        return left != right ? left < right : a.at.x < b.at.x;
    });
    begins_.assign(static_cast<std::size_t>(height_ + 2 * kMargin + 1), 0);
    for (const Splat& s : splats_) ++begins_[static_cast<std::size_t>(row_of(s)) + 1];
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
}

Vec3 Splats::on_pixel(int x, int y) const {
    Vec3 sum(0);
    const double radius = filter_.radius(), cx = x + 0.5, cy = y + 0.5;
    const auto left_of = [](const Splat& s, double at) { return s.at.x < at; };
    const int last = static_cast<int>(std::ceil(cy + radius)) - 1;
    for (int row = static_cast<int>(std::floor(cy - radius)); row <= last; ++row) {
        const auto at = static_cast<std::size_t>(row + kMargin);
        const auto end = splats_.begin() + static_cast<std::ptrdiff_t>(begins_[at + 1]);
        auto s = std::lower_bound(splats_.begin() + static_cast<std::ptrdiff_t>(begins_[at]), end, cx - radius, left_of);
        for (; s != end && s->at.x < cx + radius; ++s)
            if (s->at.y >= cy - radius && s->at.y < cy + radius) sum += s->light * (filter_.weight(s->at.x - cx) * filter_.weight(s->at.y - cy));
    }
    return sum;
}

}  // namespace whittle
