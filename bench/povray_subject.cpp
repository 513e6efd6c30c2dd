// povray_subject.cpp — POV-Ray 3.7 as a subject: it draws the picture that the camera rays make.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "bench/child.h"
#include "bench/ray_sets.h"
#include "bench/subject.h"
#include "csg/base/file.h"
#include "modeler/export/pov.h"

namespace whittle::bench {

namespace {

constexpr double kEnough = 0.4;  // user seconds of a picture beyond reading: the smallest picture that takes this is drawn

ChildRun draw(const std::string& scene, int width, const std::string& picture) {
    const std::string out = picture.empty() ? "-F" : "+O" + picture;
    return run_child({"povray", "-D", "-GA", "+WT1", "+Q1", "-A", "+FP8", out, fmt::format("+W{}", width), fmt::format("+H{}", width * 3 / 4), "+I" + scene});
}

// Of pixels that are not grey, or black: the background is grey, matter yellow, and faces of cutters within cutters come out black.
double share_of_hits(const std::string& scene, const std::string& folder) {
    const std::string picture = folder + "/hits.ppm";
    if (!draw(scene, 160, picture).good) return 0;
    std::ifstream in(picture, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    constexpr std::size_t kPixels = 160 * 120;
    if (bytes.size() < 3 * kPixels) return 0;
    std::size_t hits = 0;
    for (std::size_t i = bytes.size() - 3 * kPixels; i < bytes.size(); i += 3) hits += bytes[i] != bytes[i + 1] || bytes[i] != bytes[i + 2] || bytes[i] == 0;
    return static_cast<double>(hits) / kPixels;
}

std::optional<Subject> subject_of(const std::string& name, const std::string& scene, const std::string& folder) {
    if (!draw(scene, 4, "").good) return std::nullopt;
    int width = 40;
    while (width < 1280 && draw(scene, width, "").user_s - draw(scene, 4, "").user_s < kEnough) width *= 2;
    Subject subject;
    subject.name = fmt::format("{} ({} x {})", name, width, width * 3 / 4);
    subject.own_round = [=] {
        const double reading = draw(scene, 4, "").user_s;
        return OwnRound{0.75 * width * width, std::max(1e-3, draw(scene, width, "").user_s - reading)};
    };
    subject.hit_share = share_of_hits(scene, folder);
    return subject;
}

}  // namespace

std::vector<double> povray_distances(const BenchScene& scene, const std::vector<Ray>& rays, const std::string& folder) {
    const auto exported = pov_scene(scene.solid, {}, camera_lens(scene), 4.0 / 3, {});
    if (!exported) return {};
    // The last line uses the whole; trace() wants its name.
    std::string text = exported->text;
    const auto last = text.rfind("\nobject{");
    if (last == std::string::npos) return {};
    text.insert(last + 1, "#declare Whole=");
    const std::string questions = folder + "/rays.txt", answers = folder + "/answers.txt", file = folder + "/trace.pov";
    text += fmt::format("#declare N=<0,0,0>;\n#fopen Rays \"{}\" read\n#fopen Answers \"{}\" write\n#while(defined(Rays))#read(Rays,A,B,C,D,E,F)#declare P=trace(Whole,<A,B,C>,<D,E,F>,N);"
                        "#if(vlength(N)=0)#write(Answers,\"-1\\n\")#else #write(Answers,str(vlength(P-<A,B,C>),0,17),\"\\n\")#end#end\n#fclose Answers\n",
                        questions, answers);
    std::string list;
    for (const Ray& r : rays)
        list += fmt::format("{}{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", list.empty() ? "" : ",\n", r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z);
    if (!write_file_atomically(questions, list) || !write_file_atomically(file, text)) return {};
    if (!run_child({"povray", "-D", "-GA", "-F", "+W1", "+H1", "+L" + folder, "+I" + file}).good) return {};
    std::ifstream in(answers);
    std::vector<double> distances;
    for (double d = 0; in >> d;) distances.push_back(d);
    return distances.size() == rays.size() ? distances : std::vector<double>{};
}

std::vector<Subject> povray_subjects(const BenchScene& scene, const std::string& folder) {
    constexpr double kMostPrimitives = 200'000;
    if (scene.primitives > kMostPrimitives) return {};
    std::vector<Subject> subjects;
    const auto add = [&](const char* name, const std::string& file) {
        if (auto subject = subject_of(name, file, folder)) subjects.push_back(std::move(*subject));
    };
    for (const PovGroups groups : {PovGroups::kFlat, PovGroups::kBounded}) {
        const auto text = pov_scene(scene.solid, {}, camera_lens(scene), 4.0 / 3, {}, groups);
        const std::string file = folder + (groups == PovGroups::kFlat ? "/flat.pov" : "/bounded.pov");
        if (!text || !write_file_atomically(file, text->text)) return subjects;
        add(groups == PovGroups::kFlat ? "pov-ray flat" : "pov-ray bounded", file);
    }
    if (const std::string by_hand = WHITTLE_SOURCE_DIR "/bench/povray/s2.pov"; scene.name == "S2" && std::ifstream(by_hand)) add("pov-ray by hand", by_hand);
    return subjects;
}

}  // namespace whittle::bench
