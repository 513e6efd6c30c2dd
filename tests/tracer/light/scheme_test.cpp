// OpenSCAD's colour schemes in the preview.
#include "scenes.h"
#include "tracer/image/tone.h"

using namespace whittle;
using namespace whittle::test;

namespace {

// A cube, its near half in a colour of its own, with a square hole from the front.
Solid plate_with_hole(const Material& body) {
    SceneBuilder b;
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-10), Vec3(10), body), b.box(Vec3(-4, -20, -4), Vec3(4, 0, 4))}));
    return b.finish();
}

RenderResult previewed(const Solid& solid, const char* scheme) {
    RenderOptions options = small_options();
    options.integrator = Integrator::kPreview;
    options.scheme = color_scheme_named(scheme);
    REQUIRE(options.scheme);
    RenderScene scene;
    scene.camera = looking(Vec3(0, -100, 0));
    return drawn(solid, scene, options);
}

// 0: of one hue; 1: of nothing in common.
double apart(Vec3 a, Vec3 b) { return glm::length(glm::cross(a, b)) / (glm::length(a) * glm::length(b)); }

}  // namespace

TEST_CASE("a preview in OpenSCAD's colours has their background to the byte, and their faces") {
    for (const std::string_view name : color_scheme_names()) {
        INFO(name);
        const Film film = previewed(plate_with_hole({}), std::string(name).c_str()).film;
        const ColorScheme scheme = *color_scheme_named(name);
        std::vector<std::uint8_t> bytes;
        ToneCurve({}).append(film.color(0), bytes);
        for (int c = 0; c < 3; ++c) CHECK(bytes[static_cast<std::size_t>(c)] == std::lround(scheme.background[c] * 255));
        // Highlights add white; no other scheme's faces are nearer to the hue all the same.
        const Vec3 face = film.color(film.index(12, 12));
        for (const std::string_view other : color_scheme_names()) CHECK(apart(face, srgb_to_linear(scheme.face)) <= apart(face, srgb_to_linear(color_scheme_named(other)->face)) + 0.05);
    }
}

TEST_CASE("a scheme leaves what names a colour as it is, and other integrators their studio") {
    const Solid blue = plate_with_hole(matte(0, 0, 1));
    const Film film = previewed(blue, "Sunset").film;
    CHECK(film.color(film.index(12, 12)).z > 4 * film.color(film.index(12, 12)).x);
    RenderOptions options = small_options();
    options.integrator = Integrator::kWhitted;
    const Film plain = drawn(blue, {}, options).film;
    options.scheme = color_scheme_named("Sunset");
    CHECK(drawn(blue, {}, options).film.pixels == plain.pixels);
    CHECK(!color_scheme_named("sunset!"));
}

TEST_CASE("what a cutter without a colour lays bare has the scheme's own colour, as in OpenSCAD's preview") {
    const auto middle = [](const Film& film) { return film.color(film.index(film.width / 2, film.height / 2)); };
    for (const std::string_view name : color_scheme_names()) {
        INFO(name);
        const ColorScheme scheme = *color_scheme_named(name);
        const Vec3 seen = middle(previewed(plate_with_hole({}), std::string(name).c_str()).film);
        CHECK(apart(seen, srgb_to_linear(scheme.cut)) <= apart(seen, srgb_to_linear(scheme.face)) + 0.05);
        CHECK(apart(seen, srgb_to_linear(scheme.cut)) < 0.3);
    }
    // Whatever the body's colour; a cutter's own stays; what is cut out of a cutter is a face again; what names its matter keeps it.
    const Vec3 green = srgb_to_linear(color_scheme_named("Cornfield")->cut), yellow = srgb_to_linear(color_scheme_named("Cornfield")->face);
    Material blue;
    blue.color = Vec4(0, 0, 1, 1);
    CHECK(apart(middle(previewed(plate_with_hole(blue), "Cornfield").film), green) < 0.3);
    CHECK(apart(middle(previewed(plate_with_hole(matte(0, 0, 1)), "Cornfield").film), green) > 0.9);
    SceneBuilder b;
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-10), Vec3(10)), b.box(Vec3(-4, -20, -4), Vec3(4, 0, 4), matte(0, 0, 1))}));
    const Vec3 own = middle(previewed(b.finish(), "Cornfield").film);
    CHECK(own.z > 4 * own.x);
    SceneBuilder c;
    const Use ring = c.combined(SetOp::kDifference, {c.box(Vec3(-4, -20, -4), Vec3(4, 0, 4)), c.box(Vec3(-1, -5, -1), Vec3(1, 5, 1))});
    c.add(c.combined(SetOp::kDifference, {c.box(Vec3(-10), Vec3(10)), ring}));
    const Vec3 post = middle(previewed(c.finish(), "Cornfield").film);
    CHECK(apart(post, yellow) < apart(post, green));
}
