#include "widgets/view/tools/hand_settings.h"

#include <QtGlobal>
#include <algorithm>

namespace ramure {
namespace {

/// What is done to one limb can be done to those around the trunk.
constexpr quint32 symmetric = toolBit(HandTool::Bend) | toolBit(HandTool::Length) |
                              toolBit(HandTool::Thickness) | toolBit(HandTool::Taper) |
                              toolBit(HandTool::Curl) | toolBit(HandTool::Twist) | toolBit(HandTool::Move) |
                              toolBit(HandTool::Cut) | toolBit(HandTool::Remove) | toolBit(HandTool::Extend) |
                              toolBit(HandTool::Redraw);

/// Where a limb is meant, not a place on it.
constexpr quint32 limbs = toolBit(HandTool::Bend) | toolBit(HandTool::Length) | toolBit(HandTool::Thickness) |
                          toolBit(HandTool::Taper) | toolBit(HandTool::Curl) | toolBit(HandTool::Twist) |
                          toolBit(HandTool::Remove) | toolBit(HandTool::Keep) | toolBit(HandTool::Leaves);

template <auto member> int chosen(const HandOptions& options)
{
    return static_cast<int>(options.*member);
}

template <auto member> void choose(HandOptions& options, int item)
{
    using Kind = std::remove_reference_t<decltype(options.*member)>;
    options.*member = static_cast<Kind>(item);
}

} // namespace

std::span<const HandToolRow> handTools()
{
    using enum HandGroup;
    static constexpr HandToolRow rows[] = {
        {HandTool::Cut, Take, "hand.cut", QT_TRANSLATE_NOOP("Actions", "&Cut"), "hand-cut", Qt::Key_C,
         QT_TRANSLATE_NOOP("Actions", "Cut a branch where you click: the part above disappears, or falls")},
        {HandTool::Saw, Take, "hand.saw", QT_TRANSLATE_NOOP("Actions", "&Saw"), "hand-saw", Qt::Key_Z,
         QT_TRANSLATE_NOOP("Actions", "Draw a line through twigs: all that it crosses is cut there")},
        {HandTool::Remove, Take, "hand.remove", QT_TRANSLATE_NOOP("Actions", "&Remove"), "hand-remove",
         Qt::Key_X, QT_TRANSLATE_NOOP("Actions", "Click a limb: it goes, with all that grows on it")},
        {HandTool::Keep, Take, "hand.keep", QT_TRANSLATE_NOOP("Actions", "&Keep only"), "hand-keep",
         Qt::Key_O,
         QT_TRANSLATE_NOOP(
             "Actions",
             "Click a limb to remove everything except it, its twigs and the wood down to the ground")},
        {HandTool::Prune, Take, "hand.prune", QT_TRANSLATE_NOOP("Actions", "&Prune to a shape"), "hand-prune",
         Qt::Key_P, QT_TRANSLATE_NOOP("Actions", "Drag a shape around the tree: the wood outside it is cut")},
        {HandTool::Leaves, Take, "hand.leaves", QT_TRANSLATE_NOOP("Actions", "L&eaves on or off"),
         "hand-leaves", Qt::Key_V, QT_TRANSLATE_NOOP("Actions", "Click a limb: its leaves go, or come back")},
        {HandTool::Bend, Shape, "hand.bend", QT_TRANSLATE_NOOP("Actions", "&Bend"), "hand-bend", Qt::Key_B,
         QT_TRANSLATE_NOOP("Actions", "Drag a branch: the limb follows the hand")},
        {HandTool::Curl, Shape, "hand.curl", QT_TRANSLATE_NOOP("Actions", "C&url"), "hand-curl", Qt::Key_K,
         QT_TRANSLATE_NOOP("Actions", "Drag a branch to one side: the limb rolls up that way")},
        {HandTool::Twist, Shape, "hand.twist", QT_TRANSLATE_NOOP("Actions", "&Twist"), "hand-twist",
         Qt::Key_Y,
         QT_TRANSLATE_NOOP("Actions", "Drag a branch to the right or left: its twigs turn about it")},
        {HandTool::Length, Shape, "hand.length", QT_TRANSLATE_NOOP("Actions", "&Length"), "hand-length",
         Qt::Key_L, QT_TRANSLATE_NOOP("Actions", "Drag a branch along itself: longer or shorter")},
        {HandTool::Thickness, Shape, "hand.thickness", QT_TRANSLATE_NOOP("Actions", "Thick&ness"),
         "hand-thickness", Qt::Key_U,
         QT_TRANSLATE_NOOP("Actions", "Drag a branch to the right: thicker, to the left: thinner")},
        {HandTool::Taper, Shape, "hand.taper", QT_TRANSLATE_NOOP("Actions", "T&aper"), "hand-taper",
         Qt::SHIFT | Qt::Key_U,
         QT_TRANSLATE_NOOP("Actions",
                           "Drag a branch to the right: its tip gets thicker, to the left: thinner")},
        {HandTool::Brush, Shape, "hand.brush", QT_TRANSLATE_NOOP("Actions", "Brus&h"), "hand-brush",
         Qt::Key_A,
         QT_TRANSLATE_NOOP(
             "Actions",
             "Drag over branches: they are combed, drawn near or pushed away, or lose their leaves")},
        {HandTool::Draw, Grow, "hand.draw", QT_TRANSLATE_NOOP("Actions", "&Draw"), "hand-draw", Qt::Key_D,
         QT_TRANSLATE_NOOP("Actions", "Drag from a branch or the ground: a branch grows along the stroke")},
        {HandTool::Extend, Grow, "hand.extend", QT_TRANSLATE_NOOP("Actions", "E&xtend"), "hand-extend",
         Qt::Key_N, QT_TRANSLATE_NOOP("Actions", "Drag a branch: its tip grows on along the stroke")},
        {HandTool::Redraw, Grow, "hand.redraw", QT_TRANSLATE_NOOP("Actions", "Redra&w"), "hand-redraw",
         Qt::SHIFT | Qt::Key_D,
         QT_TRANSLATE_NOOP("Actions", "Draw over a branch: from there on it goes along the stroke")},
        {HandTool::Graft, Grow, "hand.graft", QT_TRANSLATE_NOOP("Actions", "&Graft"), "hand-graft", Qt::Key_J,
         QT_TRANSLATE_NOOP("Actions", "Click a limb to copy it, then click its new place")},
        {HandTool::Move, Grow, "hand.move", QT_TRANSLATE_NOOP("Actions", "&Move the fork"), "hand-move",
         Qt::Key_M, QT_TRANSLATE_NOOP("Actions", "Drag a branch: its fork slides along its parent")},
        {HandTool::Root, Grow, "hand.root", QT_TRANSLATE_NOOP("Actions", "Move the r&oot"), "hand-root",
         Qt::SHIFT | Qt::Key_M,
         QT_TRANSLATE_NOOP("Actions", "Drag a tree: its foot goes over the ground, and flares by the wheel")},
        {HandTool::Place, Grow, "hand.place", QT_TRANSLATE_NOOP("Actions", "Place a lea&f or fruit"),
         "hand-place", Qt::SHIFT | Qt::Key_V,
         QT_TRANSLATE_NOOP("Actions", "Click a branch: one leaf, fruit or flower grows there")},
    };
    return rows;
}

const HandToolRow& handTool(HandTool tool)
{
    return *std::ranges::find(handTools(), tool, &HandToolRow::tool);
}

std::span<const HandChoice> handChoices()
{
    using enum HandTool;
    static constexpr const char* shapes[] = {
        QT_TRANSLATE_NOOP("HandOptions", "Sphere"), QT_TRANSLATE_NOOP("HandOptions", "Box"),
        QT_TRANSLATE_NOOP("HandOptions", "Cone"), QT_TRANSLATE_NOOP("HandOptions", "Drawn outline"),
        QT_TRANSLATE_NOOP("HandOptions", "Solid of the scene")};
    static constexpr const char* thickness[] = {QT_TRANSLATE_NOOP("HandOptions", "Even"),
                                                QT_TRANSLATE_NOOP("HandOptions", "By pressure"),
                                                QT_TRANSLATE_NOOP("HandOptions", "By speed")};
    static constexpr const char* ways[] = {QT_TRANSLATE_NOOP("HandOptions", "Line"),
                                           QT_TRANSLATE_NOOP("HandOptions", "Rectangle"),
                                           QT_TRANSLATE_NOOP("HandOptions", "Lasso")};
    static constexpr const char* brushes[] = {
        QT_TRANSLATE_NOOP("HandOptions", "Attract"), QT_TRANSLATE_NOOP("HandOptions", "Repel"),
        QT_TRANSLATE_NOOP("HandOptions", "Comb"), QT_TRANSLATE_NOOP("HandOptions", "Leaves off"),
        QT_TRANSLATE_NOOP("HandOptions", "Leaves on")};
    static constexpr const char* organs[] = {QT_TRANSLATE_NOOP("HandOptions", "Leaf"),
                                             QT_TRANSLATE_NOOP("HandOptions", "Fruit"),
                                             QT_TRANSLATE_NOOP("HandOptions", "Flower")};
    static constexpr const char* rests[] = {QT_TRANSLATE_NOOP("HandOptions", "Goes"),
                                            QT_TRANSLATE_NOOP("HandOptions", "Falls")};
    static constexpr HandChoice rows[] = {
        {toolBit(Cut) | toolBit(Saw), "falls", QT_TRANSLATE_NOOP("HandOptions", "What is cut off"),
         QT_TRANSLATE_NOOP(
             "HandOptions",
             "It disappears at once, or it stays in place and falls to the ground when the timeline plays"),
         rests, &chosen<&HandOptions::falls>, &choose<&HandOptions::falls>},
        {toolBit(Place), "organ", QT_TRANSLATE_NOOP("HandOptions", "What"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "Adds a leaf, or a fruit or flower of the kind that the tree bears"),
         organs, &chosen<&HandOptions::organ>, &choose<&HandOptions::organ>},
        {toolBit(Brush), "brush", QT_TRANSLATE_NOOP("HandOptions", "Action"),
         QT_TRANSLATE_NOOP("HandOptions", "Effect of the brush on branches within its radius"), brushes,
         &chosen<&HandOptions::brush>, &choose<&HandOptions::brush>},
        {toolBit(Saw), "sawWay", QT_TRANSLATE_NOOP("HandOptions", "Cut by"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "Cuts along a line, or everything that enters a rectangle or a lasso"),
         ways, &chosen<&HandOptions::sawWay>, &choose<&HandOptions::sawWay>},
        {toolBit(Prune), "pruneShape", QT_TRANSLATE_NOOP("HandOptions", "Shape"),
         QT_TRANSLATE_NOOP("HandOptions", "Everything outside this shape is cut"), shapes,
         &chosen<&HandOptions::shape>, &choose<&HandOptions::shape>},
        {toolBit(Draw) | toolBit(Extend), "drawBy", QT_TRANSLATE_NOOP("HandOptions", "Thickness"),
         QT_TRANSLATE_NOOP(
             "HandOptions",
             "Source of the thickness along the stroke: harder pressure or a slower stroke makes it thicker"),
         thickness, &chosen<&HandOptions::drawBy>, &choose<&HandOptions::drawBy>},
    };
    return rows;
}

std::span<const HandNumber> handNumbers()
{
    using enum HandTool;
    static constexpr HandNumber rows[] = {
        {toolBit(Saw), "sawThickest", QT_TRANSLATE_NOOP("HandOptions", "Up to"),
         QT_TRANSLATE_NOOP("HandOptions", "The saw cuts branches up to this radius"),
         &HandOptions::sawThickest, 0.001, 10.0, 0.005, 1, 100.0, " cm"},
        {toolBit(Cut) | toolBit(Saw), "fallsAfter", QT_TRANSLATE_NOOP("HandOptions", "Delay before falling"),
         QT_TRANSLATE_NOOP("HandOptions", "Time on the timeline before the part comes off"),
         &HandOptions::fallsAfter, 0.0, 86400.0, 0.5, 2, 1.0, " s", &HandOptions::falls},
        {toolBit(Bend), "bendReach", QT_TRANSLATE_NOOP("HandOptions", "Influence"),
         QT_TRANSLATE_NOOP(
             "HandOptions",
             "The length that bends below the mouse, which may extend into the branch that carries the limb. "
             "The wheel changes it while you drag. 0 bends the limb down to its foot"),
         &HandOptions::bendReach, 0.0, 1000.0, 0.1, 2, 1.0, " m", nullptr,
         QT_TRANSLATE_NOOP("HandOptions", "the limb")},
        {toolBit(Curl), "curlFrom", QT_TRANSLATE_NOOP("HandOptions", "From"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "The limb curls above this share of its length and stays as it is below"),
         &HandOptions::curlFrom, 0.0, 0.95, 0.05, 0, 100.0, " %"},
        {toolBit(Brush), "brushRadius", QT_TRANSLATE_NOOP("HandOptions", "Radius"),
         QT_TRANSLATE_NOOP(
             "HandOptions",
             "Radius of the brush; Shift and the wheel change it too. 0 chooses one that suits the tree"),
         &HandOptions::brushRadius, 0.0, 100.0, 0.1, 2, 1.0, " m", nullptr,
         QT_TRANSLATE_NOOP("HandOptions", "to suit")},
        {toolBit(Brush), "brushStrength", QT_TRANSLATE_NOOP("HandOptions", "Strength"),
         QT_TRANSLATE_NOOP("HandOptions", "How far branches turn; the two brushes for leaves ignore it"),
         &HandOptions::brushStrength, 0.0, 1.0, 0.1, 0, 100.0, " %"},
        {toolBit(Draw), "drawRadius", QT_TRANSLATE_NOOP("HandOptions", "Radius"),
         QT_TRANSLATE_NOOP("HandOptions", "Radius at the foot of the new branch. 0 chooses one that suits "
                                          "its length and the branch it grows on"),
         &HandOptions::drawRadius, 0.0, 10.0, 0.005, 1, 100.0, " cm", nullptr,
         QT_TRANSLATE_NOOP("HandOptions", "to suit")},
        {toolBit(Draw) | toolBit(Extend), "drawTip", QT_TRANSLATE_NOOP("HandOptions", "Tip"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "Radius at the tip relative to the radius at the beginning of the stroke"),
         &HandOptions::drawTip, 0.02, 1.0, 0.05, 0, 100.0, " %"},
        {toolBit(Draw) | toolBit(Extend) | toolBit(Redraw), "drawSmooth",
         QT_TRANSLATE_NOOP("HandOptions", "Smoothing"),
         QT_TRANSLATE_NOOP("HandOptions", "How much of the hand’s trembling is removed"),
         &HandOptions::drawSmooth, 0.0, 1.0, 0.1, 0, 100.0, " %"},
        {toolBit(Graft), "graftSize", QT_TRANSLATE_NOOP("HandOptions", "Size"),
         QT_TRANSLATE_NOOP("HandOptions", "Size of the copy relative to the original"),
         &HandOptions::graftSize, 0.05, 20.0, 0.1, 0, 100.0, " %"},
        {toolBit(Place), "organSize", QT_TRANSLATE_NOOP("HandOptions", "Size"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "Size relative to the leaves, fruit or flowers that grow by themselves"),
         &HandOptions::organSize, 0.05, 20.0, 0.1, 0, 100.0, " %"},
    };
    return rows;
}

std::span<const HandCount> handCounts()
{
    using enum HandTool;
    static constexpr HandCount rows[] = {
        {limbs, "limbOrder", QT_TRANSLATE_NOOP("HandOptions", "Limbs up to order"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "If above 0, a click on a twig selects the limb of this order that carries it: 1 "
                           "for limbs of the trunk, 2 for the limbs on those, and so on. 0 selects the "
                           "branch under the mouse. Shift with the wheel changes the number, too"),
         &HandOptions::limbOrder, 0, 20, QT_TRANSLATE_NOOP("HandOptions", "any")},
        {toolBit(Draw) | toolBit(Graft) | toolBit(Place), "copies",
         QT_TRANSLATE_NOOP("HandOptions", "Around the trunk"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "How many grow at once, at equal angles around the branch that carries them"),
         &HandOptions::copies, 1, 24},
        {symmetric, "symmetryCopies", QT_TRANSLATE_NOOP("HandOptions", "Around the trunk"),
         QT_TRANSLATE_NOOP("HandOptions", "The limbs at this many places around the trunk, at equal angles, "
                                          "change too if they are similar"),
         &HandOptions::symmetryCopies, 1, 24},
    };
    return rows;
}

std::span<const HandFlag> handFlags()
{
    using enum HandTool;
    static constexpr HandFlag rows[] = {
        {toolBit(Length) | toolBit(Thickness), "withBelow",
         QT_TRANSLATE_NOOP("HandOptions", "With all that grows on it"),
         QT_TRANSLATE_NOOP("HandOptions", "If off, only the limb itself changes"), &HandOptions::withBelow},
        {toolBit(Draw), "drawTwigs", QT_TRANSLATE_NOOP("HandOptions", "Twigs and leaves"),
         QT_TRANSLATE_NOOP("HandOptions",
                           "Twigs with their leaves grow on the branch, as dense as on the limbs beside it"),
         &HandOptions::drawTwigs},
        {toolBit(Draw), "mirrored", QT_TRANSLATE_NOOP("HandOptions", "Mirrored"),
         QT_TRANSLATE_NOOP("HandOptions", "A second branch grows on the opposite side"),
         &HandOptions::mirrored},
        {symmetric, "symmetryMirrored", QT_TRANSLATE_NOOP("HandOptions", "Mirrored"),
         QT_TRANSLATE_NOOP(
             "HandOptions",
             "The limb on the other side of the trunk, as the view shows it, changes too if it is similar"),
         &HandOptions::symmetryMirrored},
    };
    return rows;
}

bool takesLimbs(HandTool tool)
{
    return (limbs & toolBit(tool)) != 0;
}

void HandSettings::setTool(HandTool tool)
{
    if (m_tool == tool)
        return;
    m_tool = tool;
    emit toolChanged(tool);
}

void HandSettings::setOptions(const HandOptions& options)
{
    HandOptions next = options;
    for (const HandNumber& row : handNumbers())
        next.*row.member = std::clamp(next.*row.member, row.least, row.most);
    for (const HandCount& row : handCounts())
        next.*row.member = std::clamp(next.*row.member, row.least, row.most);
    if (next == m_options)
        return;
    m_options = next;
    emit optionsChanged();
}

} // namespace ramure
