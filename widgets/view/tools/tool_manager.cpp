#include "widgets/view/tools/tool_manager.h"

#include "widgets/view/tools/tool_table.h"
#include <QKeyEvent>
#include <QPainter>

namespace ramure {

ToolManager::ToolManager(ToolContext& context)
    : m_context(context)
    , m_picks(context)
{
    context.picks = &m_picks;
    context.limbs.setShown([&host = context.host](NodeId node) { return host.shownTree(node); });
    for (const ToolMaker make : toolTable)
        m_tools.push_back(make(context));
    QObject::connect(&context.document, &Document::changed, &m_picks, [this](const Change& change) {
        for (const auto& tool : m_tools)
            tool->documentChanged(change);
    });
    QObject::connect(&context.document.history(), &UndoHistory::gestureEnded, &m_picks, [this] { cancel(); });
}

ToolManager::~ToolManager()
{
    m_context.document.disconnect(&m_picks); // a gesture that ends here is no news
    m_context.picks = nullptr;
}

Tool* ToolManager::current() const
{
    const auto found = std::ranges::find_if(m_tools, [](const auto& tool) { return tool->isBusy(); });
    return found == m_tools.end() ? nullptr : found->get();
}

bool ToolManager::hover(ToolPoint point)
{
    point.pressed = point.at;
    m_hovering = nullptr;
    for (const auto& tool : m_tools)
        if (m_hovering)
            tool->leave();
        else if (tool->hover(point))
            m_hovering = tool.get();
    return m_hovering != nullptr;
}

void ToolManager::leave()
{
    m_hovering = nullptr;
    for (const auto& tool : m_tools)
        tool->leave();
}

bool ToolManager::press(ToolPoint point)
{
    point.pressed = m_pressed;
    if (Tool* tool = current()) {
        tool->pressAgain(point);
        return true;
    }
    point.pressed = m_pressed = point.at;
    m_picks.forget();
    for (const auto& tool : m_tools)
        if (tool->press(point)) {
            tool->begin(point.button);
            return true;
        }
    return false;
}

bool ToolManager::doubleClick(const ToolPoint& point)
{
    return !current() &&
           std::ranges::any_of(m_tools, [&](const auto& tool) { return tool->doubleClick(point); });
}

bool ToolManager::move(ToolPoint point)
{
    Tool* tool = current();
    point.pressed = m_pressed;
    if (tool)
        tool->drag(point);
    return tool != nullptr;
}

void ToolManager::release(ToolPoint point)
{
    Tool* tool = current();
    if (!tool || tool->button() != point.button)
        return; // another button; or the gesture has ended without it
    point.pressed = m_pressed;
    tool->end();
    tool->release(point);
}

bool ToolManager::wheel(const ToolPoint& point, double turn)
{
    const auto first = [&](const auto& tool) { return tool->isBusy() || tool->isChosen(); };
    return std::ranges::any_of(m_tools,
                               [&](const auto& tool) { return first(tool) && tool->wheel(point, turn); }) ||
           std::ranges::any_of(m_tools, [&](const auto& tool) { return tool->wheel(point, turn); });
}

bool ToolManager::takesKey(const QKeyEvent& event) const
{
    const Tool* tool = current();
    if (!tool || event.matches(QKeySequence::Undo) || event.matches(QKeySequence::Redo))
        return false; // the document gives up what goes on
    return tool->takesKeys() || (event.key() == Qt::Key_Escape && tool->goesOn());
}

bool ToolManager::key(const QKeyEvent& event, bool pressed)
{
    if (!takesKey(event))
        return false;
    Tool* tool = current();
    if (event.key() != Qt::Key_Escape) {
        tool->key(event, pressed);
    } else if (pressed) {
        cancel();
    }
    return true;
}

/// Where the document has kept or given up the gesture already, the tool finds nothing to take back.
void ToolManager::cancel()
{
    Tool* tool = current();
    if (!tool)
        return;
    tool->end();
    tool->cancel();
}

void ToolManager::focusLost()
{
    if (Tool* tool = current())
        tool->focusLost();
}

void ToolManager::playingStopped()
{
    for (const auto& tool : m_tools)
        tool->playingStopped();
}

void ToolManager::sceneReady()
{
    m_picks.tryAgain();
    for (const auto& tool : m_tools)
        tool->sceneReady();
}

QCursor ToolManager::cursor() const
{
    if (m_hovering)
        return m_hovering->cursor();
    const auto chosen = std::ranges::find_if(m_tools, [](const auto& tool) { return tool->isChosen(); });
    return chosen == m_tools.end() ? QCursor(Qt::ArrowCursor) : (*chosen)->cursor();
}

QString ToolManager::hint(ToolPoint point) const
{
    point.pressed = point.at;
    if (goesOn())
        return current()->hint(point.held);
    for (const auto& tool : m_tools)
        if (const QString hint = tool->hintAt(point); !hint.isEmpty())
            return hint;
    Qt::KeyboardModifier held = Qt::NoModifier;
    for (const Qt::KeyboardModifier each : {Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier})
        if (point.held.testFlag(each))
            held = each;
    ToolOffers offers(held);
    for (const auto& tool : m_tools)
        tool->offer(offers);
    return offers.line();
}

void ToolManager::paint(QPainter& painter, const PickView& view) const
{
    for (auto tool = m_tools.rbegin(); tool != m_tools.rend(); ++tool) {
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        (*tool)->paint(painter, view);
        painter.restore();
    }
}

} // namespace ramure
