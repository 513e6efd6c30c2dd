// whittle_subject.cpp — the engine as a subject.
#include <utility>

#include <fmt/format.h>

#include "bench/ray_sets.h"
#include "bench/subject.h"
#include "tracer/engine/engine.h"

namespace whittle::bench {

namespace {

struct Engine {
    std::shared_ptr<const Program> program;
    Scratch scratch;
    Spans spans;
    std::array<double, kBatch> far, error;
    std::array<std::uint32_t, kBatch> use;
    std::array<bool, kBatch> found;
};

void first(Engine& e, const Batch& batch, Answers& answers) {
    Hit hit;
    for (int i = 0; i < kBatch; ++i)
        if (first_hit(*e.program, batch.rays[i], HUGE_VAL, e.scratch, hit)) {
            answers.store(i, hit.end.t, hit.end.normal, hit.end.surface);
        } else {
            answers.miss(i);
        }
}

void first_packets(Engine& e, const Batch& batch, Answers& answers) {
    first_hits(*e.program, batch.rows, kBatch, HUGE_VAL, e.scratch,
               {answers.t.data(), e.error.data(), {answers.normal[0].data(), answers.normal[1].data(), answers.normal[2].data()}, answers.surface.data(), e.use.data()});
}

void any(Engine& e, const Batch& batch, Answers& answers) {
    for (int i = 0; i < kBatch; ++i) {
        answers.miss(i);
        if (any_hit(*e.program, batch.rays[i], HUGE_VAL, e.scratch)) answers.t[static_cast<std::size_t>(i)] = 0;
    }
}

void any_packets(Engine& e, const Batch& batch, Answers& answers) {
    any_hits(*e.program, batch.rows, e.far.data(), kBatch, e.scratch, e.found.data());
    for (std::size_t i = 0; i < kBatch; ++i) answers.t[i] = e.found[i] ? 0 : -1;
    for (auto& row : answers.normal) row.fill(0);
    answers.surface.fill(0);
}

void spans(Engine& e, const Batch& batch, Answers& answers) {
    for (int i = 0; i < kBatch; ++i) {
        answers.miss(i);
        all_spans(*e.program, batch.rays[i], e.scratch, e.spans);
        if (e.spans.empty()) continue;
        double length = 0;
        Vec3 normals(0);
        for (const Span& s : e.spans)
            if (s.in && s.out) {
                length += s.out->t - s.in->t;
                normals += s.in->normal + s.out->normal;
            }
        answers.store(i, length, normals, static_cast<std::uint32_t>(e.spans.size()));
    }
}

// Since the last call.
std::string work_done(Engine& e) {
    const EngineCounters c = std::exchange(e.scratch.counters, {});
    const double rays = static_cast<double>(c.spans_evaluated + c.packet_rays) / 100;
    return fmt::format("{:.1f} cells a ray, {:.2f} % alone, {:.3f} % exact", static_cast<double>(c.primitive_tests) / rays / 100,
                       static_cast<double>(c.spans_evaluated) / rays, static_cast<double>(c.escalated_exact) / rays);
}

}  // namespace

std::vector<Subject> whittle_subjects(std::shared_ptr<const Program> program, Query query) {
    std::vector<Subject> subjects;
    const auto add = [&](const char* name, auto answer) {
        const auto engine = std::make_shared<Engine>();
        engine->program = program;
        engine->far.fill(HUGE_VAL);
        subjects.push_back({name, [engine, answer](const Batch& batch, Answers& answers) { answer(*engine, batch, answers); },
                            [engine] { return work_done(*engine); }});
    };
    if (query == Query::kFirst) add("whittle packets", first_packets);
    if (query == Query::kFirst) add("whittle ray", first);
    if (query == Query::kAny) add("whittle packets", any_packets);
    if (query == Query::kAny) add("whittle ray", any);
    if (query == Query::kSpans) add("whittle ray", spans);
    return subjects;
}

}  // namespace whittle::bench
