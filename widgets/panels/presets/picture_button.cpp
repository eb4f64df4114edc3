#include "widgets/panels/presets/picture_button.h"

#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace ramure {
namespace {

constexpr int aspectWidth = 8, aspectHeight = 5;
constexpr int margin = 1;
constexpr int textGap = 5;
constexpr qreal radius = 7.0;

} // namespace

PictureButton::PictureButton(const QString& preset, int width, QWidget* parent)
    : QAbstractButton(parent)
    , m_preset(preset)
    , m_picture(QStringLiteral(":/welcome/%1.png").arg(preset))
    , m_size(width, width * aspectHeight / aspectWidth)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void PictureButton::mousePressEvent(QMouseEvent* event)
{
    m_pressed = event->pos();
    QAbstractButton::mousePressEvent(event);
}

void PictureButton::mouseMoveEvent(QMouseEvent* event)
{
    const bool far = (event->pos() - m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (!event->buttons().testFlag(Qt::LeftButton) || !far)
        return QAbstractButton::mouseMoveEvent(event);
    setDown(false);
    auto* drag = new QDrag(this);
    auto* named = new QMimeData;
    named->setData(QLatin1String(presetMimeType), m_preset.toLatin1());
    drag->setMimeData(named);
    drag->setPixmap(m_picture.scaledToWidth(m_size.width() / 2, Qt::SmoothTransformation));
    drag->exec(Qt::CopyAction);
}

QSize PictureButton::sizeHint() const
{
    return {m_size.width() + 2 * margin, m_size.height() + textGap + fontMetrics().height() + 2 * margin};
}

void PictureButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF place(QPointF(margin, margin), QSizeF(m_size));
    QPainterPath rounded;
    rounded.addRoundedRect(place, radius, radius);
    painter.save();
    painter.setClipPath(rounded);
    painter.drawPixmap(place, m_picture, QRectF(m_picture.rect()));
    if (isDown())
        painter.fillRect(place, QColor(0, 0, 0, 50));
    painter.restore();
    const bool lit = hasFocus() || underMouse();
    QColor line = lit ? palette().color(QPalette::Highlight) : palette().color(QPalette::WindowText);
    if (!lit)
        line.setAlpha(50);
    painter.setPen(QPen(line, lit ? 2.0 : 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(rounded);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF below(margin, place.bottom() + textGap, place.width(), fontMetrics().height());
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, m_size.width()));
}

void PictureButton::enterEvent(QEnterEvent* event)
{
    update();
    QAbstractButton::enterEvent(event);
}

void PictureButton::leaveEvent(QEvent* event)
{
    update();
    QAbstractButton::leaveEvent(event);
}

} // namespace ramure
