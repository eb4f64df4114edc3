#include "widgets/view/viewport_host.h"

#include "widgets/view/render/gl_setup.h"
#include "widgets/view/viewport.h"
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

namespace ramure {

ViewportHost::ViewportHost(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_settings(new ViewSettings(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    const OpenGlProbe probe = probeOpenGl();
    if (probe.available) {
        m_viewport = new Viewport(document, m_settings, this);
        m_viewport->setSoftware(probe.software);
        layout->addWidget(m_viewport);
        setFocusProxy(m_viewport);
        return;
    }
    m_placeholder = new QLabel(this);
    m_placeholder->setObjectName(QStringLiteral("viewportPlaceholder"));
    m_placeholder->setAlignment(Qt::AlignCenter);
    m_placeholder->setWordWrap(true);
    m_placeholder->setMargin(24);
    m_placeholder->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(m_placeholder);
    retranslate();
}

void ViewportHost::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void ViewportHost::retranslate()
{
    if (!m_placeholder)
        return;
    m_placeholder->setText(
        tr("<h3>No 3D view</h3><p>%1</p><p>Everything else works: parameters, undo, saving and export.</p>")
            .arg(probeOpenGl().reason.toHtmlEscaped()));
}

} // namespace ramure
