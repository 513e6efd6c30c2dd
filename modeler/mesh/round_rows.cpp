#include "modeler/mesh/round_rows.h"

#include <numbers>

#include "csg/base/degrees.h"
#include "csg/base/vec.h"

namespace whittle {
namespace {

double squared(const Vec3& v) { return glm::dot(v, v); }

// How far the ball of radius 1 bulges over a triangle with its corners on it.
double bulge(const Vec3& p, const Vec3& q, const Vec3& r) {
    const double a = squared(q - r), b = squared(r - p), c = squared(p - q), most = std::max({a, b, c}), rest = a + b + c - most;
    const double sixteen_areas_squared = 2 * (a * b + b * c + c * a) - (a * a + b * b + c * c);
    // Of the circumscribed circle; where it bulges most beside the triangle, of the one about the longest side.
    const double radius_squared = most >= rest || !(sixteen_areas_squared > 0) ? most / 4 : a * b * c / sixteen_areas_squared;
    return radius_squared / (1 + std::sqrt(std::max(0.0, 1 - radius_squared)));
}

std::vector<Vec2> directions(const std::vector<double>& along) {
    std::vector<Vec2> out;
    for (const double share : along) out.emplace_back(cosd(90 * share), sind(90 * share));
    return out;
}

// visit(i, j, stands, corners) for the triangles between two rows, the shorter diagonal first.
template <class Visit>
void walk(const std::vector<Vec2>& lower, double c0, double s0, const std::vector<Vec2>& upper, double c1, double s1, const Visit& visit) {
    const auto low = [&](std::size_t i) { return Vec3{c0 * lower[i].x, c0 * lower[i].y, s0}; };
    const auto high = [&](std::size_t j) { return Vec3{c1 * upper[j].x, c1 * upper[j].y, s1}; };
    for (std::size_t i = 0, j = 0; i + 1 < lower.size() || j + 1 < upper.size();) {
        const bool stands = j + 1 == upper.size() || (i + 1 < lower.size() && squared(low(i + 1) - high(j)) <= squared(low(i) - high(j + 1)));
        visit(i, j, stands, low(i), high(j), stands ? low(i + 1) : high(j + 1));
        ++(stands ? i : j);
    }
}

// `count` equal steps, or the middles between their ends.
std::vector<double> shares(std::uint32_t count, bool middles) {
    std::vector<double> out{0};
    for (std::uint32_t i = 0; i < count; ++i) out.push_back((middles ? i + 0.5 : i + 1.0) / count);
    if (middles) out.push_back(1);
    return out;
}

// A row that may come next: so high that the triangles below it are within the tolerance.
struct Candidate {
    std::uint32_t count = 0;
    bool middles = false;
    double latitude_deg = 0, score = 0;
};

class Builder {
public:
    Builder(double r, const CurveRule& rule) {
        constexpr double kRounding = 1 - 0x1p-20;  // of the sums in bulge(), and of the points' own coordinates
        error_ = std::min(rule.chord(r) / r, 1.0) * kRounding;
        const double radius = std::sqrt(error_ * (2 - error_));  // of the largest circle around a triangle
        most_deg_ = std::min(45.0, rule.angle_deg.value_or(45.0));
        widest_deg_ = std::min(most_deg_, 2 * std::asin(std::min(1.0, std::numbers::sqrt3 / 2 * radius)) / kRadiansPerDegree);
        highest_deg_ = std::min(most_deg_, 2 * std::asin(std::min(1.0, radius)) / kRadiansPerDegree);
    }

    std::vector<RoundRow> run() {
        std::uint32_t count = steps_at(0);
        bool middles = false;
        double latitude_deg = 0;
        std::vector<RoundRow> rows{{1, 0, shares(count, false)}};
        const RoundRow pole{0, 1, {0}};
        const std::vector<Vec2> top = directions(pole.along);
        while (true) {
            here_ = directions(rows.back().along);
            if (90 - latitude_deg <= most_deg_ && worst(latitude_deg, top, 90) <= error_) break;
            const double near_deg = std::min(90.0, latitude_deg + 0.6 * highest_deg_);
            Candidate best = candidate(latitude_deg, count, !middles);
            for (const bool m : {false, true})
                if (const Candidate c = candidate(latitude_deg, steps_at(near_deg), m); c.score > best.score) best = c;
            count = best.count, middles = best.middles, latitude_deg = best.latitude_deg;
            rows.push_back({cosd(latitude_deg), sind(latitude_deg), shares(count, middles)});
        }
        rows.push_back(pole);
        return rows;
    }

private:
    // Steps of a quarter of a turn, none wider than may be.
    std::uint32_t steps_at(double latitude_deg) const {
        return std::max(1U, static_cast<std::uint32_t>(std::ceil(90 * cosd(latitude_deg) / widest_deg_)));
    }

    double worst(double from_deg, const std::vector<Vec2>& upper, double to_deg) const {
        double most = 0;
        walk(here_, cosd(from_deg), sind(from_deg), upper, cosd(to_deg), sind(to_deg),
             [&](std::size_t, std::size_t, bool, const Vec3& p, const Vec3& q, const Vec3& r) { most = std::max(most, bulge(p, q, r)); });
        return most;
    }

    // The area a triangle covers, less where the row would be much finer than it must be: the next would be too.
    Candidate candidate(double from_deg, std::uint32_t count, bool middles) const {
        const std::vector<Vec2> upper = directions(shares(count, middles));
        constexpr int kParts = 1 << 12;
        const double most_deg = std::min(highest_deg_, 90 - from_deg);
        int low = 0;
        for (int step = kParts / 2; step > 0; step /= 2)
            if (worst(from_deg, upper, from_deg + most_deg * (low + step) / kParts) <= error_) low += step;
        Candidate out{count, middles, from_deg + most_deg * std::max(low, 1) / kParts, 0};
        const double triangles = static_cast<double>(here_.size() + upper.size() - 2), fill = 90 * cosd(out.latitude_deg) / count / widest_deg_;
        constexpr double kFineness = 0.3;  // 0.2 to 0.8 give the same counts within 2 % at tolerances from 1e-2 to 2e-4 of the radius
        out.score = low == 0 ? 0 : (sind(out.latitude_deg) - sind(from_deg)) / triangles * (1 + kFineness * (std::min(1.0, fill) - 1));
        return out;
    }

    double error_ = 0, most_deg_ = 0, widest_deg_ = 0, highest_deg_ = 0;
    std::vector<Vec2> here_;
};

}  // namespace

std::vector<RoundRow> round_rows(double r, const CurveRule& rule) { return Builder(r, rule).run(); }

std::vector<RowTriangle> triangles_between(const RoundRow& lower, const RoundRow& upper) {
    std::vector<RowTriangle> out;
    walk(directions(lower.along), lower.cosine, lower.sine, directions(upper.along), upper.cosine, upper.sine,
         [&](std::size_t i, std::size_t j, bool stands, const Vec3&, const Vec3&, const Vec3&) {
             out.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), stands});
         });
    return out;
}

}  // namespace whittle
