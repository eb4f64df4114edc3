#include "core/params/param_items.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <type_traits>

namespace ramure {
namespace {

constexpr double pi = std::numbers::pi;
/// Whole numbers up to here survive a round trip through a double, hence through any JSON reader.
constexpr double maxSeed = 9007199254740991.0;

struct Words
{
    const char* key;
    const char* group;
    const char* label;
    const char* tooltip;
};

struct Range
{
    double hardMin = 0.0, hardMax = 0.0;
    double softMin = 0.0, softMax = 0.0;
    double step = 0.0;
    int decimals = 0;
};

template <class T> constexpr ParamType typeOf()
{
    static_assert(std::is_enum_v<T> == !itemsOf<T>.empty(), "an enumeration has items");
    if constexpr (std::is_same_v<T, bool>)
        return ParamType::Bool;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return ParamType::Int;
    else if constexpr (std::is_same_v<T, double>)
        return ParamType::Real;
    else if constexpr (std::is_same_v<T, std::string>)
        return ParamType::Text;
    else if constexpr (std::is_enum_v<T>)
        return ParamType::Enum;
    else {
        static_assert(std::is_same_v<T, glm::dvec3>,
                      "a parameter must be one of the alternatives of ParamValue");
        return ParamType::Vec3;
    }
}

/// The way to one value: a member of NodeParams and a member of that.
template <auto Group, auto Member> struct Field
{
    using Value = std::remove_cvref_t<decltype((std::declval<NodeParams&>().*Group).*Member)>;
    static ParamValue get(const NodeParams& params)
    {
        if constexpr (std::is_enum_v<Value>)
            return EnumValue{itemsOf<Value>[static_cast<std::size_t>((params.*Group).*Member)].name};
        else
            return ParamValue((params.*Group).*Member);
    }
    static void assign(NodeParams& params, const ParamValue& value)
    {
        if constexpr (std::is_enum_v<Value>) {
            const auto* name = std::get_if<EnumValue>(&value);
            for (std::size_t i = 0; name && i < itemsOf<Value>.size(); ++i)
                if (name->name == itemsOf<Value>[i].name)
                    (params.*Group).*Member = static_cast<Value>(i);
        } else if (const auto* held = std::get_if<Value>(&value))
            (params.*Group).*Member = *held;
    }
};

constexpr std::uint8_t treeOnly = kindBit(NodeKind::Tree);
constexpr std::uint8_t primitiveOnly = kindBit(NodeKind::Primitive);
constexpr std::uint8_t objectKinds = kindBit(NodeKind::Primitive) | kindBit(NodeKind::Mesh);
constexpr std::uint8_t armOnly = kindBit(NodeKind::Arm);
constexpr std::uint8_t terrainOnly = kindBit(NodeKind::Terrain);
/// All but groups, which have no geometry.
constexpr std::uint8_t everyKind = 0xFF;
constexpr std::uint8_t shapedKinds = everyKind & ~kindBit(NodeKind::Group);

using Condition = bool(const NodeParams&);
constexpr Condition* growsByChance = [](const NodeParams& p) { return p.grammar.stochastic; };
constexpr Condition* mergesRuns = [](const NodeParams& p) { return p.simplify.enabled; };
constexpr Condition* hasNoBudget = [](const NodeParams& p) { return p.mesh.targetTriangles == 0; };
constexpr Condition* isFaithful = [](const NodeParams& p) { return p.leaf.shape == LeafShape::Faithful; };
constexpr Condition* isOfPlant = [](const NodeParams& p) { return p.leaf.shape != LeafShape::Faithful; };
constexpr Condition* softensForks = [](const NodeParams& p) { return p.mesh.forkSoftness > 0.0; };

template <auto Group, auto Member>
constexpr ParamDef row(const Words& words, ParamUnit unit, const Range& range, Stage stage,
                       std::uint8_t flags = paramNone, std::uint8_t kinds = treeOnly,
                       Condition* matters = nullptr)
{
    using Access = Field<Group, Member>;
    return {words.key,
            words.group,
            words.label,
            words.tooltip,
            typeOf<typename Access::Value>(),
            unit,
            range.hardMin,
            range.hardMax,
            range.softMin,
            range.softMax,
            range.step,
            range.decimals,
            stage,
            flags,
            kinds,
            &Access::get,
            &Access::assign,
            itemsOf<typename Access::Value>,
            matters};
}

constexpr const char* grammarGroup = RAMURE_NOOP("Grammar");
constexpr const char* turtleGroup = RAMURE_NOOP("Turtle");
constexpr const char* variationGroup = RAMURE_NOOP("Variation");
constexpr const char* simplifyGroup = RAMURE_NOOP("Simplification");
constexpr const char* sectionsGroup = RAMURE_NOOP("Cross-sections");
constexpr const char* forksGroup = RAMURE_NOOP("Forks");
constexpr const char* foliageGroup = RAMURE_NOOP("Foliage");
constexpr const char* barkGroup = RAMURE_NOOP("Bark");
constexpr const char* placementGroup = RAMURE_NOOP("Placement");
constexpr const char* localGroup = RAMURE_NOOP("Own shape");
constexpr const char* primitiveGroup = RAMURE_NOOP("Primitive");
constexpr const char* surfaceGroup = RAMURE_NOOP("Surface");
constexpr const char* physicsGroup = RAMURE_NOOP("Physics");
constexpr const char* skinGroup = RAMURE_NOOP("Skin");
constexpr const char* armGroup = RAMURE_NOOP("Arm");
constexpr const char* ikGroup = RAMURE_NOOP("Inverse kinematics");
constexpr const char* armSkinGroup = RAMURE_NOOP("Skin of the arm");
constexpr const char* terrainGroup = RAMURE_NOOP("Terrain");

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
constexpr std::array table{
    row<&NodeParams::grammar, &GrammarParams::axiom>(
        {"grammar.axiom", grammarGroup, RAMURE_NOOP("Axiom"),
         RAMURE_NOOP("The seed the tree grows from: the symbols that stand there before any rule is used.")},
        ParamUnit::None, {}, Stage::Symbols, paramGrammar),
    row<&NodeParams::grammar, &GrammarParams::rules>(
        {"grammar.rules", grammarGroup, RAMURE_NOOP("Rules"),
         RAMURE_NOOP("How symbols grow, one rule a line: \"A -> [+A]B\" puts [+A]B in the place of every A. "
                     "Several outcomes by chance: \"B -> 0.7: B | 0.3: BB\".")},
        ParamUnit::None, {}, Stage::Symbols, paramGrammar | paramMultiline),
    row<&NodeParams::grammar, &GrammarParams::iterations>(
        {"grammar.iterations", grammarGroup, RAMURE_NOOP("Iterations"),
         RAMURE_NOOP("How often the rules are used. Each round makes the tree finer; the number of branches grows "
                     "quickly.")},
        ParamUnit::Count, {0, 30, 0, 12, 1, 0}, Stage::Symbols),
    row<&NodeParams::grammar, &GrammarParams::stochastic>(
        {"grammar.stochastic", grammarGroup, RAMURE_NOOP("By chance"),
         RAMURE_NOOP("Let chance choose among the outcomes of a rule and vary the branches, so that every seed gives "
                     "another tree. Off: each rule always gives its default, and nothing varies.")},
        ParamUnit::None, {}, Stage::Symbols),
    row<&NodeParams::grammar, &GrammarParams::seed>(
        {"grammar.seed", grammarGroup, RAMURE_NOOP("Seed of the tree"),
         RAMURE_NOOP("Names one tree among all that chance can give. The same seed always grows the same tree.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Symbols, paramSeed, treeOnly, growsByChance),

    row<&NodeParams::turtle, &TurtleParams::theta>(
        {"turtle.theta", turtleGroup, RAMURE_NOOP("Turn"),
         RAMURE_NOOP("The angle of every turn a symbol asks for. Small angles give slender trees, large ones "
                     "spreading trees.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, 0, pi / 3, 0.01, 4}, Stage::Skeleton, paramAnimatable),
    row<&NodeParams::turtle, &TurtleParams::alpha>(
        {"turtle.alpha", turtleGroup, RAMURE_NOOP("Step"),
         RAMURE_NOOP("Length of each piece of branch, and the radius of the trunk at the ground. Leaves and apples "
                     "take their size from it too: it scales the whole tree.")},
        ParamUnit::Metre, {1e-4, 1000, 0.01, 1, 0.01, 4}, Stage::Skeleton, paramAnimatable),
    row<&NodeParams::turtle, &TurtleParams::decay>(
        {"turtle.decay", turtleGroup, RAMURE_NOOP("Taper"),
         RAMURE_NOOP("What remains of the radius at the end of each piece of branch. 1 keeps branches as thick as "
                     "the trunk.")},
        ParamUnit::Ratio, {0.01, 1, 0.5, 1, 0.01, 4}, Stage::Skeleton, paramAnimatable),

    row<&NodeParams::variation, &VariationParams::angle>(
        {"variation.angle", variationGroup, RAMURE_NOOP("Angles"),
         RAMURE_NOOP("How far each turn of a tree grown by chance may lie from the angle above, by seed. 0: every turn is the "
                     "same.")},
        ParamUnit::Share, {0, 0.9, 0, 0.3, 0.01, 3}, Stage::Skeleton, paramNone, treeOnly, growsByChance),
    row<&NodeParams::variation, &VariationParams::length>(
        {"variation.length", variationGroup, RAMURE_NOOP("Lengths"),
         RAMURE_NOOP("How far each piece of branch of a tree grown by chance may be longer or shorter than the step, by seed.")},
        ParamUnit::Share, {0, 0.9, 0, 0.3, 0.01, 3}, Stage::Skeleton, paramNone, treeOnly, growsByChance),
    row<&NodeParams::variation, &VariationParams::radius>(
        {"variation.radius", variationGroup, RAMURE_NOOP("Radii"),
         RAMURE_NOOP("How far each piece of branch of a tree grown by chance may taper more or less than the taper says, by "
                     "seed. No branch gets thicker towards its tip.")},
        ParamUnit::Share, {0, 0.9, 0, 0.3, 0.01, 3}, Stage::Skeleton, paramNone, treeOnly, growsByChance),

    row<&NodeParams::simplify, &SimplifyParams::enabled>(
        {"simplify.enabled", simplifyGroup, RAMURE_NOOP("Merge straight runs"),
         RAMURE_NOOP("Make one branch of pieces that follow each other without a turn. The shape stays, the mesh gets "
                     "lighter.")},
        ParamUnit::None, {}, Stage::Simplified),
    row<&NodeParams::simplify, &SimplifyParams::rotationThreshold>(
        {"simplify.rotationThreshold", simplifyGroup, RAMURE_NOOP("Straight below"),
         RAMURE_NOOP("Pieces that turn by less than this angle count as straight and are merged. Larger angles remove "
                     "bends too.")},
        ParamUnit::Radian, {0, pi, 0, 0.5, 0.001, 6}, Stage::Simplified, paramAdvanced, treeOnly, mergesRuns),

    row<&NodeParams::sections, &SectionParams::lengthDivisions>(
        {"sections.lengthDivisions", sectionsGroup, RAMURE_NOOP("Along the branch"),
         RAMURE_NOOP("Cross-sections of each branch, both ends included. More make smoother bends.")},
        ParamUnit::Count, {2, 64, 2, 16, 1, 0}, Stage::Sections),
    row<&NodeParams::sections, &SectionParams::radialDivisions>(
        {"sections.radialDivisions", sectionsGroup, RAMURE_NOOP("Around the branch"),
         RAMURE_NOOP("Points of each cross-section. More make rounder branches.")},
        ParamUnit::Count, {3, 64, 3, 32, 1, 0}, Stage::Mesh, paramNone, treeOnly, hasNoBudget),
    row<&NodeParams::mesh, &MeshParams::targetTriangles>(
        {"mesh.targetTriangles", sectionsGroup, RAMURE_NOOP("Triangle budget"),
         RAMURE_NOOP("About how many triangles all branches may take together, within 5 %. Thick and bent branches get "
                     "more of them, thin and straight ones fewer, and the two numbers above have no say. 0 sets no "
                     "budget.")},
        ParamUnit::Count, {0, 20'000'000, 0, 500'000, 1000, 0}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::forkSoftness>(
        {"mesh.forkSoftness", forksGroup, RAMURE_NOOP("Softness"),
         RAMURE_NOOP("How far wood grows over the creases between the branches of a fork: 0 leaves them sharp, 1 rounds "
                     "them fully.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::forkReach>(
        {"mesh.forkReach", forksGroup, RAMURE_NOOP("Reach"),
         RAMURE_NOOP("How far from the crease the branches of a fork begin to swell, as a share of the thinner one's "
                     "radius.")},
        ParamUnit::Ratio, {0, 4, 0, 2, 0.05, 3}, Stage::Mesh, paramNone, treeOnly, softensForks),
    row<&NodeParams::mesh, &MeshParams::clampOvershoot>(
        {"mesh.clampOvershoot", forksGroup, RAMURE_NOOP("Calm short branches"),
         RAMURE_NOOP("A branch much shorter than its parent swings out in a wide bow before it turns to its own direction. "
                     "On: the bow is no larger than one and a half times the branch.")},
        ParamUnit::None, {}, Stage::Mesh),
    row<&NodeParams::mesh, &MeshParams::nearTwinRatio>(
        {"mesh.nearTwinRatio", forksGroup, RAMURE_NOOP("Join twins below"),
         RAMURE_NOOP("Branches of a fork become one where their ends are closer than this share of their added radii: they "
                     "would lie in each other all along. 0 joins only those in the same place.")},
        ParamUnit::Ratio, {0, 4, 0, 1, 0.05, 3}, Stage::Mesh, paramAdvanced),

    row<&NodeParams::leaf, &LeafParams::shape>(
        {"foliage.leaf", foliageGroup, RAMURE_NOOP("Leaf"),
         RAMURE_NOOP("The plant whose leaves the twigs carry, each on its petiole. Faithful: flat triangles that float about "
                     "the twigs, squares in the rough model.")},
        ParamUnit::None, {}, Stage::Foliage),
    row<&NodeParams::foliage, &FoliageParams::leavesCutoff>(
        {"foliage.leavesCutoff", foliageGroup, RAMURE_NOOP("Twig thickness"),
         RAMURE_NOOP("Branches thinner than this share of the trunk's radius carry leaves and apples. 0 leaves the tree "
                     "bare.")},
        ParamUnit::Ratio, {0, 10, 0, 1, 0.01, 3}, Stage::Foliage, paramAnimatable),
    row<&NodeParams::foliage, &FoliageParams::leavesDensity>(
        {"foliage.leavesDensity", foliageGroup, RAMURE_NOOP("Leaves per twig"),
         RAMURE_NOOP("How many leaves grow on each branch that is thin enough.")},
        ParamUnit::Count, {0, 1000, 0, 50, 1, 0}, Stage::Foliage, paramAnimatable, treeOnly, isFaithful),
    row<&NodeParams::leaf, &LeafParams::internode>(
        {"foliage.internode", foliageGroup, RAMURE_NOOP("Internode"),
         RAMURE_NOOP("How far it is along a twig from one node with leaves to the next: 1 as the plant has it.")},
        ParamUnit::Factor, {0.01, 1000, 0.25, 4, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::arrangement>(
        {"foliage.arrangement", foliageGroup, RAMURE_NOOP("Arrangement"),
         RAMURE_NOOP("How the leaves of a twig follow each other. Alternate: one a node, two fifths of a turn apart; in two "
                     "rows: left and right; spiral: 137.5° apart; opposite: pairs in one plane; crossed pairs: each across "
                     "the last; whorled: several a node.")},
        ParamUnit::None, {}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::whorl>(
        {"foliage.whorl", foliageGroup, RAMURE_NOOP("Leaves per node"),
         RAMURE_NOOP("How many leaves of a whorl stand around the twig.")},
        ParamUnit::Count, {1, 24, 3, 12, 1, 0}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::angle>(
        {"foliage.leafAngle", foliageGroup, RAMURE_NOOP("Angle to the twig"),
         RAMURE_NOOP("Between the twig and a petiole before it droops: 0 lies along the twig, a quarter turn stands away.")},
        ParamUnit::Radian, {0, pi, 0.2, pi / 2, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::droop>(
        {"foliage.leafDroop", foliageGroup, RAMURE_NOOP("Droop"),
         RAMURE_NOOP("How far the weight of a leaf pulls it down: 0 keeps the angle to the twig, 1 lets it hang.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Foliage, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::light>(
        {"foliage.leafLight", foliageGroup, RAMURE_NOOP("To the light"),
         RAMURE_NOOP("How far a petiole twists to turn the upper side of its leaf to the sky: 0 not at all, 1 as far as it "
                     "goes.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::size>(
        {"foliage.leafSize", foliageGroup, RAMURE_NOOP("Leaf size"),
         RAMURE_NOOP("1 as the plant has it on a tree with such a trunk; 0 leaves the twigs bare.")},
        ParamUnit::Factor, {0, 100, 0.2, 3, 0.05, 3}, Stage::Foliage, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::variation>(
        {"foliage.leafVariation", foliageGroup, RAMURE_NOOP("Size varies"),
         RAMURE_NOOP("How far one leaf may be larger or smaller than the others.")},
        ParamUnit::Share, {0, 0.9, 0, 0.6, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::width>(
        {"foliage.leafWidth", foliageGroup, RAMURE_NOOP("Leaf width"),
         RAMURE_NOOP("1 as the plant has it, more makes broader leaves. Leaflets end where their neighbours begin.")},
        ParamUnit::Factor, {0.05, 2, 0.3, 2, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::petiole>(
        {"foliage.petiole", foliageGroup, RAMURE_NOOP("Petiole"),
         RAMURE_NOOP("Length of the stalk between bark and blade: 1 as the plant has it, 0 none.")},
        ParamUnit::Factor, {0, 10, 0, 3, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::fold>(
        {"foliage.leafFold", foliageGroup, RAMURE_NOOP("Fold"),
         RAMURE_NOOP("How far both halves of a blade rise from its midrib.")},
        ParamUnit::Radian, {0, 1.3, 0, 1.2, 0.05, 3}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::curl>(
        {"foliage.leafCurl", foliageGroup, RAMURE_NOOP("Curl"),
         RAMURE_NOOP("How far a blade bends down from its foot to its tip, or up where it is negative.")},
        ParamUnit::Radian, {-pi / 2, pi, -0.5, 2, 0.05, 3}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::cup>(
        {"foliage.leafCup", foliageGroup, RAMURE_NOOP("Cup"),
         RAMURE_NOOP("1 hollows a blade like a spoon, -1 arches it, 0 leaves its halves even.")},
        ParamUnit::Ratio, {-1, 1, -1, 1, 0.05, 3}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::detail>(
        {"foliage.leafDetail", foliageGroup, RAMURE_NOOP("Leaf detail"),
         RAMURE_NOOP("1 draws a leaf with the fewest triangles, 3 with the smoothest outline.")},
        ParamUnit::Count, {1, 3, 1, 3, 1, 0}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::foliage, &FoliageParams::applesProbability>(
        {"foliage.applesProbability", foliageGroup, RAMURE_NOOP("Apples"),
         RAMURE_NOOP("The chance that a branch which is thin enough carries an apple: 0 for none, 1 for one on each.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.01, 3}, Stage::Foliage, paramAnimatable),
    row<&NodeParams::foliage, &FoliageParams::seed>(
        {"foliage.seed", foliageGroup, RAMURE_NOOP("Seed of the leaves"),
         RAMURE_NOOP("Another seed arranges leaves and apples anew; the branches stay as they are.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Foliage, paramSeed),

    row<&NodeParams::bark, &BarkParams::family>(
        {"bark.family", barkGroup, RAMURE_NOOP("Bark"),
         RAMURE_NOOP("What the bark looks like. Its picture is made by the program and repeats without a seam.")},
        ParamUnit::None, {}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::depth>(
        {"bark.depth", barkGroup, RAMURE_NOOP("Depth"),
         RAMURE_NOOP("How deep cracks and furrows look: 1 as is usual for this bark, 0 flat.")},
        ParamUnit::Ratio, {0, 5, 0, 2, 0.05, 3}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::light>(
        {"bark.light", barkGroup, RAMURE_NOOP("Lighter"),
         RAMURE_NOOP("Makes the bark lighter, or darker where it is negative.")},
        ParamUnit::Share, {-1, 1, -0.5, 0.5, 0.01, 3}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::moss>(
        {"bark.moss", barkGroup, RAMURE_NOOP("Moss"),
         RAMURE_NOOP("How much of the bark moss covers. It begins in the cracks.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 3}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::seed>(
        {"bark.seed", barkGroup, RAMURE_NOOP("Seed of the bark"),
         RAMURE_NOOP("Another seed draws another piece of the same bark.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Texture, paramSeed),
    row<&NodeParams::texture, &TextureParams::tileSize>(
        {"texture.tileSize", barkGroup, RAMURE_NOOP("Bark tile"),
         RAMURE_NOOP("Side of the piece of bark that is repeated. A whole number of them goes around every branch. 0: half "
                     "the way around the trunk, and with plain bark the largest that fits the twigs.")},
        ParamUnit::Metre, {0, 1000, 0, 0.1, 0.001, 4}, Stage::Texture, paramAdvanced),
    row<&NodeParams::texture, &TextureParams::seamsAround>(
        {"texture.seamsAround", barkGroup, RAMURE_NOOP("Seams open at bends"),
         RAMURE_NOOP("On: where a branch bends sharply, the two sides of its seam part, and 95 of 100 triangles keep the "
                     "shape of the picture. Off: the picture meets itself along the whole seam, but is stretched at "
                     "bends.")},
        ParamUnit::None, {}, Stage::Texture, paramAdvanced),

    row<&NodeParams::tree, &PlacementParams::translation>(
        {"tree.translation", placementGroup, RAMURE_NOOP("Position"),
         RAMURE_NOOP("Where it stands, measured from its parent.")},
        ParamUnit::Metre, {-1e6, 1e6, -10, 10, 0.1, 3}, Stage::Placement, paramNone, everyKind),
    row<&NodeParams::tree, &PlacementParams::rotation>(
        {"tree.rotation", placementGroup, RAMURE_NOOP("Rotation"),
         RAMURE_NOOP("How it is turned: first about the parent's X axis, then Y, then Z. Y points up.")},
        ParamUnit::Radian, {-200 * pi, 200 * pi, -pi, pi, pi / 180, 4}, Stage::Placement, paramNone, everyKind),
    row<&NodeParams::tree, &PlacementParams::scale>(
        {"tree.scale", placementGroup, RAMURE_NOOP("Scale"),
         RAMURE_NOOP("How large it is along its own axes; 1 is its natural size.")},
        ParamUnit::Ratio, {1e-4, 1e4, 0.1, 10, 0.1, 3}, Stage::Placement, paramNone, everyKind),

    row<&NodeParams::local, &PlacementParams::translation>(
        {"local.translation", localGroup, RAMURE_NOOP("Own position"),
         RAMURE_NOOP("Moves what the node itself shows, but none of its children.")},
        ParamUnit::Metre, {-1e6, 1e6, -10, 10, 0.1, 3}, Stage::Placement, paramAdvanced, shapedKinds),
    row<&NodeParams::local, &PlacementParams::rotation>(
        {"local.rotation", localGroup, RAMURE_NOOP("Own rotation"),
         RAMURE_NOOP("Turns what the node itself shows, but none of its children: first about X, then Y, then Z.")},
        ParamUnit::Radian, {-200 * pi, 200 * pi, -pi, pi, pi / 180, 4}, Stage::Placement, paramAdvanced, shapedKinds),
    row<&NodeParams::local, &PlacementParams::scale>(
        {"local.scale", localGroup, RAMURE_NOOP("Own scale"),
         RAMURE_NOOP("Stretches what the node itself shows, but none of its children.")},
        ParamUnit::Ratio, {1e-4, 1e4, 0.1, 10, 0.1, 3}, Stage::Placement, paramAdvanced, shapedKinds),

    row<&NodeParams::primitive, &PrimitiveParams::shape>(
        {"primitive.shape", primitiveGroup, RAMURE_NOOP("Shape"),
         RAMURE_NOOP("Which solid it is. Cylinders and cones stand on their origin, the others lie about it.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::radius>(
        {"primitive.radius", primitiveGroup, RAMURE_NOOP("Radius"),
         RAMURE_NOOP("Of cylinders, cones and spheres; of a frame cross the thickness of its arrows.")},
        ParamUnit::Metre, {1e-4, 1e4, 0.01, 5, 0.05, 4}, Stage::Mesh, paramAnimatable, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::height>(
        {"primitive.height", primitiveGroup, RAMURE_NOOP("Height"),
         RAMURE_NOOP("Of cylinders and cones along their axis; of a frame cross the length of its arrows.")},
        ParamUnit::Metre, {1e-4, 1e4, 0.01, 5, 0.05, 4}, Stage::Mesh, paramAnimatable, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::size>(
        {"primitive.size", primitiveGroup, RAMURE_NOOP("Size"),
         RAMURE_NOOP("Width, height and depth of a box; of a plane the first and the last.")},
        ParamUnit::Metre, {1e-4, 1e4, 0.01, 5, 0.05, 4}, Stage::Mesh, paramAnimatable, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::sides>(
        {"primitive.sides", primitiveGroup, RAMURE_NOOP("Sides"),
         RAMURE_NOOP("How many sides make a circle. More make it rounder.")},
        ParamUnit::Count, {3, 1024, 3, 64, 1, 0}, Stage::Mesh, paramNone, primitiveOnly),
    row<&NodeParams::primitive, &PrimitiveParams::axis>(
        {"primitive.axis", primitiveGroup, RAMURE_NOOP("Axis"),
         RAMURE_NOOP("Along which of its own axes it stands.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, primitiveOnly),
    row<&NodeParams::surface, &SurfaceParams::color>(
        {"surface.color", surfaceGroup, RAMURE_NOOP("Colour"),
         RAMURE_NOOP("Red, green and blue of the surface, each from 0 to 1.")},
        ParamUnit::None, {0, 1, 0, 1, 0.01, 3}, Stage::Placement, paramAnimatable | paramColor,
        objectKinds | armOnly | terrainOnly),

    row<&NodeParams::physics, &PhysicsParams::mode>(
        {"physics.mode", physicsGroup, RAMURE_NOOP("Mode"),
         RAMURE_NOOP("Robust: damped springs that stay calm for every value. Faithful: the step of the reference, exactly, "
                     "which large values make nervous.")},
        ParamUnit::None, {}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::stepSeconds>(
        {"physics.stepSeconds", physicsGroup, RAMURE_NOOP("Time step"),
         RAMURE_NOOP("How much time passes in each step of the motion. Short steps are more exact and take longer.")},
        ParamUnit::Second, {1e-4, 0.1, 0.002, 0.05, 0.001, 4}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::substeps>(
        {"physics.substeps", physicsGroup, RAMURE_NOOP("Substeps"),
         RAMURE_NOOP("Into how many parts the robust mode divides each step. More follow a quick wind more closely. The "
                     "faithful mode always takes whole steps.")},
        ParamUnit::Count, {1, 64, 1, 8, 1, 0}, Stage::Motion, paramAdvanced),
    row<&NodeParams::physics, &PhysicsParams::gravity>(
        {"physics.gravity", physicsGroup, RAMURE_NOOP("Gravity"),
         RAMURE_NOOP("How heavy everything is: 1 as on Earth, 0 weightless. Apples fall, and branches sag unless the tree starts "
                     "settled.")},
        ParamUnit::Ratio, {0, 100, 0, 3, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::damping>(
        {"physics.damping", physicsGroup, RAMURE_NOOP("Damping"),
         RAMURE_NOOP("What remains of a movement: close to 1 the tree swings for long, at 0 it follows the wind without a "
                     "swing. Robust: what half a swing leaves of it; faithful: what each step leaves of the speed.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.01, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::restitution>(
        {"physics.restitution", physicsGroup, RAMURE_NOOP("Stiffness"),
         RAMURE_NOOP("How strongly branches want back to their place. Stiff ones bend less and swing faster.")},
        ParamUnit::None, {0, 1e6, 0, 5000, 10, 1}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::restFrame>(
        {"physics.restFrame", physicsGroup, RAMURE_NOOP("Back to"),
         RAMURE_NOOP("Where a branch wants back to: the place it has as seen from its parent, or the direction it had in the "
                     "world at first. The faithful mode always takes the world.")},
        ParamUnit::None, {}, Stage::Motion, paramAdvanced),
    row<&NodeParams::physics, &PhysicsParams::settled>(
        {"physics.settled", physicsGroup, RAMURE_NOOP("Starts settled"),
         RAMURE_NOOP("The shape as modelled already hangs under its own weight, and motion starts from rest. Off: the weight "
                     "comes on when motion starts, and branches sag. Only in the robust mode.")},
        ParamUnit::None, {}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::appleMass>(
        {"physics.appleMass", physicsGroup, RAMURE_NOOP("Mass of an apple"),
         RAMURE_NOOP("Added to the branch that carries it. A branch itself counts as many kilograms as the radius of its end "
                     "has metres.")},
        ParamUnit::Kilogram, {0, 100, 0, 1, 0.005, 4}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::windStrength>(
        {"physics.windStrength", physicsGroup, RAMURE_NOOP("Wind"),
         RAMURE_NOOP("How strong the wind is, as a factor: 0 is calm, 1 a gentle breeze of 4 m/s on average. The faithful "
                     "mode multiplies the wind of the reference by it.")},
        ParamUnit::Factor, {0, 100, 0, 3, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::windDirection>(
        {"physics.windDirection", physicsGroup, RAMURE_NOOP("Wind direction"),
         RAMURE_NOOP("Where the wind blows to, about the vertical axis: 0 along X, a quarter turn against Z.")},
        ParamUnit::Radian, {-2 * pi, 2 * pi, -pi, pi, pi / 36, 4}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::windGust>(
        {"physics.windGust", physicsGroup, RAMURE_NOOP("Gusts"),
         RAMURE_NOOP("How much the wind swells and dies down within seconds. Only in the robust mode.")},
        ParamUnit::Ratio, {0, 10, 0, 1, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::windTurbulence>(
        {"physics.windTurbulence", physicsGroup, RAMURE_NOOP("Turbulence"),
         RAMURE_NOOP("How much the wind differs from place to place, quickly, so that twigs flutter. Only in the robust mode.")},
        ParamUnit::Ratio, {0, 10, 0, 1, 0.05, 3}, Stage::Motion, paramAnimatable),
    row<&NodeParams::physics, &PhysicsParams::seed>(
        {"physics.seed", physicsGroup, RAMURE_NOOP("Seed of the wind"),
         RAMURE_NOOP("Another seed gives other gusts and eddies. The same seed always gives the same motion.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Motion, paramSeed),
    row<&NodeParams::physics, &PhysicsParams::appleBounce>(
        {"physics.appleBounce", physicsGroup, RAMURE_NOOP("Apples bounce"),
         RAMURE_NOOP("What the ground gives back of the speed of a fallen apple: 0 it stays where it falls.")},
        ParamUnit::Ratio, {0, 0.95, 0, 0.95, 0.01, 3}, Stage::Motion),
    row<&NodeParams::physics, &PhysicsParams::appleFriction>(
        {"physics.appleFriction", physicsGroup, RAMURE_NOOP("Apple friction"),
         RAMURE_NOOP("How strongly the ground slows a rolling apple: 0 it rolls on for ever.")},
        ParamUnit::Ratio, {0, 10, 0, 2, 0.05, 3}, Stage::Motion),

    row<&NodeParams::skin, &SkinParams::method>(
        {"skin.method", skinGroup, RAMURE_NOOP("Bends"),
         RAMURE_NOOP("How the bark follows moving branches at forks and bends. Rigid: every ring follows one branch. Linear "
                     "blend: smooth, but strong bends get thin. Dual quaternion: smooth, and branches keep their thickness.")},
        ParamUnit::None, {}, Stage::Motion, paramNone, treeOnly | armOnly),

    row<&NodeParams::arm, &ArmParams::follows>(
        {"arm.follows", armGroup, RAMURE_NOOP("Follows the target"),
         RAMURE_NOOP("Inverse kinematics turns the joints until the tip is at the target. Otherwise the angles stay.")},
        ParamUnit::None, {}, Stage::Motion, paramNone, armOnly),
    row<&NodeParams::arm, &ArmParams::target>(
        {"arm.target", armGroup, RAMURE_NOOP("Target"),
         RAMURE_NOOP("Where the tip is to go, in the arm's own space: its foot at 0, Z up.")},
        ParamUnit::Metre, {-1e6, 1e6, -5, 5, 0.1, 3}, Stage::Motion, paramAnimatable, armOnly),
    row<&NodeParams::arm, &ArmParams::jointRadius>(
        {"arm.jointRadius", armGroup, RAMURE_NOOP("Joint size"),
         RAMURE_NOOP("Radius of the spheres at the joints.")},
        ParamUnit::Metre, {0, 1e3, 0, 1, 0.01, 3}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::kind>(
        {"ik.solver", ikGroup, RAMURE_NOOP("Solver"),
         RAMURE_NOOP("Damped least squares keeps to the limits and reaches nearly everything in a few steps. Jacobian transpose "
                     "goes downhill in many small ones.")},
        ParamUnit::None, {}, Stage::Motion, paramNone, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::gain>(
        {"ik.gain", ikGroup, RAMURE_NOOP("Step size"),
         RAMURE_NOOP("Jacobian transpose only: how far each step goes. Too much, and the arm shakes.")},
        ParamUnit::None, {1e-5, 10, 0.001, 0.1, 0.001, 5}, Stage::Motion, paramAdvanced, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::stepsPerTick>(
        {"ik.stepsPerTick", ikGroup, RAMURE_NOOP("Steps"),
         RAMURE_NOOP("Jacobian transpose only: steps for each sixtieth of a second.")},
        ParamUnit::Count, {1, 1000, 1, 50, 1, 0}, Stage::Motion, paramAdvanced, armOnly),
    row<&NodeParams::ik, &ArmSolverParams::tolerance>(
        {"ik.tolerance", ikGroup, RAMURE_NOOP("Tolerance"),
         RAMURE_NOOP("Nearer than this, the target counts as reached.")},
        ParamUnit::Metre, {1e-6, 1e3, 1e-5, 0.01, 1e-4, 6}, Stage::Motion, paramAdvanced, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::shown>(
        {"armSkin.shown", armSkinGroup, RAMURE_NOOP("Visible"),
         RAMURE_NOOP("Shows the skin; without it, joints and rods.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::radius>(
        {"armSkin.radius", armSkinGroup, RAMURE_NOOP("Radius"),
         RAMURE_NOOP("Of the cylinder around the arm.")},
        ParamUnit::Metre, {1e-4, 1e3, 0.05, 1, 0.05, 4}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::lengthDivisions>(
        {"armSkin.lengthDivisions", armSkinGroup, RAMURE_NOOP("Divisions along"),
         RAMURE_NOOP("Cells of the skin's grid along the arm.")},
        ParamUnit::Count, {1, 4096, 4, 256, 1, 0}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::radialDivisions>(
        {"armSkin.radialDivisions", armSkinGroup, RAMURE_NOOP("Divisions around"),
         RAMURE_NOOP("Cells of the skin's grid around the arm.")},
        ParamUnit::Count, {3, 1024, 3, 64, 1, 0}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::window>(
        {"armSkin.window", armSkinGroup, RAMURE_NOOP("Blending"),
         RAMURE_NOOP("How far on either side of a joint two segments share the skin; at most half a segment.")},
        ParamUnit::Metre, {0, 1e3, 0, 1, 0.01, 3}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::axis>(
        {"armSkin.axis", armSkinGroup, RAMURE_NOOP("Axis of the mesh"),
         RAMURE_NOOP("Which axis of an object comes to lie along the arm when the arm puts it on: Y for a tree.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, armOnly),
    row<&NodeParams::armSkin, &ArmSkinParams::weights>(
        {"armSkin.weights", armSkinGroup, RAMURE_NOOP("Show weights"),
         RAMURE_NOOP("Colours the skin by the segments that it follows.")},
        ParamUnit::None, {}, Stage::Mesh, paramNone, armOnly),

    row<&NodeParams::terrain, &TerrainParams::seed>(
        {"terrain.seed", terrainGroup, RAMURE_NOOP("Seed of the hills"),
         RAMURE_NOOP("Another seed, another terrain.")},
        ParamUnit::None, {0, maxSeed, 0, 1000, 1, 0}, Stage::Mesh, paramSeed, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::size>(
        {"terrain.size", terrainGroup, RAMURE_NOOP("Size"),
         RAMURE_NOOP("Length of a side.")},
        ParamUnit::Metre, {1e-3, 1e5, 1, 50, 0.5, 3}, Stage::Mesh, paramAnimatable, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::height>(
        {"terrain.height", terrainGroup, RAMURE_NOOP("Height"),
         RAMURE_NOOP("How far the widest hills rise and fall.")},
        ParamUnit::Metre, {-1e4, 1e4, 0, 5, 0.1, 3}, Stage::Mesh, paramAnimatable, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::roughness>(
        {"terrain.roughness", terrainGroup, RAMURE_NOOP("Roughness"),
         RAMURE_NOOP("How high hills of half the width are, compared with the wider ones.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Mesh, paramAnimatable, terrainOnly),
    row<&NodeParams::terrain, &TerrainParams::divisions>(
        {"terrain.divisions", terrainGroup, RAMURE_NOOP("Divisions"),
         RAMURE_NOOP("Cells of the grid along a side.")},
        ParamUnit::Count, {1, 1024, 8, 256, 1, 0}, Stage::Mesh, paramNone, terrainOnly),
};
// clang-format on

} // namespace

std::span<const ParamDef> paramTable()
{
    return table;
}

const ParamDef* findParam(std::string_view key)
{
    const auto found =
        std::ranges::find(table, key, [](const ParamDef& def) { return std::string_view(def.key); });
    return found == table.end() ? nullptr : &*found;
}

ParamId paramId(const ParamDef& def)
{
    return static_cast<ParamId>(&def - table.data());
}

bool hasParam(NodeKind kind, const ParamDef& def)
{
    return (def.kinds & kindBit(kind)) != 0;
}

} // namespace ramure
