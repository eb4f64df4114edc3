#include "widgets/validation/validation_panel.h"

#include "core/document/document.h"

namespace ramure {

struct ValidationPanel::Private
{
    Document* document = nullptr;
};

ValidationPanel::ValidationPanel(Document* document, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(Private{document}))
{
}

ValidationPanel::~ValidationPanel() = default;

QSize ValidationPanel::sizeHint() const
{
    return {320, 420};
}

void ValidationPanel::copyReport()
{
}

void ValidationPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
}

void ValidationPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
}

} // namespace ramure
