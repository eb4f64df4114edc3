#include "core/scene/recipe_demo.h"

#include "core/generators/sources.h"
#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "core/recipe/edit_context.h"
#include <algorithm>

namespace ramure {
namespace {

/// \pre a preset of this name ships.
NodeParams presetOf(const char* name)
{
    return *presetParams(name);
}

void append(NodeParams& params, TreeEdit step)
{
    step.id = newEditId(params.edits, step);
    params.edits.push_back(std::move(step));
}

/// A step with \p change made to the values of a new one, and the generator of \p like where one is given.
template <class Change>
TreeEdit stepOf(EditOperation operation, Change&& change, const NodeParams* like = nullptr)
{
    TreeEdit step = like ? newStep(operation, *like) : newStep(operation);
    NodeParams values = *step.values;
    change(values);
    step.values = StepValues(std::move(values));
    return step;
}

/// A twig that the axiom draws alone.
void growOnce(GrammarParams& grammar, const char* axiom)
{
    grammar.axiom = axiom;
    grammar.rules.clear();
    grammar.iterations = 0;
}

NodeParams drawnTrunk()
{
    NodeParams params = presetOf("EnglishOak1995");
    params.generator.kind = EditOperation::Draw;
    TreeEdit trunk = newStep(EditOperation::Draw);
    // In the frame of the ground: x, then against z, then up.
    trunk.points = {{{0.0, 0.0, 0.0}, 0.26},     {{0.25, -0.05, 1.0}, 0.22}, {{0.1, -0.3, 2.2}, 0.19},
                    {{-0.35, -0.25, 3.4}, 0.14}, {{-0.2, 0.1, 4.8}, 0.08},   {{0.1, 0.0, 6.0}, 0.02}};
    append(params, std::move(trunk));
    NodeParams oak = presetOf("EnglishOak1995");
    oak.weberPenn.level[1].branches = 22;
    oak.weberPenn.level[2].branches = 30;
    append(params, stepOf(
                       EditOperation::WeberPenn, [](NodeParams& v) { v.step.stand.from = 0.3; }, &oak));
    return params;
}

NodeParams colonisedWithTwigs()
{
    NodeParams params = presetOf("ParkTree");
    params.colonisation.points = 500;
    append(params, stepOf(EditOperation::Grammar, [](NodeParams& v) {
               v.step.where = "order > 0 and length > 0.5";
               v.step.stand.count = 8;
               v.step.stand.size = 0.25;
               growOnce(v.grammar, "FF[+F]F[-F]F[^F]F");
           }));
    return params;
}

NodeParams twoOnOneParent()
{
    NodeParams params = presetOf("SilverBirch1995");
    params.weberPenn.levels = 2;
    const NodeParams willow = presetOf("WeepingWillow1995");
    append(params, stepOf(
                       EditOperation::WeberPenn,
                       [](NodeParams& v) {
                           v.step.where = "order = 1 and share > 0.5";
                           v.weberPenn.levels = 2;
                           v.step.stand.size = 0.7;
                       },
                       &willow));
    append(params, stepOf(EditOperation::Grammar, [](NodeParams& v) {
               v.step.where = "order = 1";
               v.step.stand.count = 10;
               growOnce(v.grammar, "F[+F]F[-F]F");
           }));
    return params;
}

NodeParams oldOak()
{
    NodeParams params = presetOf("EnglishOak1995");
    params.grammar.seed = 7;
    append(params, stepOf(EditOperation::Gnarl, [](NodeParams& v) { v.step.gnarl.angle = 0.45; }));
    append(params, stepOf(EditOperation::Sag, [](NodeParams& v) { v.step.sag.amount = 12.0; }));
    append(params, stepOf(EditOperation::DeadWood, [](NodeParams& v) { v.step.deadWood.share = 0.2; }));
    append(params, stepOf(EditOperation::Flare, [](NodeParams& v) { v.step.flare.amount = 0.4; }));
    return params;
}

NodeParams twoStems()
{
    NodeParams params = presetOf("SilverBirch1995");
    const NodeParams other = params;
    append(params, stepOf(
                       EditOperation::WeberPenn,
                       [](NodeParams& v) {
                           v.step.stand.way = StandWay::Ground;
                           v.step.stand.offset = {0.5, 0.0, 0.3};
                           v.step.stand.size = 0.8;
                       },
                       &other));
    return params;
}

/// The skeleton of a source alone.
Skeleton grownBy(const NodeParams& params)
{
    return *growSkeleton(*growSymbols(params), params);
}

/// A cherry that bears two limbs of an apple tree.
NodeParams grafted()
{
    NodeParams params = presetOf("WildCherry1995");
    const Skeleton donor = grownBy(presetOf("OrchardApple1995"));
    const TreeAxes limbs = axesOf(donor);
    const Axis& longest = *std::ranges::max_element(
        limbs.axes, {}, [](const Axis& axis) { return axis.order == 1 ? axis.length : 0.0; });
    const Skeleton stock = grownBy(params);
    EditContext context(stock, {}, nullptr, treeSeed(params));
    for (const double at : {0.35, 0.5}) {
        TreeEdit graft;
        graft.operation = EditOperation::Graft;
        graft.target.address = axesOf(stock).axes.front().address;
        graft.at = at;
        graft.azimuthRad = 4.0 * at;
        graft.limb = EditContext(donor, {}).limb(longest.address);
        graft.id = newEditId(params.edits, graft);
        params.edits.push_back(*context.prepared(std::move(graft), false));
    }
    return params;
}

} // namespace

Scene recipeDemo()
{
    constexpr double apart = 9.0; // m
    const std::pair<const char*, NodeParams (*)()> trees[] = {
        {"Oak on a drawn trunk", drawnTrunk},
        {"Twigs on colonised limbs", colonisedWithTwigs},
        {"Two sources on one parent", twoOnOneParent},
        {"Old oak", oldOak},
        {"Two stems", twoStems},
        {"Grafted cherry", grafted}};
    std::vector<Node> nodes;
    for (const auto& [name, make] : trees) {
        Node node;
        node.id = static_cast<NodeId>(nodes.size() + 1);
        node.kind = NodeKind::Tree;
        node.name = name;
        node.params = make();
        node.params.tree.translation.x = apart * (static_cast<double>(nodes.size()) - 2.5);
        nodes.push_back(std::move(node));
    }
    return *Scene::fromNodes(std::move(nodes));
}

} // namespace ramure
