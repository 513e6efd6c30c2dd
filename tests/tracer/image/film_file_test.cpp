// A film as bytes: to the bit and back, and nothing else taken for one.
#include <catch2/catch.hpp>

#include "tracer/image/film_file.h"

using namespace whittle;

namespace {

Film some_film() {
    Film film(3, 2, aov_bit(Aov::kNormal) | aov_bit(Aov::kDepth));
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const double x = 1.0 / (static_cast<double>(i) + 3);
        film.pixels[i] = {Vec3(x, -x, x * x), 1 - x, 2.5 * x, x / 3, x / 7, static_cast<std::uint32_t>(i)};
    }
    for (auto& plane : film.planes)
        for (float& value : plane) value = 0.1F + static_cast<float>(&value - plane.data());
    return film;
}

}  // namespace

TEST_CASE("a film comes back from its bytes to the bit") {
    const Film film = some_film();
    const Result<Film> back = film_of_bytes(film_bytes(film, 17), 17);
    REQUIRE(back);
    CHECK(back->width == 3);
    CHECK(back->height == 2);
    CHECK(back->aovs == film.aovs);
    CHECK(back->pixels == film.pixels);
    for (int k = 0; k < kAovCount; ++k) CHECK(back->planes[k] == film.planes[k]);
}

TEST_CASE("a film of another fingerprint is refused as the command's fault, a damaged one as the world's") {
    const std::string bytes = film_bytes(some_film(), 17);
    const Result<Film> other = film_of_bytes(bytes, 18);
    REQUIRE(!other);
    CHECK(other.error().fault == Fault::kCommand);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string bad = bytes;
        bad[i] = static_cast<char>(bad[i] ^ 4);
        const Result<Film> changed = film_of_bytes(bad, 17), shorter = film_of_bytes(std::string_view(bytes).substr(0, i), 17);
        REQUIRE(!changed);
        REQUIRE(!shorter);
        CHECK(changed.error().fault == Fault::kWorld);
        CHECK(shorter.error().fault == Fault::kWorld);
    }
}
