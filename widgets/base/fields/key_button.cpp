#include "widgets/base/fields/key_button.h"

#include "widgets/base/theme/icons.h"
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

QIcon keyIcon(KeyState state)
{
    return icon(state == KeyState::Here       ? "key-here"
                : state == KeyState::Animated ? "key-animated"
                                              : "key-none");
}

} // namespace ramure
