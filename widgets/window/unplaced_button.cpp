#include "widgets/window/unplaced_button.h"

#include "core/qt/session/jobs/unplaced_edits.h"
#include "widgets/base/theme/icons.h"
#include "widgets/dialogs/unplaced_dialog.h"

namespace ramure {

UnplacedButton::UnplacedButton(Document* document, QWidget* parent)
    : QToolButton(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("unplacedButton"));
    setAutoRaise(true);
    setIcon(ramure::icon("warning"));
    setIconSize({14, 14});
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFocusPolicy(Qt::TabFocus);
    // The bar keeps its height when the button comes and goes, and so does the viewport above it.
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeResults | changeReset | changeStructure | changeBranches))
            update();
    });
    connect(this, &QToolButton::clicked, this, [this] {
        auto* dialog = new UnplacedDialog(m_document, window());
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    update();
}

void UnplacedButton::update()
{
    const auto count = static_cast<int>(unplacedEdits(*m_document).size());
    setText(tr("%Ln edit(s) without a place", nullptr, count));
    setToolTip(tr("Steps on limbs that are not there at present. They are kept. A click lists them."));
    setAccessibleName(text());
    setVisible(count > 0);
}

} // namespace ramure
