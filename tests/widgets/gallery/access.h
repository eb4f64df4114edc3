/// \file
/// Can everybody use a window: has every control a name that a screen reader says, does Tab lead to it, and
/// has every text that is not greyed a contrast of 4.5 : 1 (WCAG 2.1, 1.4.3)?
#pragma once

#include "tests/widgets/gallery/text_fit.h"
#include <QAbstractItemView>
#include <QAccessible>
#include <QFileDialog>
#include <QMenu>
#include <QPaintEngine>
#include <QPlainTextEdit>
#include <QSlider>
#include <QTextEdit>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace ramure::test {

inline double luminance(const QColor& colour)
{
    const auto linear = [](double s) {
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

inline double contrastOf(const QColor& a, const QColor& b)
{
    const double lighter = std::max(luminance(a), luminance(b)),
                 darker = std::min(luminance(a), luminance(b));
    return (lighter + 0.05) / (darker + 0.05);
}

struct DrawnText
{
    QString text;
    QRectF box; ///< in the widget
    QColor colour;
};

/// Keeps the texts that are painted on it, and nothing else.
class TextRecorder : public QPaintDevice
{
public:
    explicit TextRecorder(QSize size)
        : m_size(size)
    {
    }
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &m_engine; }
    [[nodiscard]] const std::vector<DrawnText>& texts() const { return m_engine.texts; }

protected:
    int metric(PaintDeviceMetric which) const override
    {
        switch (which) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmDepth:
            return 32;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        case PdmDevicePixelRatioScaled:
            return int(devicePixelRatioFScale());
        default:
            return 1;
        }
    }

private:
    class Engine : public QPaintEngine
    {
    public:
        Engine()
            : QPaintEngine(AllFeatures)
        {
        }
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState&) override {}
        void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
        void drawPath(const QPainterPath&) override {}
        void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
        void drawTextItem(const QPointF& at, const QTextItem& item) override
        {
            QRectF box(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
            const QRect inner = box.toAlignedRect().adjusted(1, 1, -1, -1);
            const QRegion seen = painter()->hasClipping() ? painter()->clipRegion() & inner : QRegion(inner);
            if (seen != QRegion(inner)) // of a selected text, each part is drawn without the other
                box = QRectF(seen.boundingRect());
            if (box.isEmpty())
                return;
            QColor colour = painter()->pen().color();
            colour.setAlphaF(float(colour.alphaF() * painter()->opacity()));
            texts.push_back({item.text(), painter()->combinedTransform().mapRect(box), colour});
        }
        [[nodiscard]] Type type() const override { return User; }
        std::vector<DrawnText> texts;
    };
    QSize m_size;
    mutable Engine m_engine;
};

/// Is what stands at a point of a widget greyed?
inline bool isGreyed(const QWidget* widget, QPoint at)
{
    if (!widget->isEnabled())
        return true;
    if (const auto* menu = qobject_cast<const QMenu*>(widget)) {
        const QAction* action = menu->actionAt(at);
        return !action || !action->isEnabled(); // none: the entry is scrolled out of sight
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
        return tabs->tabAt(at) >= 0 && !tabs->isTabEnabled(tabs->tabAt(at));
    const auto* view = qobject_cast<const QAbstractItemView*>(widget->parentWidget());
    const QModelIndex index = view && view->viewport() == widget ? view->indexAt(at) : QModelIndex();
    return index.isValid() && !index.flags().testFlag(Qt::ItemIsEnabled);
}

/// The colour that most of a part has: what a text stands on.
inline QColor groundOf(const QImage& picture, const QRect& part)
{
    std::map<QRgb, int> counts;
    const QRect seen = part & picture.rect();
    for (int y = seen.top(); y <= seen.bottom(); ++y)
        for (int x = seen.left(); x <= seen.right(); ++x)
            ++counts[picture.pixel(x, y)];
    const auto most = std::ranges::max_element(counts, {}, &std::pair<const QRgb, int>::second);
    return most == counts.end() ? QColor() : QColor(most->first);
}

inline QColor over(const QColor& ground, const QColor& colour)
{
    const double share = colour.alphaF();
    const auto mix = [share](double under, double above) { return float(under + share * (above - under)); };
    return QColor::fromRgbF(mix(ground.redF(), colour.redF()), mix(ground.greenF(), colour.greenF()),
                            mix(ground.blueF(), colour.blueF()));
}

inline QString nameOf(const QWidget* widget)
{
    QString name = QLatin1String(widget->metaObject()->className());
    for (const QWidget* at = widget; at && !at->isWindow(); at = at->parentWidget())
        if (!at->objectName().isEmpty())
            return name + (at == widget ? u'#' : u'<') + at->objectName();
    return name;
}

inline void findFaintTexts(const QWidget* widget, const QWidget* window, const QImage& picture,
                           QStringList& found)
{
    constexpr double least = 4.5;
    const double ratio = picture.devicePixelRatio();
    TextRecorder recorder(widget->size());
    const_cast<QWidget*>(widget)->render(&recorder, QPoint(), QRegion(), QWidget::RenderFlags());
    const std::vector<DrawnText>& texts = recorder.texts();
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        const DrawnText& drawn = *it;
        const auto hides = [&](const DrawnText& later) {
            return later.box.adjusted(1.0, 1.0, -1.0, -1.0).intersects(drawn.box);
        };
        if (std::any_of(it + 1, texts.end(), hides)) // such as what is selected, which is drawn once more
            continue;
        const QRectF room(widget->visibleRegion().boundingRect()), seen = drawn.box & room;
        if (seen.isEmpty() || drawn.text.trimmed().isEmpty() || isGreyed(widget, seen.center().toPoint()))
            continue;
        constexpr double around = 3.0; // most of a thin letter's own place is the letter
        const QRectF place = seen.adjusted(-around, 0.0, around, 0.0) & room;
        const QPointF origin = widget->mapTo(window, QPoint(0, 0));
        const QRectF part((place.topLeft() + origin) * ratio, place.size() * ratio);
        const QColor ground = groundOf(picture, part.toRect());
        if (!ground.isValid())
            continue;
        const QColor colour = over(ground, drawn.colour);
        if (const double there = contrastOf(colour, ground); there < least)
            found += QStringLiteral("%1 \"%2\": %3 on %4 has a contrast of %5")
                         .arg(nameOf(widget), drawn.text, colour.name(), ground.name())
                         .arg(there, 0, 'f', 2);
    }
}

/// What a hand or a key can do something with; not the parts that Qt makes for itself.
inline bool isControl(const QWidget* widget)
{
    const QWidget* above = widget->parentWidget();
    if (widget->inherits("QDockWidgetTitleButton") || widget->objectName().startsWith(QLatin1String("qt_")) ||
        qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget) ||
        qobject_cast<const QLineEdit*>(above) || qobject_cast<const QComboBox*>(above) ||
        qobject_cast<const QAbstractSpinBox*>(above) || qobject_cast<const QTabBar*>(above))
        return false;
    if (const auto* label = qobject_cast<const QLabel*>(widget)) // a text to be copied is no control
        return label->text().contains(QLatin1String("<a "));
    return widget->focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(widget) ||
           qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTextEdit*>(widget) ||
           qobject_cast<const QPlainTextEdit*>(widget);
}

/// Of everything that is visible in a window.
inline QStringList inaccessible(QWidget* window)
{
    QStringList found;
    const QImage picture = window->grab().toImage();
    std::set<const QWidget*> chain;
    for (const QWidget* at = window; chain.insert(at).second;)
        at = at->nextInFocusChain();
    QList<QWidget*> all = window->findChildren<QWidget*>();
    all += window;
    for (QWidget* widget : all) {
        if (!widget->isVisibleTo(window) || isBehindATab(widget))
            continue;
        findFaintTexts(widget, window, picture, found);
        if (widget == window || qobject_cast<QFileDialog*>(window) || !widget->isEnabled() ||
            !isControl(widget))
            continue;
        const auto* face = QAccessible::queryAccessibleInterface(widget);
        if (!qobject_cast<QTabBar*>(widget) && (!face || face->text(QAccessible::Name).trimmed().isEmpty()))
            found += nameOf(widget) + QStringLiteral(": no accessible name");
        const QWidget* taker = widget->focusProxy() ? widget->focusProxy() : widget;
        if (!(taker->focusPolicy() & Qt::TabFocus) || !chain.contains(taker))
            found += nameOf(widget) + QStringLiteral(": Tab does not lead to it");
    }
    found.removeDuplicates();
    return found;
}

} // namespace ramure::test
