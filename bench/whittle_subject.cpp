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
    std::vector<Hit> hits;
    std::unique_ptr<bool[]> found;
    std::vector<double> far;
};

void store(const Hit& hit, bool found, Answer& a) { a = found ? Answer{hit.end.t, hit.end.normal, hit.end.surface} : Answer{}; }

void first(Engine& e, const Ray* rays, int count, Answer* answers) {
    Hit hit;
    for (int i = 0; i < count; ++i) {
        const bool found = first_hit(*e.program, rays[i], HUGE_VAL, e.scratch, hit);
        store(hit, found, answers[i]);
    }
}

void first_packets(Engine& e, const Ray* rays, int count, Answer* answers) {
    first_hits(*e.program, rays, count, HUGE_VAL, e.scratch, e.hits.data(), e.found.get());
    for (int i = 0; i < count; ++i) store(e.hits[static_cast<std::size_t>(i)], e.found[static_cast<std::size_t>(i)], answers[i]);
}

void any(Engine& e, const Ray* rays, int count, Answer* answers) {
    for (int i = 0; i < count; ++i) {
        answers[i] = Answer();
        if (any_hit(*e.program, rays[i], HUGE_VAL, e.scratch)) answers[i].t = 0;
    }
}

void any_packets(Engine& e, const Ray* rays, int count, Answer* answers) {
    any_hits(*e.program, rays, e.far.data(), count, e.scratch, e.found.get());
    for (int i = 0; i < count; ++i) {
        answers[i] = Answer();
        if (e.found[static_cast<std::size_t>(i)]) answers[i].t = 0;
    }
}

void spans(Engine& e, const Ray* rays, int count, Answer* answers) {
    for (int i = 0; i < count; ++i) {
        answers[i] = Answer();
        all_spans(*e.program, rays[i], e.scratch, e.spans);
        if (e.spans.empty()) continue;
        answers[i].t = 0;
        answers[i].surface = static_cast<std::uint32_t>(e.spans.size());
        for (const Span& s : e.spans)
            if (s.in && s.out) {
                answers[i].t += s.out->t - s.in->t;
                answers[i].normal += s.in->normal + s.out->normal;
            }
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
        engine->hits.resize(kBatch);
        engine->found = std::make_unique<bool[]>(kBatch);
        engine->far.assign(kBatch, HUGE_VAL);
        subjects.push_back({name, [engine, answer](const Ray* rays, int count, Answer* answers) { answer(*engine, rays, count, answers); },
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
