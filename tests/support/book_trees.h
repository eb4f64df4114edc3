/// \file
/// The trees of "The Algorithmic Beauty of Plants" (Prusinkiewicz and Lindenmayer 1990), figures 2.6 to 2.8,
/// in the book's numbers. What an independent program made of them stands in tests/data/abop.csv.
#pragma once

#include "core/params/node_params.h"
#include <string>

namespace ramure::test {

struct BookTree
{
    const char* figure;
    const char* axiom;
    const char* rules;
    const char* constants;
    glm::dvec3 tropism{0.0, -1.0, 0.0};
    double elasticity = 0.0;

    [[nodiscard]] NodeParams params(int iterations) const
    {
        NodeParams params;
        params.grammar = {axiom, rules, iterations, false, 1, GrammarDialect::Parametric, constants};
        params.turtle.tropism = tropism;
        params.turtle.elasticity = elasticity;
        return params;
    }
};

// clang-format off
inline constexpr const char* hondaRules =
    "A(l,w) -> !(w)F(l)[&(a0)B(l*r2,w*wr)]/(d)A(l*r1,w*wr)\n"
    "B(l,w) -> !(w)F(l)[-(a2)$C(l*r2,w*wr)]C(l*r1,w*wr)\n"
    "C(l,w) -> !(w)F(l)[+(a2)$B(l*r2,w*wr)]B(l*r1,w*wr)\n";
inline constexpr const char* aonoKuniiRules =
    "A(l,w) -> !(w)F(l)[&(a1)B(l*r1,w*wr)]/(180)[&(a2)B(l*r2,w*wr)]\n"
    "B(l,w) -> !(w)F(l)[+(a1)$B(l*r1,w*wr)][-(a2)$B(l*r2,w*wr)]\n";
inline constexpr const char* ternaryRules =
    "A -> !(vr)F(50)[&(a)F(50)A]/(d1)[&(a)F(50)A]/(d2)[&(a)F(50)A]\n"
    "F(l) -> F(l*lr)\n"
    "!(w) -> !(w*vr)\n";

inline constexpr BookTree bookTrees[] = {
    {"2.6a", "A(1,10)", hondaRules, "r1 = 0.9\nr2 = 0.6\na0 = 45\na2 = 45\nd = 137.5\nwr = 0.707"},
    {"2.6b", "A(1,10)", hondaRules, "r1 = 0.9\nr2 = 0.9\na0 = 45\na2 = 45\nd = 137.5\nwr = 0.707"},
    {"2.6c", "A(1,10)", hondaRules, "r1 = 0.9\nr2 = 0.8\na0 = 45\na2 = 45\nd = 137.5\nwr = 0.707"},
    {"2.7a", "A(1,10)", aonoKuniiRules, "r1 = 0.9\nr2 = 0.7\na1 = 5\na2 = 65\nwr = 0.707"},
    {"2.7b", "A(1,10)", aonoKuniiRules, "r1 = 0.9\nr2 = 0.7\na1 = 10\na2 = 60\nwr = 0.707"},
    {"2.7d", "A(1,10)", aonoKuniiRules, "r1 = 0.9\nr2 = 0.8\na1 = 35\na2 = 35\nwr = 0.707"},
    {"2.8a", "!(1)F(200)/(45)A", ternaryRules, "d1 = 94.74\nd2 = 132.63\na = 18.95\nlr = 1.109\nvr = 1.732",
     {0.0, -1.0, 0.0}, 0.22},
    {"2.8c", "!(1)F(200)/(45)A", ternaryRules, "d1 = 112.5\nd2 = 157.5\na = 22.5\nlr = 1.79\nvr = 1.732",
     {-0.02, -1.0, 0.0}, 0.27},
};
// clang-format on

} // namespace ramure::test
