#include "widgets/window/isolation_button.h"

#include "widgets/base/theme/icons.h"
#include "widgets/panels/scene/isolation.h"

namespace ramure {

IsolationButton::IsolationButton(Isolation* isolation, QWidget* parent)
    : QToolButton(parent)
    , m_isolation(isolation)
{
    setObjectName(QStringLiteral("isolationButton"));
    setAutoRaise(true);
    setIcon(ramure::icon("cancel"));
    setIconSize({14, 14});
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFocusPolicy(Qt::TabFocus);
    // The bar keeps its height when the button comes and goes, and so does the viewport above it.
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    connect(isolation, &Isolation::changed, this, &IsolationButton::update);
    connect(this, &QToolButton::clicked, isolation, &Isolation::clear);
    update();
}

void IsolationButton::update()
{
    const auto count = static_cast<int>(m_isolation->branches().size());
    setText(count > 0 ? tr("%Ln branch(es) alone", nullptr, count) : tr("The branches shown alone are gone"));
    setToolTip(tr("Only these branches are shown. A click shows the whole tree again."));
    setAccessibleName(text());
    setVisible(m_isolation->isActive());
}

} // namespace ramure
