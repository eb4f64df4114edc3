#include "widgets/dialogs/recovery_dialog.h"

#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int iconSize = 32;
constexpr QSize filesSize(560, 130);

} // namespace

RecoveryDialog::RecoveryDialog(const QList<RecoveryEntry>& entries, QWidget* parent)
    : QDialog(parent)
    , m_list(new QTreeWidget(this))
{
    setWindowTitle(tr("Recover unsaved work"));
    auto* picture = new QLabel(this);
    picture->setPixmap(icon("warning").pixmap(iconSize, iconSize));
    auto* text =
        new QLabel(tr("Ramure did not end in good order last time. These changes had not been saved:"), this);
    text->setWordWrap(true);
    auto* hint =
        new QLabel(tr("“Recover” opens the selected one; nothing is written to its file until you save. "
                      "“Later” asks again at the next start."),
                   this);
    hint->setObjectName(QStringLiteral("hint"));
    hint->setWordWrap(true);
    addEntries(entries);
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* recover = buttons->addButton(tr("Recover"), QDialogButtonBox::AcceptRole);
    QPushButton* discard = buttons->addButton(tr("Discard"), QDialogButtonBox::DestructiveRole);
    QPushButton* later = buttons->addButton(tr("Later"), QDialogButtonBox::RejectRole);
    recover->setObjectName(QStringLiteral("recover"));
    discard->setObjectName(QStringLiteral("discard"));
    later->setObjectName(QStringLiteral("later"));
    recover->setDefault(true);
    discard->setAutoDefault(false);
    later->setAutoDefault(false);

    auto* top = new QHBoxLayout;
    top->setSpacing(14);
    top->addWidget(picture, 0, Qt::AlignTop);
    top->addWidget(text, 1);
    auto* layout = layoutOf<QVBoxLayout>(this, 12, {20, 18, 20, 16});
    layout->addLayout(top);
    layout->addWidget(m_list, 1);
    layout->addWidget(hint);
    layout->addWidget(buttons);
    connect(recover, &QPushButton::clicked, this, [this] { finish(RecoveryAnswer::Action::Recover); });
    connect(discard, &QPushButton::clicked, this, [this] { finish(RecoveryAnswer::Action::Discard); });
    connect(later, &QPushButton::clicked, this, [this] { finish(RecoveryAnswer::Action::Later); });
    connect(m_list, &QTreeWidget::itemActivated, this, [this] { finish(RecoveryAnswer::Action::Recover); });
    m_list->setFocus();
}

void RecoveryDialog::addEntries(const QList<RecoveryEntry>& entries)
{
    m_list->setAccessibleName(windowTitle());
    m_list->setColumnCount(4);
    m_list->setHeaderLabels({tr("File"), tr("Folder"), tr("Last change kept"), tr("File saved later")});
    const auto shown = [](const QDateTime& time) {
        return QLocale().toString(time.toLocalTime(), QLocale::ShortFormat);
    };
    bool isOld = false;
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setMinimumSize(filesSize);
    m_list->setTextElideMode(Qt::ElideMiddle);
    for (const RecoveryEntry& entry : entries) {
        const QFileInfo file(entry.file);
        auto* item = new QTreeWidgetItem(m_list);
        item->setIcon(0, icon("tree"));
        item->setText(0, entry.file.isEmpty() ? tr("Untitled") : file.fileName());
        item->setText(1, entry.file.isEmpty() ? tr("never saved")
                                              : QDir::toNativeSeparators(file.absolutePath()));
        item->setText(2, shown(entry.time));
        if (entry.savedLater.isValid()) {
            item->setText(3, shown(entry.savedLater));
            item->setToolTip(3, tr("The file was saved after this change was kept. “Recover” may open an "
                                   "older state than the file; compare the two before you save."));
            isOld = true;
        }
        item->setToolTip(1, QDir::toNativeSeparators(entry.file));
    }
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(3, QHeaderView::ResizeToContents);
    m_list->setColumnHidden(3, !isOld);
    m_list->setCurrentItem(m_list->topLevelItem(0));
}

void RecoveryDialog::finish(RecoveryAnswer::Action action)
{
    m_answer = {action, std::max(0, m_list->indexOfTopLevelItem(m_list->currentItem()))};
    done(action == RecoveryAnswer::Action::Later ? QDialog::Rejected : QDialog::Accepted);
}

} // namespace ramure
