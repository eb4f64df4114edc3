#include "widgets/dialogs/gesture_keys.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QStringList>

namespace ramure {
namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(GestureKeys)
};

QString named(std::initializer_list<QKeyCombination> keys)
{
    QStringList names;
    for (const QKeyCombination key : keys)
        names << QKeySequence(key).toString(QKeySequence::NativeText);
    return names.join(QStringLiteral(", "));
}

/// A key that is held: named as in combinations.
QString held(Qt::KeyboardModifier key)
{
    const QString with = QKeySequence(QKeyCombination(key, Qt::Key_X)).toString(QKeySequence::NativeText);
    return with.left(with.lastIndexOf(u'X')).chopped(with.endsWith(QLatin1String("+X")) ? 1 : 0);
}

QString mouse(const QString& what, Qt::KeyboardModifier key)
{
    return held(key) + QStringLiteral(" + ") + what;
}

GestureKeys transformKeys()
{
    return {
        Words::tr("While nodes are moved, turned or scaled"),
        {{Words::tr("Along or about one axis; once more: of the other space; a third time: free"),
          named({Qt::Key_X, Qt::Key_Y, Qt::Key_Z})},
         {Words::tr("In the plane across the axis"),
          named({Qt::SHIFT | Qt::Key_X, Qt::SHIFT | Qt::Key_Y, Qt::SHIFT | Qt::Key_Z})},
         {Words::tr("Type metres, degrees (or radians) or the factor"), QStringLiteral("0 … 9  .  ,  −")},
         {Words::tr("The number of the next axis"), named({Qt::Key_Tab})},
         {Words::tr("Take back a digit; without digits the mouse counts again"), named({Qt::Key_Backspace})},
         {Words::tr("In steps, or free of them where steps are on"), held(Qt::ControlModifier)},
         {Words::tr("A tenth as fast"), held(Qt::ShiftModifier)},
         {Words::tr("Done"), named({Qt::Key_Return}) + QStringLiteral(", ") + Words::tr("left click")},
         {Words::tr("Back to where they were"),
          named({Qt::Key_Escape}) + QStringLiteral(", ") + Words::tr("right click")}}};
}

GestureKeys viewKeys()
{
    return {
        Words::tr("In the 3D view"),
        {{Words::tr("Bend a limb, or set the target of an arm"),
          mouse(Words::tr("drag"), Qt::ControlModifier)},
         {Words::tr("Bend a limb with the trunk and the root"),
          mouse(Words::tr("drag"), Qt::ControlModifier) + QStringLiteral(", ") + held(Qt::ShiftModifier)},
         {Words::tr("Menu of the object under the cursor"), Words::tr("right click")},
         {Words::tr("Turn around the target"), mouse(Words::tr("drag"), Qt::AltModifier)},
         {Words::tr("Add to the selection, or take away"), mouse(Words::tr("click"), Qt::ShiftModifier)}}};
}

GestureKeys handKeys()
{
    return {
        Words::tr("While a tree is shaped by hand"),
        {{Words::tr("Factor or angle of the current gesture"), QStringLiteral("0 … 9  .  ,  −")},
         {Words::tr("The same in steps"), mouse(Words::tr("drag"), Qt::ControlModifier)},
         {Words::tr("Copy another limb, with the graft tool"), mouse(Words::tr("click"), Qt::ShiftModifier)},
         {Words::tr("Done"), named({Qt::Key_Return})},
         {Words::tr("Back to how it was; without a gesture: lay the tool down"), named({Qt::Key_Escape})},
         {Words::tr("In the list of edits: earlier or later"),
          named({Qt::ALT | Qt::Key_Up, Qt::ALT | Qt::Key_Down})}}};
}

GestureKeys sheetKeys()
{
    return {Words::tr("While the dope sheet has the focus"),
            {{Words::tr("The key before or behind; with Shift it is added"),
              named({Qt::Key_Left, Qt::Key_Right})},
             {Words::tr("Move the selected keys by a frame; with Shift by ten"),
              named({Qt::ALT | Qt::Key_Left, Qt::ALT | Qt::Key_Right})},
             {Words::tr("The row above or below"), named({Qt::Key_Up, Qt::Key_Down})},
             {Words::tr("Select all keys"), named({Qt::CTRL | Qt::Key_A})},
             {Words::tr("Select the column of the playhead"), named({Qt::Key_K})},
             {Words::tr("Select all before or behind the playhead"),
              named({Qt::Key_BracketLeft, Qt::Key_BracketRight})},
             {Words::tr("Cut, copy, paste at the playhead"),
              named({Qt::CTRL | Qt::Key_X, Qt::CTRL | Qt::Key_C, Qt::CTRL | Qt::Key_V})},
             {Words::tr("Paste at the copied times"), named({Qt::CTRL | Qt::SHIFT | Qt::Key_V})},
             {Words::tr("Duplicate, mirror about the playhead"),
              named({Qt::CTRL | Qt::Key_D, Qt::CTRL | Qt::Key_M})},
             {Words::tr("Delete the selected keys"), named({Qt::Key_Delete})},
             {Words::tr("Zoom in time"), named({Qt::Key_Plus, Qt::Key_Minus})},
             {Words::tr("Show the selected keys, or all"), named({Qt::Key_Home})},
             {Words::tr("Give up the drag, or select no key"), named({Qt::Key_Escape})},
             {Words::tr("Move copies of the keys"), mouse(Words::tr("drag"), Qt::ControlModifier)},
             {Words::tr("Between frames, without snapping"), mouse(Words::tr("drag"), Qt::ShiftModifier)}}};
}

GestureKeys curveKeys()
{
    return {
        Words::tr("While the curve editor has the focus"),
        {{Words::tr("Move the selected keys by a frame; with Shift by ten"),
          named({Qt::Key_Left, Qt::Key_Right})},
         {Words::tr("Move their values by a pixel; with Shift by ten"), named({Qt::Key_Up, Qt::Key_Down})},
         {Words::tr("Select all keys"), named({Qt::CTRL | Qt::Key_A})},
         {Words::tr("Copy, paste at the playhead"), named({Qt::CTRL | Qt::Key_C, Qt::CTRL | Qt::Key_V})},
         {Words::tr("Paste at the copied times"), named({Qt::CTRL | Qt::SHIFT | Qt::Key_V})},
         {Words::tr("Delete the selected keys"), named({Qt::Key_Delete})},
         {Words::tr("Show the selected keys, or all"), named({Qt::Key_Home})},
         {Words::tr("Give up the drag, or select no key"), named({Qt::Key_Escape})},
         {Words::tr("Change values only"), mouse(Words::tr("drag"), Qt::ControlModifier)},
         {Words::tr("Between frames, without snapping"), mouse(Words::tr("drag"), Qt::ShiftModifier)}}};
}

} // namespace

QList<GestureKeys> gestureKeys()
{
    return {transformKeys(), viewKeys(), handKeys(), sheetKeys(), curveKeys()};
}

} // namespace ramure
