/// \file
/// Rows of the steps of a recipe: each kind of step names those that it has (tree_edit_table.cpp). Internal
/// to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"

namespace ramure::rows {

inline constexpr const char* stepGroup = RAMURE_NOOP("Step");
inline constexpr const char* standGroup = RAMURE_NOOP("Where it grows");
inline constexpr const char* sagGroup = RAMURE_NOOP("Sag");
inline constexpr const char* gnarlGroup = RAMURE_NOOP("Gnarl");
inline constexpr const char* deadWoodGroup = RAMURE_NOOP("Dead wood");
inline constexpr const char* pipeGroup = RAMURE_NOOP("Pipe rule");
inline constexpr const char* flareGroup = RAMURE_NOOP("Flare");
inline constexpr const char* growOnGroup = RAMURE_NOOP("Grow on");

/// No node has these: a bit beyond those of NodeKind.
inline constexpr KindBits stepOnly = 1u << 14;

template <StandWay... ways>
inline constexpr Condition* stands = [](const NodeParams& p) { return ((p.step.stand.way == ways) || ...); };

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
inline constexpr std::array stepRows{
    row<&NodeParams::step, &StepParams::where>(
        {"step.where", stepGroup, RAMURE_NOOP("Where"),
         RAMURE_NOOP("A condition for the axes on which the step acts, as \"order = 1 and share > 0.4\". Names: order (0 is the "
                     "trunk), share and s (where the axis starts on its parent), length, radius, azimuth, angle, height, forks. "
                     "Empty: every axis. \"axes\" and addresses: those alone.")},
        ParamUnit::None, {}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::seed>(
        {"step.seed", stepGroup, RAMURE_NOOP("Seed of the step"),
         RAMURE_NOOP("Another draw of this step alone: the rest of the tree stays.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Skeleton, paramSeed, stepOnly),

    row<&NodeParams::step, &StepParams::stand, &StandParams::way>(
        {"stand.way", standGroup, RAMURE_NOOP("Grows"),
         RAMURE_NOOP("Where it grows. Limbs along axes: each axis takes the place of its trunk. Whole, along axes: as twigs on "
                     "a limb. Whole, at tips: axes go on with it. On the ground: beside the tree.")},
        ParamUnit::None, {}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::stand, &StandParams::count>(
        {"stand.count", standGroup, RAMURE_NOOP("Number"),
         RAMURE_NOOP("How many grow on each axis.")},
        ParamUnit::Count, {1, 1000, 1, 40, 1, 0}, Stage::Skeleton, paramNone, stepOnly, stands<StandWay::Along>),
    row<&NodeParams::step, &StepParams::stand, &StandParams::from>(
        {"stand.from", standGroup, RAMURE_NOOP("From"),
         RAMURE_NOOP("Lowest place on the axis at which one may grow, as a share of the axis's length.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly, stands<StandWay::Limbs, StandWay::Along>),
    row<&NodeParams::step, &StepParams::stand, &StandParams::to>(
        {"stand.to", standGroup, RAMURE_NOOP("To"),
         RAMURE_NOOP("Highest place on the axis at which one may grow, as a share of the axis's length.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly, stands<StandWay::Limbs, StandWay::Along>),
    row<&NodeParams::step, &StepParams::stand, &StandParams::angle>(
        {"stand.angle", standGroup, RAMURE_NOOP("Angle"),
         RAMURE_NOOP("Angle between a new shoot and the axis that carries it.")},
        ParamUnit::Radian, {0, pi, 0, pi / 2, pi / 180, 4}, Stage::Skeleton, paramNone, stepOnly, stands<StandWay::Along, StandWay::Tips>),
    row<&NodeParams::step, &StepParams::stand, &StandParams::size>(
        {"stand.size", standGroup, RAMURE_NOOP("Size"),
         RAMURE_NOOP("Limbs along axes: 1 is as long as they are for a trunk of that length. Whole, on axes: its length as a "
                     "share of the axis'. On the ground: 1 is as its parameters say.")},
        ParamUnit::Factor, {0.001, 100, 0.05, 2, 0.05, 3}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::stand, &StandParams::variants>(
        {"stand.variants", standGroup, RAMURE_NOOP("Variants"),
         RAMURE_NOOP("How many different ones are grown; the axes take them in turn. More take longer.")},
        ParamUnit::Count, {1, 64, 1, 16, 1, 0}, Stage::Skeleton, paramAdvanced, stepOnly, stands<StandWay::Limbs, StandWay::Along, StandWay::Tips>),
    row<&NodeParams::step, &StepParams::stand, &StandParams::offset>(
        {"stand.offset", standGroup, RAMURE_NOOP("Place"),
         RAMURE_NOOP("Position relative to the foot of the tree.")},
        ParamUnit::Metre, {-1e4, 1e4, -5, 5, 0.1, 3}, Stage::Skeleton, paramNone, stepOnly, stands<StandWay::Ground>),

    row<&NodeParams::step, &StepParams::sag, &SagParams::amount>(
        {"sag.amount", sagGroup, RAMURE_NOOP("Amount"),
         RAMURE_NOOP("How many times as far as this wood gives way under its weight. Trees that have sagged while they were "
                     "young and thin hang 5 to 20 times as far.")},
        ParamUnit::Factor, {-100, 100, 0, 20, 0.1, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::sag, &SagParams::stiffness>(
        {"sag.stiffness", sagGroup, RAMURE_NOOP("Stiffness"),
         RAMURE_NOOP("Young's modulus of the green wood, in gigapascals: willow about 5, pine 8, oak 9, ash 10.")},
        ParamUnit::None, {0.01, 1000, 1, 15, 0.1, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::sag, &SagParams::load>(
        {"sag.load", sagGroup, RAMURE_NOOP("Load of a metre"),
         RAMURE_NOOP("Weight of leaves and fruit on one metre of twig thinner than a centimetre.")},
        ParamUnit::Kilogram, {0, 100, 0, 2, 0.01, 3}, Stage::Skeleton, paramNone, stepOnly),

    row<&NodeParams::step, &StepParams::gnarl, &GnarlParams::angle>(
        {"gnarl.angle", gnarlGroup, RAMURE_NOOP("Angle"),
         RAMURE_NOOP("How far an axis wanders from the direction that it had.")},
        ParamUnit::Radian, {0, pi, 0, pi / 3, pi / 180, 4}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::gnarl, &GnarlParams::length>(
        {"gnarl.length", gnarlGroup, RAMURE_NOOP("Spacing"),
         RAMURE_NOOP("How long an axis runs from one turn to the next, in diameters of its foot.")},
        ParamUnit::Factor, {0.5, 1000, 2, 30, 0.5, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::gnarl, &GnarlParams::byOrder>(
        {"gnarl.byOrder", gnarlGroup, RAMURE_NOOP("By order"),
         RAMURE_NOOP("How much more each order wanders than the one it grows on; 1: all alike.")},
        ParamUnit::Factor, {0, 10, 0, 2, 0.05, 2}, Stage::Skeleton, paramNone, stepOnly),

    row<&NodeParams::step, &StepParams::deadWood, &DeadWoodParams::share>(
        {"deadWood.share", deadWoodGroup, RAMURE_NOOP("Dead limbs"),
         RAMURE_NOOP("How many of the axes that the step acts on have died, with all that grows on them.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::deadWood, &DeadWoodParams::low>(
        {"deadWood.low", deadWoodGroup, RAMURE_NOOP("In the shade"),
         RAMURE_NOOP("How far those low on their parent die before those near its tip; 0: all alike.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::deadWood, &DeadWoodParams::twigs>(
        {"deadWood.twigs", deadWoodGroup, RAMURE_NOOP("Lost twigs"),
         RAMURE_NOOP("How many of its twigs a dead limb has lost.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::deadWood, &DeadWoodParams::length>(
        {"deadWood.length", deadWoodGroup, RAMURE_NOOP("Broken at"),
         RAMURE_NOOP("Average place at which dead limbs have broken off, as a share of their length. At 100 % none is broken.")},
        ParamUnit::Share, {0.05, 1, 0.1, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly),

    row<&NodeParams::step, &StepParams::pipe, &PipeParams::exponent>(
        {"pipe.exponent", pipeGroup, RAMURE_NOOP("Exponent"),
         RAMURE_NOOP("Exponent with which the radii of a branch's twigs add up to its own: 2 keeps the area of the wood (Leonardo), 3 makes limbs thin more slowly. Most trees lie between 2 and 2.6.")},
        ParamUnit::None, {1.2, 5, 1.8, 3, 0.05, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::pipe, &PipeParams::blend>(
        {"pipe.blend", pipeGroup, RAMURE_NOOP("Blend"),
         RAMURE_NOOP("Blends from the old radii (0) to those of the rule (1).")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::pipe, &PipeParams::keepsFoot>(
        {"pipe.keepsFoot", pipeGroup, RAMURE_NOOP("Keep the foot"),
         RAMURE_NOOP("Each trunk keeps the radius of its foot, and the radii of the twigs follow. If off, twigs begin with the radius below.")},
        ParamUnit::None, {}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::pipe, &PipeParams::tip>(
        {"pipe.tip", pipeGroup, RAMURE_NOOP("Radius of tips"),
         RAMURE_NOOP("The radius with which every twig ends.")},
        ParamUnit::Metre, {1e-5, 10, 0.0005, 0.02, 0.0005, 4}, Stage::Skeleton, paramNone, stepOnly,
        [](const NodeParams& p) { return !p.step.pipe.keepsFoot; }),

    row<&NodeParams::step, &StepParams::flare, &FlareParams::amount>(
        {"flare.amount", flareGroup, RAMURE_NOOP("Amount"),
         RAMURE_NOOP("How much thicker the trunk is at the ground: 0.5 makes it half as thick again.")},
        ParamUnit::Factor, {0, 20, 0, 2, 0.05, 2}, Stage::Skeleton, paramNone, stepOnly),
    row<&NodeParams::step, &StepParams::flare, &FlareParams::height>(
        {"flare.height", flareGroup, RAMURE_NOOP("Height"),
         RAMURE_NOOP("How far up the swelling reaches: at this height a third of it is left.")},
        ParamUnit::Metre, {0.01, 100, 0.05, 3, 0.05, 3}, Stage::Skeleton, paramNone, stepOnly),

    row<&NodeParams::step, &StepParams::growOn, &GrowOnParams::years>(
        {"growOn.years", growOnGroup, RAMURE_NOOP("Years"),
         RAMURE_NOOP("How many years the tree lives on.")},
        ParamUnit::Year, {0, 500, 0, 60, 1, 1}, Stage::Skeleton, paramNone, stepOnly),
};
// clang-format on

} // namespace ramure::rows
