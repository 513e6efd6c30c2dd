// The loop around the tile function: threads, tiles, shards, passes, stopping; planes.
#include "scenes.h"

using namespace whittle;
using namespace whittle::test;

TEST_CASE("the picture's bits depend on neither threads, regions, shards nor resumption") {
    const Solid solid = classic();
    RenderOptions options = small_options();
    options.samples = 9;
    options.noise = 0x1p-4;
    options.aovs = aov_bit(Aov::kDepth) | aov_bit(Aov::kSurface);
    options.threads = 1;
    const RenderResult whole = drawn(solid, {}, options);
    CHECK(whole.film.missing_pixels() == 0);
    CHECK(whole.samples_finished == 4);
    CHECK(whole.samples_most == 9);
    options.threads = 3;
    CHECK(drawn(solid, {}, options).film.pixels == whole.film.pixels);

    RenderOptions part = options;
    part.region = TileRegion{5, 3, 20, 17};
    const Film region = cropped(drawn(solid, {}, part).film, *part.region);
    for (int y = 0; y < options.height; ++y)
        for (int x = 0; x < options.width; ++x) {
            const bool inside = x >= 5 && x < 25 && y >= 3 && y < 20;
            CHECK(region.pixels[region.index(x, y)] == (inside ? whole.film.pixels[region.index(x, y)] : PixelSums{}));
        }

    Film merged(options.width, options.height, options.aovs);
    for (int k = 0; k < 3; ++k) {
        RenderOptions shard = options;
        shard.shard = {k, 3};
        merge(merged, drawn(solid, {}, shard).film);
    }
    CHECK(merged.pixels == whole.film.pixels);
    CHECK(merged.planes[0] == whole.film.planes[0]);

    RenderControl control;
    control.stop = true;
    const auto program = compile(solid);
    REQUIRE(program);
    const Result<RenderResult> stopped = render(*program, {}, options, control);
    REQUIRE(stopped);
    CHECK(stopped->interrupted);
    CHECK(stopped->samples_finished == 1);
    CHECK(stopped->film.missing_pixels() == 0);
    CHECK(drawn(solid, {}, options, &stopped->film).film.pixels == whole.film.pixels);
}

TEST_CASE("a rendering stopped after any pass goes on to the bits of one that never stopped") {
    const Solid solid = classic();
    RenderOptions options = small_options();
    options.samples = 40;
    options.noise = 0.02;
    const auto program = compile(solid);
    REQUIRE(program);
    const Film whole = drawn(solid, {}, options).film;
    for (int passes = 1; passes < 8; ++passes) {
        INFO(passes);
        RenderControl control;
        int kept = 0;
        control.keep_every_s = 0;
        control.keep = [&](const Film&) { control.stop = ++kept == passes; };
        const Result<RenderResult> stopped = render(*program, {}, options, control);
        REQUIRE(stopped);
        CHECK(stopped->film.pixels != whole.pixels);
        CHECK(drawn(solid, {}, options, &stopped->film).film.pixels == whole.pixels);
    }
}

TEST_CASE("an aborted rendering returns at once with what is finished") {
    const auto program = compile(classic());
    REQUIRE(program);
    RenderControl control;
    control.abort = true;
    const Result<RenderResult> result = render(*program, {}, small_options(), control);
    REQUIRE(result);
    CHECK(result->interrupted);
    CHECK(result->film.missing_pixels() == result->film.pixels.size());
}

TEST_CASE("the seed changes the noise and one sample has none") {
    const Solid solid = classic();
    RenderOptions options = small_options();
    options.samples = 2;
    const Film a = drawn(solid, {}, options).film;
    options.seed = 1;
    CHECK(drawn(solid, {}, options).film.pixels != a.pixels);
    options.samples = 1;
    const Film b = drawn(solid, {}, options).film;
    options.seed = 2;
    CHECK(drawn(solid, {}, options).film.pixels == b.pixels);
}

TEST_CASE("progress rises to one") {
    const auto program = compile(classic());
    REQUIRE(program);
    RenderControl control;
    std::vector<double> reports;
    control.progress = [&](const RenderProgress& p) { reports.push_back(p.done); };
    REQUIRE(render(*program, {}, small_options(), control));
    REQUIRE(!reports.empty());
    CHECK(std::is_sorted(reports.begin(), reports.end()));
    CHECK(reports.back() == 1);
}

TEST_CASE("a tile that is good enough gets no more samples") {
    const Solid solid = classic();
    RenderOptions options = small_options();
    options.samples = 64;
    const double all = static_cast<double>(drawn(solid, {}, options).counters.camera);
    options.noise = 0.05;
    const RenderResult calm = drawn(solid, {}, options);
    CHECK(static_cast<double>(calm.counters.camera) < all);
    CHECK(calm.samples_finished >= 4);
}

TEST_CASE("planes hold what the ray through the pixel's centre met") {
    SceneBuilder b;
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-10), Vec3(10), matte(0.5, 0.25, 1)), b.box(Vec3(-4, -20, -4), Vec3(4, 0, 4), matte(1, 0, 0))}));
    RenderOptions options = small_options();
    options.width = options.height = 33;
    options.aovs = (1U << kAovCount) - 1;
    RenderScene scene;
    scene.camera = looking(Vec3(0, -100, 0));
    const Film film = drawn(b.finish(), scene, options).film;
    const auto plane = [&](Aov kind) -> const std::vector<float>& { return film.planes[static_cast<int>(kind)]; };
    const std::size_t centre = film.index(16, 16), corner = film.index(0, 0);
    CHECK(plane(Aov::kDepth)[centre] == Approx(100));
    CHECK(std::isinf(plane(Aov::kDepth)[corner]));
    CHECK(plane(Aov::kPosition)[centre * 3 + 1] == Approx(0).margin(1e-6));
    CHECK(plane(Aov::kNormal)[centre * 3 + 1] == -1);
    CHECK(plane(Aov::kThickness)[centre] == Approx(10));
    CHECK(plane(Aov::kSpans)[centre] == 1);
    CHECK(plane(Aov::kSpans)[corner] == 0);
    CHECK(plane(Aov::kCertified)[centre] == 1);
    CHECK(plane(Aov::kSolid)[centre] > 0);
    CHECK(plane(Aov::kSurface)[centre] > 0);
    CHECK(plane(Aov::kSurface)[corner] == 0);
    CHECK(plane(Aov::kAlbedo)[centre * 3] == 1);
    CHECK(plane(Aov::kAlbedo)[centre * 3 + 1] == 0);
    CHECK(plane(Aov::kCost)[centre] > 0);
}

TEST_CASE("options out of range are refused") {
    const auto program = compile(classic());
    REQUIRE(program);
    RenderControl control;
    for (int kind = 0; kind < 5; ++kind) {
        RenderOptions o = small_options();
        if (kind == 0) o.width = 0;
        if (kind == 1) o.samples = 0;
        if (kind == 2) o.shard = {3, 3};
        if (kind == 3) o.region = TileRegion{20, 0, 20, 5};
        if (kind == 4) o.width = o.height = 1 << 20;
        const Result<RenderResult> result = render(*program, {}, o, control);
        REQUIRE(!result);
        CHECK(result.error().fault == Fault::kCommand);
    }
}

TEST_CASE("a picture of thickness is darker where the solid is thicker") {
    SceneBuilder b;
    b.add(b.box(Vec3(-10, -10, -10), Vec3(0, 10, 10)));
    b.add(b.box(Vec3(0, 5, -10), Vec3(10, 10, 10)));
    RenderOptions options = small_options();
    options.look = Look::kXray;
    RenderScene scene;
    scene.camera = looking(Vec3(0, -100, 0));
    const Film film = drawn(b.finish(), scene, options).film;
    const double thick = film.color(film.index(11, 12)).x, thin = film.color(film.index(20, 12)).x, none = film.color(film.index(0, 12)).x;
    CHECK(thick < thin);
    CHECK(thin < none);
}

TEST_CASE("edges darken the border of two faces and the silhouette, and nothing else") {
    SceneBuilder b;
    b.add(b.box(Vec3(-10), Vec3(10)));
    const Solid solid = b.finish();
    RenderOptions options = small_options();
    options.width = options.height = 64;
    RenderScene scene;
    scene.camera = looking(Vec3(60, -60, 0));
    const Film plain = drawn(solid, scene, options).film;
    options.edges = true;
    const Film lined = drawn(solid, scene, options).film;
    const auto darker = [&](int x, int y) { return lined.color(lined.index(x, y)).x < 0.5 * plain.color(plain.index(x, y)).x; };
    CHECK((darker(31, 32) || darker(32, 32)));
    CHECK(!darker(25, 32));
    CHECK(!darker(2, 2));
    int dark = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) dark += darker(x, y);
    CHECK(dark > 100);
    CHECK(dark < 500);
}
