// interfaces.cpp — see interfaces.h.
#include "tracer/engine/interfaces.h"

#include <algorithm>

#include "tracer/engine/gradient.h"
#include "tracer/engine/scratch.h"

namespace whittle {

namespace {

// Is the change at `e` from one material to another, inside of the solid before and behind?
bool divides(const Program& program, Walker& walker, const Event& e, std::uint32_t& from, std::uint32_t& to) {
    from = walker.matter_at(program.root, Event::beside(e, true));
    if (from == Walker::kNoLeafUse) return false;
    to = walker.matter_at(program.root, Event::beside(e, false));
    return to != Walker::kNoLeafUse && to != from && !(program.uses[from].material == program.uses[to].material);
}

Interface interface_at(const Program& program, RayContext& context, const Ray& ray, const Event& e, std::uint32_t from, std::uint32_t to) {
    Interface r;
    r.from = from;
    r.at.t = e.t;
    r.at.t_error = e.error;
    r.at.use = to;
    r.at.surface = e.id();
    const Support& support = program.classes[e.id()];
    r.at.normal = unit_gradient(support, context.frame(support.frame), point_at(ray, e.t));
    if (glm::dot(r.at.normal, ray.direction) > 0) r.at.normal = -r.at.normal;
    return r;
}

}  // namespace

void all_spans(const Program& program, const Ray& ray, Scratch& scratch, Spans& spans, Interfaces& interfaces) {
    interfaces.clear();
    all_spans(program, ray, scratch, spans);
    if (program.one_matter || program.empty || program.everything || spans.empty()) return;
    Walker& walker = scratch.impl->walker;
    RayContext& context = walker.context();
    std::vector<Walker::MatterChange> changes;
    walker.matter_changes(program.root, changes);
    std::stable_sort(changes.begin(), changes.end(), [&](const auto& a, const auto& b) { return context.compare(a.event, b.event) < 0; });
    const Event origin{0, 0, kNoClass};
    for (std::size_t i = 0, next = 0; i < changes.size(); i = next) {
        const Event& e = changes[i].event;
        std::vector<Walker::Cause> causes;
        for (next = i; next < changes.size() && (next == i || context.compare(e, changes[next].event) == 0); ++next) {
            causes.push_back({changes[next].leaf, changes[next].event});
        }
        std::uint32_t from = 0, to = 0;
        if (context.compare(e, origin) <= 0 || !divides(program, walker, e, from, to)) continue;
        interfaces.push_back(interface_at(program, context, ray, e, from, to));
        interfaces.back().at.certified = walker.are_certain(causes);
    }
}

}  // namespace whittle
