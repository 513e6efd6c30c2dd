#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <unistd.h>

#include "csg/base/file.h"
#include "tracer/image/filter.h"
#include "tracer/image/image_file.h"

using namespace whittle;
namespace fs = std::filesystem;

namespace {

// A folder of this test's own, gone afterwards.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("whittle-image-test-" + std::to_string(::rand()) + "-" + std::to_string(static_cast<long>(::getpid())));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator())); }
};

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

// A ramp with values above 1, one plane of depth.
Film ramp(AovSet aovs) {
    Film film(7, 5, aovs);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        film.pixels[i].color = Vec3(0.05, 0.01, 0.002) * static_cast<double>(i) * 2.0;
        film.pixels[i].weight = 2;
        film.pixels[i].coverage = 2;
        film.pixels[i].samples = 2;
        if (aovs & aov_bit(Aov::kDepth)) film.planes[static_cast<int>(Aov::kDepth)][i] = 100.125f + static_cast<float>(i);
    }
    return film;
}

}  // namespace

TEST_CASE("sRGB encoding and decoding are inverse, and hold the standard's fixed points") {
    for (int i = 0; i <= 255; ++i) CHECK(linear_to_srgb(srgb_to_linear(i / 255.0)) == Approx(i / 255.0).margin(1e-6));
    CHECK(linear_to_srgb(1) == Approx(1));
    CHECK(srgb_to_linear(0.5) == Approx(0.21404114).epsilon(1e-7));
}

TEST_CASE("eight-bit values are the nearest to the exact curve, and survive the way back") {
    const ToneCurve curve(Tone{});
    for (int i = 0; i <= 255; ++i) {
        std::vector<std::uint8_t> bytes;
        curve.append(Vec3(srgb_to_linear(i / 255.0), srgb_to_linear((i + 0.49) / 255.0), srgb_to_linear((i - 0.49) / 255.0)), bytes);
        CHECK(static_cast<int>(bytes[0]) == i);
        CHECK(static_cast<int>(bytes[1]) == i);
        CHECK(static_cast<int>(bytes[2]) == i);
    }
}

TEST_CASE("exposure counts in stops, and what is no number is black") {
    std::vector<std::uint8_t> bytes;
    ToneCurve(Tone{1, Tonemap::kLinear}).append(Vec3(0.25, 0.5, 3), bytes);
    CHECK(bytes == std::vector<std::uint8_t>{128, 255, 255});
    bytes.clear();
    ToneCurve(Tone{}).append(Vec3(std::nan(""), -1, std::numeric_limits<double>::infinity()), bytes);
    CHECK(bytes == std::vector<std::uint8_t>{0, 0, 255});
}

TEST_CASE("the filmic curve rises and keeps detail above white") {
    std::vector<std::uint8_t> bytes;
    const ToneCurve curve(Tone{0, Tonemap::kFilmic});
    curve.append(Vec3(0.5, 1, 2), bytes);
    CHECK(bytes[0] < bytes[1]);
    CHECK(bytes[1] < bytes[2]);
    CHECK(bytes[2] < 255);
}

TEST_CASE("places drawn from a filter have its mean, its spread and its sign") {
    for (FilterKind kind : {FilterKind::kBox, FilterKind::kGaussian, FilterKind::kMitchell}) {
        const FilterSampler sampler(kind);
        double weight = 0, mean = 0, second = 0, exact_total = 0, exact_second = 0, exact_absolute = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i) {
            const FilterSampler::Place p = sampler.place({(i + 0.5) / n, 0.5});
            CHECK(std::abs(p.offset.x) <= filter_radius(kind));
            weight += p.weight / n;
            mean += p.weight * p.offset.x / n;
            second += p.weight * p.offset.x * p.offset.x / n;
            const double x = filter_radius(kind) * (2 * (i + 0.5) / n - 1);
            exact_total += filter_profile(kind, x);
            exact_absolute += std::abs(filter_profile(kind, x));
            exact_second += filter_profile(kind, x) * x * x;
        }
        CHECK(weight * weight == Approx(sampler.expected_weight()).epsilon(2e-3));
        CHECK(weight == Approx(exact_total / exact_absolute).epsilon(5e-3));
        CHECK(mean == Approx(0).margin(1e-6));
        CHECK(second / weight == Approx(exact_second / exact_total).margin(5e-3));
    }
}

TEST_CASE("a film forgets nothing when shards are merged") {
    Film whole(4, 2, aov_bit(Aov::kDepth)), part(4, 2, aov_bit(Aov::kDepth));
    whole.pixels[1].samples = 3;
    whole.pixels[1].color = Vec3(1);
    part.pixels[1].samples = 3;
    part.pixels[6].samples = 2;
    part.pixels[6].luminance = 0.5;
    part.planes[0][6] = 7;
    CHECK(whole.missing_pixels() == 7);
    merge(whole, part);
    CHECK(whole.missing_pixels() == 6);
    CHECK(whole.pixels[1].color == Vec3(1));
    CHECK(whole.pixels[6] == part.pixels[6]);
    CHECK(whole.planes[0][6] == 7);
}

TEST_CASE("formats are known by their suffix") {
    CHECK(image_format_of("a.PNG") == ImageFormat::kPng);
    CHECK(image_format_of("a.b.jpeg") == ImageFormat::kJpeg);
    CHECK(image_format_of("x.tif") == ImageFormat::kTiff);
    CHECK(!image_format_of("png"));
    CHECK(!image_format_of("a.gif"));
}

TEST_CASE("every format is written, read back, and the same bytes again") {
    const Folder folder;
    ImageFiles files(WHITTLE_IMAGE_MODULE_DIR);
    CHECK(!files.loaded());
    files.start_loading_for("a.png");
    files.start_loading();
    const Film film = ramp(0);
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
        INFO(name);
        const Result<Image> image = image_of(film, *image_format_of(name), PictureOptions{});
        REQUIRE(image);
        const Result<void> written = files.write(folder.path / name, *image);
        INFO((written ? "" : written.error().message));
        REQUIRE(written);
        const std::string first = text_of(folder.path / name);
        REQUIRE(files.write(folder.path / name, *image));
        CHECK(text_of(folder.path / name) == first);
        const Result<Image> back = files.read(folder.path / name);
        REQUIRE(back);
        CHECK(back->width == 7);
        CHECK(back->height == 5);
        if (!image->bytes.empty() && std::string(name) != "a.jpg")
            for (std::size_t i = 0; i < image->bytes.size(); ++i) CHECK(back->floats[i] == Approx(image->bytes[i] / 255.0).margin(1e-6));
    }
    CHECK(files.loaded());
    CHECK(folder.files() == 4);
}

TEST_CASE("an EXR keeps half colours, float planes and their names in one file") {
    const Folder folder;
    ImageFiles files(WHITTLE_IMAGE_MODULE_DIR);
    const Film film = ramp(aov_bit(Aov::kDepth) | aov_bit(Aov::kNormal));
    const Result<Image> image = image_of(film, ImageFormat::kExr, PictureOptions{});
    REQUIRE(image);
    REQUIRE(files.write(folder.path / "a.exr", *image));
    const Result<Image> back = files.read(folder.path / "a.exr");
    REQUIRE(back);
    REQUIRE(back->channels.size() == 8);
    std::size_t depth = 99, red = 99;
    for (std::size_t c = 0; c < 8; ++c) {
        if (back->channels[c] == "depth.Z") depth = c;
        if (back->channels[c] == "R") red = c;
    }
    REQUIRE(depth < 8);
    REQUIRE(red < 8);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        CHECK(back->floats[i * 8 + depth] == 100.125f + static_cast<float>(i));
        CHECK(back->floats[i * 8 + red] == Approx(0.05 * static_cast<double>(i)).epsilon(1e-3));
    }
    PictureOptions exact;
    exact.color_type = ChannelType::kFloat;
    REQUIRE(files.write(folder.path / "b.exr", *image_of(film, ImageFormat::kExr, exact)));
    const Result<Image> full = files.read(folder.path / "b.exr");
    REQUIRE(full);
    CHECK(full->floats[8 + red] == 0.05f);
}

TEST_CASE("a PNG of any content comes back bit by bit, without the module to write it") {
    const Folder folder;
    std::uint32_t state = 7;
    for (int kind = 0; kind < 5; ++kind)
        for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {257, 31}, {400, 300}}) {
            Image image;
            image.width = width;
            image.height = height;
            image.channels = {"R", "G", "B"};
            image.types.assign(3, ChannelType::kByte);
            for (int i = 0; i < width * height * 3; ++i) {
                state = state * 1664525U + 1013904223U;
                const std::uint32_t noise = state >> 24;
                const std::uint32_t value = kind == 0 ? 0U : kind == 1 ? noise : kind == 2 ? static_cast<std::uint32_t>(i / 7) : kind == 3 ? (noise > 250 ? noise : 17U) : static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(i) / 3000;
                image.bytes.push_back(static_cast<std::uint8_t>(value));
            }
            ImageFiles writer(folder.path);
            REQUIRE(writer.write(folder.path / "a.png", image));
            CHECK(!writer.loaded());
            ImageFiles reader(WHITTLE_IMAGE_MODULE_DIR);
            const Result<Image> back = reader.read(folder.path / "a.png");
            REQUIRE(back);
            REQUIRE(back->floats.size() == image.bytes.size());
            bool equal = true;
            for (std::size_t i = 0; i < image.bytes.size(); ++i) equal = equal && static_cast<int>(back->floats[i] * 255 + 0.5f) == image.bytes[i];
            INFO("kind " << kind << ", " << width << " x " << height);
            CHECK(equal);
        }
}

TEST_CASE("planes have no place in a PNG") {
    const Result<Image> image = image_of(ramp(aov_bit(Aov::kDepth)), ImageFormat::kPng, PictureOptions{});
    REQUIRE(!image);
    CHECK(image.error().fault == Fault::kCommand);
}

TEST_CASE("a failure leaves the file that was there, and nothing beside it") {
    const Folder folder;
    const fs::path path = folder.path / "kept.jpg";
    std::ofstream(path) << "old";
    ImageFiles nowhere(folder.path / "no" / "such");
    const Result<Image> image = image_of(ramp(0), ImageFormat::kJpeg, PictureOptions{});
    const Result<void> written = nowhere.write(path, *image);
    REQUIRE(!written);
    CHECK(written.error().fault == Fault::kWorld);
    CHECK(text_of(path) == "old");
    CHECK(folder.files() == 1);
    REQUIRE(write_file_atomically(path.string(), "new"));
    CHECK(text_of(path) == "new");
    CHECK(!write_file_atomically((folder.path / "missing" / "a.png").string(), "x"));
    CHECK(folder.files() == 1);
}

TEST_CASE("a full disk is an error") {
    if (!fs::exists("/dev/full")) return;
    const Result<void> written = write_file_atomically("/dev/full", "x");
    REQUIRE(!written);
    CHECK(written.error().fault == Fault::kWorld);
}
