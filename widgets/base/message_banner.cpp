#include "widgets/base/message_banner.h"

#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

const char* iconName(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return "error";
    case Severity::Warning:
        return "warning";
    case Severity::Info:
        break;
    }
    return "info";
}

} // namespace

MessageBanner::MessageBanner(QWidget* parent)
    : QFrame(parent)
    , m_icon(new QLabel(this))
    , m_text(new QLabel(this))
    , m_button(new QPushButton(this))
{
    auto* close = new QToolButton(this);
    setObjectName(QStringLiteral("banner"));
    auto* layout = layoutOf<QHBoxLayout>(this, 8, {10, 6, 6, 6});
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    close->setAutoRaise(true);
    close->setIcon(icon("close"));
    close->setIconSize({14, 14});
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    m_button->setObjectName(QStringLiteral("bannerAction"));
    layout->addWidget(m_button, 0, Qt::AlignTop);
    layout->addWidget(close, 0, Qt::AlignTop);
    connect(m_button, &QPushButton::clicked, this, [this] {
        if (m_action)
            m_action();
    });
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(tr("Close this message"));
    hide();
}

void MessageBanner::showMessage(Severity severity, const QString& text)
{
    showMessage(severity, text, {}, {});
}

void MessageBanner::showMessage(Severity severity, const QString& text, const QString& button,
                                std::function<void()> action)
{
    m_button->setText(button);
    m_button->setVisible(!button.isEmpty());
    m_action = std::move(action);
    m_severity = severity;
    m_text->setText(text);
    m_icon->setPixmap(icon(iconName(severity)).pixmap(18, 18));
    setProperty("severity", QString::fromLatin1(iconName(severity)));
    style()->unpolish(this);
    style()->polish(this);
    setAccessibleName(text);
    show();
}

void MessageBanner::lieOver(QWidget* place)
{
    m_place = place;
    place->installEventFilter(this);
    this->place();
}

void MessageBanner::place()
{
    if (!m_place)
        return;
    const int width = m_place->width();
    resize(width, std::max(minimumSizeHint().height(), layout()->heightForWidth(width)));
    move(m_place->mapTo(parentWidget(), QPoint()));
    raise();
}

bool MessageBanner::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_place && (event->type() == QEvent::Resize || event->type() == QEvent::Move))
        place();
    return QFrame::eventFilter(watched, event);
}

/// Another text, style or language needs another height.
bool MessageBanner::event(QEvent* event)
{
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show)
        place();
    return QFrame::event(event);
}

QString MessageBanner::text() const
{
    return isHidden() ? QString() : m_text->text();
}

void MessageBanner::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        m_icon->setPixmap(icon(iconName(m_severity)).pixmap(18, 18));
    QFrame::changeEvent(event);
}

void MessageBanner::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QFrame::keyPressEvent(event);
}

} // namespace ramure
