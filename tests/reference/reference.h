// reference.h — the slow, obvious, exact answer to "where does a ray cross the borders of a solid".
//
// A solid is one boolean formula over the signs of polynomials in its root frame (formula.h). On a ray each polynomial is one in t; between two
// neighbouring roots of all of them no sign changes, so the formula is evaluated once there, and a border is a root where its value changes.
// Everything is exact: no tolerance anywhere, except `fuse`, which imitates the documented snap before any ray is asked.
//
// It shares with the engine the solid, the ray, and the vectors of csg/span/perturbation.h, and nothing else.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "csg/solid/solid.h"
#include "csg/span/ray.h"
#include "tests/reference/formula.h"
#include "tests/reference/parity.h"
#include "tests/reference/polynomial.h"

namespace whittle::reference {

struct Options {
    bool round_chains = true;  // a chain of placements is multiplied exactly and rounded once to twelve doubles; otherwise never rounded
    double fuse = 0;           // supports whose coefficients agree to this relative difference are one
};

// The exact t lies in [lo, hi], which is at most 2^-200 of |t| wide. `leaves`: those whose own membership changes here, in author's order; `holding`: all
// that hold the side that is inside.
struct Border {
    Dyadic lo, hi;
    bool entering = true;
    std::vector<std::uint32_t> leaves, holding;
};

struct Borders {
    bool starts_inside = false;  // just after t = 0; then the first border is an exit unless the ray enters exactly at 0
    std::vector<Border> borders; // t >= 0, ascending; one that leaves exactly at 0 is not among them
};

// The set operations over the leaves. A leaf has no operands.
struct Branch {
    SetOp op = SetOp::kUnion;
    bool is_leaf = false;
    std::uint32_t leaf = 0;
    std::vector<std::size_t> operands;
};

// A solid as formulas: what each leaf is, and what the leaves make.
struct Tree {
    Formulas formulas;
    std::vector<ExpressionId> leaves;          // not read where the leaf has facets
    std::map<std::uint32_t, Faceted> faceted;  // by leaf
    std::vector<Branch> branches;
    std::size_t root = 0;
};

// Leaves in author's order. Requires has_formula(solid) (shapes.h).
Tree tree_of(const Solid& solid, const Options& options = {});

class Evaluator {
public:
    explicit Evaluator(Tree tree);
    explicit Evaluator(const Solid& solid, const Options& options = {}) : Evaluator(tree_of(solid, options)) {}

    // With `leaving`: supports of the formulas that the ray starts on, whatever the rounding of its origin; then nothing is reported at t = 0.
    Borders borders(const Ray& ray, const std::set<std::uint32_t>& leaving = {}) const;
    std::uint32_t leaf_count() const { return static_cast<std::uint32_t>(tree_.leaves.size()); }

private:
    bool holds(std::size_t branch, const std::vector<bool>& leaf_holds) const;

    Tree tree_;
    std::vector<std::vector<std::uint32_t>> readers_;  // by support: the leaves that read it, ascending
};

}  // namespace whittle::reference
