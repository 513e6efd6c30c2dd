#include <algorithm>

#include "csg/eval/builtin.h"
#include "csg/eval/machine.h"
#include "csg/eval/nearest.h"

namespace whittle {

using namespace code;

void Machine::run_binds(const code::Scope& scope, Activation* frame) {
    for (const Bind& b : scope.binds) bind(b, eval(b.value, frame), frame);
}

void Machine::make_all(const code::Scope& scope, Activation* frame) {
    for (const InstId id : scope.insts) make(id, frame);
}

// A block under a module or a control word: its assignments, then its instantiations.
void Machine::make_scope(ScopeId id, Activation* frame) {
    if (id == code::kNone) return;
    const code::Scope& scope = program_.scopes[id];
    if (scope.frame_size == code::kNone) {
        run_binds(scope, frame);
        return make_all(scope, frame);
    }
    const FrameRef inner(heap_.frame(program_.frame_sizes[scope.frame_size], frame));
    run_binds(scope, inner.get());
    make_all(scope, inner.get());
}

// Makes what an instantiation stands for: appends its nodes, usually one, to pending_.
void Machine::make(InstId id, Activation* frame) {
    const Inst& inst = program_.insts[id];
    tick();
    const Depth depth(*this, 4, "module", inst.name, inst.place);
    const std::size_t before = mark();
    const std::size_t first_light = scene_->lights.size();
    const std::size_t first_node = pending_.size();
    const std::optional<Camera> camera = inst.modifiers & ast::kModBackground ? scene_->camera : std::nullopt;
    try {
        make_kind(inst, frame);
    } catch (StopRun& stop) {
        trace(stop, names_.text(inst.name), inst.place);
        throw;
    }
    if (trail_.size() > before) undo(before);
    if (inst.modifiers == 0) return;
    if (inst.modifiers & ast::kModBackground) {  // drawn at most: gives no light
        scene_->lights.resize(first_light);
        scene_->camera = camera;
    }
    if (pending_.size() > first_node && (inst.modifiers & ast::kModRoot))
        roots_.push_back({pending_[first_node], inst.place, first_light, scene_->lights.size()});
}

void Machine::make_kind(const Inst& inst, Activation* frame) {
    switch (inst.kind) {
        case InstKind::kBuiltin: return make_builtin(inst, frame);
        case InstKind::kUser: return make_user(inst, frame);
        case InstKind::kUnknown:
            return warn(inst.place, "Ignoring unknown module '" + names_.text(inst.name) + "'", hint(hint_for_module, inst.name));
        case InstKind::kFor:
        case InstKind::kIntersectionFor: return make_loop(inst, frame);
        case InstKind::kIf: return make_if(inst, frame);
        case InstKind::kLet:
        case InstKind::kAssign: return make_let(inst, frame);
        case InstKind::kEcho:
            run_echo(inst.arguments, 0, inst.arguments.size(), frame);
            break;
        case InstKind::kAssert:
            run_assert(inst.arguments, 0, inst.arguments.size(), frame, inst.place);
            break;
        case InstKind::kEach:
            return warn(inst.place, "Ignoring unknown module 'each'");
        case InstKind::kChildren: return make_children(inst, frame);
    }
    // echo and assert stand for what is under them.
    if (inst.children == code::kNone) return;
    const std::size_t first = pending_.size();
    make_scope(inst.children, frame);
    if (pending_.size() > first) add_node(inst, scene::Group{"group"}, first);
}

// Turns the pending nodes from `first_child` on into the children of a new node, which becomes pending itself.
void Machine::add_node(const Inst& inst, scene::What&& what, std::size_t first_child) {
    SceneNode& node = scene_->nodes.emplace_back();
    node.what = std::move(what);
    node.children.assign(pending_.data() + first_child, pending_.data() + pending_.size());
    node.place = inst.place;
    node.facets = facets();
    if (inst.clamps_facets) {
        node.facets.fa = std::max(node.facets.fa, kLeastFacet);
        node.facets.fs = std::max(node.facets.fs, kLeastFacet);
    }
    node.modifiers = inst.modifiers;
    pending_.resize(first_child);
    pending_.push_back(static_cast<SceneNodeId>(scene_->nodes.size() - 1));
}

void Machine::warn_of_facets(SourcePlace place) {
    const Facets f = facets();
    if (f.fs < kLeastFacet) warn(place, "$fs too small - clamping to 0.010000");
    if (f.fa < kLeastFacet) warn(place, "$fa too small - clamping to 0.010000");
}

void Machine::make_builtin(const Inst& inst, Activation* frame) {
    const BuiltinModule& builtin = builtin_modules()[inst.target];
    const bool has_children = inst.children != code::kNone;
    const code::Scope* children = has_children ? &program_.scopes[inst.children] : nullptr;
    if (children && inst.refuses_children && !(children->insts.empty() && children->binds.empty()))
        warn(inst.place, "module " + std::string(builtin.name) + "() does not support child modules", "is a ';' missing behind " + std::string(builtin.name) + "(...)?");
    if (input_.check_parameters)
        for (const Complaint& complaint : inst.matched.complaints) warn(inst.place, complaint.text, hint_of_complaint(names_, complaint, builtin));
    const std::size_t base = stack_.size();
    stack_.resize(base + inst.parameters);
    for (const Passed& p : inst.matched.passed) {
        Value value = eval(p.value, frame);
        if (p.to == Passed::To::kParameter) stack_[base + p.target] = std::move(value);
        else if (p.to == Passed::To::kDynamic) set_dynamic(p.target, std::move(value));
    }
    if (inst.clamps_facets) warn_of_facets(inst.place);
    const std::size_t first = pending_.size();
    FrameRef block(nullptr);
    Activation* inside = frame;
    if (children && builtin.takes_children) {
        if (children->frame_size != code::kNone) {
            block.reset(heap_.frame(program_.frame_sizes[children->frame_size], frame));
            inside = block.get();
        }
        run_binds(*children, inside);
    }
    ModuleUse use{*this, inst.place, {stack_.data() + base, inst.parameters}, builtin.signature};
    std::optional<scene::What> what = builtin.run(use);
    stack_.resize(base);
    if (!what) return;
    if (const scene::Transform* t = std::get_if<scene::Transform>(&*what); t && children && program_.sees_lights) {
        const Placement outer = placement_;
        placement_ = placement_ * t->placement;
        make_all(*children, inside);
        placement_ = outer;
    } else if (children && builtin.takes_children && use.takes_children) {
        make_all(*children, inside);
    }
    add_node(inst, std::move(*what), first);
}

void Machine::make_user(const Inst& inst, Activation* frame) {
    const code::Module& module = program_.modules[inst.target];
    const Depth depth(*this, 8, "module", inst.name, inst.place);
    const std::size_t first = pending_.size();
    // The assignments of the block of children are made first, once.
    FrameRef block(nullptr);
    Activation* outside = frame;
    std::size_t written = 0;
    if (inst.children != code::kNone) {
        const code::Scope& children = program_.scopes[inst.children];
        written = children.insts.size();
        if (children.frame_size != code::kNone) {
            block.reset(heap_.frame(program_.frame_sizes[children.frame_size], frame));
            outside = block.get();
        }
        run_binds(children, outside);
    }
    const FrameRef home(home_frame(inst.home, frame));
    const FrameRef inner(heap_.frame(module.layout.slots, home.get()));
    ModuleCall call{&inst, outside};
    inner.get()->call = &call;
    set_parameters(inst.name, module.parameters, inst.matched, {home.get(), frame, inner.get()}, inst.place);
    inner.get()->slots()[module.children_slot] = Value(static_cast<double>(written));
    module_names_.push_back(inst.name);
    for (const auto& [name, place] : module.overwritten)
        warn(place, "Module " + names_.text(module.name) + ": Parameter " + names_.text(name) + " is overwritten with a literal");
    const code::Scope& body = program_.scopes[module.body];
    run_binds(body, inner.get());
    make_all(body, inner.get());
    module_names_.pop_back();
    inner.get()->call = nullptr;
    add_node(inst, scene::Group{names_.text(module.name)}, first);
}

}  // namespace whittle
