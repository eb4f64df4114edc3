/// \file
/// The steps of a tree's recipe: a list beside the parameters, applied in its order to the grown tree
/// (core/recipe/). Plain values; tree_edit_table.h says which of them an operation has.
#pragma once

#include "core/base/shared_value.h"
#include "core/params/branch_place.h"
#include "core/params/step_kinds.h"
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace ramure {

/// What Place puts on a branch. The tree's parameters say what its fruit are; in bloom a fruit is a flower.
enum class EditOrgan : std::uint8_t { Leaf, Fruit, Flower };

/// The axis that a step acts on. A grown axis is described by its place in the tree as grown, before any
/// edit, so that the edit finds it in a changed tree. An axis that an edit made is known by its address
/// alone.
struct EditTarget
{
    std::uint64_t address = 0; ///< Axis::address; 0: none
    std::uint64_t maker = 0;   ///< TreeEdit::id of the graft that made the axis: the place is its original's
    BranchPlace place{};       ///< empty: known by its address alone
    bool operator==(const EditTarget&) const = default;
};

/// One point of a stroke or of a drawn axis.
struct StrokePoint
{
    glm::dvec3 position{0.0}; ///< m
    double radius = 0.0;      ///< m; 0: like the axis that it continues
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
    std::vector<std::array<std::uint32_t, 3>> triangles{}; ///< triangles of a closed mesh
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

/// One step of a tree's recipe after its first source: a hand edit, a modifier, or another source. Vectors
/// are in the frame that the parent carries to the fork, x and y along its normal and binormal, z along its
/// tangent (Axis::azimuth is measured in the same), so that they keep their meaning when the tree changes.
/// Vectors of Prune, Attract, Comb and Root are in tree space. Shares refer to the axis's length after the
/// steps before.
struct TreeEdit
{
    std::uint64_t id = 0; ///< unique in the tree; for an edit that draws an axis, the address of that axis
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
    bool below = false; ///< also acts on the limbs of the axis; Draw: the axis grows like a limb beside it
    bool shown = true;
    bool falls = false;   ///< Cut: the cut part stays in its place, and falls when the physics plays
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
    /// Version of the algorithm. A saved tree keeps its version and grows as before, even if a later version
    /// of the program grows other trees better.
    std::int64_t version = 1;
    std::string kept{}; ///< Unknown: the step's JSON in the file
    bool operator==(const TreeEdit&) const = default;
};

} // namespace ramure
