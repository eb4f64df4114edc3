#include "widgets/panels/history/history_dock.h"

#include "core/document/document.h"
#include <QEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QUndoView>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int dotSide = 16;

/// A filled dot in the accent colour: the state that is in the file.
QPixmap cleanDot(const QColor& colour, int side, qreal scale)
{
    QPixmap pixmap(QSize(side, side) * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const qreal radius = side * 0.25;
    painter.drawEllipse(QPointF(side, side) / 2.0, radius, radius);
    return pixmap;
}

/// Rows that keep the place of the dot free, and steps that were undone in a fainter colour.
class StepDelegate : public QStyledItemDelegate
{
public:
    StepDelegate(const QUndoStack* stack, QObject* parent)
        : QStyledItemDelegate(parent)
        , m_stack(stack)
    {
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::HasDecoration;
        option->decorationSize = {dotSide, dotSide};
        if (index.row() > m_stack->index())
            option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
    }

private:
    const QUndoStack* m_stack;
};

} // namespace

HistoryDock::HistoryDock(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_view(new QUndoView(document->undoStack(), this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    m_view->setItemDelegate(new StepDelegate(document->undoStack(), this));
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setUniformItemSizes(true);
    m_view->setTextElideMode(Qt::ElideMiddle);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusProxy(m_view);
    drawCleanIcon();
    retranslate();
}

QSize HistoryDock::sizeHint() const
{
    return {260, 220};
}

void HistoryDock::drawCleanIcon()
{
    QIcon icon;
    for (const qreal scale : {1.0, 1.5, 2.0, 3.0})
        icon.addPixmap(cleanDot(palette().color(QPalette::Highlight), dotSide, scale));
    m_view->setCleanIcon(icon);
}

void HistoryDock::retranslate()
{
    m_view->setEmptyLabel(tr("Start"));
    m_view->setAccessibleName(tr("History of changes"));
    m_view->setToolTip(tr("Click a step to go back or forth to it. The dot marks what is in the file."));
}

void HistoryDock::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        drawCleanIcon();
}

} // namespace ramure
