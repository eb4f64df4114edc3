#include "widgets/inspector/branch_inspector.h"

#include "core/document/document.h"

namespace ramure {

struct BranchInspector::Private
{
    Document* document = nullptr;
};

BranchInspector::BranchInspector(Document* document, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(Private{document}))
{
}

BranchInspector::~BranchInspector() = default;

QSize BranchInspector::sizeHint() const
{
    return {320, 560};
}

void BranchInspector::nextSection()
{
}

void BranchInspector::previousSection()
{
}

void BranchInspector::copyCsv()
{
}

void BranchInspector::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
}

void BranchInspector::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
}

void BranchInspector::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
}

} // namespace ramure
