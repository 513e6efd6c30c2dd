// formula.cpp — see formula.h.
#include "tests/reference/formula.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace whittle::reference {

namespace {

// A positive multiple of f with coprime odd-part content: equal for proportional forms of one sign.
Form primitive(const Form& f) {
    mpz_class content = 0;
    long lowest = f.terms().begin()->second.exponent();
    for (const auto& [m, c] : f.terms()) {
        content = gcd(content, c.mantissa());
        lowest = std::min(lowest, c.exponent());
    }
    Form r;
    for (const auto& [m, c] : f.terms()) r.add(m, Dyadic(c.mantissa() / content, c.exponent() - lowest));
    return r;
}

// The coefficients over the largest, in double: fusing is a matter of closeness, not of exactness.
using Outline = std::map<Monomial, double>;

Outline outline(const Form& f) {
    Dyadic most;
    for (const auto& [m, c] : f.terms())
        if (most < abs(c)) most = abs(c);
    Outline r;
    for (const auto& [m, c] : f.terms()) r[m] = c.scaled(-most.top()).to_double() / most.scaled(-most.top()).to_double();
    return r;
}

bool nearly_equal(const Outline& f, const Outline& g, double sign, double relative) {
    const auto close = [&](const Outline& a, const Outline& b) {
        return std::all_of(a.begin(), a.end(), [&](const auto& t) {
            const auto at = b.find(t.first);
            return std::abs(t.second - sign * (at == b.end() ? 0 : at->second)) <= relative;
        });
    };
    return close(f, g) && close(g, f);
}

}  // namespace

Formulas::Formulas() : expressions_{{Expression::Kind::kFalse, 0, {}}, {Expression::Kind::kTrue, 0, {}}} {}

ExpressionId Formulas::add(Expression e) {
    expressions_.push_back(std::move(e));
    return static_cast<ExpressionId>(expressions_.size() - 1);
}

std::uint32_t Formulas::support(const Form& f, bool& flipped) {
    flipped = f.terms().rbegin()->second.sign() < 0;  // f and -f are one support
    const Form kept = primitive(flipped ? -f : f);
    std::vector<std::pair<Monomial, std::pair<mpz_class, long>>> key;
    for (const auto& [m, c] : kept.terms()) key.push_back({m, {c.mantissa(), c.exponent()}});
    const auto [at, fresh] = by_terms_.try_emplace(std::move(key), static_cast<std::uint32_t>(supports_.size()));
    if (fresh) supports_.push_back(kept);
    return at->second;
}

ExpressionId Formulas::negative(const Form& form) {
    const Form f = form.leading();
    if (f.is_constant()) return !f.is_zero() && f.terms().begin()->second.sign() < 0 ? always() : never();
    bool flipped = false;
    const std::uint32_t at = support(f, flipped);
    return add({flipped ? Expression::Kind::kPositive : Expression::Kind::kNegative, at, {}});
}

ExpressionId Formulas::negative(const Surd& s) {
    if (s.b.is_zero()) return negative(s.a);
    if (s.a.is_zero()) return negative(s.b);
    // a + b rho < 0: where both are negative, or where the negative one is the larger.
    const Form norm = s.a * s.a - s.b * s.b * s.rho2;
    const ExpressionId a = negative(s.a), b = negative(s.b);
    return any({all({a, b}), all({a, positive(norm)}), all({b, negative(norm)})});
}

int Formulas::fuse(double relative) {
    std::vector<Outline> outlines;
    for (const Form& f : supports_) outlines.push_back(outline(f));
    std::vector<std::uint32_t> into(supports_.size());
    std::vector<bool> turned(supports_.size());
    int fused = 0;
    for (std::uint32_t i = 0; i < supports_.size(); ++i) {
        into[i] = i;
        for (std::uint32_t j = 0; j < i && into[i] == i; ++j) {
            turned[i] = nearly_equal(outlines[j], outlines[i], -1, relative);
            if (into[j] != j || !(turned[i] || nearly_equal(outlines[j], outlines[i], 1, relative))) continue;
            into[i] = j;
            ++fused;
        }
    }
    for (Expression& e : expressions_) {
        const bool negative = e.kind == Expression::Kind::kNegative;
        if (!negative && e.kind != Expression::Kind::kPositive) continue;
        if (into[e.support] != e.support && turned[e.support]) e.kind = negative ? Expression::Kind::kPositive : Expression::Kind::kNegative;
        e.support = into[e.support];
    }
    return fused;
}

std::vector<std::uint32_t> Formulas::reads(ExpressionId e) const {
    std::set<std::uint32_t> found;
    std::vector<ExpressionId> open{e};
    while (!open.empty()) {
        const Expression& x = expressions_[open.back()];
        open.pop_back();
        if (x.kind == Expression::Kind::kNegative || x.kind == Expression::Kind::kPositive) found.insert(x.support);
        open.insert(open.end(), x.operands.begin(), x.operands.end());
    }
    return {found.begin(), found.end()};
}

bool Formulas::holds(ExpressionId id, const std::vector<int>& signs) const {
    const Expression& e = expressions_[id];
    const auto operand_holds = [&](ExpressionId o) { return holds(o, signs); };
    switch (e.kind) {
        case Expression::Kind::kFalse: return false;
        case Expression::Kind::kTrue: return true;
        case Expression::Kind::kNegative: return signs[e.support] < 0;
        case Expression::Kind::kPositive: return signs[e.support] > 0;
        case Expression::Kind::kAll: return std::all_of(e.operands.begin(), e.operands.end(), operand_holds);
        case Expression::Kind::kAny: return std::any_of(e.operands.begin(), e.operands.end(), operand_holds);
        case Expression::Kind::kOdd: return std::count_if(e.operands.begin(), e.operands.end(), operand_holds) % 2 != 0;
        case Expression::Kind::kNot: return !holds(e.operands[0], signs);
    }
    return false;
}

}  // namespace whittle::reference
