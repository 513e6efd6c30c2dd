#include "tracer/light/planes.h"

#include <limits>
#include <memory>

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

}  // namespace

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

void fill_planes(const Stage& stage, const PixelPlace* pixels, int count, Scratch& scratch, Film& film) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) rays.push_back(picture_ray(stage, pixels[i].x + 0.5, pixels[i].y + 0.5));
    std::vector<Hit> hits(rays.size());
    const auto met = std::make_unique<bool[]>(rays.size());
    first_hits(*stage.program, rays.data(), count, kInfinity, scratch, hits.data(), met.get());
    Spans spans;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Writer writer(film, film.index(pixels[i].x, pixels[i].y));
        fill_nothing(writer);
        if (!met[i]) continue;
        fill_hit(stage, hits[i], writer);
        if ((film.aovs & (aov_bit(Aov::kSpans) | aov_bit(Aov::kThickness))) == 0) continue;
        writer.put(Aov::kThickness, thickness_along(stage, rays[i], scratch, spans));
        writer.put(Aov::kSpans, static_cast<double>(spans.size()));
    }
}

}  // namespace whittle
