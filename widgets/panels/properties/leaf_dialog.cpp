#include "widgets/panels/properties/leaf_dialog.h"

#include "widgets/base/named.h"
#include "widgets/panels/properties/leaf_view.h"
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>
#include <QVBoxLayout>

namespace ramure {

LeafDialog::LeafDialog(Document* document, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_view(new LeafView(this))
{
    auto* hint =
        named(new QLabel(tr("Drag: turn · wheel: nearer · the properties shape the leaf"), this), "hint");
    setObjectName(QStringLiteral("leafDialog"));
    auto* layout = layoutOf<QVBoxLayout>(this);
    layout->addWidget(m_view, 1);
    auto* foot = layoutOf<QHBoxLayout>(nullptr, -1, {12, 0, 12, 8});
    hint->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    foot->addWidget(hint, 1);
    foot->addWidget(buttons);
    layout->addLayout(foot);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    // A window of its own does not hear the keys of the main window.
    connect(new QShortcut(QKeySequence::Undo, this), &QShortcut::activated, document, &Document::undo);
    connect(new QShortcut(QKeySequence::Redo, this), &QShortcut::activated, document, &Document::redo);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeParams | changeReset | changeStructure | changeNodeState))
            refresh();
    });
    refresh();
}

void LeafDialog::setTree(NodeId tree)
{
    m_tree = tree;
    refresh();
}

void LeafDialog::refresh()
{
    const Node* node = m_document->scene().find(m_tree);
    if (!isVisible() || !node || node->kind != NodeKind::Tree)
        return;
    setWindowTitle(tr("Leaves of “%1”").arg(QString::fromStdString(node->name)));
    m_view->setParams(node->params);
}

void LeafDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    refresh();
}

} // namespace ramure
