#include "core/params/tree_edit_table.h"

#include "core/math/angle.h"
#include "core/math/stage_hash.h"
#include "core/params/node_params.h"
#include <algorithm>
#include <cmath>
#include <set>

namespace ramure {
namespace {

constexpr double farAway = 1e5; ///< m

constexpr EditNumber numbers[] = {
    {"at", &TreeEdit::at, editAt, 0.0, 1.0, false},
    {"from", &TreeEdit::from, editFrom, 0.0, 1.0, false},
    {"to", &TreeEdit::to, editTo, 0.0, 1.0, false},
    {"factor", &TreeEdit::factor, editFactor, 0.01, 100.0, false},
    {"angle", &TreeEdit::angleRad, editAngle, -100.0 * pi, 100.0 * pi, true},
    {"azimuth", &TreeEdit::azimuthRad, editAzimuth, -100.0 * pi, 100.0 * pi, true},
    {"radius", &TreeEdit::radius, editRadius, 1e-6, farAway, false},
    {"strength", &TreeEdit::strength, editStrength, -1.0, 1.0, false},
    {"seconds", &TreeEdit::seconds, editFalls, 0.0, 86400.0, false},
    {"year", &TreeEdit::year, editYear, 0.0, 2000.0, false},
};

constexpr EditVector vectors[] = {
    {"rotation", &TreeEdit::rotation, editRotation},
    {"direction", &TreeEdit::direction, editDirection},
    {"centre", &TreeEdit::centre, editCentre},
    {"offset", &TreeEdit::offset, editOffset},
};

constexpr EditFlag flags[] = {
    {"below", &TreeEdit::below, editBelow},
    {"shown", &TreeEdit::shown, editShown},
    {"falls", &TreeEdit::falls, editFalls},
};

constexpr EditShapeInfo shapes[] = {
    {EditShapeKind::Sphere, "sphere", 4}, {EditShapeKind::Box, "box", 6},
    {EditShapeKind::Cone, "cone", 5},     {EditShapeKind::Profile, "profile", 3},
    {EditShapeKind::Mesh, "mesh", 0},
};

constexpr EditOrganInfo organs[] = {
    {EditOrgan::Leaf, "leaf", RAMURE_NOOP("Leaf")},
    {EditOrgan::Fruit, "fruit", RAMURE_NOOP("Fruit")},
    {EditOrgan::Flower, "flower", RAMURE_NOOP("Flower")},
};

tl::unexpected<Error> refuse(const char* path, const char* why)
{
    auto error = fail(ErrorCode::Invalid, why);
    error.value().path = path;
    return error;
}

bool isNear(const glm::dvec3& v)
{
    return std::abs(v.x) <= farAway && std::abs(v.y) <= farAway && std::abs(v.z) <= farAway;
}

bool isRadius(double radius)
{
    return radius >= 0.0 && radius <= farAway;
}

Expected<void> checkPoints(const TreeEdit& edit)
{
    if (edit.points.empty() || edit.points.size() > mostEditPoints)
        return refuse("points", RAMURE_NOOP("a stroke needs between one and 100000 points"));
    double longest = 0.0;
    for (const StrokePoint& point : edit.points) {
        if (!isNear(point.position) || !isRadius(point.radius))
            return refuse("points", RAMURE_NOOP("points need three finite coordinates and a radius that is "
                                                "not negative"));
        longest = std::max(
            {longest, std::abs(point.position.x), std::abs(point.position.y), std::abs(point.position.z)});
    }
    if (longest < 1e-6)
        return refuse("points", RAMURE_NOOP("the stroke goes nowhere"));
    return {};
}

bool isProfile(const std::vector<glm::dvec3>& points)
{
    const bool rises = std::ranges::adjacent_find(points, [](const glm::dvec3& a, const glm::dvec3& b) {
                           return !(a.y < b.y);
                       }) == points.end();
    return points.size() >= 2 && points.size() <= mostEditPoints && rises &&
           std::ranges::all_of(points, [](const glm::dvec3& p) { return isNear(p) && p.x >= 0.0; }) &&
           std::ranges::any_of(points, [](const glm::dvec3& p) { return p.x > 0.0; });
}

bool isMesh(const EditShape& shape)
{
    const std::size_t corners = shape.points.size();
    return shape.triangles.size() >= 4 && shape.triangles.size() <= mostShapeTriangles &&
           std::ranges::all_of(shape.points, isNear) &&
           std::ranges::all_of(shape.triangles, [corners](const std::array<std::uint32_t, 3>& t) {
               return t[0] < corners && t[1] < corners && t[2] < corners;
           });
}

Expected<void> checkShape(const EditShape& shape)
{
    const auto& n = shape.numbers;
    if (!std::ranges::all_of(n, [](double number) { return std::abs(number) <= farAway; }))
        return refuse("shape", RAMURE_NOOP("must be a finite number"));
    if (shape.kind == EditShapeKind::Profile && !isProfile(shape.points))
        return refuse("shape", RAMURE_NOOP("a profile needs two heights or more, upwards, and radii"));
    if (shape.kind == EditShapeKind::Mesh && !isMesh(shape))
        return refuse("shape", RAMURE_NOOP("a mesh needs four triangles or more between its points"));
    const bool hasExtent = shape.kind == EditShapeKind::Sphere ? n[3] > 0.0
                           : shape.kind == EditShapeKind::Box  ? n[3] > n[0] && n[4] > n[1] && n[5] > n[2]
                           : shape.kind == EditShapeKind::Cone ? n[3] > 0.0 && n[4] > 0.0
                                                               : true;
    return hasExtent ? Expected<void>() : refuse("shape", RAMURE_NOOP("the shape has no extent"));
}

bool isOrgan(const LimbOrgan& organ)
{
    return organ.share >= 0.0 && organ.share <= 1.0 && std::abs(organ.size) <= farAway &&
           isNear(organ.offset) && isNear(organ.heading) && isNear(organ.up);
}

Expected<void> checkLimb(const TreeEdit& edit)
{
    const std::vector<LimbPiece>& limb = edit.limb;
    if (limb.size() > mostEditPoints)
        return refuse("limb", RAMURE_NOOP("a limb has at most 100000 pieces"));
    std::int64_t axes = 0;
    for (std::size_t i = 0; i < limb.size(); ++i) {
        const LimbPiece& piece = limb[i];
        const bool hasParent = piece.parent >= 0 && piece.parent < static_cast<std::int64_t>(i);
        if (hasParent == (i == 0))
            return refuse("limb", RAMURE_NOOP("the pieces of a limb must follow their parents"));
        // An axis starts with a number of its own and goes on from the piece before.
        const bool starts = piece.axis == axes;
        const bool continues =
            i > 0 && limb[i - 1].axis == piece.axis && piece.parent == static_cast<std::int64_t>(i) - 1;
        if (!starts && !continues)
            return refuse("limb", RAMURE_NOOP("the pieces of an axis must follow each other"));
        axes += starts ? 1 : 0;
        const bool isFinite = isNear(piece.p0) && isNear(piece.p1) && isRadius(piece.a0) &&
                              isRadius(piece.a1) && std::ranges::all_of(piece.organs, isOrgan);
        if (!isFinite)
            return refuse("limb", RAMURE_NOOP("must be a finite number"));
    }
    if (limb.empty() == (edit.other.address == 0))
        return refuse("source", RAMURE_NOOP("a graft needs a limb of this tree, or one of its own"));
    return {};
}

} // namespace

std::span<const EditOperationInfo> editOperations()
{
    return stepKinds;
}

const EditOperationInfo& infoOf(EditOperation operation)
{
    return stepKinds[static_cast<std::size_t>(operation)];
}

const EditOperationInfo* editOperationOf(std::string_view key)
{
    const auto* const found =
        std::ranges::find_if(stepKinds, [key](const EditOperationInfo& info) { return key == info.key; });
    return found == std::end(stepKinds) || found->group == StepGroup::Unknown ? nullptr : found;
}

static std::vector<const ParamDef*> rowsOf(std::string_view prefixes)
{
    std::vector<const ParamDef*> rows;
    while (!prefixes.empty()) {
        const std::string_view prefix = prefixes.substr(0, prefixes.find(' '));
        prefixes.remove_prefix(std::min(prefix.size() + 1, prefixes.size()));
        for (const ParamDef& def : allParams()) // a step has a seed of its own
            if (std::string_view(def.key).starts_with(prefix) &&
                !(def.flags & paramSeed && prefix == "grammar."))
                rows.push_back(&def);
    }
    return rows;
}

std::span<const ParamDef* const> stepParams(EditOperation operation)
{
    static const auto all = [] {
        std::array<std::vector<const ParamDef*>, editOperationCount> rows;
        for (const EditOperationInfo& info : stepKinds)
            rows[static_cast<std::size_t>(info.operation)] = rowsOf(info.rows);
        return rows;
    }();
    return all[static_cast<std::size_t>(operation)];
}

TreeEdit newStep(EditOperation operation)
{
    TreeEdit step;
    step.operation = operation;
    const EditOperationInfo& info = infoOf(operation);
    step.version = info.version;
    if (info.group != StepGroup::Modifier && info.group != StepGroup::Source)
        return step;
    NodeParams params;
    params.step.where = info.where;
    if (info.group == StepGroup::Source)
        params.generator.kind = operation;
    if (operation == EditOperation::GrowOn) {
        params.generator.kind = EditOperation::Growth;
        params.growth.shadeTolerance = 0.8; // what stands has borne its shade so far
        params.growth.shedding = 0.2;
    }
    if (operation == EditOperation::Growth) {
        params.growth.age = 8.0;
        params.step.stand = {.way = StandWay::Along, .size = 0.4, .variants = 3};
    }
    if (operation == EditOperation::Grammar) {
        params.step.stand = {.way = StandWay::Along, .size = 0.3};
        params.grammar.iterations = 4;
    }
    step.values = StepValues(std::move(params));
    return step;
}

TreeEdit newStep(EditOperation operation, const NodeParams& like)
{
    TreeEdit step = newStep(operation);
    NodeParams values = *step.values;
    for (const ParamDef* def : stepParams(operation))
        if (hasParam(NodeKind::Tree, *def))
            def->assign(values, def->get(like));
    step.values = StepValues(std::move(values));
    return step;
}

StepValues::StepValues(NodeParams params)
    : m_params(std::make_shared<const NodeParams>(std::move(params)))
{
}

const NodeParams& StepValues::operator*() const
{
    static const NodeParams usual;
    return m_params ? *m_params : usual;
}

bool StepValues::operator==(const StepValues& other) const
{
    return m_params == other.m_params || **this == *other;
}

std::uint64_t hashOf(const FrozenTree& tree)
{
    return StageHash(0).add(std::string_view(tree.bytes)).value();
}

std::size_t stepsFrozen(std::span<const TreeEdit> steps)
{
    std::size_t count = steps.size();
    while (count > 0 && !(steps[count - 1].enabled && steps[count - 1].operation == EditOperation::Frozen))
        --count;
    return count;
}

std::span<const EditNumber> editNumbers()
{
    return numbers;
}

std::span<const EditVector> editVectors()
{
    return vectors;
}

std::span<const EditFlag> editFlags()
{
    return flags;
}

std::span<const EditShapeInfo> editShapes()
{
    return shapes;
}

std::span<const EditOrganInfo> editOrgans()
{
    return organs;
}

Expected<void> checkTreeEdit(const TreeEdit& edit)
{
    if (static_cast<std::size_t>(edit.operation) >= editOperationCount)
        return refuse("op", RAMURE_NOOP("there is no such operation"));
    const EditOperationInfo& info = infoOf(edit.operation);
    if ((info.fields & editNeedsTarget) && edit.target.address == 0)
        return refuse(info.targetKey, RAMURE_NOOP("the limb is missing"));
    for (const EditNumber& number : numbers) {
        const double value = edit.*number.member;
        if ((info.fields & number.field) && !(value >= number.least && value <= number.most))
            return refuse(number.key, RAMURE_NOOP("must be a finite number within its range"));
    }
    for (const EditVector& vector : vectors)
        if ((info.fields & vector.field) && !isNear(edit.*vector.member))
            return refuse(vector.key, RAMURE_NOOP("must be three finite numbers"));
    if ((info.fields & editDirection) && edit.direction == glm::dvec3(0.0))
        return refuse("direction", RAMURE_NOOP("a direction must not be zero"));
    if ((info.fields & editOrgan) && static_cast<std::size_t>(edit.organ) >= std::size(organs))
        return refuse("organ", RAMURE_NOOP("a leaf, fruit or flower is expected here"));
    if ((info.fields & editPoints) || ((info.fields & editPath) && !edit.points.empty()))
        if (auto ok = checkPoints(edit); !ok)
            return ok;
    if (info.fields & editShape)
        if (auto ok = checkShape(edit.shape); !ok)
            return ok;
    if ((info.fields & editFrozen) && !edit.frozen)
        return refuse("tree", RAMURE_NOOP("the tree is missing"));
    for (const ParamDef* def : stepParams(edit.operation))
        if (auto ok = checkValue(*def, def->get(*edit.values)); !ok) {
            ok.error().path = "values." + ok.error().path;
            return ok;
        }
    return info.fields & editLimb ? checkLimb(edit) : Expected<void>();
}

Expected<void> checkTreeEdits(std::span<const TreeEdit> edits)
{
    std::set<std::uint64_t> ids;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        auto ok = checkTreeEdit(edits[i]);
        if (ok && (edits[i].id == 0 || !ids.insert(edits[i].id).second))
            ok = refuse("id", RAMURE_NOOP("every edit needs a name of its own"));
        if (ok)
            continue;
        ok.error().path = "edits[" + std::to_string(i) + "]." + ok.error().path;
        return ok;
    }
    return {};
}

std::uint64_t newEditId(std::span<const TreeEdit> edits, const TreeEdit& edit)
{
    StageHash hash(edits.size());
    hash.add(std::string_view(infoOf(edit.operation).key)).add(edit.target.address).add(edit.other.address);
    for (;;) {
        const std::uint64_t id = hash.value();
        if (id != 0 && std::ranges::find(edits, id, &TreeEdit::id) == edits.end())
            return id;
        hash.add(1);
    }
}

} // namespace ramure
