#include "modeler/mesh/combine.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include <fmt/format.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace whittle {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class Combiner {
public:
    Combiner(const Plan& plan, const CombineOptions& options, MeshControl& control)
        : plan_(plan), options_(options), control_(control), done_(plan.size()), loaded_(plan.size()), waiting_(plan.size()) {}

    Result<Parts> run(PlanId root, MeshStats& stats) {
        find_needed(root);
        for (const auto& level : levels_) {
            const auto start = Clock::now();
            tbb::parallel_for(std::size_t{0}, level.size(), [&](std::size_t i) { carry_out(level[i]); });
            busy_ += seconds_since(start);
            if (failed_) break;
        }
        stats.booleans += booleans_;
        stats.fallbacks += fallbacks_;
        stats.decimated += decimated_;
        stats.skipped_boxes += skipped_;
        stats.seconds_decimate += seconds_decimate_;
        stats.seconds_boolean += busy_;
        stats.loaded_cgal = stats.loaded_cgal || kernel_used_;
        if (failed_) return tl::unexpected(error_);
        return std::move(done_[root]);
    }

private:
    // Nodes under the root by height: those of one level do not depend on each other.
    void find_needed(PlanId root) {
        std::vector<std::uint32_t> height(root + 1, 0);
        std::vector<bool> needed(root + 1, false);
        needed[root] = true;
        for (PlanId id = root + 1; id-- > 0;) {
            const PlanNode& n = plan_.node(id);
            if (!needed[id] || !n.op) continue;
            needed[n.a.plan] = needed[n.b.plan] = true;
            ++waiting_[n.a.plan].count;
            ++waiting_[n.b.plan].count;
        }
        for (PlanId id = 0; id <= root; ++id) {
            if (!needed[id]) continue;
            const PlanNode& n = plan_.node(id);
            if (n.op) height[id] = std::max(height[n.a.plan], height[n.b.plan]) + 1;
            if (levels_.size() <= height[id]) levels_.resize(height[id] + 1);
            levels_[height[id]].push_back(id);
            if (n.op) ++total_;
        }
        waiting_[root].count += 1;  // the root's result is fetched by run
    }

    void carry_out(PlanId id) {
        if (failed_) return;
        if (control_.cancelled()) return stop({Fault::kInterrupted, "interrupted"});
        const PlanNode& n = plan_.node(id);
        if (!n.op) {
            done_[id] = {Part{id, nullptr, {}, 0, n.box}};
            return;
        }
        auto result = combined(*n.op, placed(n.a, 0), placed(n.b, plan_.node(n.a.plan).tag_count));
        if (!result) return stop(result.error());
        done_[id] = std::move(*result);
        release(n.a.plan);
        release(n.b.plan);
        control_.progress(static_cast<double>(++finished_) / static_cast<double>(total_));
    }

    void release(PlanId id) {
        if (--waiting_[id].count > 0) return;
        done_[id] = {};
        loaded_[id].mesh = nullptr;
    }

    Parts placed(const PlanRef& ref, FacetTag tag_base) const {
        Parts parts = done_[ref.plan];
        for (Part& p : parts) {
            p.offset = sum(p.offset, ref.offset);
            p.box = moved(p.box, ref.offset);
            p.tag_base += tag_base;
        }
        return parts;
    }

    // Only parts that can meet enter the operation; the others go on as they are, or vanish.
    Result<Parts> combined(SetOp op, Parts a, Parts b) {
        const auto meet = op == SetOp::kUnion ? boxes_touch : boxes_overlap;
        const auto near = [&](const Parts& others) {
            return [&](const Part& p) { return std::any_of(others.begin(), others.end(), [&](const Part& q) { return meet(p.box, q.box); }); };
        };
        const auto a_end = std::stable_partition(a.begin(), a.end(), near(b));
        Parts result(a_end, a.end());
        a.erase(a_end, a.end());
        const auto b_end = std::stable_partition(b.begin(), b.end(), near(a));
        if (op == SetOp::kUnion) result.insert(result.end(), b_end, b.end());
        if (op == SetOp::kIntersection) result.clear();
        b.erase(b_end, b.end());
        if (a.empty() || b.empty()) {
            ++skipped_;
            return result;
        }
        auto left = exact(a), right = left ? exact(b) : left;
        if (!right) return tl::unexpected(right.error());
        return operated(op, *left, *right, std::move(result));
    }

    Result<Parts> operated(SetOp op, const std::vector<PlacedExact>& a, const std::vector<PlacedExact>& b, Parts result) {
        const auto kernel = exact_kernel();
        if (!kernel) return tl::unexpected(kernel.error());
        KernelWatch watch;
        watch.control = &control_;
        watch.decimate = options_.decimate;
        auto mesh = (*kernel)->combine(op, a, b, watch);
        const std::lock_guard lock(mutex_);
        booleans_ += watch.booleans;
        fallbacks_ += watch.fallbacks;
        decimated_ += watch.decimated;
        seconds_decimate_ += watch.seconds_decimate;
        if (!mesh) return tl::unexpected(mesh.error());
        if ((*mesh)->triangles > 0) {
            const GridBox box = (*mesh)->box;
            result.push_back(Part{0, std::move(*mesh), {}, 0, box});
        }
        return result;
    }

    Result<std::vector<PlacedExact>> exact(const Parts& parts) {
        std::vector<PlacedExact> out;
        for (const Part& p : parts) {
            ExactRef mesh = p.exact;
            if (!mesh) {
                auto loaded = load(p.leaf);
                if (!loaded) return tl::unexpected(loaded.error());
                mesh = std::move(*loaded);
            }
            out.push_back({std::move(mesh), p.offset, p.tag_base});
        }
        return out;
    }

    Result<ExactRef> load(PlanId leaf) {
        const auto kernel = exact_kernel();
        if (!kernel) return tl::unexpected(kernel.error());
        kernel_used_ = true;
        Loaded& slot = loaded_[leaf];
        const std::lock_guard lock(slot.mutex);
        if (!slot.mesh) {
            const PlanNode& node = plan_.node(leaf);
            if (node.may_cross_itself)
                if (const auto sound = check_sound(**kernel, node.leaf); !sound) return tl::unexpected(sound.error());
            auto mesh = (*kernel)->load(node.leaf);
            if (!mesh) return mesh;
            slot.mesh = std::move(*mesh);
        }
        return slot.mesh;
    }

    // An operand that crosses itself makes booleans wrong without a word, or worse.
    static Result<void> check_sound(const ExactKernel& kernel, const GridMesh& mesh) {
        std::vector<Vec3> points;
        for (const GridPoint& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
        for (const Triangle& t : mesh.triangles)
            if (glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) == Vec3{0})
                return fail(Fault::kScene, "a solid that is to be combined has facets of no area at this scale");
        const auto pairs = kernel.self_intersections(points, mesh.triangles);
        if (!pairs) return tl::unexpected(pairs.error());
        if (*pairs > 0) return fail(Fault::kScene, fmt::format("a solid that is to be combined crosses or touches itself: {} pairs of facets", *pairs));
        return {};
    }

    void stop(Error error) {
        const std::lock_guard lock(mutex_);
        if (!failed_) error_ = std::move(error);
        failed_ = true;
    }

    struct Loaded {
        std::mutex mutex;
        ExactRef mesh;
    };
    struct Waiting {
        std::atomic<std::uint32_t> count{0};
    };

    const Plan& plan_;
    const CombineOptions& options_;
    MeshControl& control_;
    std::vector<Parts> done_;
    std::vector<Loaded> loaded_;
    std::vector<Waiting> waiting_;
    std::vector<std::vector<PlanId>> levels_;
    std::mutex mutex_;
    std::atomic<bool> failed_{false}, kernel_used_{false};
    std::atomic<std::uint64_t> finished_{0}, skipped_{0};
    Error error_;
    std::uint64_t total_ = 0, booleans_ = 0, fallbacks_ = 0, decimated_ = 0;
    double seconds_decimate_ = 0, busy_ = 0;
};

}  // namespace

Result<Parts> combine_plan(const Plan& plan, PlanId root, const CombineOptions& options, MeshControl& control, MeshStats& stats) {
    Combiner combiner(plan, options, control);
    const int most = tbb::info::default_concurrency();  // asking for more only makes TBB print a warning
    tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, most) : most);
    return arena.execute([&] { return combiner.run(root, stats); });
}

}  // namespace whittle
