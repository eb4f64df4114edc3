#include "widgets/base/fields/key_button.h"

#include "widgets/base/theme/icons.h"
#include <QCoreApplication>
#include <QToolButton>

namespace ramure {

QToolButton* newKeyButton(QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setAutoRaise(true);
    button->setFixedSize(keyButtonSide, keyButtonSide);
    button->setIconSize({16, 16});
    button->setFocusPolicy(Qt::TabFocus);
    button->setObjectName(QStringLiteral("keyButton"));
    button->hide();
    return button;
}

void showKeyState(QToolButton* button, const QString& name, KeyState state)
{
    const bool isHere = state == KeyState::Here, isAnimated = state == KeyState::Animated;
    button->setIcon(icon(isHere ? "key-here" : isAnimated ? "key-animated" : "key-none"));
    const char* const does =
        isHere ? QT_TRANSLATE_NOOP(
                     "KeyButton", "%1 has a key at this frame: a click removes it, another value replaces it")
        : isAnimated
            ? QT_TRANSLATE_NOOP(
                  "KeyButton",
                  "%1 has keys at other frames: a click sets one at this frame, and so does another value")
            : QT_TRANSLATE_NOOP("KeyButton", "%1 has no keys: a click sets the first one, at this frame");
    button->setToolTip(QCoreApplication::translate("KeyButton", does).arg(name));
    button->setAccessibleName(button->toolTip());
}

QString keyToggledText(const QString& name, KeyState before, qint64 frame)
{
    return QCoreApplication::translate(
               "KeyButton",
               before == KeyState::Here
                   ? QT_TRANSLATE_NOOP("KeyButton",
                                       "The key of “%1” at frame %2 is gone: Undo brings it back.")
                   : QT_TRANSLATE_NOOP("KeyButton", "“%1” has a key at frame %2 now: Undo takes it back."))
        .arg(name)
        .arg(frame);
}

} // namespace ramure
