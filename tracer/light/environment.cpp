#include "tracer/light/environment.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

#include "csg/base/degrees.h"
#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

// What is infinite in a file.
constexpr double kBrightest = 1e9;

double as_light(float value, bool& odd) {
    const double x = value;
    odd = odd || !(x >= 0) || x > kBrightest;
    return x > 0 ? std::min(x, kBrightest) : 0;
}

// Solid angle of a pixel in row y.
double pixel_angle(int y, int width, int height) {
    return 2 * kPi / width * (cosd(180.0 * y / height) - cosd(180.0 * (y + 1) / height));
}

constexpr double kFirstHarmonic = 0.282095;

std::array<double, 9> harmonics_at(Vec3 d) {
    return {kFirstHarmonic, 0.488603 * d.y, 0.488603 * d.z, 0.488603 * d.x, 1.092548 * d.x * d.y, 1.092548 * d.y * d.z, 0.315392 * (3 * d.z * d.z - 1),
            1.092548 * d.x * d.z, 0.546274 * (d.x * d.x - d.y * d.y)};
}

// Where a number falls among cumulative sums [first, last] that run from 0 to 1, and the rest of it within.
std::size_t fall(const double* first, const double* last, double u, double& rest) {
    const double* above = std::upper_bound(first, last, u);
    const std::size_t i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - first, 1, last - first) - 1);
    const double width = first[i + 1] - first[i];
    rest = width > 0 ? std::clamp((u - first[i]) / width, 0.0, 1.0) : 0.5;
    return i;
}

}  // namespace

EnvironmentMap::EnvironmentMap(const Image& image, Vec3 tint, Vec3 rotate_deg, std::size_t& mended) : width_(image.width), height_(image.height) {
    const auto turned = [&](Vec3 v) {
        const Vec3 c{cosd(rotate_deg.x), cosd(rotate_deg.y), cosd(rotate_deg.z)}, s{sind(rotate_deg.x), sind(rotate_deg.y), sind(rotate_deg.z)};
        v = {v.x, c.x * v.y - s.x * v.z, s.x * v.y + c.x * v.z};
        v = {c.y * v.x + s.y * v.z, v.y, c.y * v.z - s.y * v.x};
        return Vec3(c.z * v.x - s.z * v.y, s.z * v.x + c.z * v.y, v.z);
    };
    x_ = turned(x_);
    y_ = turned(y_);
    z_ = turned(z_);
    read(image, tint, mended);
    make_chances();
    project();
}

void EnvironmentMap::read(const Image& image, Vec3 tint, std::size_t& mended) {
    const std::size_t channels = image.channels.size(), count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    mended = 0;
    pixels_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        bool odd = false;
        const float* at = &image.floats[i * channels];
        const double r = as_light(at[0], odd);
        const Vec3 light = channels < 3 ? Vec3(r) : Vec3(r, as_light(at[1], odd), as_light(at[2], odd));
        pixels_.push_back(light * tint);
        mended += odd;
    }
}

void EnvironmentMap::make_chances() {
    const auto w = static_cast<std::size_t>(width_);
    rows_.assign(static_cast<std::size_t>(height_) + 1, 0);
    cells_.assign(static_cast<std::size_t>(height_) * (w + 1), 0);
    const auto brightest = [&](int x, int y) {
        double most = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) most = std::max(most, luminance(pixel((x + dx + width_) % width_, std::clamp(y + dy, 0, height_ - 1))));
        return most;
    };
    for (int y = 0; y < height_; ++y) {
        double* row = &cells_[static_cast<std::size_t>(y) * (w + 1)];
        for (int x = 0; x < width_; ++x) row[x + 1] = row[x] + brightest(x, y);
        const double sum = row[w];
        for (std::size_t x = 0; x <= w; ++x) row[x] = sum > 0 ? row[x] / sum : static_cast<double>(x) / static_cast<double>(w);
        rows_[static_cast<std::size_t>(y) + 1] = rows_[static_cast<std::size_t>(y)] + sum * pixel_angle(y, width_, height_);
    }
    total_ = rows_.back();
    for (double& r : rows_) r /= total_ > 0 ? total_ : 1;
}

void EnvironmentMap::project() {
    // Bands of the cosine: pi, 2 pi / 3, pi / 4; over pi.
    constexpr std::array<double, 9> kBands{1, 2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25, 0.25, 0.25, 0.25, 0.25};
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const std::array<double, 9> basis = harmonics_at(direction_of({(x + 0.5) / width_, (y + 0.5) / height_}));
            const Vec3 light = pixel(x, y) * pixel_angle(y, width_, height_);
            for (std::size_t i = 0; i < basis.size(); ++i) harmonics_[i] += light * (basis[i] * kBands[i]);
        }
}

Vec3 EnvironmentMap::mean() const { return harmonics_[0] / (kFirstHarmonic * 4 * kPi); }

Vec2 EnvironmentMap::place_of(Vec3 d) const {
    const double a = glm::dot(d, x_), b = glm::dot(d, y_), c = glm::dot(d, z_);
    const double across = a == 0 && b == 0 ? 0.5 : 0.5 + Sleef_cinz_atan2d1_u10purec(a, b) / (2 * kPi);
    return {across, Sleef_cinz_acosd1_u10purec(std::clamp(c, -1.0, 1.0)) / kPi};
}

Vec3 EnvironmentMap::direction_of(Vec2 place) const {
    const Sleef_double_2 turn = Sleef_cinz_sincospid1_u05purec(2 * place.x - 1), rise = Sleef_cinz_sincospid1_u05purec(place.y);
    return rise.x * (turn.x * x_ + turn.y * y_) + rise.y * z_;
}

Vec3 EnvironmentMap::radiance(Vec3 direction) const {
    const Vec2 place = place_of(direction);
    const double px = place.x * width_ - 0.5, py = std::clamp(place.y * height_ - 0.5, 0.0, height_ - 1.0);
    const int x0 = static_cast<int>(std::floor(px)), y0 = std::min(static_cast<int>(py), std::max(0, height_ - 2)), y1 = std::min(y0 + 1, height_ - 1);
    const double fx = px - x0, fy = py - y0;
    const auto at = [&](int x, int y) { return pixel((x + width_) % width_, y); };
    return glm::mix(glm::mix(at(x0, y0), at(x0 + 1, y0), fx), glm::mix(at(x0, y1), at(x0 + 1, y1), fx), fy);
}

Vec3 EnvironmentMap::smooth(Vec3 normal) const {
    const std::array<double, 9> basis = harmonics_at(normal);
    Vec3 sum(0);
    for (std::size_t i = 0; i < basis.size(); ++i) sum += harmonics_[i] * basis[i];
    return glm::max(sum, Vec3(0));
}

EnvironmentMap::Drawn EnvironmentMap::draw(Vec2 u) const {
    if (dark()) return {};
    double fy = 0, fx = 0;
    const std::size_t y = fall(rows_.data(), rows_.data() + height_, u.y, fy);
    const double* row = &cells_[y * (static_cast<std::size_t>(width_) + 1)];
    const std::size_t x = fall(row, row + width_, u.x, fx);
    // Evenly over the pixel's solid angle: evenly in the cosine.
    const double top = cosd(180.0 * static_cast<double>(y) / height_), bottom = cosd(180.0 * static_cast<double>(y + 1) / height_);
    const double rise = Sleef_cinz_acosd1_u10purec(std::clamp(glm::mix(top, bottom, fy), -1.0, 1.0)) / kPi;
    Drawn d;
    d.direction = direction_of({(static_cast<double>(x) + fx) / width_, rise});
    d.density = density(d.direction);
    return d;
}

double EnvironmentMap::density(Vec3 direction) const {
    if (dark()) return 0;
    const Vec2 place = place_of(direction);
    const int x = std::clamp(static_cast<int>(place.x * width_), 0, width_ - 1), y = std::clamp(static_cast<int>(place.y * height_), 0, height_ - 1);
    const double* row = &cells_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1)];
    const double chance = (rows_[static_cast<std::size_t>(y) + 1] - rows_[static_cast<std::size_t>(y)]) * (row[x + 1] - row[x]);
    return chance / pixel_angle(y, width_, height_);
}

}  // namespace whittle
