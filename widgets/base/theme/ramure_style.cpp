#include "widgets/base/theme/ramure_style.h"

#include "widgets/base/theme/wheel_guard.h"
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QPainter>
#include <QScrollArea>
#include <QSlider>
#include <QStyleFactory>
#include <QTabBar>

namespace ramure {
namespace {

/// Names buttons that show a picture alone, for screen readers, by their tool tips; other names stay.
class TipNames : public QObject
{
public:
    using QObject::QObject;
    static void name(QAbstractButton* button)
    {
        constexpr const char* given = "nameOfTip";
        if (!button->text().isEmpty() || button->accessibleName() != button->property(given).toString())
            return;
        button->setProperty(given, button->toolTip());
        button->setAccessibleName(button->toolTip());
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::ToolTipChange)
            name(static_cast<QAbstractButton*>(watched));
        return false;
    }
};

/// A place in the order of Tab, and a name. A click still leaves the keys where they are. The small buttons
/// within Qt's own fields, tabs and docks are left alone.
void makeAccessible(QAbstractButton* button)
{
    static TipNames names;
    const QWidget* above = button->parentWidget();
    if (qobject_cast<const QTabBar*>(above) || qobject_cast<const QLineEdit*>(above) ||
        button->inherits("QDockWidgetTitleButton"))
        return;
    if (button->focusPolicy() == Qt::NoFocus)
        button->setFocusPolicy(Qt::TabFocus);
    button->installEventFilter(&names);
    TipNames::name(button);
}

} // namespace

RamureStyle::RamureStyle()
    : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion")))
{
}

QPixmap RamureStyle::generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap,
                                         const QStyleOption* option) const
{
    if (mode != QIcon::Disabled)
        return QProxyStyle::generatedIconPixmap(mode, pixmap, option);
    QPixmap faint(pixmap.size());
    faint.setDevicePixelRatio(pixmap.devicePixelRatio());
    faint.fill(Qt::transparent);
    QPainter painter(&faint);
    painter.setOpacity(0.35);
    painter.drawPixmap(0, 0, pixmap);
    return faint;
}

void RamureStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    if (qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
        qobject_cast<QSlider*>(widget))
        guardFromWheel(widget);
    if (auto* button = qobject_cast<QAbstractButton*>(widget))
        makeAccessible(button);
    if (widget->metaObject() == &QScrollArea::staticMetaObject)
        widget->setFocusPolicy(Qt::NoFocus); // what it shows has the keys
}

int RamureStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* data) const
{
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons)
        return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
}

} // namespace ramure
