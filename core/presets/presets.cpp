#include "core/presets/presets.h"

#include "core/presets/species.h"
#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

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

// From here on: figures 2.6 c, 2.7 d and 2.8 a of "The Algorithmic Beauty of Plants", in metres.
constexpr const char* hondaRules = R"(# after Honda: a trunk with boughs that fork in a plane
A(l, w) -> !(w)F(l)[&(a0)B(l*r2, w*wr)]/(d)A(l*r1, w*wr)
B(l, w) -> !(w)F(l)[-(a2)$C(l*r2, w*wr)]C(l*r1, w*wr)
C(l, w) -> !(w)F(l)[+(a2)$B(l*r2, w*wr)]B(l*r1, w*wr)
)";
constexpr const char* hondaConstants = R"(r1 = 0.9    # length of what goes on
r2 = 0.8    # length of a side branch
a0 = 45     # boughs from the trunk
a2 = 45     # twigs from the boughs
d = 137.5   # around the trunk
wr = 0.707  # width: both branches together carry as much
)";
constexpr const char* aonoKuniiRules = R"(# after Aono and Kunii: every branch ends in two
A(l, w) -> !(w)F(l)[&(a1)B(l*r1, w*wr)]/(180)[&(a2)B(l*r2, w*wr)]
B(l, w) -> !(w)F(l)[+(a1)$B(l*r1, w*wr)][-(a2)$B(l*r2, w*wr)]
)";
constexpr const char* aonoKuniiConstants = R"(r1 = 0.9
r2 = 0.8
a1 = 35
a2 = 35
wr = 0.707
)";
constexpr const char* ternaryRules = R"(# every branch ends in three, and all grow longer and thicker
A -> !(w0*vr)F(l0)[&(a)F(l0)A]/(d1)[&(a)F(l0)A]/(d2)[&(a)F(l0)A]
F(l) -> F(l*lr)
!(w) -> !(w*vr)
)";
constexpr const char* ternaryConstants = R"(l0 = 0.3     # length and width of a new branch
w0 = 0.006
d1 = 94.74   # around the branch
d2 = 132.63
a = 18.95
lr = 1.109
vr = 1.732
)";

GrammarParams parametric(const char* axiom, const char* rules, const char* constants, std::int64_t iterations)
{
    return {axiom, rules, iterations, false, 1, GrammarDialect::Parametric, constants};
}

NodeParams grown(GrammarParams grammar, TurtleParams turtle)
{
    NodeParams params;
    params.grammar = std::move(grammar);
    params.turtle = turtle;
    return params;
}

NodeParams filling(ColonisationParams crown)
{
    NodeParams params;
    params.generator.kind = EditOperation::Colonisation;
    params.colonisation = std::move(crown);
    params.sections = {3, 8};
    params.mesh.clampOvershoot = true;
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

/// Half a metre of old pine: a thick trunk with a bend, and limbs like trays.
NodeParams bonsai(NodeParams tree)
{
    WeberPennParams& small = tree.weberPenn;
    small.shape = CrownShape::Hemispherical;
    small.levels = 4;
    small.scale = 0.6;
    small.scaleV = 0.0;
    small.baseSize = 0.3;
    small.ratio = 0.075;
    small.ratioPower = 1.9;
    small.flare = 0.9;
    small.attractionUp = 1.6;
    small.clearance = 0.02;
    small.level[0] = {.curveRes = 8, .curve = 1.1, .curveBack = -1.7, .curveV = 0.5};
    small.level[1] = {.length = 0.55,
                      .lengthV = 0.1,
                      .curveRes = 6,
                      .curve = 0.15,
                      .curveBack = -0.45,
                      .curveV = 0.45,
                      .downAngle = 1.35,
                      .rotate = 2.4,
                      .rotateV = 0.44,
                      .branches = 12};
    small.level[2] = {.length = 0.34,
                      .lengthV = 0.1,
                      .curveRes = 4,
                      .curve = -0.5,
                      .curveV = 0.6,
                      .downAngle = 1.1,
                      .rotate = -1.57,
                      .rotateV = 0.44,
                      .branches = 30};
    small.level[3] = {
        .length = 0.5, .curveRes = 3, .curve = -0.6, .downAngle = 0.9, .rotate = 1.35, .branches = 12};
    tree.grammar.seed = 19;
    tree.leaf.shape = LeafShape::ScotsPine;
    tree.leaf.size = 1.0;
    tree.leaf.internode = 1.0;
    tree.foliage.leavesCutoff = 0.06;
    tree.foliage.applesProbability = 0.0;
    tree.bark.family = BarkFamily::Plated;
    tree.texture.tileSize = 0.1; // its plates are small, too
    return tree;
}

/// A box of box: what fills a wide low crown is clipped to it.
NodeParams hedge()
{
    ColonisationParams crown;
    crown.envelope = CrownEnvelope::Cylinder;
    crown.crownBase = 0.03;
    crown.crownHeight = 1.6;
    crown.crownRadius = 1.2;
    crown.points = 60'000;
    crown.surface = 0.1;
    crown.influence = 0.2;
    crown.kill = 0.045;
    crown.step = 0.04;
    crown.tropism = {0.0, -0.3, 0.0};
    crown.tipRadius = 0.0016;
    crown.thinning = 0.05;
    NodeParams params =
        dressed(filling(crown), LeafShape::Box, 6.0, FruitKind::Faithful, 0.0, BarkFamily::Furrowed, -0.3);
    params.texture.tileSize = 0.1;
    params.leaf.internode = 1.1;
    params.foliage.leavesCutoff = 0.5;
    TreeEdit clip;
    clip.id = 1;
    clip.operation = EditOperation::Prune;
    clip.shape = {EditShapeKind::Box, {-0.85, -0.1, -0.42, 0.85, 1.2, 0.42}};
    params.edits = {clip};
    return params;
}

/// Species in another state than a grown tree's in summer.
std::vector<Preset> forms(std::span<const Preset> grown)
{
    const auto like = [grown](std::string_view name) {
        return std::ranges::find(grown, name, &Preset::name)->params;
    };
    constexpr const char* group = RAMURE_NOOP("Forms");
    Preset snag{"DeadSnag", RAMURE_NOOP("A broken pine trunk with the stubs of its limbs"),
                like("ScotsPine1995"), "", group};
    WeberPennParams& dead = snag.params.weberPenn;
    dead.levels = 2;
    dead.baseSize = 0.25;
    dead.ratioPower = 1.0;
    dead.level[0].taper = 0.75;
    dead.level[0].curveV = 0.9;
    dead.level[1].length = 0.16;
    dead.level[1].lengthV = 0.1;
    dead.level[1].branches = 17;
    snag.params.foliage.leavesCutoff = 0.0;
    snag.params.foliage.applesProbability = 0.0;
    snag.params.bark.family = BarkFamily::Fibrous;
    snag.params.bark.light = 0.3;
    Preset sapling{"Sapling", RAMURE_NOOP("A young birch, three metres high"), like("SilverBirch1995"), "",
                   group};
    WeberPennParams& young = sapling.params.weberPenn;
    young.scale = 3.2;
    young.scaleV = 0.4;
    young.ratio = 0.011;
    young.baseSize = 0.12;
    young.clearance = 0.2;
    young.level[1].branches = 16;
    young.level[2].branches = 7;
    sapling.params.leaf.size = 4.0;
    sapling.params.leaf.internode = 3.0;
    sapling.params.foliage.leavesCutoff = 0.3;
    Preset bare{"WinterOak", RAMURE_NOOP("An English oak in winter, without a leaf"), like("EnglishOak1995"),
                "", group};
    bare.params.leaf.season = 1.0;
    bare.params.foliage.applesProbability = 0.0;
    Preset tray{"Bonsai", RAMURE_NOOP("A small old pine with a bent trunk and limbs like trays"),
                bonsai(like("JapaneseMaple1995")), "", group};
    Preset combed{"CliffHawthorn",
                  RAMURE_NOOP("An old hawthorn on a cliff, combed by the sea wind, in autumn"),
                  like("Hawthorn"), "", group};
    combed.params.grammar.seed = 2;
    combed.params.growth.wind = 9.0;
    combed.params.growth.slope = 0.35;
    combed.params.growth.lean = 0.5;
    combed.params.leaf.season = 0.55;
    Preset clipped{"Hedge", RAMURE_NOOP("Box, clipped to a block"), hedge(), "", group};
    return {std::move(tray),    std::move(combed),  std::move(snag),
            std::move(clipped), std::move(sapling), std::move(bare)};
}

std::vector<Preset> colonised()
{
    ColonisationParams umbrella;
    umbrella.envelope = CrownEnvelope::Profile;
    umbrella.profile = "0 0, 0.6 0.15, 0.72 1, 0.9 0.8, 1 0.2";
    umbrella.crownRadius = 4.0;
    umbrella.points = 5000;
    umbrella.influence = 1.5;
    umbrella.step = 0.12;
    constexpr const char* group = RAMURE_NOOP("Space colonisation");
    NodeParams park = dressed(filling(ColonisationParams()), LeafShape::Linden, 1.7, FruitKind::Faithful, 0.0,
                              BarkFamily::Furrowed);
    NodeParams acacia =
        dressed(filling(umbrella), LeafShape::Mimosa, 1.5, FruitKind::Faithful, 0.0, BarkFamily::Corky);
    park.leaf.internode = acacia.leaf.internode = 0.5;
    park.mesh.collar = acacia.mesh.collar = 0.5;
    park.mesh.roots = 7;
    acacia.mesh.roots = 5;
    park.mesh.rootLength = acacia.mesh.rootLength = 0.55;
    return {{"ParkTree", RAMURE_NOOP("A round crown that its branches fill"), park, "", group},
            {"UmbrellaAcacia", RAMURE_NOOP("A flat roof of twigs, drawn as a profile"), acacia,
             "Vachellia tortilis", group}};
}

Preset grownPreset(const GrownSpecies& species, const NodeParams& dress, const char* group)
{
    return {species.name, species.description, grownParams(species, dress), species.latin,
            group,        species.ages};
}

/// Group by group, each in the order of names. Where a species grows by years, its tree of 1995 stands in a
/// group of its own.
std::vector<Preset> everySpecies()
{
    constexpr const char *broadleaved = RAMURE_NOOP("Broadleaved trees"), *conifers = RAMURE_NOOP("Conifers"),
                         *of1995 = RAMURE_NOOP("Weber and Penn 1995");
    std::vector<Preset> all;
    for (const auto& list : {species(), broadleavedSpecies(), coniferSpecies()})
        for (const Species& each : list) {
            const bool isOld = std::string_view(each.name).ends_with("1995");
            all.push_back({each.name, each.description, speciesParams(each), each.latin,
                           isOld          ? of1995
                           : each.conifer ? conifers
                                          : broadleaved});
        }
    for (const GrownSpecies& each : grownSpecies())
        if (const auto dress = std::ranges::find(all, std::string(each.name) + "1995", &Preset::name);
            dress != all.end())
            all.push_back(grownPreset(each, dress->params, each.conifer ? conifers : broadleaved));
    const auto place = [&](const Preset& preset) {
        const std::string_view group = preset.group;
        return std::pair(group == of1995 ? 2 : group == conifers ? 1 : 0, std::string_view(preset.name));
    };
    std::ranges::sort(all, {}, place);
    return all;
}

/// Palms, bamboos and cacti: those of rules, and before its own the palm that grows by years.
std::vector<Preset> everyOrganPreset()
{
    std::vector<Preset> all = organPresets();
    for (const GrownSpecies& each : grownSpecies())
        if (const auto dress = std::ranges::find(all, std::string(each.name) + "Rules", &Preset::name);
            dress != all.end())
            all.insert(dress, grownPreset(each, dress->params, dress->group));
    return all;
}

/// Limbs stand around their stems or run along them: faired, these would lose a little of their collars or of
/// the wood that goes on above a fork, or their bark would change its scale too fast.
void leaveForksAsBuilt(std::vector<Preset>& presets)
{
    constexpr std::array names{
        "Baobab",    "CommonYew1995", "Hornbeam",          "LiveOak1995",     "RainTree1995",  "RedOak1995",
        "Rowan1995", "ScotsPine",     "WeepingWillow1995", "WhiteWillow1995", "WildCherry1995"};
    for (Preset& preset : presets)
        if (std::ranges::find(names, std::string_view(preset.name)) != names.end())
            preset.params.mesh.fairing = preset.params.mesh.ridge = 0.0;
}

constexpr std::size_t courseworkCount = 4;

std::vector<Preset> everyPreset()
{
    std::vector<Preset> all{
        {"SmallTree", RAMURE_NOOP("A tree that forks in two, again and again"),
         dressed(NodeParams(), LeafShape::Apple, 1.4, FruitKind::Apple, 0.05, BarkFamily::Scaly)},
        {"FanTree", RAMURE_NOOP("Slender branches with fans of twigs"),
         dressed(grown({"EEEEEEBA", fanTreeRules, 8}, {0.15, 0.2, 0.92}), LeafShape::Cherry, 1.2,
                 FruitKind::Blossom, 0.35, BarkFamily::Banded)},
        {"TinyTree", RAMURE_NOOP("A small tree, drawn once by chance and kept"),
         dressed(grown({tinyTreeSymbols, "", 0}, {0.394, 0.2, 0.8}), LeafShape::Oak, 1.3, FruitKind::Acorn,
                 0.3, BarkFamily::Furrowed)},
        {"Fern2D", RAMURE_NOOP("A fern that grows in one plane"),
         dressed(grown({"X", fernRules, 5}, {0.4363, 0.1, 0.92}), LeafShape::Fern, 1.0, FruitKind::Faithful,
                 0.0, BarkFamily::Smooth)},
        {"HondaTree", RAMURE_NOOP("A trunk that goes on to the top, with boughs around it"),
         dressed(grown(parametric("A(1.2, 0.36)", hondaRules, hondaConstants, 10), TurtleParams()),
                 LeafShape::Linden, 1.2, FruitKind::Faithful, 0.0, BarkFamily::Furrowed)},
        {"AonoKuniiTree", RAMURE_NOOP("An umbrella: every branch ends in two, and these lie level"),
         dressed(grown(parametric("A(1.2, 0.36)", aonoKuniiRules, aonoKuniiConstants, 10), TurtleParams()),
                 LeafShape::Mimosa, 1.2, FruitKind::Faithful, 0.0, BarkFamily::Corky)},
        {"TernaryTree", RAMURE_NOOP("Long twigs that bend down under their weight"),
         dressed(grown(parametric("!(w0)F(4*l0)/(45)A", ternaryRules, ternaryConstants, 6),
                       {0.3142, 0.2, 0.88, {0.0, -1.0, 0.0}, 0.22}),
                 LeafShape::Olive, 1.2, FruitKind::Olive, 0.1, BarkFamily::Fibrous)},
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].group = i < courseworkCount ? "Coursework" : RAMURE_NOOP("The Algorithmic Beauty of Plants");
        all[i].params.mesh.forkLength = 0.0; // the book and the coursework say how thick their branches are
    }
    for (std::size_t i = 0; i < courseworkCount; ++i) // the coursework says what their sections are
        all[i].params.mesh.leastRadius = 0.0;
    const auto filled = colonised();
    all.insert(all.end(), filled.begin(), filled.end());
    std::vector<Preset> trees = everySpecies();
    leaveForksAsBuilt(trees);
    all.insert(all.end(), trees.begin(), trees.end());
    for (const auto& more : {everyOrganPreset(), forms(all)})
        all.insert(all.end(), more.begin(), more.end());
    for (std::size_t i = courseworkCount; i < all.size(); ++i) // those of the coursework have no scale
        if (double& tile = all[i].params.texture.tileSize; tile == 0.0)
            tile = grownBarkTile(all[i].params.bark.family);
    return all;
}

} // namespace

std::span<const Preset> presets()
{
    static const std::vector<Preset> all = everyPreset();
    return all;
}

std::span<const Preset> courseworkPresets()
{
    return presets().first(courseworkCount);
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
