// form.cpp — see form.h.
#include "tests/reference/form.h"

#include <algorithm>
#include <cmath>

namespace whittle::reference {

Form Form::variable(int axis) {
    Form f;
    Monomial m{};
    m[static_cast<std::size_t>(axis)] = 1;
    f.add(m, Dyadic(1.0));
    return f;
}

void Form::add(const Monomial& monomial, const Dyadic& coefficient) {
    if (coefficient.is_zero()) return;
    const auto [at, fresh] = terms_.try_emplace(monomial, coefficient);
    if (fresh) return;
    at->second += coefficient;
    if (at->second.is_zero()) terms_.erase(at);
}

Form Form::leading() const {
    int least = terms_.empty() ? 0 : terms_.begin()->first[3];
    for (const auto& [m, c] : terms_) least = std::min(least, m[3]);
    Form r;
    for (const auto& [m, c] : terms_)
        if (m[3] == least) r.add({m[0], m[1], m[2], 0}, c);
    return r;
}

int Form::degree() const {
    int most = 0;
    for (const auto& [m, c] : terms_) most = std::max(most, m[0] + m[1] + m[2]);
    return most;
}

Form operator+(Form a, const Form& b) {
    for (const auto& [m, c] : b.terms_) a.add(m, c);
    return a;
}

Form operator-(Form a, const Form& b) {
    for (const auto& [m, c] : b.terms_) a.add(m, -c);
    return a;
}

Form operator*(const Form& a, const Form& b) {
    Form r;
    for (const auto& [m, c] : a.terms_)
        for (const auto& [n, d] : b.terms_) r.add({m[0] + n[0], m[1] + n[1], m[2] + n[2], m[3] + n[3]}, c * d);
    return r;
}

Matrix exact(const Placement& placement) {
    Matrix m;
    std::transform(placement.m.begin(), placement.m.end(), m.begin(), [](double v) { return Dyadic(v); });
    return m;
}

Matrix operator*(const Matrix& outer, const Matrix& inner) {
    Matrix r;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            Dyadic& s = r[4 * i + j];
            if (j == 3) s = outer[4 * i + 3];
            for (std::size_t k = 0; k < 3; ++k) s += outer[4 * i + k] * inner[4 * k + j];
        }
    return r;
}

Matrix rounded(const Matrix& m) {
    Matrix r;
    std::transform(m.begin(), m.end(), r.begin(), [](const Dyadic& v) {
        const double below = v.to_double();  // towards zero
        const double above = std::nextafter(below, v.sign() < 0 ? -INFINITY : INFINITY);
        const Dyadic under = abs(v - below), over = abs(Dyadic(above) - v);
        const bool even = Dyadic(below).mantissa() == 0 || Dyadic(below).exponent() > Dyadic(above).exponent();
        return Dyadic(under < over || (under == over && even) ? below : above);
    });
    return r;
}

Dyadic determinant(const Matrix& m) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
}

FormPoint pulled_back(const FormPoint& p, const Matrix& m) {
    const Dyadic det = determinant(m);
    const Form s(det.sign() < 0 ? -1.0 : 1.0);
    const Form d[3] = {s * (p.x - Form(m[3]) * p.w), s * (p.y - Form(m[7]) * p.w), s * (p.z - Form(m[11]) * p.w)};
    const auto cofactor = [&](std::size_t i, std::size_t j) {  // of the entry in row i, column j
        const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return Form(m[4 * i1 + j1] * m[4 * i2 + j2] - m[4 * i1 + j2] * m[4 * i2 + j1]);
    };
    const auto row = [&](std::size_t j) { return cofactor(0, j) * d[0] + cofactor(1, j) * d[1] + cofactor(2, j) * d[2]; };
    return {row(0), row(1), row(2), s * Form(det) * p.w};
}

}  // namespace whittle::reference
