#include "widgets/window/hint_line.h"

#include <QEvent>
#include <algorithm>

namespace ramure {

HintLine::HintLine(QWidget* parent)
    : QLabel(parent)
{
    setObjectName(QStringLiteral("hintLine"));
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void HintLine::addSource(QWidget* widget, HintSource* source)
{
    m_entries.push_back({widget, source});
    widget->installEventFilter(this);
    connect(source, &HintSource::changed, this, &HintLine::update);
    connect(source, &HintSource::gestureBegan, this, &HintLine::gestureBegan);
    if (widget->underMouse())
        m_under = source;
    update();
}

QSize HintLine::minimumSizeHint() const
{
    return {0, QLabel::minimumSizeHint().height()};
}

QSize HintLine::sizeHint() const
{
    return minimumSizeHint();
}

bool HintLine::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave || event->type() == QEvent::Hide) {
        const auto entry =
            std::ranges::find_if(m_entries, [watched](const Entry& each) { return each.widget == watched; });
        if (entry != m_entries.end()) {
            if (event->type() == QEvent::Enter)
                m_under = entry->source;
            else if (m_under == entry->source)
                m_under = nullptr;
            update();
        }
    }
    return QLabel::eventFilter(watched, event);
}

void HintLine::update()
{
    const auto gesture = std::ranges::find_if(
        m_entries, [](const Entry& entry) { return entry.source && entry.source->isGesture(); });
    const HintSource* speaker = gesture != m_entries.end() ? gesture->source.data() : m_under.data();
    const QString hint = speaker ? speaker->hint() : QString();
    if (hint == m_hint)
        return;
    m_hint = hint;
    elide();
}

void HintLine::elide()
{
    // What the hand does first stands first: as many whole parts as there is room for.
    static const QString between = QStringLiteral(" · "), more = QStringLiteral(" · …");
    const int room = contentsRect().width();
    QString shown = m_hint;
    for (qsizetype end = m_hint.size(); fontMetrics().horizontalAdvance(shown) > room;) {
        end = end > 0 ? m_hint.lastIndexOf(between, end - 1) : -1;
        if (end <= 0) {
            shown = fontMetrics().elidedText(m_hint, Qt::ElideRight, room);
            break;
        }
        shown = m_hint.left(end) + more;
    }
    setText(shown);
    setToolTip(m_hint == text() ? QString() : m_hint);
    setAccessibleName(m_hint);
}

void HintLine::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    elide();
}

void HintLine::changeEvent(QEvent* event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        elide();
}

} // namespace ramure
