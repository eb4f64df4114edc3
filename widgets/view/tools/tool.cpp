#include "widgets/view/tools/tool.h"

#include "widgets/view/tools/pending_pick.h"
#include <QGuiApplication>
#include <QStyleHints>

namespace ramure {

bool ToolPoint::isDrag() const
{
    return (at - pressed).manhattanLength() >= QGuiApplication::styleHints()->startDragDistance();
}

QString ToolOffers::line() const
{
    QStringList parts;
    for (const auto& [place, part] : m_parts)
        parts << part;
    return parts.join(QStringLiteral(" · "));
}

void Tool::begin(Qt::MouseButton button)
{
    m_busy = true;
    m_button = button;
    if (m_context.picks)
        m_context.picks->forget();
    if (goesOn())
        m_context.host.stopFlight();
    m_context.host.updateHint();
    m_context.host.repaint();
}

void Tool::end()
{
    m_busy = false;
    m_button = Qt::NoButton;
    m_context.host.updateHint();
    m_context.host.repaint();
}

bool Tool::wheel(const ToolPoint&, double)
{
    return false;
}

void Tool::key(const QKeyEvent&, bool)
{
}

} // namespace ramure
