#include "tracer/light/planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Writes one plane's channels where the film has that plane.
class Writer {
public:
    Writer(Film& film, std::size_t pixel) : film_(film), pixel_(pixel) {}
    void put(Aov kind, double value) const { store(kind, 1, Vec3(value)); }
    void put(Aov kind, Vec3 value) const { store(kind, 3, value); }

private:
    void store(Aov kind, std::size_t channels, Vec3 value) const {
        std::vector<float>& plane = film_.planes[static_cast<std::size_t>(kind)];
        if (plane.empty()) return;
        for (std::size_t c = 0; c < channels; ++c) plane[pixel_ * channels + c] = static_cast<float>(value[static_cast<int>(c)]);
    }
    Film& film_;
    std::size_t pixel_;
};

void fill_nothing(const Writer& writer) {
    writer.put(Aov::kDepth, kInfinity);
    for (Aov kind : {Aov::kPosition, Aov::kNormal, Aov::kAlbedo}) writer.put(kind, Vec3(0));
    for (Aov kind : {Aov::kSolid, Aov::kSurface, Aov::kSpans, Aov::kThickness}) writer.put(kind, 0.0);
    writer.put(Aov::kCertified, 1.0);
}

void fill_hit(const Stage& stage, const Hit& hit, const Writer& writer) {
    writer.put(Aov::kDepth, hit.end.t);
    writer.put(Aov::kPosition, hit.point);
    writer.put(Aov::kNormal, hit.end.normal);
    writer.put(Aov::kSolid, static_cast<double>(hit.end.use) + 1);
    writer.put(Aov::kSurface, static_cast<double>(hit.end.surface) + 1);
    writer.put(Aov::kAlbedo, stage.surfaces[hit.end.use].color);
    writer.put(Aov::kCertified, hit.end.certified ? 1.0 : 0.0);
}

// Faces that meet more flatly than this (15 degrees) are drawn as one.
constexpr double kFlatCosine = 0.9659258262890683;

struct Seen {
    bool met = false;
    Hit hit;
};

Seen seen_at(const Stage& stage, double px, double py, Scratch& scratch) {
    Seen s;
    s.met = first_hit(*stage.program, picture_ray(stage, px, py), kInfinity, scratch, s.hit);
    return s;
}

// Is one of the two far in front of the other's tangent plane, seen in pixels?
bool stepped(const Stage& stage, const Hit& a, const Hit& b) {
    constexpr double kMostPixels = 6;
    const double pixel = 2 * stage.lens.half_height / stage.options.height * (stage.lens.orthographic ? 1 : std::min(a.end.t, b.end.t));
    const Vec3 across = b.point - a.point;
    return std::min(std::abs(glm::dot(across, a.end.normal)), std::abs(glm::dot(across, b.end.normal))) > kMostPixels * pixel;
}

bool differ(const Stage& stage, const Seen& a, const Seen& b) {
    if (!a.met || !b.met) return a.met != b.met;
    if (stepped(stage, a.hit, b.hit)) return true;
    return a.hit.end.surface != b.hit.end.surface && glm::dot(a.hit.end.normal, b.hit.end.normal) < kFlatCosine;
}

}  // namespace

bool on_edge(const Stage& stage, double px, double py, Scratch& scratch) {
    constexpr double kHalf = 0.5;
    if (differ(stage, seen_at(stage, px - kHalf, py - kHalf, scratch), seen_at(stage, px + kHalf, py + kHalf, scratch))) return true;
    return differ(stage, seen_at(stage, px - kHalf, py + kHalf, scratch), seen_at(stage, px + kHalf, py - kHalf, scratch));
}

Ray picture_ray(const Stage& stage, double px, double py) {
    const double half = stage.options.height / 2.0;
    return camera_ray(stage.lens, (px - stage.options.width / 2.0) / half, (half - py) / half);
}

double picture_height(const Stage& stage, double py) { return 1 - 2 * py / stage.options.height; }

double thickness_along(const Stage& stage, const Ray& ray, Scratch& scratch, Spans& spans) {
    spans.clear();
    all_spans(*stage.program, ray, scratch, spans);
    double total = 0;
    for (const Span& span : spans) total += (span.out ? span.out->t : kInfinity) - (span.in ? span.in->t : 0);
    return total;
}

void fill_planes(const Stage& stage, int x, int y, Scratch& scratch, Film& film) {
    const Ray ray = picture_ray(stage, x + 0.5, y + 0.5);
    const Writer writer(film, film.index(x, y));
    fill_nothing(writer);
    Hit hit;
    if (!first_hit(*stage.program, ray, kInfinity, scratch, hit)) return;
    fill_hit(stage, hit, writer);
    if ((film.aovs & (aov_bit(Aov::kSpans) | aov_bit(Aov::kThickness))) == 0) return;
    Spans spans;
    writer.put(Aov::kThickness, thickness_along(stage, ray, scratch, spans));
    writer.put(Aov::kSpans, static_cast<double>(spans.size()));
}

}  // namespace whittle
