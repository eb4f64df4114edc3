#include "core/generators/growth/whole_life.h"

#include "core/generators/growth/age_cutter.h"
#include <algorithm>

namespace ramure {

using growth::AgeCutter;

WoodAtAge woodAtAge(const GrowthHistory& history, double age)
{
    WoodAtAge out{std::vector(history.size(), glm::dvec3(0.0)), std::vector(history.size(), 0.0)};
    const AgeCutter cutter(history, age);
    for (const AgeCutter::Piece& piece : cutter.pieces()) {
        out.at[piece.metamer] = piece.at;
        out.radius[piece.metamer] = piece.radius;
    }
    return out;
}

std::vector<double> greatestShares(const GrowthHistory& history, const std::vector<double>& ages)
{
    std::vector<double> greatest(history.axisAddress.size(), 0.0);
    std::vector<Index> below(greatest.size(), noIndex); // axis that carries it
    for (Index i = 0; i < history.size(); ++i)
        if (const Index parent = history.parent[i];
            parent != noIndex && history.axis[parent] != history.axis[i])
            below[history.axis[i]] = history.axis[parent];
    for (const double age : ages) {
        std::vector<double> wood(greatest.size(), 0.0); // m2, length times radius
        double all = 0.0;
        const AgeCutter cutter(history, age);
        for (const AgeCutter::Piece& piece : cutter.pieces()) {
            const double own = piece.radius * double(history.length[piece.metamer]);
            wood[history.axis[piece.metamer]] += own;
            all += own;
        }
        for (std::size_t a = wood.size(); a-- > 0;) { // what carries an axis was there before it
            if (below[a] != noIndex)
                wood[below[a]] += wood[a];
            if (all > 0.0)
                greatest[a] = std::max(greatest[a], wood[a] / all);
        }
    }
    return greatest;
}

WholeLife wholeLife(const GrowthHistory& history, const std::vector<bool>& axes)
{
    AgeCutter cutter(history, axes);
    WholeLife out;
    out.radius.assign(history.size(), 0.0);
    for (const AgeCutter::Piece& piece : cutter.pieces())
        out.radius[piece.metamer] = piece.radius;
    out.skeleton = cutter.draw(&out.metamer);
    constexpr double slenderness = WholeLife::slenderness;
    for (double& radius : out.radius)
        radius *= slenderness;
    for (Index b = 0; b < out.skeleton.size(); ++b) {
        out.skeleton.a0[b] *= slenderness;
        out.skeleton.a1[b] *= slenderness;
    }
    return out;
}

} // namespace ramure
