#include "widgets/view/viewport_host.h"

#include "widgets/base/named.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport.h"
#include <QLabel>
#include <QVBoxLayout>

namespace ramure {

ViewportHost::ViewportHost(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_settings(new ViewSettings(this))
{
    auto* layout = layoutOf<QVBoxLayout>(this);
    const OpenGlProbe probe = probeOpenGl();
    if (probe.available) {
        m_viewport = new Viewport(document, m_settings, this);
        m_viewport->setSoftware(probe.software);
        layout->addWidget(m_viewport);
        setFocusProxy(m_viewport);
        return;
    }
    auto* placeholder = named(new QLabel(tr("<h3>No 3D view</h3><p>%1</p><p>Everything else works: "
                                            "parameters, undo, saving and export.</p>")
                                             .arg(probe.reason.toHtmlEscaped()),
                                         this),
                              "viewportPlaceholder");
    placeholder->setAlignment(Qt::AlignCenter);
    placeholder->setWordWrap(true);
    placeholder->setMargin(24);
    placeholder->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(placeholder);
}

} // namespace ramure
