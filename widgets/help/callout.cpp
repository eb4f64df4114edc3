#include "widgets/help/callout.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

namespace ramure {
namespace {

constexpr int calloutWidth = 340;
constexpr int arrow = 12; ///< its length; the box keeps so much free around itself
constexpr int edge = 8;   ///< between box and window
constexpr double round = 8.0;

} // namespace

Callout::Callout(QWidget* window)
    : QFrame(window)
    , m_mark(new QFrame(window))
    , m_title(new QLabel(this))
    , m_text(new QLabel(this))
    , m_count(new QLabel(this))
    , m_done(new QLabel(QStringLiteral("✓ ") + tr("Done"), this)) // a mark, not a button
    , m_leave(new QPushButton(tr("Skip"), this))
    , m_back(new QPushButton(tr("Back"), this))
    , m_next(new QPushButton(this))
{
    setObjectName(QStringLiteral("callout"));
    setFocusPolicy(Qt::StrongFocus); // the box, not a button: Space is to be tried out
    m_mark->setObjectName(QStringLiteral("calloutMark"));
    m_mark->setAttribute(Qt::WA_TransparentForMouseEvents);
    build();
    connect(m_leave, &QPushButton::clicked, this, &Callout::leaveRequested);
    connect(m_back, &QPushButton::clicked, this, &Callout::backRequested);
    connect(m_next, &QPushButton::clicked, this, &Callout::nextRequested);
    connect(this, &QObject::destroyed, m_mark, &QObject::deleteLater);
    window->installEventFilter(this);
}

void Callout::build()
{
    m_title->setObjectName(QStringLiteral("panelTitle"));
    m_text->setWordWrap(true);
    m_count->setObjectName(QStringLiteral("dim"));
    m_done->setObjectName(QStringLiteral("badge"));
    m_done->setProperty("state", QStringLiteral("good"));
    m_leave->setObjectName(QStringLiteral("calloutLeave"));
    m_next->setObjectName(QStringLiteral("calloutNext"));
    m_leave->setToolTip(tr("Ends the tour (Esc); the Help menu starts it again"));
    m_next->setToolTip(tr("Return"));
    for (QPushButton* button : {m_leave, m_back, m_next})
        button->setAutoDefault(false);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_done);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_count, 1);
    foot->addWidget(m_leave);
    foot->addWidget(m_back);
    foot->addWidget(m_next);
    auto* layout = new QVBoxLayout(this);
    constexpr int inside = arrow + 12;
    layout->setContentsMargins(inside, inside, inside, inside);
    layout->setSpacing(10);
    layout->addLayout(head);
    layout->addWidget(m_text);
    layout->addLayout(foot);
    setFixedWidth(calloutWidth + 2 * arrow);
}

void Callout::pointAt(QWidget* target)
{
    if (m_target)
        m_target->removeEventFilter(this);
    m_target = target;
    target->installEventFilter(this);
    place();
    m_mark->show();
    m_mark->raise();
    show();
    raise();
    setFocus();
}

/// Beside the target where there is room, else upon it.
void Callout::place()
{
    if (!m_target)
        return;
    adjustSize();
    const QRect target(m_target->mapTo(parentWidget(), QPoint(0, 0)), m_target->size());
    const QRect room = parentWidget()->rect().adjusted(edge, edge, -edge, -edge);
    m_mark->setGeometry(target);
    const QSize size = Callout::size();
    const QPoint middle = target.center();
    struct Side
    {
        QPoint corner, tip;
    };
    const std::array sides{
        Side{{middle.x() - size.width() / 2, target.bottom()}, {middle.x(), target.bottom() + 1}},
        Side{{target.left() - size.width(), middle.y() - size.height() / 2}, {target.left(), middle.y()}},
        Side{{middle.x() - size.width() / 2, target.top() - size.height()}, {middle.x(), target.top()}},
    };
    const auto into = [&room](QRect box) { // without changing its size
        box.moveLeft(std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
        box.moveTop(std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
        return box;
    };
    const bool large = target.width() > 2 * size.width() && target.height() > 2 * size.height();
    for (const Side& side : sides) {
        const QRect box = into({side.corner, size});
        if (large || box.adjusted(1, 1, -1, -1).intersects(target))
            continue;
        m_tip = side.tip;
        return setGeometry(box);
    }
    const QRect box = into({{middle.x() - size.width() / 2, target.top() + arrow}, size});
    m_tip = box.center();
    setGeometry(box);
}

void Callout::setTexts(const QString& title, const QString& text, int step, int steps)
{
    m_title->setText(title);
    m_text->setText(text);
    m_count->setText(tr("%1 of %2").arg(step + 1).arg(steps));
    m_back->setVisible(step > 0);
    const bool isLast = step + 1 == steps;
    m_leave->setVisible(!isLast);
    m_next->setText(isLast ? tr("Finish") : tr("Next"));
    setAccessibleName(title);
    setAccessibleDescription(text);
    place();
}

void Callout::setDone(bool done)
{
    m_done->setVisible(done);
}

void Callout::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(arrow, arrow, -arrow, -arrow);
    QPainterPath shape;
    shape.addRoundedRect(box, round, round);
    const QPointF tip = mapFrom(parentWidget(), m_tip);
    if (!box.contains(tip)) {
        const QPointF foot(qBound(box.left() + 2 * arrow, tip.x(), box.right() - 2 * arrow),
                           qBound(box.top() + 2 * arrow, tip.y(), box.bottom() - 2 * arrow));
        const bool upright = tip.y() < box.top() || tip.y() > box.bottom();
        const QPointF across = upright ? QPointF(arrow, 0) : QPointF(0, arrow);
        QPainterPath pointer;
        pointer.addPolygon(QPolygonF{{foot + across, tip, foot - across}});
        pointer.closeSubpath();
        shape = shape.united(pointer);
    }
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawPath(shape);
}

void Callout::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return emit nextRequested();
    case Qt::Key_Backspace:
        return emit backRequested();
    default:
        QFrame::keyPressEvent(event);
    }
}

bool Callout::eventFilter(QObject* watched, QEvent* event)
{
    const QEvent::Type type = event->type();
    if (type == QEvent::Resize || type == QEvent::Move || type == QEvent::LayoutRequest)
        QMetaObject::invokeMethod(this, &Callout::place, Qt::QueuedConnection);
    return QFrame::eventFilter(watched, event);
}

} // namespace ramure
