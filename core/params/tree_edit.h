/// \file
/// What a hand did to a tree: a list beside the parameters, applied in its order to what the generator grew
/// (core/recipe/). Plain values; which of them an operation has stands in tree_edit_table.h.
#pragma once

#include "core/base/shared_value.h"
#include "core/params/branch_place.h"
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace ramure {

enum class EditOperation : std::uint8_t {
    Cut,       ///< what lies above `at` goes, or falls; a closed end stays
    Remove,    ///< the limb goes, with all on it
    Keep,      ///< all goes but the limb, what is on it and the way down to the ground
    Bend,      ///< what lies above `from` is turned, bit by bit up to `to` where that is above
    Curl,      ///< turned bit by bit between `from` and `to`
    Twist,     ///< what grows on the axis is turned about it, by `angleRad` at the tip
    Length,    ///< times `factor`
    Thickness, ///< radii times `factor`
    Taper,     ///< radii times `factor` at the tip, unchanged at the foot
    Draw,      ///< a new axis along `points`, at `at` of the target
    Extend,    ///< the tip goes on along `points`
    Redraw,    ///< the axis gets another way, what grows on it follows
    Graft,     ///< a copy of a limb, at `at` of the target
    Move,      ///< the limb is put at `at` of its parent, or of another axis
    Prune,     ///< what stands out of a shape is cut
    Attract,   ///< branches within a sphere turn towards its centre, or away from it
    Comb,      ///< branches within a sphere turn into a direction
    Leaves,    ///< those of a limb, or without a target within a sphere, are shown or hidden
    Root,      ///< the foot stands elsewhere, and flares
    Place,     ///< one leaf, fruit or flower, at `at` of the target, on the side of `azimuth`
    // Modifiers and sources: no hand made them, and their values are rows of the parameter table.
    Sag,
    Gnarl,
    DeadWood,
    Pipe, ///< radii by the pipe rule
    Flare,
    GrowOn, ///< the tree lives some years longer, whatever made it
    Grammar,
    WeberPenn,
    Colonisation,
    Growth,
    Frozen,  ///< the tree as it was behind the steps before, which do not run
    Unknown, ///< of a file that a newer version has written: kept, and does nothing
};
inline constexpr std::size_t editOperationCount = static_cast<std::size_t>(EditOperation::Unknown) + 1;

/// What Place puts there. The tree says what its fruit are: a flower is one where it blooms.
enum class EditOrgan : std::uint8_t { Leaf, Fruit, Flower };

/// An axis. Of those that grew, its place in the tree as grown, before any edit, so that the edit finds it in
/// a changed tree; of one that an edit made, its name alone.
struct EditTarget
{
    std::uint64_t address = 0; ///< Axis::address; 0: none
    std::uint64_t maker = 0;   ///< TreeEdit::id of the graft that made the axis: the place is its original's
    BranchPlace place{};       ///< empty: known by its address alone
    bool operator==(const EditTarget&) const = default;
};

/// Of a stroke, of an axis that is drawn.
struct StrokePoint
{
    glm::dvec3 position{0.0}; ///< m
    double radius = 0.0;      ///< m; 0: as what it continues
    bool operator==(const StrokePoint&) const = default;
};

enum class EditShapeKind : std::uint8_t { Sphere, Box, Cone, Profile, Mesh };

/// In tree space, metres.
struct EditShape
{
    EditShapeKind kind = EditShapeKind::Sphere;
    /// Sphere: centre, radius. Box: least and greatest corner. Cone, upright: centre of the foot, radius
    /// there, height. Profile: its foot. The rest is 0.
    std::array<double, 6> numbers{0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
    /// Profile: radius and height above the foot, upwards, and 0; it turns about the vertical. Mesh: corners.
    std::vector<glm::dvec3> points{};
    std::vector<std::array<std::uint32_t, 3>> triangles{}; ///< of a closed mesh
    bool operator==(const EditShape&) const = default;
};

/// A leaf, fruit or flower on it, as Organ has it; vectors in the frame of the limb.
struct LimbOrgan
{
    EditOrgan organ = EditOrgan::Leaf;
    double share = 1.0;
    double size = -1.0;
    glm::dvec3 offset{0.0}, heading{0.0}, up{0.0};
    bool operator==(const LimbOrgan&) const = default;
};

/// One piece of a limb that comes from another tree.
struct LimbPiece
{
    std::int64_t parent = -1;        ///< among the pieces before it; the first has none
    glm::dvec3 p0{0.0}, p1{0.0};     ///< m, from the foot, in the parent's frame there
    double a0 = 0.0, a1 = 0.0;       ///< m
    std::int64_t axis = 0;           ///< counted from 0 within the limb; pieces of one axis follow each other
    bool sawn = false, bare = false; ///< its end was cut; no leaves grow on it by themselves
    std::vector<LimbOrgan> organs{};
    bool operator==(const LimbPiece&) const = default;
};

/// A tree that a step has in its own right.
struct FrozenTree
{
    std::string bytes; ///< core/skeleton/packed_skeleton.h
    bool operator==(const FrozenTree&) const = default;
};
std::uint64_t hashOf(const FrozenTree& tree);

struct NodeParams;

/// Values of a step whose kind has rows in the parameter table: shared, and never changed in place.
class StepValues
{
public:
    StepValues() = default; ///< the defaults
    explicit StepValues(NodeParams params);

    const NodeParams& operator*() const;
    const NodeParams* operator->() const { return &**this; }
    bool operator==(const StepValues& other) const;

private:
    std::shared_ptr<const NodeParams> m_params;
};

/// One step of a tree's recipe behind the source that it begins with: what a hand did, a modifier, or another
/// source. Vectors are in the frame that the parent carries to the fork, x and y along its normal and
/// binormal, z along its tangent (Axis::azimuth is measured in the same), so that they keep their meaning
/// when the tree changes; those of Prune, Attract, Comb and Root in tree space. Shares are of the axis'
/// length as the edits before left it.
struct TreeEdit
{
    std::uint64_t id = 0; ///< unlike those of the tree's other edits; the address of an axis that it draws
    std::string name{};   ///< empty: that of the operation
    EditOperation operation = EditOperation::Remove;
    bool enabled = true;
    EditTarget target{}; ///< Draw: the parent, none for the ground; Graft: the parent; Prune, Attract and
                         ///< Comb: the limb, or the whole tree
    EditTarget other{}; ///< Graft: the original, none if it has a limb; Move: the parent, or none for its own
    double at = 0.5;
    double from = 0.0, to = 1.0;
    double factor = 1.0; ///< Graft: of its size; Root: of the radius at the foot; Place: of the usual size
    double angleRad = 0.0;
    double azimuthRad = 0.0;
    double radius = 1.0;      ///< m, of a brush
    double strength = 0.5;    ///< 0..1, Attract also down to -1
    glm::dvec3 rotation{0.0}; ///< axis times angle, rad
    glm::dvec3 direction{0.0, 1.0, 0.0};
    glm::dvec3 centre{0.0}; ///< m, of a brush
    glm::dvec3 offset{0.0}; ///< m
    bool below = false;     ///< also what grows on the axis; Draw: as on a limb beside it
    bool shown = true;
    bool falls = false;   ///< Cut: what is cut off stays in its place, and falls when the physics plays
    double seconds = 0.0; ///< Cut: when it comes off
    /// Cut, Remove and Prune: the age of a growing tree, in years, at which it is done: younger trees are
    /// without it, and older ones have answered (growth_history.h). 0: it is done to the tree as it has
    /// grown.
    double year = 0.0;
    EditOrgan organ = EditOrgan::Leaf;
    EditShape shape{};
    /// Draw and Redraw: from the fork; Extend: from the tip, in its frame. Comb and Leaves: where the brush
    /// goes on from its centre, each with its radius (0: that of the first).
    std::vector<StrokePoint> points{};
    std::vector<LimbPiece> limb{};
    StepValues values{};
    SharedValue<FrozenTree> frozen{};
    /// Of the algorithm: a saved tree grows as it did when a later version of the program grows others
    /// better.
    std::int64_t version = 1;
    std::string kept{}; ///< Unknown: what the file says of it, as JSON
    bool operator==(const TreeEdit&) const = default;
};

} // namespace ramure
