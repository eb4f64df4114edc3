/// \file
/// The tools with which a hand shapes trees in the view: which of them is chosen, and what its options are.
/// Exists also where OpenGL does not.
#pragma once

#include "core/params/tree_edit.h"
#include <QObject>
#include <QVariantMap>
#include <Qt>
#include <span>

namespace ramure {

/// None: clicks select, modifiers bend, and nodes are moved (GizmoSettings::tool).
enum class HandTool : quint8 {
    None,
    Cut,
    Saw,
    Remove,
    Keep,
    Prune,
    Leaves,
    Bend,
    Curl,
    Twist,
    Length,
    Thickness,
    Taper,
    Brush,
    Draw,
    Extend,
    Redraw,
    Graft,
    Move,
    Root,
    Place
};

/// In the tool bar and the menu a line stands between groups.
enum class HandGroup : quint8 { Take, Shape, Grow };

/// A button of the tool bar.
struct HandToolRow
{
    HandTool tool;
    HandGroup group;
    const char* id;   ///< id of its action: "hand.cut"
    const char* text; ///< English, context "Actions", with a mnemonic
    const char* icon;
    QKeyCombination key;
    const char* tip; ///< English, context "Actions"
};
/// In the order of the tool bar; all but None.
std::span<const HandToolRow> handTools();
const HandToolRow& handTool(HandTool tool);

/// The source of a drawn branch's thickness, besides its foot and tip.
enum class DrawBy : quint8 { Even, Pressure, Speed };

/// Saw: cuts along a line, or within an area.
enum class SawWay : quint8 { Line, Rectangle, Lasso };

enum class BrushKind : quint8 {
    Attract,
    Repel,
    Comb,
    Bare, ///< leaves go
    Leafy ///< leaves come back
};

struct HandOptions
{
    SawWay sawWay = SawWay::Line;
    double sawThickest = 0.05; ///< m, radius of the thickest wood that the saw cuts
    bool falls = false;        ///< Cut and Saw: the cut part falls when the physics plays
    double fallsAfter = 0.0;   ///< s
    bool withBelow = true;     ///< Length and Thickness: also for the limbs of the limb
    double curlFrom = 0.0;     ///< share of the limb that stays straight
    double bendReach = 0.0;    ///< m, along the wood below the hand that bows; 0: down to the limb's foot
    BrushKind brush = BrushKind::Comb;
    double brushRadius = 0.0;   ///< m; 0: to suit the tree
    double brushStrength = 0.5; ///< 0..1
    double drawRadius = 0.0;    ///< m, at the foot; 0: to suit the parent
    double drawTip = 0.3;       ///< radius at the tip, of that at the foot
    double drawSmooth = 0.6;    ///< 0: as drawn, 1: very smooth
    bool drawTwigs = true;      ///< twigs grow on the branch, as dense as on those beside it
    DrawBy drawBy = DrawBy::Pressure;
    double graftSize = 1.0; ///< factor
    int copies = 1;         ///< Draw, Graft and Place: so many around the trunk
    bool mirrored = false;  ///< Draw: and once more across the trunk
    EditOrgan organ = EditOrgan::Leaf;
    double organSize = 1.0;        ///< factor
    int symmetryCopies = 1;        ///< an edit of a limb is repeated at so many places around the trunk
    bool symmetryMirrored = false; ///< and at the mirrored ones
    int limbOrder =
        /// If > 0, a click on a twig selects its ancestor of this branch order (1 = grows on the trunk). 0
        /// selects the twig itself.
        0;
    EditShapeKind shape = EditShapeKind::Sphere;
    bool operator==(const HandOptions&) const = default;
};

class HandSettings : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] HandTool tool() const { return m_tool; }
    [[nodiscard]] const HandOptions& options() const { return m_options; }

public slots:
    void setTool(ramure::HandTool tool);
    void setOptions(const ramure::HandOptions& options); ///< held to the ranges of handNumbers()

signals:
    void toolChanged(ramure::HandTool tool);
    void optionsChanged();

private:
    HandTool m_tool = HandTool::None;
    HandOptions m_options;
};

constexpr quint32 toolBit(HandTool tool)
{
    return quint32(1) << quint32(tool);
}

/// A number that the strip over the view shows for a tool.
struct HandNumber
{
    quint32 tools; ///< toolBit of each
    const char* id;
    const char* label; ///< English, context "HandOptions"
    const char* tip;
    double HandOptions::*member;
    double least, most, step;
    int decimals;
    double scale;                       ///< shown = scale * value
    const char* suffix;                 ///< " cm"
    bool HandOptions::*where = nullptr; ///< only where that is chosen; null: always
    const char* atZero = nullptr;       ///< shown in the place of 0; English, context "HandOptions"
};
struct HandCount
{
    quint32 tools; ///< toolBit of each
    const char* id;
    const char* label;
    const char* tip;
    int HandOptions::*member;
    int least, most;
    const char* atZero = nullptr; ///< see HandNumber
};
struct HandFlag
{
    quint32 tools; ///< toolBit of each
    const char* id;
    const char* label;
    const char* tip;
    bool HandOptions::*member;
};
/// One of a few kinds, an enum of HandOptions.
struct HandChoice
{
    quint32 tools; ///< toolBit of each
    const char* id;
    const char* label;
    const char* tip;
    std::span<const char* const> items; ///< English, context "HandOptions"
    int (*chosen)(const HandOptions& options);
    void (*choose)(HandOptions& options, int item);
};
std::span<const HandChoice> handChoices();
std::span<const HandNumber> handNumbers();
std::span<const HandCount> handCounts();
std::span<const HandFlag> handFlags();
/// HandOptions::limbOrder counts.
bool takesLimbs(HandTool tool);

} // namespace ramure
