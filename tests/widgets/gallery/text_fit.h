/// \file
/// Does every text of a window, and every arrow of its spin boxes, have the room it needs? Texts that are
/// shortened with an ellipsis on purpose say so in their tool tip and are left out.
#pragma once

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QStyleOptionSpinBox>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

namespace ramure::test {

/// What is to be seen of a widget, cut by everything around it; what can be scrolled into sight counts as
/// seen.
inline QRect seenOf(const QWidget* widget)
{
    constexpr int far = 100'000;
    QRect seen(QPoint(0, 0), widget->size());
    bool scrollsAcross = false, scrollsDown = false;
    const QWidget* at = widget;
    for (const QWidget* above = at->parentWidget(); above && !at->isWindow(); above = at->parentWidget()) {
        seen.translate(at->pos());
        const auto* area = qobject_cast<const QAbstractScrollArea*>(above->parentWidget());
        if (area && area->viewport() == above) {
            scrollsDown = scrollsDown || area->verticalScrollBar()->maximum() > 0;
            scrollsAcross = scrollsAcross || (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff &&
                                              area->horizontalScrollBar()->maximum() > 0);
        }
        QRect room = above->rect();
        if (scrollsDown)
            room.adjust(0, -far, 0, far);
        if (scrollsAcross)
            room.adjust(-far, 0, far, 0);
        seen &= room;
        at = above;
    }
    return seen;
}

/// What is wrong with one widget; empty: nothing.
inline QString misfit(const QWidget* widget)
{
    const auto say = [widget](const QString& text, int needed, int there) {
        return QStringLiteral("%1 \"%2\" needs %3 and has %4")
            .arg(QLatin1String(widget->metaObject()->className()), text)
            .arg(needed)
            .arg(there);
    };
    const auto cut = [&](const QString& text) {
        const QRect seen = seenOf(widget);
        if (seen.width() < widget->width())
            return say(text, widget->width(), seen.width()) + QStringLiteral(": cut at the side");
        return seen.height() < widget->height()
                   ? say(text, widget->height(), seen.height()) + QStringLiteral(": cut below or above")
                   : QString();
    };
    if (const auto* label = qobject_cast<const QLabel*>(widget); label && !label->text().isEmpty()) {
        if (label->wordWrap() && label->heightForWidth(label->width()) > label->height())
            return say(label->text(), label->heightForWidth(label->width()), label->height());
        // A word that is wider than its column is cut even where lines wrap.
        const int needed = label->wordWrap() ? label->minimumSizeHint().width() : label->sizeHint().width();
        return needed > label->width() ? say(label->text(), needed, label->width()) : cut(label->text());
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget);
        button && !button->text().isEmpty()) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull())
            return {};
        if (button->text().contains(u'…') && !button->toolTip().isEmpty())
            return {}; // elided, whole in the tool tip
        // Of its padding a button may lose a little, as it does where half pixels are rounded.
        constexpr int spare = 4;
        const int needed = button->minimumSizeHint().width() - spare;
        return needed > button->width() ? say(button->text(), needed, button->width()) : cut(button->text());
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
        QStyleOptionComboBox option;
        option.initFrom(combo);
        const int there =
            combo->style()
                ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo)
                .width();
        const int needed = combo->fontMetrics().horizontalAdvance(combo->currentText());
        return needed > there ? say(combo->currentText(), needed, there) : cut(combo->currentText());
    }
    if (const auto* field = qobject_cast<const QLineEdit*>(widget)) {
        const QString text = field->text().isEmpty() ? field->placeholderText() : field->text();
        const bool isNumber = qobject_cast<const QAbstractSpinBox*>(field->parentWidget());
        if (!isNumber && !field->text().isEmpty())
            return {}; // what somebody wrote may be long: it scrolls
        const int margins = field->textMargins().left() + field->textMargins().right() + 4;
        const int needed = field->fontMetrics().horizontalAdvance(text) + margins;
        return needed > field->width() ? say(text, needed, field->width()) : cut(text);
    }
    if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(widget);
        spin && spin->buttonSymbols() != QAbstractSpinBox::NoButtons) {
        constexpr int arrow = 10; // as in the style sheet
        QStyleOptionSpinBox option;
        option.initFrom(spin);
        option.frame = spin->hasFrame();
        option.buttonSymbols = spin->buttonSymbols();
        option.subControls = QStyle::SC_All;
        for (const QStyle::SubControl part : {QStyle::SC_SpinBoxUp, QStyle::SC_SpinBoxDown}) {
            const QRect there = spin->style()->subControlRect(QStyle::CC_SpinBox, &option, part, spin);
            if (const int least = std::min(there.width(), there.height()); least < arrow)
                return say(QStringLiteral("arrow"), arrow, least);
        }
        return cut(spin->objectName());
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            const int needed = tabs->fontMetrics().horizontalAdvance(tabs->tabText(i));
            if (needed > tabs->tabRect(i).width())
                return say(tabs->tabText(i), needed, tabs->tabRect(i).width());
            if (!tabs->rect().contains(tabs->tabRect(i)))
                return say(tabs->tabText(i), tabs->tabRect(i).right() + 1, tabs->width());
        }
        return {};
    }
    if (const auto* header = qobject_cast<const QHeaderView*>(widget); header && header->model()) {
        for (int i = 0; i < header->count(); ++i) {
            if (header->isSectionHidden(i) || header->orientation() == Qt::Vertical)
                continue;
            const QString text = header->model()->headerData(i, Qt::Horizontal).toString();
            const int needed = header->fontMetrics().size(0, text).width(); // of its lines
            if (needed > header->sectionSize(i))
                return say(text, needed, header->sectionSize(i));
        }
    }
    return {};
}

/// Among tabbed docks only one is to be seen; the others stand beside the window.
inline bool isBehindATab(const QWidget* widget)
{
    for (const QWidget* at = widget; at && !at->isWindow(); at = at->parentWidget())
        if (qobject_cast<const QDockWidget*>(at) && !at->parentWidget()->rect().intersects(at->geometry()))
            return true;
    return false;
}

/// Of everything visible in a window; what Qt itself makes (scroll bars, its own file dialog) is left alone.
inline QStringList misfits(const QWidget* window)
{
    QStringList found;
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
        if (!widget->isVisibleTo(window) || isBehindATab(widget))
            continue;
        if (const QString wrong = misfit(widget); !wrong.isEmpty())
            found += wrong;
    }
    return found;
}

} // namespace ramure::test
