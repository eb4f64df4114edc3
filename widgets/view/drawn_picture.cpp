#include "widgets/view/drawn_picture.h"

#include "widgets/base/texts/core_text.h"
#include <QMouseEvent>
#include <QPainter>
#include <utility>

namespace ramure {

struct DrawnPicture::Context
{
    OffscreenRenderer renderer; ///< made on the thread of the interface
    bool hasBegun = false;

    Expected<QImage> draw(const Draw& draw, QSize size, int finer, const Progress& progress)
    {
        if (!hasBegun)
            RAMURE_TRY(renderer.begin());
        hasBegun = true;
        auto picture = draw(renderer, finer * size, progress);
        if (!picture || finer == 1)
            return picture;
        return picture->scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
};

DrawnPicture::DrawnPicture(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
}

/// The context ends on the thread that it was made on.
DrawnPicture::~DrawnPicture()
{
    if (!m_context)
        return;
    m_job.start([context = m_context](const Progress&) -> Expected<void> {
        if (std::exchange(context->hasBegun, false))
            context->renderer.end();
        return {};
    });
    m_job.wait(Job::patience);
}

void DrawnPicture::start(Draw draw, int finer, std::function<void()> shown)
{
    const QSize size = (QSizeF(this->size()) * devicePixelRatioF())
                           .toSize()
                           .boundedTo({mostPicturePixels, mostPicturePixels});
    if (size.isEmpty() || !isVisible())
        return;
    if (!m_context)
        m_context = std::make_shared<Context>();
    m_job.start([context = m_context, draw = std::move(draw), size,
                 finer](const Progress& progress) { return context->draw(draw, size, finer, progress); },
                [this, shown = std::move(shown)](Expected<QImage>&& made) {
                    m_problem = made ? QString() : errorText(made.error());
                    if (made)
                        m_picture = std::move(*made);
                    shown();
                    update();
                },
                Job::Running::GoesOn);
}

void DrawnPicture::clear(std::function<void()> forget)
{
    m_picture = {};
    m_problem.clear();
    if (m_context)
        m_job.start([forget = std::move(forget)](const Progress&) -> Expected<void> {
            forget();
            return {};
        });
    update();
}

QPointF DrawnPicture::movedBy(const QMouseEvent& event)
{
    return event.position() - std::exchange(m_last, event.position());
}

void DrawnPicture::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
}

void DrawnPicture::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    redraw();
}

void DrawnPicture::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    redraw();
}

void DrawnPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(),
                     m_picture.isNull() ? palette().color(QPalette::Base) : m_picture.pixelColor(0, 0));
    if (!m_picture.isNull()) { // at its size while that of the window changes
        const QSizeF shown = QSizeF(m_picture.size()) / devicePixelRatioF();
        const QPointF corner(0.5 * (width() - shown.width()), 0.5 * (height() - shown.height()));
        painter.drawImage(QRectF(corner, shown), m_picture);
        painter.save();
        paintOver(painter);
        painter.restore();
    }
    const QString text = m_problem.isEmpty() ? waitText() : m_problem;
    const int above = int(m_problem.isEmpty() ? Qt::AlignBottom : Qt::AlignVCenter);
    if (!text.isEmpty())
        painter.drawText(rect().adjusted(8, 8, -8, -8), above | int(Qt::AlignHCenter) | int(Qt::TextWordWrap),
                         text);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

} // namespace ramure
