#include "widgets/panels/presets/picture_button.h"

#include <QApplication>
#include <QDrag>
#include <QHelpEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr int aspectWidth = 8, aspectHeight = 5;
constexpr int margin = 1;
constexpr int nameLines = 2; // names of two words or three are common

QPainterPath starIn(const QRectF& place)
{
    QPainterPath star;
    for (int i = 0; i < 10; ++i) {
        const double angle = (i - 2.5) * std::numbers::pi / 5.0, reach = i % 2 == 0 ? 0.5 : 0.2;
        const QPointF corner =
            place.center() + reach * place.width() * QPointF(std::cos(angle), std::sin(angle));
        i == 0 ? star.moveTo(corner) : star.lineTo(corner);
    }
    star.closeSubpath();
    return star;
}

} // namespace

QRect pictureStarPlace(const QPoint& corner)
{
    constexpr int size = 20, gap = 4;
    return {corner.x() - size - gap, corner.y() + gap, size, size};
}

void paintPictureStar(QPainter& painter, const QRect& place, bool starred)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 120));
    painter.drawEllipse(place);
    const QColor colour = starred ? QColor(0xFF, 0xC8, 0x3D) : QColor(Qt::white);
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(starred ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawPath(starIn(QRectF(place).adjusted(2, 2, -2, -2)));
}

PictureButton::PictureButton(const QString& preset, int width, QWidget* parent)
    : QAbstractButton(parent)
    , m_preset(preset)
    , m_picture(preset.isEmpty() ? QPixmap() : QPixmap(QStringLiteral(":/welcome/%1.png").arg(preset)))
    , m_size(width, width * aspectHeight / aspectWidth)
{
    setFocusPolicy(Qt::TabFocus); // after a click the keys are the view's
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void PictureButton::setPicture(const QPixmap& picture)
{
    m_picture = picture;
    update();
}

void PictureButton::setStar(bool on)
{
    m_hasStar = true;
    m_isStarred = on;
    update();
}

QRect PictureButton::starPlace() const
{
    return pictureStarPlace({m_size.width() + margin, margin});
}

/// The star has a tip of its own, and its press is none of the button's.
bool PictureButton::event(QEvent* event)
{
    const auto* help = event->type() == QEvent::ToolTip ? static_cast<QHelpEvent*>(event) : nullptr;
    if (!help || !m_hasStar || !starPlace().contains(help->pos()))
        return QAbstractButton::event(event);
    QToolTip::showText(help->globalPos(),
                       m_isStarred ? tr("Take it out of the favourites") : tr("Add it to the favourites"),
                       this);
    return true;
}

void PictureButton::mousePressEvent(QMouseEvent* event)
{
    m_pressed = event->pos();
    if (!m_hasStar || !starPlace().contains(m_pressed))
        QAbstractButton::mousePressEvent(event);
}

void PictureButton::mouseReleaseEvent(QMouseEvent* event)
{
    const bool isOnStar = m_hasStar && starPlace().contains(m_pressed);
    if (!isOnStar)
        QAbstractButton::mouseReleaseEvent(event);
    else if (event->button() == Qt::LeftButton && starPlace().contains(event->pos()))
        emit starClicked();
}

void PictureButton::mouseMoveEvent(QMouseEvent* event)
{
    const bool far = (event->pos() - m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (!event->buttons().testFlag(Qt::LeftButton) || !far || m_preset.isEmpty() ||
        (m_hasStar && starPlace().contains(m_pressed)))
        return QAbstractButton::mouseMoveEvent(event);
    setDown(false);
    auto* drag = new QDrag(this);
    auto* named = new QMimeData;
    named->setData(QLatin1String(presetMimeType), m_preset.toUtf8());
    drag->setMimeData(named);
    if (hasPicture())
        drag->setPixmap(m_picture.scaledToWidth(m_size.width() / 2, Qt::SmoothTransformation));
    drag->exec(Qt::CopyAction);
}

QSize PictureButton::sizeHint() const
{
    return {m_size.width() + 2 * margin,
            m_size.height() + textGap + nameLines * fontMetrics().height() + 2 * margin};
}

void PictureButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF place(QPointF(margin, margin), QSizeF(m_size));
    QPainterPath rounded;
    rounded.addRoundedRect(place, cornerRadius, cornerRadius);
    painter.save();
    painter.setClipPath(rounded);
    if (m_picture.isNull())
        painter.fillRect(place, palette().color(QPalette::Base));
    else
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
    if (m_hasStar && (m_isStarred || underMouse()))
        paintPictureStar(painter, starPlace(), m_isStarred);
    painter.setPen(palette().color(QPalette::WindowText));
    const int lineHeight = fontMetrics().height();
    const QRectF below(margin, place.bottom() + textGap, place.width(), nameLines * lineHeight);
    const int wrapped = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
    const bool fits =
        fontMetrics().boundingRect(below.toRect(), wrapped, text()).height() <= below.height() &&
        fontMetrics().boundingRect(below.toRect(), wrapped, text()).width() <= below.width();
    painter.drawText(below, wrapped,
                     fits ? text() : fontMetrics().elidedText(text(), Qt::ElideRight, m_size.width()));
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
