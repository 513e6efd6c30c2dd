// test_parse.cpp — the command line as docs/command-line states it: what is read, what is refused, and how that is said.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "modeler/cli/parse.h"

using namespace whittle;

namespace {

Request read(std::vector<std::string> words) {
    auto parsed = parse_command_line(std::move(words));
    INFO((parsed ? std::string() : parsed.error().message));
    REQUIRE(parsed);
    REQUIRE(std::holds_alternative<Request>(*parsed));
    return std::get<Request>(*parsed);
}

std::string refusal(std::vector<std::string> words) {
    auto parsed = parse_command_line(std::move(words));
    REQUIRE_FALSE(parsed);
    CHECK(parsed.error().fault == Fault::kCommand);
    return parsed.error().message;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a file alone is drawn, a verb names its job, -o takes OpenSCAD's form") {
    CHECK(read({"a.scad"}).verb == Verb::kRender);
    CHECK(read({"render", "a.scad"}).verb == Verb::kRender);
    CHECK(read({"mesh", "a.scad"}).verb == Verb::kMesh);
    CHECK(read({"check", "a.scad"}).verb == Verb::kCheck);
    CHECK(read({"measure", "a.scad"}).verb == Verb::kMeasure);
    CHECK(read({"spans", "a.scad", "--ray", "0,0,0,0,0,1"}).verb == Verb::kSpans);
    CHECK(read({"merge", "a.exr", "b.exr", "-o", "c.exr"}).verb == Verb::kMerge);
    const Request convert = read({"-o", "a.stl", "-o", "b.png", "a.scad"});
    CHECK(convert.verb == Verb::kConvert);
    CHECK(convert.outputs == std::vector<std::string>{"a.stl", "b.png"});
    CHECK(convert.inputs == std::vector<std::string>{"a.scad"});
    const Request bench = read({"bench", "drilled", "--anything"});
    CHECK(bench.rest == std::vector<std::string>{"drilled", "--anything"});
}

TEST_CASE("-D takes one word and leaves the scene's name alone") {
    const Request request = read({"-o", "a.stl", "-D", "w=3", "-D", "s=\"x y\"", "a.scad"});
    CHECK(request.common.definitions == std::vector<std::string>{"w=3", "s=\"x y\""});
    CHECK(request.inputs == std::vector<std::string>{"a.scad"});
    CHECK(read({"-Dw=3", "a.scad"}).common.definitions == std::vector<std::string>{"w=3"});
}

TEST_CASE("options that all verbs share are read") {
    const Request request = read({"measure", "-", "--threads", "3", "--seed", "42", "--json", "-q", "--hardwarnings", "--allow-missing", "--limit-time", "2.5",
                                  "--limit-memory", "100", "--disable", "equal,buried", "-d", "x.d", "--stats", "s.json", "--no-snap", "--progress", "json",
                                  "--diagnostics=json", "-p", "p.json", "-P", "small"});
    const CommonRequest& common = request.common;
    CHECK(request.inputs == std::vector<std::string>{"-"});
    CHECK(common.threads == 3);
    CHECK(common.seed == 42);
    CHECK(common.json);
    CHECK(common.quiet);
    CHECK(common.hard_warnings);
    CHECK(common.allow_missing);
    CHECK(common.limit_seconds == 2.5);
    CHECK(common.limit_memory == MemoryLimit::kBytes);
    CHECK(common.limit_bytes == 104857600);
    CHECK(common.disabled_passes == std::vector<std::string>{"equal", "buried"});
    CHECK(common.dependency_file == "x.d");
    CHECK(common.stats_file == "s.json");
    CHECK_FALSE(common.snap);
    CHECK(common.progress == ProgressStyle::kJson);
    CHECK(common.diagnostics == DiagnosticStyle::kJson);
    CHECK(common.parameter_file == "p.json");
    CHECK(common.parameter_set == "small");
}

TEST_CASE("memory is limited by the system where nothing is said, and not at all by none or 0") {
    CHECK(read({"measure", "a.scad"}).common.limit_memory == MemoryLimit::kSystem);
    CHECK(read({"measure", "a.scad", "--limit-memory", "none"}).common.limit_memory == MemoryLimit::kNone);
    CHECK(read({"measure", "a.scad", "--limit-memory", "0"}).common.limit_memory == MemoryLimit::kNone);
    CHECK(contains(refusal({"measure", "a.scad", "--limit-memory", "some"}), "--limit-memory wants MB or none, not 'some'"));
}

TEST_CASE("--curves has its four forms") {
    CHECK(read({"render", "a", "--curves=auto"}).common.reading.curves == Curves::kAuto);
    CHECK(read({"render", "a", "--curves=faceted"}).common.reading.curves == Curves::kFaceted);
    CHECK(read({"render", "a", "--curves=exact"}).common.reading.exact_threshold == 32);
    const auto reading = read({"render", "a", "--curves=exact:64"}).common.reading;
    CHECK(reading.curves == Curves::kExact);
    CHECK(reading.exact_threshold == 64);
    for (const char* wrong : {"--curves=round", "--curves=exact:2", "--curves=exact:x", "--curves=exactly"}) {
        INFO(wrong);
        CHECK(contains(refusal({"render", "a", wrong}), "--curves wants auto, exact"));
    }
}

TEST_CASE("a picture's options reach the renderer") {
    const Request request =
        read({"render", "a.scad", "--imgsize", "640,480", "--camera", "-1,2,3,-.5,0,1", "--viewall", "--projection", "o", "--samples", "4", "--light-samples", "2",
              "--noise", "0.01", "--stop-after", "3", "--integrator", "whitted", "--max-depth", "5", "--aov", "depth,normal", "--clip", "0,0,1,2", "--clip", "1,0,0,3",
              "--exposure", "-1", "--tonemap", "filmic", "--tile", "0,0,32,16", "--shard", "2/3", "--edges", "--seed", "7", "--threads", "1", "--filter", "mitchell", "--resume"});
    const RenderRequest& render = request.render;
    CHECK(render.options.width == 640);
    CHECK(render.options.height == 480);
    CHECK(render.camera.numbers == std::vector<double>{-1, 2, 3, -.5, 0, 1});
    CHECK(render.camera.viewall);
    CHECK(render.camera.orthographic == true);
    CHECK(render.options.samples == 4);
    CHECK(render.options.light_samples == 2);
    CHECK(render.options.noise == 0.01);
    CHECK(render.options.stop_after_s == 3);
    CHECK(render.options.integrator == Integrator::kWhitted);
    CHECK(render.options.max_depth == 5);
    CHECK(render.options.aovs == (aov_bit(Aov::kDepth) | aov_bit(Aov::kNormal)));
    REQUIRE(render.clips.size() == 2);
    CHECK(render.clips[1] == std::array<double, 4>{1, 0, 0, 3});
    CHECK(render.picture.tone.exposure == -1);
    CHECK(render.picture.tone.map == Tonemap::kFilmic);
    CHECK(render.options.region == TileRegion{0, 0, 32, 16});
    CHECK(render.options.shard.index == 1);
    CHECK(render.options.shard.count == 3);
    CHECK(render.options.edges);
    CHECK(render.options.filter == FilterKind::kMitchell);
    CHECK(render.resume);
    CHECK(render.options.seed == 7);
    CHECK(render.options.threads == 1);
}

TEST_CASE("--colorscheme means the preview, and goes with no other integrator") {
    const Request request = read({"-o", "a.png", "--colorscheme", "Tomorrow Night", "a.scad"});
    CHECK(request.render.options.integrator == Integrator::kPreview);
    CHECK(request.render.options.scheme == color_scheme_named("Tomorrow Night"));
    CHECK(contains(refusal({"render", "a.scad", "--colorscheme", "Sunset", "--integrator", "path"}), "--integrator preview"));
    CHECK(contains(refusal({"render", "a.scad", "--colorscheme", "Sunrise"}), "--colorscheme wants"));
}

TEST_CASE("rays may begin with a minus and be given more than once") {
    const Request request = read({"spans", "a.scad", "--ray", "-1,2,3,0,0,1", "--ray=-.5,0,1e3,1,-1,0"});
    REQUIRE(request.spans.rays.size() == 2);
    CHECK(request.spans.rays[0].origin == Vec3(-1, 2, 3));
    CHECK(request.spans.rays[1].origin == Vec3(-.5, 0, 1000));
    CHECK(request.spans.rays[1].direction == Vec3(1, -1, 0));
    CHECK(read({"spans", "a.scad", "--rays", "-"}).spans.rays_file == "-");
}

TEST_CASE("a value that is not what the option wants is refused with what it wants") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--imgsize", "512"}, "--imgsize wants W,H, not '512'"},      {{"--imgsize", "0,5"}, "--imgsize wants"},
        {{"--imgsize", "1.5,5"}, "--imgsize wants"},                   {{"--camera", "1,2,3"}, "--camera wants ex,ey,ez,cx,cy,cz or"},
        {{"--samples", "0"}, "--samples wants N, not '0'"},            {{"--samples", "many"}, "--samples wants N"},
        {{"--integrator", "magic"}, "--integrator wants auto, "},      {{"--aov", "depth,smell"}, "--aov wants"},
        {{"--clip", "0,0,0,1"}, "--clip wants nx,ny,nz,d"},            {{"--shard", "4/3"}, "--shard wants k/n"},
        {{"--threads", "-1"}, "--threads wants N"},                    {{"--limit-time", "soon"}, "--limit-time wants S"},
        {{"--exposure", "nan"}, "--exposure wants STOPS"},             {{"--projection", "fish"}, "--projection wants p or o"},
        {{"--tile", "500,0,32,32"}, "--tile reaches outside the picture"}, {{"--progress", "loud"}, "--progress wants auto, never or json"}};
    for (const auto& [words, message] : cases) {
        std::vector<std::string> line{"render", "a.scad"};
        line.insert(line.end(), words.begin(), words.end());
        INFO(words[0] << " " << words[1]);
        CHECK(contains(refusal(line), message));
    }
    for (const char* ray : {"0,0,0,0,0,0", "0,0,0,0,0,1e-320", "0,0,0,1,1e-200,0", "0,0,0,1e200,0,0", "1e300,0,0,1,0,0"})
        CHECK(contains(refusal({"spans", "a", "--ray", ray}), "--ray wants ox,oy,oz,dx,dy,dz"));
    CHECK(contains(refusal({"mesh", "a", "--tolerance", "0"}), "--tolerance wants MM"));
}

TEST_CASE("words that belong to nothing are refused, near misses with a suggestion") {
    CHECK(contains(refusal({"render", "a.scad", "--imgsiz", "3,4"}), "unknown option --imgsiz; did you mean --imgsize?"));
    CHECK(contains(refusal({"mesh", "a.scad", "--imgsize", "3,4"}), "unknown option --imgsize"));
    CHECK(contains(refusal({"render", "a.scad", "--xyzzy"}), "unknown option --xyzzy"));
    CHECK(contains(refusal({"render", "a.scad", "b.scad"}), "one scene at a time: 'b.scad'"));
    CHECK(contains(refusal({}), "no scene is named"));
    CHECK(contains(refusal({"render"}), "no scene is named"));
    CHECK(contains(refusal({"spans", "a.scad"}), "spans wants --ray"));
    CHECK(contains(refusal({"spans", "-", "--rays", "-"}), "cannot both be standard input"));
    CHECK(contains(refusal({"merge", "a.exr"}), "merge wants one -o FILE"));
    CHECK(contains(refusal({"render", "a.scad", "-o"}), "-o"));
    CHECK(contains(refusal({"render", "a.scad", "-p", "x.json"}), "-p and -P go together"));
}

TEST_CASE("what is named in the documents and not there yet is refused, never passed over") {
    CHECK_FALSE(refusal({"mesh", "a.scad", "--remesh", "0"}).empty());
    CHECK_FALSE(refusal({"mesh", "a.scad", "--simplify", "-1"}).empty());
    CHECK_FALSE(refusal({"check", "a.scad", "--booleans", "nef"}).empty());
    CHECK(refusal({"meash", "a.scad"}) == "'meash' is no verb; did you mean mesh?");
    CHECK(refusal({"photograph", "a.scad"}) == "'photograph' is no verb; whittle --help lists them");
    CHECK(refusal({"a.scad", "b.scad"}) == "one scene at a time: 'b.scad' is a second");
    CHECK(refusal({"check", "a.scad", "b.scad"}) == "one scene at a time: 'b.scad' is a second");
    CHECK(contains(refusal({"-o", "a.png", "--summary", "everything", "a.scad"}), "bounding-box"));
    CHECK(contains(refusal({"view", "a.scad"}), "render --watch"));
}

TEST_CASE("all of OpenSCAD 2021.01's options are taken") {
    const auto parsed = parse_command_line({"-o", "a.stl", "-m", "make", "-O", "export-pdf/a=b", "--view=axes,edges", "--quiet", "-d", "a.deps", "--render=cgal", "a.scad"});
    REQUIRE(parsed);
    const auto& request = std::get<Request>(*parsed);
    CHECK(request.render.options.edges);
    CHECK(request.common.quiet);
    CHECK(std::get<Request>(*parse_command_line({"-o", "a.png", "--view", "axes", "a.scad"})).render.options.edges == false);
    CHECK(contains(refusal({"-o", "a.png", "--view", "axes,egdes", "a.scad"}), "--view wants axes"));
    CHECK(std::get<Request>(*parse_command_line({"-s", "old.stl", "-x", "old.dxf", "a.scad"})).outputs == std::vector<std::string>{"old.stl", "old.dxf"});
    CHECK(contains(std::get<Say>(*parse_command_line({"--info"})).text, "whittle "));
}

TEST_CASE("options that choose what Whittle does not have two of are passed over") {
    const auto parsed = parse_command_line({"-o", "a.stl", "--csglimit", "200000", "--backend=Manifold", "--enable", "all", "--debug", "x", "a.scad"});
    REQUIRE(parsed);
    CHECK(std::get<Request>(*parsed).outputs == std::vector<std::string>{"a.stl"});
}

TEST_CASE("help and version are said, not done") {
    for (const auto& verb : verb_names()) {
        if (verb == "bench") continue;  // bench hands its words to whittle-bench
        auto parsed = parse_command_line({verb, "--help"});
        REQUIRE(parsed);
        REQUIRE(std::holds_alternative<Say>(*parsed));
        const std::string text = std::get<Say>(*parsed).text;
        for (const auto& name : option_names(verb)) {
            INFO(verb << " " << name);
            CHECK(contains(text, name));
        }
    }
    CHECK(contains(std::get<Say>(*parse_command_line({"--version"})).text, "whittle "));
    CHECK(contains(std::get<Say>(*parse_command_line({"-h"})).text, "Exit codes"));
}

TEST_CASE("OpenSCAD's engine names after --render and --preview are accepted") {
    CHECK(read({"-o", "a.png", "--render=cgal", "a.scad"}).full_render);
    CHECK(read({"-o", "a.png", "--render", "a.scad"}).inputs == std::vector<std::string>{"a.scad"});
    CHECK_FALSE(read({"-o", "a.png", "--preview=throwntogether", "a.scad"}).full_render);
}
