#include "widgets/panels/history/history_dock.h"

#include "core/qt/document/document.h"
#include <QAbstractListModel>
#include <QEvent>
#include <QGuiApplication>
#include <QListView>
#include <QPainter>
#include <QPalette>
#include <QStyledItemDelegate>
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

} // namespace

/// The states of the document: before all steps, and after each.
class HistoryModel : public QAbstractListModel
{
public:
    HistoryModel(const QUndoStack* stack, QObject* parent)
        : QAbstractListModel(parent)
        , m_stack(stack)
    {
    }
    /// The stack has changed.
    void follow()
    {
        beginResetModel();
        endResetModel();
    }
    void setStart(const QString& start)
    {
        m_start = start;
        emit dataChanged(index(0), index(0));
    }
    void setDot(const QIcon& dot)
    {
        m_dot = dot;
        emit dataChanged(index(0), index(m_stack->count()));
    }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : m_stack->count() + 1;
    }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
    {
        const int row = index.row();
        if (role == Qt::DisplayRole)
            return row == 0 ? m_start : m_stack->text(row - 1);
        if (role == Qt::DecorationRole && row == m_stack->cleanIndex())
            return m_dot;
        if (role == Qt::ForegroundRole && row > m_stack->index()) // was undone
            return QGuiApplication::palette().color(QPalette::PlaceholderText);
        return {};
    }

private:
    const QUndoStack* m_stack;
    QString m_start;
    QIcon m_dot;
};

namespace {

/// Keeps the place of the dot free.
class StepDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features |= QStyleOptionViewItem::HasDecoration;
        option->decorationSize = {dotSide, dotSide};
    }
};

} // namespace

HistoryDock::HistoryDock(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_model(new HistoryModel(document->undoStack(), this))
    , m_view(new QListView(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    m_view->setModel(m_model);
    m_view->setItemDelegate(new StepDelegate(this));
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setUniformItemSizes(true);
    m_view->setTextElideMode(Qt::ElideMiddle);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusProxy(m_view);
    const QUndoStack* stack = document->undoStack();
    const auto follow = [this, stack] {
        m_model->follow();
        m_view->setCurrentIndex(m_model->index(stack->index()));
    };
    connect(stack, &QUndoStack::indexChanged, this, follow);
    connect(stack, &QUndoStack::cleanChanged, this, follow);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [document, stack](const QModelIndex& current) {
                if (current.isValid() && current.row() != stack->index())
                    document->history().goToStep(current.row());
            });
    follow();
    drawCleanIcon();
    m_model->setStart(tr("Start"));
    m_view->setAccessibleName(tr("History of changes"));
    m_view->setToolTip(tr("Click a step to go back or forth to it. The dot marks the saved state."));
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
    m_model->setDot(icon);
}

void HistoryDock::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        drawCleanIcon();
}

} // namespace ramure
