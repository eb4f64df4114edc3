/// \file
/// All parameters of a scene node as plain structs. One struct serves all kinds of nodes; the rows of the
/// parameter table say which kinds have a parameter. The member initialisers are the defaults, stated nowhere
/// else. Meaning, unit and range of a parameter stand in its row (growth_rows.h, dress_rows.h, node_rows.h,
/// weber_penn_rows.h).
#pragma once

#include "core/params/arm_params.h"
#include "core/params/bark_params.h"
#include "core/params/camera_params.h"
#include "core/params/colonisation_params.h"
#include "core/params/fruit_params.h"
#include "core/params/ground_plane.h"
#include "core/params/growth_params.h"
#include "core/params/leaf_params.h"
#include "core/params/physics_params.h"
#include "core/params/picture_params.h"
#include "core/params/primitive_params.h"
#include "core/params/scatter_params.h"
#include "core/params/season_params.h"
#include "core/params/skin_params.h"
#include "core/params/step_params.h"
#include "core/params/tree_edit.h"
#include "core/params/weber_penn_params.h"
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ramure {

/// The language of a grammar: letters alone, or modules with numbers
/// (core/generators/parametric/parametric_grammar.h).
enum class GrammarDialect : std::uint8_t { Classic, Parametric };

/// The source that a recipe begins with. Draw: none; steps of the recipe draw all there is.
struct GeneratorParams
{
    EditOperation kind = EditOperation::Grammar;
    bool operator==(const GeneratorParams&) const = default;
};

struct GrammarParams
{
    std::string axiom = "BBBBBA";
    /// One rule a line; the syntax is documented in core/generators/grammar/grammar.h. The default is the
    /// SmallTree.
    std::string rules = "A -> [++BB[--C][++C][__C][^^C]A]/////+BBB[--C][++C][__C][^^C]A\n"
                        "B -> 0.5: B | 0.5: \\\\B | default: \\B\n"
                        "C ->\n";
    std::int64_t iterations = 8;
    bool stochastic = false;
    std::int64_t seed = 1;
    GrammarDialect dialect = GrammarDialect::Classic;
    std::string constants{}; ///< parametric dialect: one "name = expression" per line
    bool operator==(const GrammarParams&) const = default;
};

struct TurtleParams
{
    double theta = 0.3142; ///< rad
    double alpha = 0.2;    ///< m
    double decay = 0.88;
    glm::dvec3 tropism{0.0, -1.0, 0.0}; ///< parametric dialect: the direction that branches bend towards
    double elasticity = 0.0;            ///< rad that a branch across a tropism of length 1 bends by
    bool operator==(const TurtleParams&) const = default;
};

/// Largest random deviation of turns, lengths and radii from the turtle's values, as a share of those.
struct VariationParams
{
    double angle = 0.05;
    double length = 0.05;
    double radius = 0.05;
    bool operator==(const VariationParams&) const = default;
};

struct SimplifyParams
{
    bool enabled = true;
    double rotationThreshold = 1e-4; ///< rad
    bool operator==(const SimplifyParams&) const = default;
};

struct SectionParams
{
    std::int64_t lengthDivisions = 4;
    std::int64_t radialDivisions = 8;
    bool operator==(const SectionParams&) const = default;
};

struct MeshParams
{
    std::int64_t targetTriangles = 0; ///< 0: as the sections say
    double forkReach = 0.9;           ///< relative to the radius of the thinner tube
    double forkSoftness = 0.7;
    bool clampOvershoot = false;
    double nearTwinRatio = 0.25;  ///< relative to the sum of the radii
    double leastRadius = 0.25e-3; ///< m
    double forkLength = 1.0;      ///< diameters, within which branches above a fork come to their own radius
    double collar = 0.0;          ///< of a side limb's radius: how much wider it leaves the stem
    double fairing = 0.0;         ///< of forks of thick wood: 0 as they are built, 1 smooth
    double splinters = 1.0;       ///< diameters that stand out of the broken ends of dead wood; 0: flat
    double ridge = 0.0;           ///< of the stem's diameter: bark that stands up where a limb leaves it
    std::int64_t roots = 0;       ///< that leave the foot of a trunk; 0: its tube ends flat
    double rootLength = 2.0;      ///< diameters of the trunk
    double rootHeight = 1.0;      ///< the same: where roots leave the trunk
    bool operator==(const MeshParams&) const = default;
};

struct FoliageParams
{
    double leavesCutoff = 0.1;
    std::int64_t leavesDensity = 10;
    double applesProbability = 0.05;
    std::int64_t seed = 1;
    bool operator==(const FoliageParams&) const = default;
};

/// Texture of the branches. It is used if texture coordinates are asked for; no geometry depends on it.
struct TextureParams
{
    double tileSize = 0.0; ///< m, on the thickest wood; 0: four go around it
    bool operator==(const TextureParams&) const = default;
};

/// The placement of a node in its parent: T * R * S (SPEC B2, the static transform handed on to the
/// children).
struct PlacementParams
{
    glm::dvec3 translation{0.0}; ///< m
    glm::dvec3 rotation{0.0};    ///< rad, about X, then Y, then Z of the parent: R = Rz * Ry * Rx
    glm::dvec3 scale{1.0};
    bool operator==(const PlacementParams&) const = default;
};

struct NodeParams
{
    GeneratorParams generator;
    GrammarParams grammar;
    TurtleParams turtle;
    VariationParams variation;
    WeberPennParams weberPenn;
    ColonisationParams colonisation;
    GrowthParams growth;
    SimplifyParams simplify;
    SectionParams sections;
    MeshParams mesh;
    FoliageParams foliage;
    LeafParams leaf;
    FruitParams fruit;
    SeasonParams season;
    BarkParams bark;
    TextureParams texture;
    PictureParams barkPictures, leafPictures, fruitPictures; ///< pictures of a tree
    PlacementParams tree;
    /// Places the node's own geometry alone and is not handed on to the children (SPEC B2).
    PlacementParams local;
    PrimitiveParams primitive;
    SurfaceParams surface;
    GrowthRole growthRole = GrowthRole::None; ///< for primitives and imported meshes
    PictureParams surfacePictures;            ///< for primitives and imported meshes
    PhysicsParams physics;
    SkinParams skin;
    ArmParams arm;
    ArmSolverParams ik;
    ArmSkinParams armSkin;
    TerrainParams terrain;
    CameraParams camera;
    ScatterParams scatter;
    StepParams step;                                   ///< only in a step of a recipe (StepValues)
    std::vector<ArmJoint> joints = defaultArmJoints(); ///< joints of an arm, from the foot on
    std::vector<TreeEdit> edits;                       ///< steps of a tree, in the order in which they act
    StandingGround ground; ///< no parameter: filled in from the scene, where the tree stands on something
    bool operator==(const NodeParams&) const = default;
};

/// Returns the seed of the tree's generator; 0 if nothing in it is random.
inline std::uint64_t treeSeed(const NodeParams& params)
{
    const bool hasChance = params.grammar.stochastic || params.generator.kind != EditOperation::Grammar;
    return hasChance ? static_cast<std::uint64_t>(params.grammar.seed) : 0;
}

} // namespace ramure
