#include "widgets/panels/scene/scene_tree.h"

#include "widgets/panels/scene/scene_model.h"
#include <QDropEvent>
#include <QHeaderView>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QTimer>
#include <algorithm>

namespace ramure {
namespace {

constexpr float pointedTint = 0.3f;
constexpr int shortestName = 14; ///< characters of average width that a name always has

} // namespace

SceneTree::SceneTree(QWidget* parent)
    : QTreeView(parent)
    , m_fitTimer(new QTimer(this))
{
    setUniformRowHeights(true); // 10,000 rows are laid out without measuring each
    setSelectionMode(ExtendedSelection);
    setDragDropMode(DragDrop);
    setDefaultDropAction(Qt::MoveAction);
    setEditTriggers(EditKeyPressed);
    setExpandsOnDoubleClick(false);
    setIndentation(12);
    setAllColumnsShowFocus(true);
    setHorizontalScrollMode(ScrollPerPixel);
    setAutoScroll(true);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(24);
    header()->setStretchLastSection(false);
    header()->setContextMenuPolicy(Qt::CustomContextMenu);
    // Of the rows in sight: measuring thousands would cost more than it tells.
    header()->setResizeContentsPrecision(0);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setMouseTracking(true);
    connect(this, &QTreeView::entered, this, &SceneTree::pointed);
    connect(this, &QTreeView::viewportEntered, this, [this] { emit pointed({}); });

    // The names get what the other columns leave, and more where what is in sight stands deep; then the view
    // scrolls sideways. Measured once the view has laid out its rows.
    m_fitTimer->setSingleShot(true);
    m_fitTimer->setInterval(0);
    connect(m_fitTimer, &QTimer::timeout, this, [this] { fitNames(std::exchange(m_mayShrink, false)); });
    const auto anew = [this] {
        m_mayShrink = true;
        m_fitTimer->start();
    };
    connect(this, &QTreeView::expanded, this, anew);
    connect(this, &QTreeView::collapsed, this, anew);
    connect(header(), &QHeaderView::sectionResized, this, [this](int section) {
        if (section != SceneModel::NameColumn)
            m_fitTimer->start();
    });
    // While scrolling the column only grows: a breathing one would be no rest for the eye.
    connect(verticalScrollBar(), &QScrollBar::valueChanged, m_fitTimer, qOverload<>(&QTimer::start));
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, m_fitTimer, qOverload<>(&QTimer::start));
}

void SceneTree::prepareColumns()
{
    header()->setSectionResizeMode(QHeaderView::Interactive);
    header()->setSectionResizeMode(SceneModel::NameColumn, QHeaderView::Fixed);
    for (const int column : {SceneModel::VisibleColumn, SceneModel::LockedColumn}) {
        header()->setSectionResizeMode(column, QHeaderView::Fixed);
        header()->resizeSection(column, 26);
    }
    m_fitTimer->start();
}

void SceneTree::fitNames(bool mayShrink)
{
    if (!model())
        return;
    const int present = header()->sectionSize(SceneModel::NameColumn);
    const int others = header()->length() - present;
    const int least = fontMetrics().averageCharWidth() * shortestName;
    int width = std::max({viewport()->width() - others, least, sizeHintForColumn(SceneModel::NameColumn)});
    if (!mayShrink && header()->length() > viewport()->width())
        width = std::max(width, present);
    if (width != present)
        header()->resizeSection(SceneModel::NameColumn, width);
}

void SceneTree::setEmptyText(const QString& text)
{
    m_emptyText = text;
    viewport()->update();
}

void SceneTree::paintEvent(QPaintEvent* event)
{
    QTreeView::paintEvent(event);
    const bool isEmpty = model() && model()->rowCount() == 0;
    if (const QString said = isEmpty ? m_emptyText : QString(); said != accessibleDescription())
        setAccessibleDescription(said);
    if (!isEmpty || m_emptyText.isEmpty())
        return;
    constexpr int margin = 24;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(margin, margin, -margin, -margin),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_emptyText);
}

void SceneTree::setPointed(const QModelIndex& index)
{
    if (m_pointed == index)
        return;
    for (const QModelIndex& each : {QModelIndex(m_pointed), index}) {
        const QRect row = visualRect(each);
        viewport()->update(0, row.top(), viewport()->width(), row.height());
    }
    m_pointed = index;
}

void SceneTree::leaveEvent(QEvent* event)
{
    emit pointed({});
    QTreeView::leaveEvent(event);
}

void SceneTree::drawRow(QPainter* painter, const QStyleOptionViewItem& options,
                        const QModelIndex& index) const
{
    if (m_pointed.isValid() && index.siblingAtColumn(0) == m_pointed) {
        QColor tint = palette().color(QPalette::Highlight);
        tint.setAlphaF(pointedTint);
        painter->fillRect(options.rect, tint);
    }
    QTreeView::drawRow(painter, options, index);
}

void SceneTree::resizeEvent(QResizeEvent* event)
{
    QTreeView::resizeEvent(event);
    m_mayShrink = true;
    m_fitTimer->start();
}

void SceneTree::changeEvent(QEvent* event)
{
    QTreeView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        m_fitTimer->start();
}

QModelIndex SceneTree::stateAt(const QMouseEvent* event) const
{
    const QModelIndex index = indexAt(event->position().toPoint());
    if (event->button() != Qt::LeftButton || !index.data(SceneModel::isSwitchRole).toBool())
        return {};
    return index;
}

void SceneTree::tellDragged(Qt::KeyboardModifiers modifiers, bool always)
{
    const bool keepsWorld = !modifiers.testFlag(Qt::ShiftModifier);
    if (!always && keepsWorld == m_keepsWorld)
        return;
    m_keepsWorld = keepsWorld;
    emit dragged(keepsWorld);
}

void SceneTree::dragEnterEvent(QDragEnterEvent* event)
{
    QTreeView::dragEnterEvent(event);
    if (event->isAccepted())
        tellDragged(event->modifiers(), true);
}

void SceneTree::dragMoveEvent(QDragMoveEvent* event)
{
    tellDragged(event->modifiers(), false);
    QTreeView::dragMoveEvent(event);
}

void SceneTree::dropEvent(QDropEvent* event)
{
    tellDragged(event->modifiers(), false);
    QTreeView::dropEvent(event);
}

void SceneTree::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && state() != EditingState && currentIndex().isValid()) {
        emit frameRequested();
        event->accept();
        return;
    }
    m_adding = event->modifiers().testFlag(Qt::ControlModifier);
    QTreeView::keyPressEvent(event);
    m_adding = false;
}

void SceneTree::mousePressEvent(QMouseEvent* event)
{
    const QModelIndex index = stateAt(event);
    if (index.isValid()) {
        emit stateClicked(index);
        return;
    }
    if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier &&
        !indexAt(event->position().toPoint()).isValid())
        emit nothingClicked();
    m_adding = event->modifiers().testFlag(Qt::ControlModifier);
    QTreeView::mousePressEvent(event);
    m_adding = false;
}

void SceneTree::mouseReleaseEvent(QMouseEvent* event)
{
    m_adding = event->modifiers().testFlag(Qt::ControlModifier);
    QTreeView::mouseReleaseEvent(event);
    m_adding = false;
}

void SceneTree::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (stateAt(event).isValid()) {
        mousePressEvent(event);
        return;
    }
    QTreeView::mouseDoubleClickEvent(event);
    const QModelIndex index = indexAt(event->position().toPoint());
    if (!index.isValid() || event->button() != Qt::LeftButton)
        return;
    if (index.column() == SceneModel::NameColumn && (model()->flags(index) & Qt::ItemIsEditable))
        edit(index);
    else
        emit frameRequested();
}

} // namespace ramure
