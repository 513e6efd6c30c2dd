// stability.cpp — one table an axis: scale, distance, wall thickness, grazing angle, depth of the tree, condition of the placement
// (stretch, scale of one axis, shear).
//
// The solid is a nest (stability_truth.h): a hollow box with walls of 0.1 of its half edge where the axis does not say otherwise, turned by a rational
// rotation. Truth is binary128. A ray is masked where its rounding to doubles, or the placement's, changes the number of its borders; those are not compared.
#include "bench/stability.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include "bench/scene_mesh.h"
#include "bench/stability_truth.h"
#include "bench/subject.h"
#include "tracer/engine/engine.h"

namespace whittle::bench {

namespace {

// Walls of this share of the solid's extent and less are taken for one surface in reading (2^-44), unless --no-snap is given.
constexpr double kSnapMatters = 0x1p-43;

struct Case {
    std::string axis;
    double value = 0;
    std::vector<NestedShape> nest;
    QuadPlacement exact;
    double size = 1;             // of the placed solid
    double thinnest = 0.1;       // wall, in the nest's own units
    double grazing_angle = 0;    // 0: rays go anywhere
};

struct Row {
    std::uint64_t rays = 0, masked = 0, borders = 0, wrong = 0, beyond_bound = 0;
    std::vector<double> errors, bounds;  // of t |d|, in sizes
    EngineCounters counters;
};

using Quad33 = std::array<Quad3, 3>;

// Of the quaternion 1 + 2i + 3j + 4k: no entry is 0, all are rational.
Quad33 rotation() {
    const std::array<std::array<int, 3>, 3> n{{{-20, 4, 22}, {20, -10, 20}, {10, 28, 4}}};
    Quad33 m;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) m[i][j] = Quad(n[i][j]) / 30;
    return m;
}

Quad33 diagonal(Quad x, Quad y, Quad z) { return {Quad3{x, 0, 0}, Quad3{0, y, 0}, Quad3{0, 0, z}}; }

// x becomes x + k y: the condition is about k squared.
Quad33 sheared(Quad k) { return {Quad3{1, k, 0}, Quad3{0, 1, 0}, Quad3{0, 0, 1}}; }

// r k r^T: k along axes that are no coordinate axes.
Quad33 turned(const Quad33& k) {
    const Quad33 r = rotation();
    Quad33 m{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t p = 0; p < 3; ++p)
                for (std::size_t q = 0; q < 3; ++q) m[i][j] += r[i][p] * k[p][q] * r[j][q];
    return m;
}

QuadPlacement placed(double scale, double distance, const Quad33& linear = rotation()) {
    QuadPlacement m{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) m.linear[i][j] = scale * linear[i][j];
    m.offset = {Quad(distance) * scale * 6 / 7, Quad(distance) * scale * 3 / 7, Quad(distance) * scale * 2 / 7};
    return m;
}

std::vector<NestedShape> hollow(bool ball, double wall) { return {{ball, 1}, {ball, 1 - wall}}; }

std::vector<Case> cases() {
    std::vector<Case> list;
    for (int e = -6; e <= 6; e += 2) list.push_back({"scale", std::pow(10.0, e), hollow(false, 0.1), placed(std::pow(10.0, e), 0), std::pow(10.0, e)});
    for (int e = 0; e <= 12; e += 2) list.push_back({"distance", std::pow(10.0, e), hollow(false, 0.1), placed(1, std::pow(10.0, e))});
    for (int e = 1; e <= 15; e += 2) list.push_back({"thickness of a box's wall", std::pow(10.0, -e), hollow(false, std::pow(10.0, -e)), placed(1, 0), 1, std::pow(10.0, -e)});
    for (int e = 1; e <= 15; e += 2) list.push_back({"thickness of a ball's shell", std::pow(10.0, -e), hollow(true, std::pow(10.0, -e)), placed(1, 0), 1, std::pow(10.0, -e)});
    for (int e = 0; e <= 8; ++e) list.push_back({"grazing angle", std::pow(10.0, -e), {{true, 1}}, placed(1, 0), 1, 1, std::pow(10.0, -e)});
    for (int n = 2; n <= 128; n *= 2) {
        Case c{"depth", static_cast<double>(n), {}, placed(1, 0)};
        for (int i = 0; i < n; ++i) c.nest.push_back({i % 2 == 1, std::pow(0.55, i)});
        c.thinnest = 0.3 * std::pow(0.55, n);
        list.push_back(c);
    }
    // Conditions of the placement: k squared, k or 1/k, about k squared.
    for (int e = 0; e <= 6; ++e) {
        const double k = std::pow(10.0, e);
        list.push_back({"stretch", k, hollow(false, 0.1), placed(1, 0, e == 0 ? rotation() : turned(diagonal(k, 1, 1 / Quad(k)))), k});
    }
    for (int e = -6; e <= 6; e += 2) {
        const double k = std::pow(10.0, e);
        list.push_back({"scale of one axis", k, hollow(false, 0.1), placed(1, 0, turned(diagonal(k, 1, 1))), std::max(1.0, k)});
    }
    for (int e = 0; e <= 6; ++e) list.push_back({"shear", std::pow(10.0, e), hollow(false, 0.1), placed(1, 0, turned(sheared(std::pow(10.0, e)))), std::pow(10.0, e)});
    return list;
}

Placement as_doubles(const QuadPlacement& m) {
    Placement p;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) p.m[4 * i + j] = static_cast<double>(m.linear[i][j]);
        p.m[4 * i + 3] = static_cast<double>(m.offset[i]);
    }
    return p;
}

QuadPlacement as_quads(const Placement& p) {
    QuadPlacement m;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) m.linear[i][j] = p.m[4 * i + j];
        m.offset[i] = p.m[4 * i + 3];
    }
    return m;
}

// a - (b - (c - ...)).
Solid solid_of(const std::vector<NestedShape>& nest, const Placement& placement) {
    SolidBuilder b;
    const auto use = [](NodeId node) {
        Use u;
        u.node = node;
        return u;
    };
    const auto shape = [&](const NestedShape& s) { return s.is_ball ? b.shape(shape::Ellipsoid{Vec3(s.half)}) : b.shape(shape::Box{Vec3(-s.half), Vec3(s.half)}); };
    NodeId all = shape(nest.back());
    for (std::size_t i = nest.size() - 1; i-- > 0;) all = b.combine(SetOp::kDifference, {use(shape(nest[i])), use(all)});
    Use root = use(all);
    root.placement = placement;
    return b.finish(root);
}

// In the nest's own space: from a ball of 4 to the box of 1.2; or past the unit ball at an angle.
void make_ray(const Case& c, std::mt19937_64& random, Vec3& o, Vec3& d) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto direction = [&] {
        while (true) {
            const Vec3 v(unit(random), unit(random), unit(random));
            if (const double n = glm::length(v); n > 0.1 && n < 1) return v / n;
        }
    };
    o = 4.0 * direction();
    if (c.grazing_angle == 0) {
        d = 1.2 * Vec3(unit(random), unit(random), unit(random)) - o;
        return;
    }
    // Through the ball's point p, at the angle to the tangent plane there.
    const Vec3 p = direction(), across = glm::normalize(glm::cross(p, direction()));
    d = across * std::cos(c.grazing_angle) - p * std::sin(c.grazing_angle);
    o = p - 3.0 * d;
}

struct Question {
    Ray ray;
    std::vector<Quad> truth;
};

std::vector<Question> questions(const Case& c, int rays, Row& row) {
    std::mt19937_64 random(17);
    const QuadPlacement rounded_placement = as_quads(as_doubles(c.exact));
    std::vector<Question> list;
    for (int i = 0; i < rays; ++i) {
        Vec3 o, d;
        make_ray(c, random, o, d);
        Question q;
        q.ray.origin = rounded(apply_to_point(c.exact, quad(o)));
        q.ray.direction = rounded(apply_to_direction(c.exact, quad(d)));
        q.truth = crossings(c.nest, rounded_placement, quad(q.ray.origin), quad(q.ray.direction));
        const QuadPlacement here{{Quad3{1, 0, 0}, Quad3{0, 1, 0}, Quad3{0, 0, 1}}, {0, 0, 0}};
        ++row.rays;
        if (crossings(c.nest, here, quad(o), quad(d)).size() != q.truth.size()) {
            ++row.masked;
            continue;
        }
        list.push_back(std::move(q));
    }
    return list;
}

void ask_whittle(const Case& c, const std::vector<Question>& list, const EngineOptions& options, Row& row) {
    const auto program = compile(solid_of(c.nest, as_doubles(c.exact)), options);
    if (!program) return;
    Scratch scratch;
    Spans spans;
    for (const Question& q : list) {
        all_spans(**program, q.ray, scratch, spans);
        std::vector<End> ends;
        for (const Span& s : spans) {
            if (s.in) ends.push_back(*s.in);
            if (s.out) ends.push_back(*s.out);
        }
        row.borders += q.truth.size();
        if (ends.size() != q.truth.size()) {
            ++row.wrong;
            continue;
        }
        const double unit = length(q.ray.direction) / c.size;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const double error = std::abs(static_cast<double>(q.truth[i] - Quad(ends[i].t)));
            // Binary128 itself is good to some 2^-100 of t.
            row.beyond_bound += error > ends[i].t_error + 0x1p-95 * std::abs(ends[i].t);
            row.errors.push_back(error * unit);
            row.bounds.push_back(ends[i].t_error * unit);
        }
    }
    row.counters = scratch.counters;
}

double quantile(std::vector<double>& list, double share) {
    if (list.empty()) return 0;
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(list.size() - 1));
    std::nth_element(list.begin(), at, list.end());
    return *at;
}

// The nest's boxes as triangles; empty where it holds a ball.
PeerMesh mesh_of(const Case& c) {
    PeerMesh mesh;
    const Placement m = as_doubles(c.exact);
    bool out = true;
    for (const NestedShape& s : c.nest) {
        if (s.is_ball) return {};
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (int i = 0; i < 8; ++i) mesh.points.push_back(apply_to_point(m, s.half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& f : kSides)
            for (const auto& t : {std::array<std::uint32_t, 3>{f[0], f[1], f[2]}, {f[0], f[2], f[3]}})
                mesh.triangles.push_back(out ? std::array<std::uint32_t, 3>{first + t[0], first + t[1], first + t[2]} : std::array<std::uint32_t, 3>{first + t[2], first + t[1], first + t[0]});
        out = !out;
    }
    return mesh;
}

// A crossing count or a t that is off by more than a quarter of the thinnest wall is wrong.
void ask_embree(const Case& c, const std::vector<Question>& list, Row& row) {
    const PeerMesh mesh = mesh_of(c);
    if (mesh.points.empty()) return;
    std::vector<Ray> rays;
    for (const Question& q : list) rays.push_back(q.ray);
    const auto all = embree_all_hits(mesh, rays);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& truth = list[i].truth;
        row.borders += truth.size();
        const double unit = length(list[i].ray.direction) / c.size;
        bool wrong = all[i].size() != truth.size();
        for (std::size_t k = 0; !wrong && k < truth.size(); ++k) {
            const double error = std::abs(static_cast<double>(truth[k] - Quad(all[i][k]))) * unit;
            row.errors.push_back(error);
            wrong = error > 0.25 * c.thinnest;
        }
        row.wrong += wrong;
    }
}

std::string print(const Case& c, const char* program, Row& row) {
    const double asked = static_cast<double>(row.rays - row.masked), per_1000 = 1000 / std::max(1.0, asked);
    const double error = quantile(row.errors, 0.5), worst = quantile(row.errors, 1), bound = quantile(row.bounds, 0.5);
    fmt::print("{:28} {:8.0e} {:8} masked {:8.5f} wrong {:8.5f} error {:8.1e} worst {:8.1e} bound {:8.1e} beyond {} double-double {:8.3f} exact {:8.3f}\n", c.axis, c.value, program,
               static_cast<double>(row.masked) / static_cast<double>(row.rays), static_cast<double>(row.wrong) / std::max(1.0, asked), error, worst, bound, row.beyond_bound,
               static_cast<double>(row.counters.escalated_double_double) * per_1000, static_cast<double>(row.counters.escalated_exact) * per_1000);
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", c.axis, c.value, program, row.rays, static_cast<double>(row.masked) / static_cast<double>(row.rays),
                       static_cast<double>(row.wrong) / std::max(1.0, asked), error, worst, bound, row.beyond_bound,
                       static_cast<double>(row.counters.escalated_double_double) * per_1000, static_cast<double>(row.counters.escalated_exact) * per_1000);
}

// NAME.txt: what the solid is, then a line a ray: origin, direction, true first t or -1.
bool write_case(const std::string& folder, std::size_t number, const Case& c, const std::vector<Question>& list) {
    std::ofstream out(fmt::format("{}/case_{:02}.txt", folder, number));
    out << fmt::format("{}\n{:.17g}\n{:.17g} {:.17g}\n", c.axis, c.value, c.size, c.thinnest);
    for (const double x : as_doubles(c.exact).m) out << fmt::format("{:.17g} ", x);
    out << "\n";
    for (const NestedShape& s : c.nest) out << fmt::format("{} {:.17g} ", s.is_ball ? "ball" : "box", s.half);
    out << "\n";
    for (const Question& q : list)
        out << fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", q.ray.origin.x, q.ray.origin.y, q.ray.origin.z, q.ray.direction.x, q.ray.direction.y, q.ray.direction.z,
                           q.truth.empty() ? -1 : static_cast<double>(q.truth[0]));
    return out.good();
}

}  // namespace

int measure_stability(const StabilityOptions& options) {
    std::string rows = "axis,value,program,rays,masked,wrong,error_median,error_worst,bound_median,beyond_bound,double_double_per_1000,exact_per_1000\n";
    std::size_t number = 0;
    bool held = true;
    for (const Case& c : cases()) {
        Row whittle, unsnapped, embree;
        const auto list = questions(c, options.rays, whittle);
        unsnapped = embree = whittle;
        ask_whittle(c, list, {}, whittle);
        rows += print(c, "whittle", whittle);
        held = held && whittle.beyond_bound == 0 && (whittle.wrong == 0 || c.thinnest < kSnapMatters);
        if (c.thinnest < kSnapMatters) {
            EngineOptions no_snap;
            no_snap.snap = false;
            ask_whittle(c, list, no_snap, unsnapped);
            rows += print(c, "no-snap", unsnapped);
            held = held && unsnapped.beyond_bound == 0 && unsnapped.wrong == 0;
        }
        ask_embree(c, list, embree);
        if (embree.borders > 0) rows += print(c, "embree", embree);
        if (!options.cases_dir.empty() && !write_case(options.cases_dir, number, c, list)) return 3;
        ++number;
    }
    if (!held) fmt::print(stderr, "A border is lost or beyond its bound\n");
    if (options.csv.empty()) return held ? 0 : 1;
    std::ofstream out(options.csv);
    out << rows;
    if (!out) return 3;
    return held ? 0 : 1;
}

}  // namespace whittle::bench
