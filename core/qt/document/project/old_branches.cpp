#include "core/qt/document/project/old_branches.h"

#include "core/math/angle.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/tree_context.h"
#include "core/qt/document/project/project_json.h"
#include "core/qt/document/project/project_places.h"
#include "core/skeleton/branch_steps.h"
#include "core/skeleton/edit_places.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace ramure::json {
namespace {

Expected<glm::dvec3> readBend(const QJsonValue& value)
{
    const QJsonArray array = value.toArray();
    const bool numbers =
        array.size() == 3 && array[0].isDouble() && array[1].isDouble() && array[2].isDouble();
    if (!value.isUndefined() && !numbers)
        return failAt("bend", ErrorCode::Invalid, RAMURE_NOOP("three numbers are expected here"));
    return glm::dvec3(array[0].toDouble(), array[1].toDouble(), array[2].toDouble());
}

Expected<OldBranch> readBranch(const QJsonValue& value)
{
    if (!value.isObject())
        return failAt({}, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    const QJsonObject object = value.toObject();
    const QJsonValue roll = object.value(QLatin1String("roll"));
    if (!roll.isDouble() && !roll.isUndefined())
        return failAt("roll", ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
    const auto bend = readBend(object.value(QLatin1String("bend")));
    RAMURE_TRY(bend);
    auto place = readPlace(object.value(QLatin1String("place")));
    if (!place)
        return failInside("place", std::move(place.error()));
    return OldBranch{std::remainder(roll.toDouble(0.0), 2.0 * pi), *bend, std::move(*place)};
}

/// The branch that each was made for: by place where it has one, else by key; noIndex: it is not there.
std::vector<Index> branchesOf(const TreeResult& tree, const OldBranches& old)
{
    std::vector<BranchPlace> places;
    for (const auto& [key, branch] : old)
        places.push_back(branch.place);
    std::vector<Index> found = findBranches(*tree.skeleton, *tree.simplified, places);
    const std::vector<std::uint64_t>& keys = tree.simplified->skeleton.key;
    std::size_t i = 0;
    for (const auto& [key, branch] : old) {
        const auto at = std::ranges::find(keys, key);
        if (branch.place.way.empty() && at != keys.end())
            found[i] = static_cast<Index>(at - keys.begin());
        ++i;
    }
    return found;
}

/// What a tree gets at the end of its recipe.
class OldSteps
{
public:
    explicit OldSteps(Node& tree)
        : m_steps(tree.params.edits)
    {
        m_tree = TreePipeline().evaluate(tree.params, Stage::Simplified);
        if (m_tree)
            m_context.emplace(contextOf(*m_tree, tree.params));
    }

    void add(const OldBranches& old)
    {
        const std::size_t count = m_tree ? m_tree->simplified->skeleton.size() : 0;
        const TreeAxes axes = m_tree ? axesOf(*m_tree->skeleton) : TreeAxes();
        const std::vector<Index> found =
            m_tree ? branchesOf(*m_tree, old) : std::vector<Index>(old.size(), noIndex);
        std::vector<glm::dvec3> bends(count, glm::dvec3(0.0));
        std::vector<bool> isTaken(count, false);
        std::size_t i = 0;
        for (const auto& [key, branch] : old) {
            const Index at = found[i++];
            if (at == noIndex || isTaken[at]) {
                keep(key, branch);
                continue;
            }
            isTaken[at] = true;
            bends[at] = branch.bendRad;
            const BranchStart start = branchStart(axes, *m_tree->simplified, at);
            put(rollStep(branch, start.address, start.share));
        }
        if (m_tree)
            for (TreeEdit& step : bendSteps(axes, *m_tree->simplified, bends))
                put(std::move(step));
    }

private:
    static TreeEdit rollStep(const OldBranch& branch, std::uint64_t address, double share)
    {
        TreeEdit step;
        step.operation = EditOperation::Roll;
        step.target.address = address;
        step.from = share;
        step.angleRad = branch.rollRad;
        return step;
    }
    void put(TreeEdit step)
    {
        if (step.operation == EditOperation::Roll && step.angleRad == 0.0)
            return;
        if (auto ready = m_context->prepared(std::move(step), true))
            append(std::move(*ready));
    }
    /// Without a place in the tree as it is.
    void keep(std::uint64_t key, const OldBranch& branch)
    {
        const std::uint64_t address = branch.place.way.empty() ? key : branch.place.way.back().address;
        TreeEdit step = rollStep(branch, address, std::clamp(branch.place.share, 0.0, 1.0));
        step.target.place = branch.place;
        step.to = step.from;
        if (branch.rollRad != 0.0)
            append(step);
        step.operation = EditOperation::Bend;
        step.angleRad = 0.0;
        step.rotation = branch.bendRad;
        if (branch.bendRad != glm::dvec3(0.0))
            append(std::move(step));
    }
    void append(TreeEdit step)
    {
        step.id = newEditId(m_steps, step);
        m_steps.push_back(std::move(step));
    }

    std::vector<TreeEdit>& m_steps;
    Expected<TreeResult> m_tree = TreeResult();
    std::optional<EditContext> m_context;
};

} // namespace

Expected<OldBranches> readOldBranches(const QJsonValue& value)
{
    if (!value.isObject() && !value.isUndefined())
        return failAt("branches", ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    OldBranches branches;
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        const std::string place = "branches." + it.key().toStdString();
        const auto key = branchKeyFromText(it.key());
        if (!key)
            return failInside(place, key.error());
        auto branch = readBranch(it.value());
        if (!branch)
            return failInside(place, std::move(branch.error()));
        if (branch->rollRad != 0.0 || branch->bendRad != glm::dvec3(0.0))
            branches.emplace(*key, std::move(*branch));
    }
    return branches;
}

void addOldBranches(Node& tree, const OldBranches& branches)
{
    if (!branches.empty())
        OldSteps(tree).add(branches);
}

} // namespace ramure::json
