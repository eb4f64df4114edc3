/// \file
/// Trees under the hand, for suites of edits.
#pragma once

#include "core/math/random.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "core/recipe/edit_context.h"
#include "tests/support/suite.h"

namespace ramure::test {

/// A trunk of four steps of 1 m up, with a limb of two steps that carries a twig, one step up, and a limb of
/// one step two steps up. Addresses: axes() in the order of the tree.
inline NodeParams plainTree()
{
    NodeParams params;
    params.grammar.axiom = "F[+FF[+F]]F[^F]FF";
    params.grammar.rules.clear();
    params.grammar.iterations = 0;
    params.turtle.alpha = 1.0;
    params.turtle.decay = 0.9;
    params.turtle.theta = 0.5;
    return params;
}

inline TreeResult grownTree(const NodeParams& params, Stage last = Stage::Simplified)
{
    TreePipeline pipeline;
    auto result = pipeline.evaluate(params, last);
    if (!result)
        qFatal("%s", why(result).constData());
    return std::move(*result);
}

inline TreeEdit editOf(EditOperation operation, std::uint64_t target)
{
    TreeEdit edit;
    edit.operation = operation;
    edit.target.address = target;
    if (operation == EditOperation::Bend)
        edit.to = 0.0; // all at its start, as in a file that names no end
    return edit;
}

/// As an interface does it: prepared, with an id of its own. Errors: why it cannot be made; then nothing
/// changes.
inline Expected<std::uint64_t> make(NodeParams& params, TreeEdit edit, EditContext& context,
                                    bool inTreeSpace = true)
{
    auto ready = context.prepared(std::move(edit), inTreeSpace);
    if (!ready)
        return fail(ready.error());
    if (ready->id == 0)
        ready->id = newEditId(params.edits, *ready);
    if (auto made = context.apply(*ready); !made)
        return fail(made.error());
    params.edits.push_back(*ready);
    return ready->id;
}
inline Expected<std::uint64_t> make(NodeParams& params, TreeEdit edit, bool inTreeSpace = true)
{
    EditContext context(*grownTree(params, Stage::Skeleton).grown, params.edits);
    return make(params, std::move(edit), context, inTreeSpace);
}

/// The plain tree under the hand, and the tree that comes of it.
struct Shaped
{
    NodeParams params = plainTree();
    std::vector<std::uint64_t> address; ///< of the axes as grown: trunk, limb, twig, upper limb

    Shaped()
    {
        for (const Axis& axis : axesOf(*grownTree(params).skeleton).axes)
            address.push_back(axis.address);
    }
    Expected<std::uint64_t> make(const TreeEdit& edit, bool inTreeSpace = true)
    {
        return ramure::test::make(params, edit, inTreeSpace);
    }
    [[nodiscard]] TreeResult tree(Stage last = Stage::Simplified) const { return grownTree(params, last); }
    [[nodiscard]] Skeleton skeleton() const { return *tree().skeleton; }
    [[nodiscard]] std::optional<Axis> axis(std::uint64_t wanted) const
    {
        for (const Axis& axis : axesOf(skeleton()).axes)
            if (axis.address == wanted)
                return axis;
        return std::nullopt;
    }
    [[nodiscard]] glm::dvec3 tip(std::uint64_t wanted) const
    {
        return EditContext(*tree().grown, params.edits).pointOn(wanted, 1.0)->position;
    }
};

inline bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}
inline bool isNear(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::length(a - b) < 1e-9;
}

/// Any edit of any axis of a tree: one that can perhaps not be made.
inline TreeEdit randomEdit(const TreeAxes& axes, const Skeleton& skeleton, Random& random)
{
    const auto axis = [&]() -> const Axis& {
        return axes.axes[random.below(static_cast<std::uint32_t>(axes.axes.size()))];
    };
    const auto vector = [&](double size) {
        return size * glm::dvec3(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0));
    };
    const Axis& target = axis();
    constexpr auto byHand =
        static_cast<std::uint32_t>(EditOperation::Place) + 1; // the rest are no hand edits
    TreeEdit edit = editOf(static_cast<EditOperation>(random.below(byHand)), target.address);
    const EditOperationInfo& info = infoOf(edit.operation);
    const SkeletonStats stats = skeletonStats(skeleton);
    const double size = glm::length(stats.max - stats.min);
    if (!(info.fields & editNeedsTarget) && random.below(2) == 0 && edit.operation != EditOperation::Draw)
        edit.target = {};
    if (info.fields & editOther)
        edit.other.address = axis().address;
    edit.at = random.unit();
    edit.from = random.range(0.0, 0.8);
    edit.to = random.range(edit.from, 1.0);
    edit.factor = random.range(0.4, 2.0);
    edit.angleRad = random.range(-4.0, 4.0);
    edit.azimuthRad = random.range(-3.0, 3.0);
    edit.radius = random.range(0.05, 0.5) * size;
    edit.strength = random.range(-1.0, 1.0);
    edit.rotation = vector(1.5);
    edit.direction = vector(1.0) + glm::dvec3(0.0, 1e-3, 0.0);
    const Index at = random.below(skeleton.size());
    edit.centre = skeleton.p1[at];
    edit.offset = vector(0.1 * size) * glm::dvec3(1.0, 0.0, 1.0);
    edit.below = random.below(2) == 0;
    edit.shown = random.below(2) == 0;
    edit.organ = static_cast<EditOrgan>(random.below(3));
    edit.falls = random.below(3) == 0;
    edit.seconds = random.range(0.0, 1.0);
    const glm::dvec3& c = skeleton.p1[random.below(skeleton.size())];
    edit.shape.kind = static_cast<EditShapeKind>(random.below(4));
    const double r = random.range(0.2, 0.8) * size;
    edit.shape.numbers = {c.x, c.y, c.z, r, 0.0, 0.0};
    if (edit.shape.kind == EditShapeKind::Box)
        edit.shape.numbers = {c.x - r, c.y - r, c.z - r, c.x + r, c.y + 0.5 * r, c.z + r};
    if (edit.shape.kind == EditShapeKind::Cone)
        edit.shape.numbers = {c.x, stats.min.y, c.z, r, size, 0.0};
    if (edit.shape.kind == EditShapeKind::Profile)
        edit.shape.points = {{0.5 * r, -r, 0.0}, {r, 0.0, 0.0}, {0.7 * r, 0.5 * r, 0.0}};
    glm::dvec3 point = skeleton.p1[at];
    for (std::uint32_t i = 1 + random.below(6); i-- > 0;) {
        point += vector(0.1 * size);
        edit.points.push_back({point, random.below(2) == 0 ? 0.0 : random.range(0.1, 1.0) * target.radius});
    }
    return edit;
}

} // namespace ramure::test
