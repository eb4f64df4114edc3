#include "widgets/dialogs/unplaced_dialog.h"

#include "core/params/tree_edit_table.h"
#include "core/qt/document/commands.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/fact_text.h"
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

namespace ramure {
namespace {

constexpr QSize editsSize(560, 160);

QString shareText(double share)
{
    return UnplacedDialog::tr("%1 %", "a share").arg(QLocale().toString(100.0 * share, 'f', 0));
}

/// Where the branch was, by the fingerprint of its axis.
QString whereText(const BranchPlace& place)
{
    const AxisPrint& axis = place.way.back();
    const auto order = place.way.size() - 1;
    const QString length = facttext::length(axis.length);
    if (order == 0)
        return UnplacedDialog::tr("Trunk of %1, %2 up").arg(length, shareText(place.share));
    const QString start = shareText(axis.share);
    if (order == 1)
        return UnplacedDialog::tr("Limb of %1 that started %2 up the trunk").arg(length, start);
    return UnplacedDialog::tr("Branch of order %1, %2 long, that started %3 along the one below")
        .arg(QLocale().toString(order), length, start);
}

/// What an edit does, and where its branch was.
std::pair<QString, QString> textsOf(const Node& node, const UnplacedEdit& edit)
{
    const TreeEdit& found = *std::ranges::find(node.params.edits, edit.id, &TreeEdit::id);
    const bool wasDrawn = found.target.place.way.empty();
    return {found.name.empty() ? coreText(infoOf(found.operation).label) : QString::fromStdString(found.name),
            wasDrawn ? UnplacedDialog::tr("on a limb made by hand") : whereText(found.target.place)};
}

} // namespace

UnplacedDialog::UnplacedDialog(Document* document, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_list(new QTreeWidget(this))
{
    setWindowTitle(tr("Edits without a place"));
    auto* text = new QLabel(tr("These edits were made on branches that the tree has lost. They are kept with "
                               "the project, and act again as soon as such a branch grows."),
                            this);
    text->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("unplacedEdits"));
    m_list->setHeaderLabels({tr("Tree"), tr("Edit"), tr("Where it was")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setMinimumSize(editsSize);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_delete = buttons->addButton(tr("&Delete"), QDialogButtonBox::ActionRole);
    m_delete->setObjectName(QStringLiteral("deleteEdits"));
    m_delete->setToolTip(tr("Deletes the selected edits (Del). Undo brings them back."));
    QPushButton* all = buttons->addButton(tr("Delete &all"), QDialogButtonBox::ActionRole);
    all->setObjectName(QStringLiteral("deleteAllEdits"));
    for (QPushButton* remover : {m_delete, all})
        remover->setAutoDefault(false);
    buttons->button(QDialogButtonBox::Close)->setDefault(true);
    auto* layout = layoutOf<QVBoxLayout>(this, 12, {20, 18, 20, 16});
    layout->addWidget(text);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_delete, &QPushButton::clicked, this, [this] { remove(false); });
    connect(all, &QPushButton::clicked, this, [this] { remove(true); });
    connect(m_list, &QTreeWidget::itemSelectionChanged, this,
            [this] { m_delete->setEnabled(!m_list->selectedItems().isEmpty()); });
    connect(document, &Document::changed, this, &UnplacedDialog::follow);
    follow();
}

void UnplacedDialog::follow()
{
    std::vector<UnplacedEdit> edits = unplacedEdits(*m_document);
    if (edits.empty())
        return reject();
    if (edits == m_edits)
        return;
    m_edits = std::move(edits);
    m_list->clear();
    for (const UnplacedEdit& edit : m_edits) {
        const Node& node = *m_document->scene().find(edit.node);
        const auto [what, where] = textsOf(node, edit);
        new QTreeWidgetItem(m_list, {QString::fromStdString(node.name), what, where});
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
}

void UnplacedDialog::remove(bool all)
{
    std::map<NodeId, std::vector<std::uint64_t>> ids;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        if (const UnplacedEdit& edit = m_edits[static_cast<std::size_t>(row)];
            all || m_list->topLevelItem(row)->isSelected())
            ids[edit.node].push_back(edit.id);
    for (const auto& [tree, list] : ids)
        if (const auto done = edit::removeTreeEdits(*m_document, tree, list); !done) {
            QMessageBox::warning(this, windowTitle(), errorText(done.error()));
            return;
        }
}

void UnplacedDialog::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete)
        remove(false);
    else
        QDialog::keyPressEvent(event);
}

} // namespace ramure
