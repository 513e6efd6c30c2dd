// convex.cpp — see convex.h.
#include "tests/reference/convex.h"

#include <algorithm>
#include <set>

#include "tests/reference/round_hull.h"

namespace whittle::reference {

namespace {

using Parts = std::vector<ConvexPart>;

bool is_ball(const BallImage& i) { return i.u.x > 0 && i == BallImage{{i.u.x, 0, 0}, {0, i.u.x, 0}, {0, 0, i.u.x}}; }
bool is_upright_disc(const BallImage& i) { return i.u.x > 0 && i == BallImage{{i.u.x, 0, 0}, {0, i.u.x, 0}, {0, 0, 0}}; }

bool is_ball(const ConvexPart& part) { return std::all_of(part.images.begin(), part.images.end(), [](const BallImage& i) { return is_ball(i); }); }
bool is_upright_disc(const ConvexPart& part) { return std::all_of(part.images.begin(), part.images.end(), [](const BallImage& i) { return is_upright_disc(i); }); }
bool turns(const ConvexPart& part) {
    return part.centre.x == 0 && part.centre.y == 0 && std::all_of(part.images.begin(), part.images.end(), [](const BallImage& i) { return is_ball(i) || is_upright_disc(i); });
}

bool of_balls(const Parts& parts) { return std::all_of(parts.begin(), parts.end(), [](const ConvexPart& p) { return is_ball(p); }); }
bool turns(const Parts& parts) { return std::all_of(parts.begin(), parts.end(), [](const ConvexPart& p) { return turns(p); }); }
std::set<double> heights(const Parts& parts) {
    std::set<double> out;
    for (const ConvexPart& p : parts) out.insert(p.centre.z);
    return out;
}
bool of_discs(const Parts& parts) {
    return heights(parts).size() == 2 && std::all_of(parts.begin(), parts.end(), [](const ConvexPart& p) { return is_upright_disc(p); });
}

// Sums of balls, or of discs, are the ball or disc of the sum.
Dyadic radius(const ConvexPart& part, bool of_ball) {
    Dyadic sum;
    for (const BallImage& i : part.images)
        if (is_ball(i) == of_ball) sum += Dyadic(i.u.x);
    return sum;
}

ExpressionId hull_of_balls(Formulas& f, const Parts& parts, const FormPoint& p) {
    std::vector<Round<Form>> balls;
    for (const ConvexPart& part : parts)
        balls.push_back({{Form(part.centre.x) * p.w, Form(part.centre.y) * p.w, Form(part.centre.z) * p.w}, Form(radius(part, true)) * p.w});
    return RoundHull<Form>(f, {p.x, p.y, p.z}, std::move(balls))();
}

// In the half-plane (rho, z), and its mirror image, a ring is two discs.
ExpressionId turned_hull(Formulas& f, const Parts& parts, const FormPoint& p) {
    const Form rho2 = p.x * p.x + p.y * p.y;
    const auto number = [&](const Form& a) { return Surd{a, Form(), rho2}; };
    std::vector<Round<Surd>> discs;
    for (const ConvexPart& part : parts) {
        const Dyadic away = radius(part, false);
        const Surd z = number(Form(part.centre.z) * p.w), r = number(Form(radius(part, true)) * p.w);
        discs.push_back({{number(Form(away) * p.w), z}, r});
        if (!away.is_zero()) discs.push_back({{number(Form(-away) * p.w), z}, r});
    }
    return RoundHull<Surd>(f, {Surd{Form(), Form(1.0), rho2}, number(p.z)}, std::move(discs))();
}

// Across, at any height between, it is the hull of the discs between any two of which one is above and one below.
ExpressionId hull_of_discs(Formulas& f, const Parts& parts, const FormPoint& p) {
    const double low = *heights(parts).begin(), high = *heights(parts).rbegin();
    const Form height = Form(high) - Form(low), over = p.z - Form(low) * p.w, under = Form(high) * p.w - p.z;
    std::vector<Round<Form>> discs;
    for (const ConvexPart& below : parts) {
        if (below.centre.z != low) continue;
        for (const ConvexPart& above : parts) {
            if (above.centre.z != high) continue;
            const auto mixed = [&](const Dyadic& a, const Dyadic& b) { return a * under + b * over; };
            discs.push_back({{mixed(below.centre.x, above.centre.x), mixed(below.centre.y, above.centre.y)}, mixed(radius(below, false), radius(above, false))});
        }
    }
    return f.all({f.positive(over), f.positive(under), RoundHull<Form>(f, {height * p.x, height * p.y}, std::move(discs))()});
}

}  // namespace

bool has_convex_formula(const Parts& parts) { return of_balls(parts) || turns(parts) || of_discs(parts); }

ExpressionId convex_formula(Formulas& f, const Parts& parts, const FormPoint& p) {
    if (turns(parts)) return turned_hull(f, parts, p);
    return of_balls(parts) ? hull_of_balls(f, parts, p) : hull_of_discs(f, parts, p);
}

}  // namespace whittle::reference
