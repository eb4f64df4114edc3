#include "widgets/panels/animation/key_rows_view.h"

#include "widgets/base/theme/icons.h"
#include "widgets/panels/animation/key_texts.h"
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>

namespace ramure {

static constexpr int foldSide = 16;

KeyRowsView::KeyRowsView(KeyModel* model, QScrollBar* scroll, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_scroll(scroll)
{
    connect(scroll, &QScrollBar::valueChanged, this, qOverload<>(&QWidget::update));
    connect(model, &KeyModel::rowsChanged, this, qOverload<>(&QWidget::update));
    connect(model, &KeyModel::selectionChanged, this, qOverload<>(&QWidget::update));
}

int KeyRowsView::rowHeight() const
{
    return fontMetrics().height() + 5;
}

double KeyRowsView::rowTop(std::size_t row) const
{
    return strip + double(row) * rowHeight() - m_scroll->value();
}

std::optional<std::size_t> KeyRowsView::rowAt(double y) const
{
    if (y < strip)
        return {};
    const auto row = static_cast<std::size_t>((y - strip + m_scroll->value()) / rowHeight());
    return row < m_model->rows().size() ? std::optional(row) : std::nullopt;
}

std::pair<std::size_t, std::size_t> KeyRowsView::rowsInSight() const
{
    const auto first = static_cast<std::size_t>(m_scroll->value() / rowHeight());
    const auto count = static_cast<std::size_t>(height() / rowHeight()) + 2;
    return {first, std::min(first + count, m_model->rows().size())};
}

void KeyRowsView::scrollTo(std::size_t row)
{
    const int top = int(row) * rowHeight(), room = height() - strip - rowHeight();
    m_scroll->setValue(std::clamp(m_scroll->value(), top - std::max(0, room), top));
}

QSize KeyRowsView::minimumSizeHint() const
{
    return {80, strip + 2 * rowHeight()};
}

void KeyRowsView::wheelEvent(QWheelEvent* event)
{
    m_scroll->setValue(m_scroll->value() - event->angleDelta().y() * 3 * rowHeight() / 120);
    event->accept();
}

void KeyRowsView::paintRows(QPainter& painter) const
{
    painter.fillRect(rect(), palette().base());
    QColor tint = palette().color(QPalette::WindowText);
    const auto [first, last] = rowsInSight();
    for (std::size_t i = first; i < last; ++i) {
        const KeyRow& row = m_model->rows()[i];
        tint.setAlphaF(row.kind == KeyRow::Kind::Summary ? 0.13f
                       : row.kind == KeyRow::Kind::Node  ? 0.07f
                                                         : 0.f);
        painter.fillRect(QRectF(0.0, rowTop(i), width(), rowHeight() - 1.0), tint);
    }
}

void KeyRowList::setEyes(bool shown)
{
    m_eyes = shown;
    update();
}

QSize KeyRowList::sizeHint() const
{
    return {190, 100};
}

QString KeyRowList::textOf(const KeyRow& row) const
{
    if (row.kind == KeyRow::Kind::Summary)
        return tr("All keys");
    if (row.kind == KeyRow::Kind::Channel)
        return channelText(row.channel);
    const Node* node = m_model->document()->scene().find(row.node);
    return node ? QString::fromStdString(node->name) : QString();
}

QRect KeyRowList::eyeOf(std::size_t row) const
{
    return {width() - foldSide - 6, int(rowTop(row)) + (rowHeight() - foldSide) / 2, foldSide, foldSide};
}

void KeyRowList::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintRows(painter);
    const auto [first, last] = rowsInSight();
    for (std::size_t i = first; i < last; ++i)
        paintRow(painter, i);
    painter.fillRect(QRect(0, 0, width(), strip), palette().base());
}

void KeyRowList::paintRow(QPainter& painter, std::size_t index) const
{
    const KeyRow& row = m_model->rows()[index];
    const double top = rowTop(index);
    int left = 8;
    if (row.kind == KeyRow::Kind::Node) {
        icon(m_model->isFolded(row.node) ? "fold-closed" : "fold-open")
            .paint(&painter, QRect(left, int(top) + (rowHeight() - 12) / 2, 12, 12));
    }
    if (row.kind != KeyRow::Kind::Summary)
        left += foldSide;
    if (row.kind == KeyRow::Kind::Channel) {
        left += 12;
        painter.setPen(Qt::NoPen);
        painter.setBrush(channelColour(row.channel, palette()));
        painter.drawRoundedRect(QRectF(left - 9.0, top + 4.0, 3.0, rowHeight() - 9.0), 1.5, 1.5);
        if (m_eyes)
            icon(m_model->isHidden(row.tracks.front()) ? "eye-off" : "eye").paint(&painter, eyeOf(index));
    }
    QFont bold = font();
    bold.setBold(row.kind != KeyRow::Kind::Channel);
    painter.setFont(bold);
    painter.setPen(palette().color(row.selected.empty() ? QPalette::WindowText : QPalette::Highlight));
    const int room = width() - left - (m_eyes && row.kind == KeyRow::Kind::Channel ? foldSide + 10 : 4);
    painter.drawText(QRectF(left, top, room, rowHeight() - 1.0), Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetrics(bold).elidedText(textOf(row), Qt::ElideRight, room));
}

void KeyRowList::mousePressEvent(QMouseEvent* event)
{
    const auto index = rowAt(event->position().y());
    if (!index)
        return;
    const KeyRow row = m_model->rows()[*index]; // a copy: folding makes new rows
    if (row.kind == KeyRow::Kind::Node && event->position().x() < 8 + foldSide)
        return m_model->setFolded(row.node, !m_model->isFolded(row.node));
    if (m_eyes && row.kind == KeyRow::Kind::Channel && eyeOf(*index).contains(event->pos()))
        return m_model->setHidden(row.tracks.front(), !m_model->isHidden(row.tracks.front()));
    m_model->select(*index, *index, -mostTicks, mostTicks,
                    event->modifiers() & Qt::ShiftModifier ? SelectHow::Toggle : SelectHow::Replace);
    emit rowClicked(*index);
}

void KeyRowList::mouseDoubleClickEvent(QMouseEvent* event)
{
    const auto index = rowAt(event->position().y());
    if (!index || m_model->rows()[*index].kind != KeyRow::Kind::Node)
        return mousePressEvent(event);
    const NodeId node = m_model->rows()[*index].node;
    m_model->setFolded(node, !m_model->isFolded(node));
}

bool KeyRowList::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto index = rowAt(help->pos().y());
    if (!index) {
        QToolTip::hideText();
        return true;
    }
    const KeyRow& row = m_model->rows()[*index];
    QString tip = textOf(row) + QStringLiteral(": ") + tr("%n key(s)", nullptr, int(row.times.size()));
    if (row.kind == KeyRow::Kind::Node)
        tip += QLatin1Char('\n') + tr("Click selects all of them, Shift+click adds; the triangle folds.");
    else if (row.kind == KeyRow::Kind::Channel && m_eyes && eyeOf(*index).contains(help->pos()))
        tip = tr("Show or hide this curve");
    else
        tip += QLatin1Char('\n') + tr("Click selects all of them, Shift+click adds.");
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
}

} // namespace ramure
