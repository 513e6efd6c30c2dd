#include "tracer/image/film_file.h"

#include <cstring>

namespace whittle {

namespace {

constexpr std::string_view kHead = "whittle film 1\n";

template <class T>
void put(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_pixel(std::string& bytes, const PixelSums& p) {
    for (int c = 0; c < 3; ++c) put(bytes, p.color[c]);
    for (const double sum : {p.coverage, p.weight, p.luminance, p.luminance_squared}) put(bytes, sum);
    put(bytes, p.samples);
}

// Takes values off the front of `bytes`; afterwards `whole` is false if there were too few.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    template <class T>
    T take() {
        T value{};
        if (bytes_.size() < sizeof value) {
            whole = false;
            return value;
        }
        std::memcpy(&value, bytes_.data(), sizeof value);
        bytes_.remove_prefix(sizeof value);
        return value;
    }
    std::size_t left() const { return bytes_.size(); }
    bool whole = true;

private:
    std::string_view bytes_;
};

constexpr std::size_t kPixelBytes = 7 * sizeof(double) + sizeof(std::uint32_t);

std::size_t plane_values(AovSet aovs) {
    std::size_t values = 0;
    for (int k = 0; k < kAovCount; ++k)
        if (aovs & aov_bit(static_cast<Aov>(k))) values += static_cast<std::size_t>(aov_channels(static_cast<Aov>(k)));
    return values;
}

void take_pixel(Reader& reader, PixelSums& p) {
    for (int c = 0; c < 3; ++c) p.color[c] = reader.take<double>();
    p.coverage = reader.take<double>();
    p.weight = reader.take<double>();
    p.luminance = reader.take<double>();
    p.luminance_squared = reader.take<double>();
    p.samples = reader.take<std::uint32_t>();
}

tl::unexpected<Error> damaged() { return fail(Fault::kWorld, "it is damaged or was written by another version of Whittle"); }

}  // namespace

std::uint64_t fingerprint_of(std::string_view bytes, std::uint64_t before) {
    for (const char c : bytes) before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return before;
}

std::string film_bytes(const Film& film, std::uint64_t fingerprint) {
    std::string bytes(kHead);
    bytes.reserve(bytes.size() + 64 + film.pixels.size() * (kPixelBytes + sizeof(float) * plane_values(film.aovs)));
    put(bytes, fingerprint);
    put(bytes, film.width);
    put(bytes, film.height);
    put(bytes, film.aovs);
    for (const PixelSums& p : film.pixels) put_pixel(bytes, p);
    for (const std::vector<float>& plane : film.planes) bytes.append(reinterpret_cast<const char*>(plane.data()), plane.size() * sizeof(float));
    put(bytes, fingerprint_of(bytes));
    return bytes;
}

bool is_film(std::string_view bytes) { return bytes.substr(0, kHead.size()) == kHead; }

Result<Film> film_of_bytes(std::string_view bytes, std::uint64_t fingerprint) {
    std::uint64_t checksum = 0;
    if (!is_film(bytes) || bytes.size() < kHead.size() + sizeof checksum) return damaged();
    const std::string_view body = bytes.substr(0, bytes.size() - sizeof checksum);
    std::memcpy(&checksum, bytes.data() + body.size(), sizeof checksum);
    if (checksum != fingerprint_of(body)) return damaged();
    Reader reader(body.substr(kHead.size()));
    const bool same = reader.take<std::uint64_t>() == fingerprint;
    const int width = reader.take<int>(), height = reader.take<int>();
    const AovSet aovs = reader.take<AovSet>();
    if (!reader.whole || width < 1 || height < 1) return damaged();
    if (!same) return fail(Fault::kCommand, "it is of another scene or of other options");
    const std::size_t a_pixel = kPixelBytes + sizeof(float) * plane_values(aovs);
    if (reader.left() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * a_pixel) return damaged();
    Film film(width, height, aovs);
    for (PixelSums& p : film.pixels) take_pixel(reader, p);
    for (std::vector<float>& plane : film.planes)
        for (float& value : plane) value = reader.take<float>();
    return film;
}

}  // namespace whittle
