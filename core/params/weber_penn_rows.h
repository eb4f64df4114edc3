/// \file
/// Rows of the generator of Weber and Penn: those of the whole tree and, the same for each, those of its
/// levels. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"
#include "core/params/source_facts.h"

namespace ramure::rows {

inline constexpr Condition* isWeberPenn = [](const NodeParams& p) {
    return p.generator.kind == EditOperation::WeberPenn;
};
/// A tree of Weber and Penn that grows stems of level \p n.
template <std::size_t n>
inline constexpr Condition* hasLevel =
    [](const NodeParams& p) { return isWeberPenn(p) && p.weberPenn.levels > std::int64_t(n); };
inline constexpr Condition* isPruned = [](const NodeParams& p) {
    return isWeberPenn(p) && p.weberPenn.pruneRatio > 0.0;
};
/// The outline of the pruning envelope may also be the shape of the crown.
inline constexpr Condition* hasEnvelope = [](const NodeParams& p) {
    return isPruned(p) || (isWeberPenn(p) && p.weberPenn.shape == CrownShape::Envelope);
};
inline constexpr Condition* hasLobes = [](const NodeParams& p) {
    return isWeberPenn(p) && p.weberPenn.lobes > 0;
};

inline constexpr SourceFacts weberPennFacts{
    EditOperation::WeberPenn, "weberPenn.levels",
    [](const NodeParams& p) { return p.weberPenn.scale * p.weberPenn.level[0].length * p.weberPenn.ratio; },
    [](const NodeParams& p) { return 0.35 * p.weberPenn.scale; }};

/// A text as a template's argument.
template <std::size_t size> struct FixedText
{
    char text[size]{};
    // NOLINTNEXTLINE(google-explicit-constructor): so that a literal is one
    constexpr FixedText(const char (&from)[size])
    {
        for (std::size_t i = 0; i < size; ++i)
            text[i] = from[i];
    }
};

/// "weberPenn.level1.downAngle"
template <std::size_t n, FixedText name>
inline constexpr auto levelKey = [] {
    constexpr std::string_view before = "weberPenn.level";
    std::array<char, before.size() + 2 + sizeof(name.text)> key{};
    std::size_t at = 0;
    for (const char c : before)
        key[at++] = c;
    key[at++] = static_cast<char>('0' + n);
    key[at++] = '.';
    for (const char c : name.text)
        key[at++] = c;
    return key;
}();

inline constexpr const char* weberPennGroup = RAMURE_NOOP("Weber and Penn");
inline constexpr std::array levelGroups{
    RAMURE_NOOP("Level 0: trunk"),
    RAMURE_NOOP("Level 1: limbs"),
    RAMURE_NOOP("Level 2: branches"),
    RAMURE_NOOP("Level 3: twigs"),
};

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
template <auto Member>
constexpr ParamDef wholeRow(const char* key, const char* label, const char* tooltip, ParamUnit unit,
                            const Range& range, std::uint16_t flags = paramNone, Condition* matters = isWeberPenn)
{
    return row<&NodeParams::weberPenn, Member>({key, weberPennGroup, label, tooltip}, unit, range, Stage::Skeleton,
                                               flags, treeOnly, matters);
}

inline constexpr std::array weberPennRows{
    wholeRow<&WeberPennParams::shape>(
        "weberPenn.shape", RAMURE_NOOP("Crown"),
        RAMURE_NOOP("How long limbs are by their height on the trunk: the outline of the crown."),
        ParamUnit::None, {}, paramNumbered),
    wholeRow<&WeberPennParams::scale>(
        "weberPenn.scale", RAMURE_NOOP("Height"),
        RAMURE_NOOP("Size of the tree; the length of the trunk is a share of it."),
        ParamUnit::Metre, {1e-3, 1000, 0.5, 60, 0.1, 3}), // far enough for a slider by ratios
    wholeRow<&WeberPennParams::scaleV>(
        "weberPenn.scaleV", RAMURE_NOOP("Height varies"),
        RAMURE_NOOP("How far the height of one tree may lie from it, by seed."),
        ParamUnit::Metre, {0, 1000, 0, 20, 0.5, 3}),
    wholeRow<&WeberPennParams::baseSize>(
        "weberPenn.baseSize", RAMURE_NOOP("Bare trunk"),
        RAMURE_NOOP("The share of the trunk, from the ground, without limbs."),
        ParamUnit::Share, {0, 0.99, 0, 0.8, 0.01, 3}),
    wholeRow<&WeberPennParams::levels>(
        "weberPenn.levels", RAMURE_NOOP("Levels"),
        RAMURE_NOOP("1: a trunk alone; 2: with limbs; 3: with branches; 4: with twigs."),
        ParamUnit::Count, {1, 4, 1, 4, 1, 0}),
    wholeRow<&WeberPennParams::ratio>(
        "weberPenn.ratio", RAMURE_NOOP("Thickness"),
        RAMURE_NOOP("Radius of the trunk as a share of its length. Leaves and fruit take their size from it too."),
        ParamUnit::Ratio, {1e-4, 1, 0.002, 0.1, 0.001, 4}),
    wholeRow<&WeberPennParams::ratioPower>(
        "weberPenn.ratioPower", RAMURE_NOOP("Thinner branches"),
        RAMURE_NOOP("How much thinner a shorter stem is than the one that carries it: the radii are as this power of the "
                    "lengths."),
        ParamUnit::None, {0, 10, 0.5, 3, 0.05, 3}),
    wholeRow<&WeberPennParams::flare>(
        "weberPenn.flare", RAMURE_NOOP("Flare"),
        RAMURE_NOOP("Extra thickness of the trunk at the ground, as a share of its radius. Negative values make it thinner."),
        ParamUnit::Ratio, {-1, 10, 0, 2, 0.05, 3}),
    wholeRow<&WeberPennParams::lobes>(
        "weberPenn.lobes", RAMURE_NOOP("Lobes"),
        RAMURE_NOOP("Ribs around the trunk. Cross-sections here are round: they get the radius that the ribs have on "
                    "average."),
        ParamUnit::Count, {0, 32, 0, 12, 1, 0}, paramAdvanced),
    wholeRow<&WeberPennParams::lobeDepth>(
        "weberPenn.lobeDepth", RAMURE_NOOP("Depth of lobes"),
        RAMURE_NOOP("How far the ribs stand out, as a share of the trunk's radius."),
        ParamUnit::Ratio, {0, 1, 0, 0.3, 0.01, 3}, paramAdvanced, hasLobes),
    wholeRow<&WeberPennParams::attractionUp>(
        "weberPenn.attractionUp", RAMURE_NOOP("Upwards"),
        RAMURE_NOOP("How strongly branches from the second level on grow towards the sky; negative, towards the ground."),
        ParamUnit::None, {-10, 10, -4, 4, 0.1, 3}),
    wholeRow<&WeberPennParams::clearance>(
        "weberPenn.clearance", RAMURE_NOOP("Ground clearance"),
        RAMURE_NOOP("Limbs that sink to this height continue level, and their twigs end above the ground. At 0 they may grow below the ground."),
        ParamUnit::Metre, {0, 1000, 0, 3, 0.05, 3}),
    wholeRow<&WeberPennParams::pruneRatio>(
        "weberPenn.pruneRatio", RAMURE_NOOP("Pruning"),
        RAMURE_NOOP("How far limbs that reach out of the pruning envelope are shortened to fit: 0 not at all, 1 fully."),
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}),
    wholeRow<&WeberPennParams::pruneWidth>(
        "weberPenn.pruneWidth", RAMURE_NOOP("Envelope width"),
        RAMURE_NOOP("Half the greatest width of the pruning envelope, as a share of the height."),
        ParamUnit::Ratio, {0, 10, 0, 1, 0.01, 3}, paramNone, isPruned),
    wholeRow<&WeberPennParams::pruneWidthPeak>(
        "weberPenn.pruneWidthPeak", RAMURE_NOOP("Widest at"),
        RAMURE_NOOP("Height at which the envelope is widest: 0 at the base of the crown, 1 at its top."),
        ParamUnit::Ratio, {0, 1, 0, 1, 0.01, 3}, paramNone, hasEnvelope),
    wholeRow<&WeberPennParams::prunePowerLow>(
        "weberPenn.prunePowerLow", RAMURE_NOOP("Curve below"),
        RAMURE_NOOP("The outline below the widest place: 1 straight, less full, more hollow."),
        ParamUnit::None, {0, 10, 0, 3, 0.05, 4}, paramAdvanced, hasEnvelope),
    wholeRow<&WeberPennParams::prunePowerHigh>(
        "weberPenn.prunePowerHigh", RAMURE_NOOP("Curve above"),
        RAMURE_NOOP("The outline above the widest place: 1 straight, less full, more hollow."),
        ParamUnit::None, {0, 10, 0, 3, 0.05, 4}, paramAdvanced, hasEnvelope),
};

template <std::size_t n, FixedText name, auto Member>
constexpr ParamDef levelRow(const char* label, const char* tooltip, ParamUnit unit, const Range& range,
                            std::uint16_t flags = paramNone)
{
    return row<&NodeParams::weberPenn, &WeberPennParams::level, n, Member>(
        {levelKey<n, name>.data(), levelGroups[n], label, tooltip}, unit, range, Stage::Skeleton, flags, treeOnly,
        hasLevel<n>);
}

inline constexpr Range turns{-4 * pi, 4 * pi, -pi, pi, pi / 180, 4};

template <std::size_t n> inline constexpr std::array weberPennLevel{
    levelRow<n, "branches", &WeberPennLevel::branches>(
        RAMURE_NOOP("Stems"),
        RAMURE_NOOP("How many stems of this level a full stem of the level below carries; at level 0, how many trunks "
                    "share the foot."),
        ParamUnit::Count, {0, 10000, 0, 100, 1, 0}),
    levelRow<n, "length", &WeberPennLevel::length>(
        RAMURE_NOOP("Length"),
        RAMURE_NOOP("Length as a share of the parent stem's. For the trunk, a share of the tree's height."),
        ParamUnit::Ratio, {0, 100, 0, 2, 0.01, 3}),
    levelRow<n, "lengthV", &WeberPennLevel::lengthV>(
        RAMURE_NOOP("Length varies"),
        RAMURE_NOOP("How far that share may be more or less, by seed."),
        ParamUnit::Ratio, {0, 10, 0, 0.5, 0.01, 3}),
    levelRow<n, "taper", &WeberPennLevel::taper>(
        RAMURE_NOOP("Taper"),
        RAMURE_NOOP("0: a cylinder; 1: a cone to a point; 2: a cylinder with a round end; 3: a chain of spheres. Between them, "
                    "a mixture."),
        ParamUnit::None, {0, 3, 0, 3, 0.05, 3}),
    levelRow<n, "downAngle", &WeberPennLevel::downAngle>(
        RAMURE_NOOP("Angle to the parent"),
        RAMURE_NOOP("Angle between a stem and its parent: 0 continues straight, a quarter turn stands off at a right angle. For the trunk, the angle to the vertical. Negative: to the other side."),
        ParamUnit::Radian, {-pi, pi, 0, pi, pi / 180, 4}),
    levelRow<n, "downAngleV", &WeberPennLevel::downAngleV>(
        RAMURE_NOOP("Angle varies"),
        RAMURE_NOOP("How far that angle may be more or less. Negative: not by chance but by height, more at the lowest "
                    "stem, less at the highest."),
        ParamUnit::Radian, {-pi, pi, -pi / 2, pi / 2, pi / 180, 4}),
    levelRow<n, "rotate", &WeberPennLevel::rotate>(
        RAMURE_NOOP("Turn around"),
        RAMURE_NOOP("From one stem to the next around the one that carries them. Negative: left and right in turns."),
        ParamUnit::Radian, turns),
    levelRow<n, "rotateV", &WeberPennLevel::rotateV>(
        RAMURE_NOOP("Turn varies"),
        RAMURE_NOOP("How far each of these turns may be more or less, by seed."),
        ParamUnit::Radian, {0, pi, 0, pi, pi / 180, 4}),
    levelRow<n, "curveRes", &WeberPennLevel::curveRes>(
        RAMURE_NOOP("Pieces"),
        RAMURE_NOOP("How many pieces a stem bends in."),
        ParamUnit::Count, {1, 64, 1, 20, 1, 0}),
    levelRow<n, "curve", &WeberPennLevel::curve>(
        RAMURE_NOOP("Curve"),
        RAMURE_NOOP("Angle by which a stem bends from its foot to its tip, away from its parent. A negative angle bends it towards the parent."),
        ParamUnit::Radian, turns),
    levelRow<n, "curveBack", &WeberPennLevel::curveBack>(
        RAMURE_NOOP("Curve back"),
        RAMURE_NOOP("If it is not 0, the first half of a stem bends by the curve, the second half by this angle."),
        ParamUnit::Radian, turns),
    levelRow<n, "curveV", &WeberPennLevel::curveV>(
        RAMURE_NOOP("Curve varies"),
        RAMURE_NOOP("How crooked a stem is, by seed. Negative: it winds in a helix of this angle."),
        ParamUnit::Radian, turns),
    levelRow<n, "baseSplits", &WeberPennLevel::baseSplits>(
        RAMURE_NOOP("Splits at the foot"),
        RAMURE_NOOP("Into how many stems more it splits at the end of its first piece."),
        ParamUnit::Count, {0, 20, 0, 6, 1, 0}),
    levelRow<n, "segSplits", &WeberPennLevel::segSplits>(
        RAMURE_NOOP("Splits"),
        RAMURE_NOOP("Into how many stems more it splits at the end of each other piece, on average."),
        ParamUnit::Ratio, {0, 4, 0, 1, 0.05, 3}),
    levelRow<n, "splitAngle", &WeberPennLevel::splitAngle>(
        RAMURE_NOOP("Split angle"),
        RAMURE_NOOP("How far the stems of a split turn away from each other. Leaning stems turn less."),
        ParamUnit::Radian, {0, pi, 0, pi / 2, pi / 180, 4}),
    levelRow<n, "splitAngleV", &WeberPennLevel::splitAngleV>(
        RAMURE_NOOP("Split angle varies"),
        RAMURE_NOOP("How far that angle may be more or less, by seed."),
        ParamUnit::Radian, {0, pi, 0, pi / 2, pi / 180, 4}),
};
// clang-format on

} // namespace ramure::rows
