// verb_spans.cpp — whittle spans: rays in, spans out, in the order of the rays.
//
// Rays are answered in blocks on all cores, each block into a buffer of its own; the buffers are written in order.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "modeler/cli/ray_lines.h"
#include "modeler/cli/span_text.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

constexpr std::size_t kBlock = 256;  // rays: a millisecond or so, against some microseconds to hand a block out

class Answerer {
public:
    Answerer(const Program& program, const UseTexts& uses, bool as_json) : program_(program), uses_(uses), as_json_(as_json) {}

    // Answers all rays and writes them; false where standard output fails.
    bool answer(const std::vector<Ray>& rays) {
        std::vector<json::Buffer> texts((rays.size() + kBlock - 1) / kBlock);
        if (texts.size() == 1)
            answer_block(rays, 0, texts[0], scratch_.local());
        else
            tbb::parallel_for(std::size_t{0}, texts.size(), [&](std::size_t block) { answer_block(rays, block, texts[block], scratch_.local()); });
        return std::all_of(texts.begin(), texts.end(), [](const auto& text) { return std::fwrite(text.data(), 1, text.size(), stdout) == text.size(); }) &&
               std::fflush(stdout) == 0;
    }
    void count(Stats& stats) {
        for (const Scratch& scratch : scratch_) stats.add(scratch.counters);
    }

private:
    void answer_block(const std::vector<Ray>& rays, std::size_t block, json::Buffer& text, Scratch& scratch) const {
        Spans spans;
        Interfaces interfaces;
        for (std::size_t i = block * kBlock; i < std::min(rays.size(), (block + 1) * kBlock); ++i) {
            all_spans(program_, rays[i], scratch, spans, interfaces);
            if (as_json_)
                append_spans_json(text, rays[i], spans, interfaces, uses_);
            else
                append_spans_table(text, rays[i], spans, interfaces, uses_);
        }
    }

    const Program& program_;
    const UseTexts& uses_;
    bool as_json_;
    tbb::enumerable_thread_specific<Scratch> scratch_;
};

Error output_failed() { return {Fault::kWorld, std::string("cannot write to standard output: ") + std::strerror(errno)}; }

Result<void> answer_all(const SpansRequest& request, Answerer& answerer) {
    if (!request.rays.empty() && !answerer.answer(request.rays)) return tl::unexpected<Error>(output_failed());
    if (request.rays_file.empty()) return {};
    auto lines = RayLines::open(request.rays_file);
    if (!lines) return tl::unexpected<Error>(lines.error());
    while (true) {
        const auto rays = lines->next();
        if (!rays) return tl::unexpected<Error>(rays.error());
        if (rays->empty()) return {};
        if (!answerer.answer(*rays)) return tl::unexpected<Error>(output_failed());
    }
}

}  // namespace

Exit run_spans(Session& session) {
    const auto scene = read_scene(session);
    if (!scene) return give_up(session, scene.error());
    if (const auto deep = check_not_flat(scene->canonical); !deep) return give_up(session, deep.error());
    const auto program = compile_scene(session, scene->canonical.solid);
    if (!program) return give_up(session, program.error());
    const UseTexts uses(leaf_uses(**program), scene->evaluated.sources);
    Answerer answerer(**program, uses, session.request.common.json);
    const auto answered = answer_all(session.request.spans, answerer);
    answerer.count(session.stats);
    return answered ? scene->verdict : give_up(session, answered.error());
}

}  // namespace whittle
