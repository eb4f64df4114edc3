#include "core/params/presets.h"

#include <algorithm>
#include <array>

namespace ramure {
namespace {

// clang-format off
/// The TinyTree was drawn once by chance; its symbols are kept as they fell, there is nothing left to rewrite.
constexpr const char* tinyTreeSymbols =
    R"(\\\\\\B\\\\\\B\\\\\\B\\\\\\\\B\\\\\\B[++\\\\B\\\\B[--][++][__][^^][++\\BB[--][++][__][^^][++B\\B)"
    R"([--][++][__][^^][++BB[--C][++C][__C][^^C]A]/////+BBB[--C][++C][__C][^^C]A]/////+B\\BB[--][++][__)"
    R"(][^^][++BB[--C][++C][__C][^^C]A]/////+BBB[--C][++C][__C][^^C]A]/////+\\\\B\\\\B\\B[--][++][__][^)"
    R"(^][++B\\B[--][++][__][^^][++BB[--C][++C][__C][^^C]A]/////+BBB[--C][++C][__C][^^C]A]/////+\\BBB[-)"
    R"(-][++][__][^^][++BB[--C][++C][__C][^^C]A]/////+BBB[--C][++C][__C][^^C]A]/////+\\\\B\\B\\\\\\B[--)"
    R"(][++][__][^^][++\\B\\\\B[--][++][__][^^][++BB[--][++][__][^^][++BB[--C][++C][__C][^^C]A]/////+BB)"
    R"(B[--C][++C][__C][^^C]A]/////+BB\\B[--][++][__][^^][++BB[--C][++C][__C][^^C]A]/////+BBB[--C][++C])"
    R"([__C][^^C]A]/////+\\B\\BB[--][++][__][^^][++\\B\\B[--][++][__][^^][++BB[--C][++C][__C][^^C]A]///)"
    R"(//+BBB[--C][++C][__C][^^C]A]/////+BBB[--][++][__][^^][++BB[--C][++C][__C][^^C]A]/////+BBB[--C][+)"
    R"(+C][__C][^^C]A)";
// clang-format on

constexpr const char* fanTreeRules = R"(A -> [++BBB[--C][++C][__C]-A]//-BBB[--C][__C][^^C]+A
B -> 0.5: B | 0.5: \\B | default: \B
C -> [--D][++D][__D][^^D]
D ->
)";

constexpr const char* fernRules = R"(X -> F^[[X]_X]_F[_FX]^X
F -> FF
)";

NodeParams grown(GrammarParams grammar, TurtleParams turtle)
{
    NodeParams params;
    params.grammar = std::move(grammar);
    params.turtle = turtle;
    return params;
}

/// The coursework says how the presets grow; they wear what suits their habit.
NodeParams dressed(NodeParams tree, LeafShape leaf, double leafSize, FruitKind fruit, double fruitful,
                   BarkFamily bark, double barkLight = 0.0)
{
    tree.leaf.shape = leaf;
    tree.leaf.size = leafSize;
    tree.fruit.kind = fruit;
    tree.foliage.applesProbability = fruitful;
    tree.bark.family = bark;
    tree.bark.light = barkLight;
    return tree;
}

} // namespace

std::span<const Preset> presets()
{
    static const std::array<Preset, 4> all{{
        {"SmallTree", RAMURE_NOOP("A tree that forks in two, again and again"),
         dressed(NodeParams(), LeafShape::Apple, 1.4, FruitKind::Apple, 0.05, BarkFamily::Scaly)},
        {"FanTree", RAMURE_NOOP("Slender branches with fans of twigs"),
         dressed(grown({"EEEEEEBA", fanTreeRules, 8}, {0.15, 0.2, 0.92}), LeafShape::Cherry, 1.2,
                 FruitKind::Blossom, 0.35, BarkFamily::Ringed, -0.5)},
        {"TinyTree", RAMURE_NOOP("A small tree, drawn once by chance and kept"),
         dressed(grown({tinyTreeSymbols, "", 0}, {0.394, 0.2, 0.8}), LeafShape::Oak, 1.3, FruitKind::Acorn,
                 0.3, BarkFamily::Furrowed)},
        {"Fern2D", RAMURE_NOOP("A fern that grows in one plane"),
         dressed(grown({"X", fernRules, 5}, {0.4363, 0.1, 0.92}), LeafShape::Fern, 1.0, FruitKind::Faithful,
                 0.0, BarkFamily::Smooth)},
    }};
    return all;
}

Expected<NodeParams> presetParams(std::string_view name)
{
    std::string names;
    for (const Preset& preset : presets()) {
        if (name == preset.name)
            return preset.params;
        names += (names.empty() ? "" : ", ") + std::string(preset.name);
    }
    return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no preset \"%1\"; there are %2"),
                {std::string(name), names});
}

ParamValue presetValue(std::string_view preset, const ParamDef& def)
{
    const auto all = presets();
    const auto found = std::ranges::find(all, preset, &Preset::name);
    return found == all.end() ? defaultValue(def) : def.get(found->params);
}

} // namespace ramure
