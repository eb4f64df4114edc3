/// \file
/// Rows of scatters. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"

namespace ramure::rows {

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
inline constexpr std::array scatterRows{
    row<&NodeParams::scatter, &ScatterParams::count>(
        {"scatter.count", scatterGroup, RAMURE_NOOP("Instances"),
         RAMURE_NOOP("At most so many copies of the nodes below stand on the ground. 0: as many as the spacing lets stand.")},
        ParamUnit::Count, {0, 1'000'000, 0, 5000, 10, 0}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::spacing>(
        {"scatter.spacing", scatterGroup, RAMURE_NOOP("Spacing"),
         RAMURE_NOOP("Two copies stand at least so far apart, measured on a map.")},
        ParamUnit::Metre, {0, 1e4, 0, 20, 0.1, 3}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::seed>(
        {"scatter.seed", scatterGroup, RAMURE_NOOP("Seed of the places"),
         RAMURE_NOOP("Another seed gives other places, turns and sizes. The same seed always gives the same.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Mesh, paramSeed, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::width>(
        {"scatter.width", scatterGroup, RAMURE_NOOP("Width of the area"),
         RAMURE_NOOP("How far the area reaches along X, with the node in its middle.")},
        ParamUnit::Metre, {1e-3, 1e6, 1, 500, 1, 2}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::depth>(
        {"scatter.depth", scatterGroup, RAMURE_NOOP("Depth of the area"),
         RAMURE_NOOP("How far the area reaches along Z, with the node in its middle.")},
        ParamUnit::Metre, {1e-3, 1e6, 1, 500, 1, 2}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::ground>(
        {"scatter.ground", scatterGroup, RAMURE_NOOP("Ground"),
         RAMURE_NOOP("Name of the node that the copies stand on: a terrain, a mesh or a shape. If it is empty, they stand on all "
                     "terrains of the scene, and on the level ground where there is none.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::density>(
        {"scatter.density", scatterGroup, RAMURE_NOOP("Map of density"),
         RAMURE_NOOP("A picture that lies over the area as seen from above, its lower edge at the greater Z: where it is white, copies stand as "
                     "densely as they may; where it is black, none stand.")},
        ParamUnit::None, {}, Stage::Mesh, paramPicture, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::steepest>(
        {"scatter.steepest", scatterGroup, RAMURE_NOOP("Steepest slope"),
         RAMURE_NOOP("No copy stands where the ground is steeper than this.")},
        ParamUnit::Radian, {0, pi / 2, 0, pi / 2, pi / 180, 4}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::lowest>(
        {"scatter.lowest", scatterGroup, RAMURE_NOOP("Lowest ground"),
         RAMURE_NOOP("No copy stands on ground that lies lower than this, from the scatter's own height.")},
        ParamUnit::Metre, {-1e6, 1e6, -100, 100, 1, 0}, Stage::Mesh, paramAdvanced, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::highest>(
        {"scatter.highest", scatterGroup, RAMURE_NOOP("Highest ground"),
         RAMURE_NOOP("No copy stands on ground that lies higher than this, from the scatter's own height.")},
        ParamUnit::Metre, {-1e6, 1e6, -100, 100, 1, 0}, Stage::Mesh, paramAdvanced, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::clearance>(
        {"scatter.clearance", scatterGroup, RAMURE_NOOP("Distance from obstacles"),
         RAMURE_NOOP("How far copies keep away from shapes and meshes whose role for trees is “Obstacle”, measured on a map. None "
                     "stands on such a solid.")},
        ParamUnit::Metre, {0, 1e4, 0, 20, 0.1, 3}, Stage::Mesh, paramAdvanced, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::clusters>(
        {"scatter.clusters", scatterGroup, RAMURE_NOOP("Clusters"),
         RAMURE_NOOP("How strongly copies gather in clusters: 0 spreads them evenly, 1 leaves clearings empty.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::clusterSize>(
        {"scatter.clusterSize", scatterGroup, RAMURE_NOOP("Size of clusters"),
         RAMURE_NOOP("How wide a cluster is.")},
        ParamUnit::Metre, {1e-2, 1e5, 1, 100, 1, 2}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::shares>(
        {"scatter.shares", scatterGroup, RAMURE_NOOP("Shares"),
         RAMURE_NOOP("How often each of the nodes below is taken, in their order: “3 1” takes the first three times as often as the "
                     "second. A node without a number has 1.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::leastScale>(
        {"scatter.leastScale", scatterGroup, RAMURE_NOOP("Smallest scale"),
         RAMURE_NOOP("How small the smallest copy is, compared with the node that it copies.")},
        ParamUnit::Factor, {1e-3, 1e3, 0.1, 3, 0.05, 3}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::mostScale>(
        {"scatter.mostScale", scatterGroup, RAMURE_NOOP("Largest scale"),
         RAMURE_NOOP("How large the largest copy is, compared with the node that it copies.")},
        ParamUnit::Factor, {1e-3, 1e3, 0.1, 3, 0.05, 3}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::turn>(
        {"scatter.turn", scatterGroup, RAMURE_NOOP("Turned by chance"),
         RAMURE_NOOP("How far copies are turned about the vertical: 0 not at all, 1 by any angle.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::alignment>(
        {"scatter.alignment", scatterGroup, RAMURE_NOOP("Along the slope"),
         RAMURE_NOOP("How far copies lean with the ground: 0 stands upright, as trees do, 1 square to the ground, as stones lie.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::stand>(
        {"scatter.stand", scatterGroup, RAMURE_NOOP("Grows as a stand"),
         RAMURE_NOOP("The trees are sown at their places and grow up together: they take each other's light, most of them die of "
                     "shade, and the others are as high as trees of their age in a stand. Of several prototypes of one species each "
                     "tree takes the one that is most nearly as high.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::age>(
        {"scatter.age", scatterGroup, RAMURE_NOOP("Age of the stand"),
         RAMURE_NOOP("How long ago its trees were sown.")},
        ParamUnit::Year, {1, 400, 1, 150, 1, 0}, Stage::Mesh, paramAnimatable, scatterOnly),
    row<&NodeParams::scatter, &ScatterParams::removed>(
        {"scatter.removed", scatterGroup, RAMURE_NOOP("Left out"),
         RAMURE_NOOP("Keys of copies that were taken away by hand, or made trees of their own. Empty it to have them all back.")},
        ParamUnit::None, {}, Stage::Mesh, paramAdvanced, scatterOnly),
};
// clang-format on

} // namespace ramure::rows
