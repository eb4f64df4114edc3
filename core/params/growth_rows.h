/// \file
/// Rows from the grammar to the mesh: what makes the branches of a tree. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"
#include "core/params/source_facts.h"

namespace ramure::rows {

inline constexpr SourceFacts grammarFacts{EditOperation::Grammar, "grammar.iterations",
                                          [](const NodeParams& p) { return p.turtle.alpha; },
                                          [](const NodeParams& p) { return 10.0 * p.turtle.alpha; }};

inline constexpr SourceFacts drawnFacts{EditOperation::Draw, "generator.kind",
                                        [](const NodeParams& p) {
                                            for (const TreeEdit& step : p.edits)
                                                if (step.operation == EditOperation::Draw &&
                                                    step.target.address == 0 && !step.points.empty() &&
                                                    step.points.front().radius > 0.0)
                                                    return step.points.front().radius;
                                            return p.turtle.alpha;
                                        },
                                        grammarFacts.reach};

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
inline constexpr std::array growthRows{
    row<&NodeParams::generator, &GeneratorParams::kind>(
        {"generator.kind", generatorGroup, RAMURE_NOOP("Generator"),
         RAMURE_NOOP("Method that makes the branches. Grammar: rules replace symbols, and a turtle draws them. Weber and Penn: trunk, limbs, branches and twigs, each level with its own numbers. Space colonisation: branches reach for points that fill a crown of your shape. Drawn by hand: the steps of the recipe draw all branches. Growth: shoots compete for light, year by year, and the tree has an age. Leaves, bark and motion stay.")},
        ParamUnit::None, {}, Stage::Symbols),
    row<&NodeParams::grammar, &GrammarParams::seed>(
        {"grammar.seed", generatorGroup, RAMURE_NOOP("Seed of the tree"),
         RAMURE_NOOP("Names one tree among all that chance can give. The same seed always grows the same tree.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Symbols, paramSeed, treeOnly, usesSeed),

    row<&NodeParams::grammar, &GrammarParams::dialect>(
        {"grammar.dialect", grammarGroup, RAMURE_NOOP("Language"),
         RAMURE_NOOP("Letters: each symbol is one letter, and every step has one length. Modules with numbers: letters carry "
                     "lengths, widths and angles, and rules compute with them.")},
        ParamUnit::None, {}, Stage::Symbols),
    row<&NodeParams::grammar, &GrammarParams::axiom>(
        {"grammar.axiom", grammarGroup, RAMURE_NOOP("Axiom"),
         RAMURE_NOOP("The seed the tree grows from: the symbols that stand there before any rule is used.")},
        ParamUnit::None, {}, Stage::Symbols, paramGrammar),
    row<&NodeParams::grammar, &GrammarParams::rules>(
        {"grammar.rules", grammarGroup, RAMURE_NOOP("Rules"),
         RAMURE_NOOP("How symbols grow, one rule a line: \"A -> [+A]B\" puts [+A]B in the place of every A. "
                     "Several outcomes by chance: \"B -> 0.7: B | 0.3: BB\".")},
        ParamUnit::None, {}, Stage::Symbols, paramGrammar | paramMultiline),
    row<&NodeParams::grammar, &GrammarParams::constants>(
        {"grammar.constants", grammarGroup, RAMURE_NOOP("Constants"),
         RAMURE_NOOP("Names for numbers that axiom and rules use, one a line: \"r1 = 0.9\". A line may use the names above it.")},
        ParamUnit::None, {}, Stage::Symbols, paramGrammar | paramMultiline, treeOnly, isParametric),
    row<&NodeParams::grammar, &GrammarParams::iterations>(
        {"grammar.iterations", grammarGroup, RAMURE_NOOP("Iterations"),
         RAMURE_NOOP("How often the rules are used. Each round makes the tree finer; the number of branches grows "
                     "quickly.")},
        ParamUnit::Count, {0, 30, 0, 12, 1, 0}, Stage::Symbols),
    row<&NodeParams::grammar, &GrammarParams::stochastic>(
        {"grammar.stochastic", grammarGroup, RAMURE_NOOP("Random"),
         RAMURE_NOOP("Let chance choose among the outcomes of a rule and vary the branches, so that every seed gives "
                     "another tree. Off: each rule always gives its default, and nothing varies.")},
        ParamUnit::None, {}, Stage::Symbols),

    row<&NodeParams::turtle, &TurtleParams::theta>(
        {"turtle.theta", turtleGroup, RAMURE_NOOP("Turn"),
         RAMURE_NOOP("The angle of every turn a symbol asks for. Small angles give slender trees, large ones "
                     "spreading trees.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, 0, pi / 3, 0.01, 4}, Stage::Skeleton, paramAnimatable),
    row<&NodeParams::turtle, &TurtleParams::alpha>(
        {"turtle.alpha", turtleGroup, RAMURE_NOOP("Step"),
         RAMURE_NOOP("Length of each piece of branch, and the radius of the trunk at the ground. Leaves and apples "
                     "take their size from it too: it scales the whole tree.")},
        ParamUnit::Metre, {1e-4, 1000, 0.01, 1, 0.01, 4}, Stage::Skeleton, paramAnimatable),
    row<&NodeParams::turtle, &TurtleParams::decay>(
        {"turtle.decay", turtleGroup, RAMURE_NOOP("Taper"),
         RAMURE_NOOP("Share of the radius that remains at the end of each piece of branch. 1 keeps branches as thick as the trunk.")},
        ParamUnit::Ratio, {0.01, 1, 0.5, 1, 0.01, 4}, Stage::Skeleton, paramAnimatable),
    row<&NodeParams::turtle, &TurtleParams::tropism>(
        {"turtle.tropism", turtleGroup, RAMURE_NOOP("Tropism"),
         RAMURE_NOOP("Direction that branches bend towards as they grow: down under their weight, up towards the light. A longer arrow bends them more.")},
        ParamUnit::None, {-1000, 1000, -1, 1, 0.05, 3}, Stage::Skeleton, paramAnimatable, treeOnly, isParametric),
    row<&NodeParams::turtle, &TurtleParams::elasticity>(
        {"turtle.elasticity", turtleGroup, RAMURE_NOOP("Elasticity"),
         RAMURE_NOOP("How much each piece of branch gives way to the tropism. 0: branches stay as the rules say.")},
        ParamUnit::Ratio, {-10, 10, 0, 0.5, 0.01, 4}, Stage::Skeleton, paramAnimatable, treeOnly, isParametric),

    row<&NodeParams::variation, &VariationParams::angle>(
        {"variation.angle", variationGroup, RAMURE_NOOP("Angles"),
         RAMURE_NOOP("How far each turn of a tree grown by chance may lie from the angle above, by seed. 0: every turn is the "
                     "same.")},
        ParamUnit::Share, {0, 0.9, 0, 0.3, 0.01, 3}, Stage::Skeleton, paramNone, treeOnly, growsByChance),
    row<&NodeParams::variation, &VariationParams::length>(
        {"variation.length", variationGroup, RAMURE_NOOP("Lengths"),
         RAMURE_NOOP("How far each piece of branch of a tree grown by chance may be longer or shorter than the step, by seed.")},
        ParamUnit::Share, {0, 0.9, 0, 0.3, 0.01, 3}, Stage::Skeleton, paramNone, treeOnly, growsByChance),
    row<&NodeParams::variation, &VariationParams::radius>(
        {"variation.radius", variationGroup, RAMURE_NOOP("Radii"),
         RAMURE_NOOP("How far each piece of branch of a tree grown by chance may taper more or less than the taper says, by "
                     "seed. No branch gets thicker towards its tip.")},
        ParamUnit::Share, {0, 0.9, 0, 0.3, 0.01, 3}, Stage::Skeleton, paramNone, treeOnly, growsByChance),
};

/// From the branches to the mesh.
inline constexpr std::array modelRows{
    row<&NodeParams::simplify, &SimplifyParams::enabled>(
        {"simplify.enabled", simplifyGroup, RAMURE_NOOP("Merge straight runs"),
         RAMURE_NOOP("Make one branch of pieces that follow each other without a turn. The shape stays, the mesh gets "
                     "lighter.")},
        ParamUnit::None, {}, Stage::Simplified),
    row<&NodeParams::simplify, &SimplifyParams::rotationThreshold>(
        {"simplify.rotationThreshold", simplifyGroup, RAMURE_NOOP("Straight below"),
         RAMURE_NOOP("Pieces that turn by less than this angle count as straight and are merged. Larger angles remove "
                     "bends too.")},
        ParamUnit::Radian, {0, pi, 0, 0.5, 0.001, 6}, Stage::Simplified, paramAdvanced, treeOnly, mergesRuns),

    row<&NodeParams::sections, &SectionParams::lengthDivisions>(
        {"sections.lengthDivisions", sectionsGroup, RAMURE_NOOP("Along the branch"),
         RAMURE_NOOP("Cross-sections of each branch, both ends included. More make smoother bends.")},
        ParamUnit::Count, {2, 64, 2, 16, 1, 0}, Stage::Sections),
    row<&NodeParams::sections, &SectionParams::radialDivisions>(
        {"sections.radialDivisions", sectionsGroup, RAMURE_NOOP("Around the branch"),
         RAMURE_NOOP("Points of each cross-section. More make rounder branches.")},
        ParamUnit::Count, {3, 64, 3, 32, 1, 0}, Stage::Mesh, paramNone, treeOnly, hasNoBudget),
    row<&NodeParams::mesh, &MeshParams::targetTriangles>(
        {"mesh.targetTriangles", sectionsGroup, RAMURE_NOOP("Triangle budget"),
         RAMURE_NOOP("About how many triangles all branches may take together, within 5 %. Thick and bent branches get "
                     "more of them, thin and straight ones fewer, and the two numbers above have no say. 0 sets no "
                     "budget.")},
        ParamUnit::Count, {0, 20'000'000, 0, 500'000, 1000, 0}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::leastRadius>(
        {"mesh.leastRadius", sectionsGroup, RAMURE_NOOP("Least radius"),
         RAMURE_NOOP("Branches of the mesh are made no thinner than this, and no two of its vertices lie closer together "
                     "than about half of it: at 0.25 mm, programs that merge vertices within 0.1 mm keep the mesh closed. "
                     "No more than a two-thousandth of the size of the tree is taken, and where branches have more than 12"
                     " points around, these may lie closer. 0 leaves the thinnest twigs as they are.")},
        ParamUnit::Metre, {0, 1, 0, 0.005, 0.00005, 5}, Stage::Mesh, paramAdvanced),
    row<&NodeParams::mesh, &MeshParams::splinters>(
        {"mesh.splinters", sectionsGroup, RAMURE_NOOP("Splinters"),
         RAMURE_NOOP("How far splinters stand out of the broken ends of dead limbs, in diameters of the wood. 0: ends are "
                     "flat, as those of living wood that was cut.")},
        ParamUnit::Factor, {0, 4, 0, 2, 0.1, 2}, Stage::Mesh, paramAdvanced),
    row<&NodeParams::mesh, &MeshParams::forkSoftness>(
        {"mesh.forkSoftness", forksGroup, RAMURE_NOOP("Softness"),
         RAMURE_NOOP("How far wood grows over the creases between the branches of a fork: 0 leaves them sharp, 1 rounds "
                     "them fully.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::forkReach>(
        {"mesh.forkReach", forksGroup, RAMURE_NOOP("Reach"),
         RAMURE_NOOP("How far from the crease the branches of a fork begin to swell, as a share of the thinner one's "
                     "radius.")},
        ParamUnit::Ratio, {0, 4, 0, 2, 0.05, 3}, Stage::Mesh, paramNone, treeOnly, softensForks),
    row<&NodeParams::mesh, &MeshParams::forkLength>(
        {"mesh.forkLength", forksGroup, RAMURE_NOOP("Length"),
         RAMURE_NOOP("Distance above a fork, in diameters of the branch, over which a branch narrows from its parent's width to its own. At 0 it begins with its own width, which leaves a ledge if it is thinner.")},
        ParamUnit::Factor, {0, 10, 0, 3, 0.1, 2}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::collar>(
        {"mesh.collar", forksGroup, RAMURE_NOOP("Collar"),
         RAMURE_NOOP("How much wider than its own radius a side limb is where it leaves a thicker branch. The collar "
                     "narrows within about a diameter of the limb.")},
        ParamUnit::Ratio, {0, 2, 0, 1, 0.05, 2}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::fairing>(
        {"mesh.fairing", forksGroup, RAMURE_NOOP("Fairing"),
         RAMURE_NOOP("How far the surface around forks of thick wood is smoothed, from the walls between the branches "
                     "to the cross-sections beside them. 0 leaves it as it is built.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 2}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::ridge>(
        {"mesh.ridge", forksGroup, RAMURE_NOOP("Bark ridge"),
         RAMURE_NOOP("How high bark stands up above a limb where it leaves a thicker branch, as a share of that one's "
                     "diameter. Twins that part at less than 30 degrees have a crease instead. 0 leaves it out.")},
        ParamUnit::Ratio, {0, 0.2, 0, 0.08, 0.005, 3}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::clampOvershoot>(
        {"mesh.clampOvershoot", forksGroup, RAMURE_NOOP("Calm short branches"),
         RAMURE_NOOP("A branch much shorter than its parent swings out in a wide bow before it turns to its own direction. "
                     "On: the bow is no larger than one and a half times the branch.")},
        ParamUnit::None, {}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::nearTwinRatio>(
        {"mesh.nearTwinRatio", forksGroup, RAMURE_NOOP("Join twins below"),
         RAMURE_NOOP("Branches of a fork become one where their ends are closer than this share of their added radii: they "
                     "would lie in each other all along. 0 joins only those in the same place.")},
        ParamUnit::Ratio, {0, 4, 0, 1, 0.05, 3}, Stage::Mesh, paramAdvanced),
    row<&NodeParams::mesh, &MeshParams::roots>(
        {"mesh.roots", footGroup, RAMURE_NOOP("Roots"),
         RAMURE_NOOP("Main roots into which the foot of a trunk divides, three or more. They run out over the ground and "
                     "sink. With 0 the trunk stands on the ground like a post.")},
        ParamUnit::Count, {0, 16, 0, 9, 1, 0}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::rootLength>(
        {"mesh.rootLength", footGroup, RAMURE_NOOP("Root length"),
         RAMURE_NOOP("How far from the trunk the roots sink into the ground, in diameters of the trunk. Each root is "
                     "longer or shorter than that by its share of chance.")},
        ParamUnit::Factor, {0.1, 10, 0.5, 3, 0.1, 2}, Stage::Mesh, paramNone, treeOnly, hasRoots),
    row<&NodeParams::mesh, &MeshParams::rootHeight>(
        {"mesh.rootHeight", footGroup, RAMURE_NOOP("Root height"),
         RAMURE_NOOP("How high above the ground the roots leave the trunk, in diameters of the trunk: 1 gives the foot of "
                     "an oak, 3 the buttresses of a kapok tree.")},
        ParamUnit::Factor, {0.1, 10, 0.3, 3, 0.1, 2}, Stage::Mesh, paramNone, treeOnly, hasRoots),
};
// clang-format on

} // namespace ramure::rows
