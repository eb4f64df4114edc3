/// \file
/// Values of the steps of a recipe that are no hand edits (core/params/tree_edit.h): modifiers, and how a
/// source stands on what has grown before it. Member initialisers are the defaults.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace ramure {

/// Where a source lets things grow.
enum class StandWay : std::uint8_t {
    Ground, ///< beside the tree, on the ground
    Limbs,  ///< its limbs grow on each axis, which takes the place of its trunk
    Along,  ///< the whole of it grows several times along each axis
    Tips,   ///< the whole of it goes on from the tip of each axis
};

struct StandParams
{
    StandWay way = StandWay::Limbs;
    std::int64_t count = 6;      ///< Along: on each axis
    double from = 0.1, to = 1.0; ///< shares of the axis
    double angle = 0.87;         ///< rad from the axis; Along and Tips
    double size = 1.0; ///< Limbs: of what fits the axis; Along and Tips: shares of its length; Ground: times
    std::int64_t variants = 8;        ///< different ones; the axes take them in turn
    glm::dvec3 offset{0.6, 0.0, 0.0}; ///< m; Ground
    bool operator==(const StandParams&) const = default;
};

/// Limbs bend by their weight.
struct SagParams
{
    double amount = 1.0;
    double stiffness = 8.0; ///< GPa
    double load = 0.15;     ///< kg of leaves and fruit on a metre of twig
    bool operator==(const SagParams&) const = default;
};

/// Axes wander from side to side.
struct GnarlParams
{
    double angle = 0.3;  ///< rad
    double length = 8.0; ///< diameters from one turn to the next
    double byOrder = 1.0;
    bool operator==(const GnarlParams&) const = default;
};

/// Some limbs have died.
struct DeadWoodParams
{
    double share = 0.15;
    double low = 0.7;    ///< how much likelier low on the parent than at its tip
    double twigs = 0.85; ///< lost
    double length = 0.7; ///< kept, on average
    bool operator==(const DeadWoodParams&) const = default;
};

/// The pipe rule: the wood below a fork carries what the limbs above it need.
struct PipeParams
{
    double exponent = 2.3;
    double blend = 1.0;
    bool keepsFoot = true;
    double tip = 0.001; ///< m; where the foot does not keep its radius
    bool operator==(const PipeParams&) const = default;
};

/// The foot swells.
struct FlareParams
{
    double amount = 0.6;
    double height = 0.5; ///< m
    bool operator==(const FlareParams&) const = default;
};

/// The tree grows on.
struct GrowOnParams
{
    double years = 10.0;
    bool operator==(const GrowOnParams&) const = default;
};

struct StepParams
{
    std::string where{}; ///< core/recipe/axis_filter.h; empty: every axis
    std::int64_t seed = 0;
    StandParams stand;
    SagParams sag;
    GnarlParams gnarl;
    DeadWoodParams deadWood;
    PipeParams pipe;
    FlareParams flare;
    GrowOnParams growOn;
    bool operator==(const StepParams&) const = default;
};

} // namespace ramure
