#include "widgets/actions/dialog_chooser.h"

#include "widgets/base/message_banner.h"
#include "widgets/base/theme/icons.h"
#include "widgets/dialogs/recovery_dialog.h"
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeView>
#include <algorithm>

namespace ramure {
void DialogChooser::setWindow(QWidget* window, MessageBanner* banner)
{
    m_window = window;
    m_banner = banner;
}

/// Qt's own dialog, shown where the desktop has none, starts with columns too narrow for their headings.
static void fitColumns(QFileDialog& dialog)
{
    for (auto* view : dialog.findChildren<QTreeView*>()) {
        const QFontMetrics metrics(view->header()->font());
        for (int i = 1; i < view->header()->count(); ++i) {
            const QString text = view->model()->headerData(i, Qt::Horizontal).toString();
            const int wide = metrics.horizontalAdvance(text) + 4 * metrics.averageCharWidth();
            view->setColumnWidth(i, std::max(view->columnWidth(i), wide));
        }
    }
}

static QString chosen(QFileDialog& dialog)
{
    fitColumns(dialog);
    dialog.resize(dialog.sizeHint().expandedTo(QSize(760, 460)));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    return dialog.selectedFiles().constFirst();
}

QString DialogChooser::openFile(const QString& title, const QString& folder, const QString& filter)
{
    QFileDialog dialog(m_window, title, folder, filter);
    dialog.setFileMode(QFileDialog::ExistingFile);
    return chosen(dialog);
}

QString DialogChooser::openFolder(const QString& title, const QString& folder)
{
    QFileDialog dialog(m_window, title, folder);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    return chosen(dialog);
}

QString DialogChooser::saveFile(const QString& title, const QString& suggestion, const QString& filter,
                                const QString& suffix)
{
    QFileDialog dialog(m_window, title, QFileInfo(suggestion).absolutePath(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(QFileInfo(suggestion).fileName());
    return chosen(dialog);
}

Chooser::Unsaved DialogChooser::unsavedChanges(const QString& documentName)
{
    QMessageBox box(m_window);
    box.setIconPixmap(icon("warning").pixmap(32, 32));
    box.setWindowTitle(tr("Unsaved changes"));
    box.setText(tr("Save the changes to “%1”?").arg(documentName));
    box.setInformativeText(tr("They are lost if you do not save them."));
    QPushButton* save = box.addButton(tr("Save"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("Don’t save"), QMessageBox::DestructiveRole);
    QPushButton* cancel = box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    box.setDefaultButton(save);
    box.setEscapeButton(cancel);
    box.exec();
    if (box.clickedButton() == save)
        return Unsaved::Save;
    return box.clickedButton() == discard ? Unsaved::Discard : Unsaved::Cancel;
}

bool DialogChooser::agrees(const QString& title, const QString& question, const QString& why,
                           const QString& yes)
{
    QMessageBox box(m_window);
    box.setIconPixmap(icon("info").pixmap(32, 32));
    box.setWindowTitle(title);
    box.setText(question);
    box.setInformativeText(why);
    QPushButton* agree = box.addButton(yes, QMessageBox::AcceptRole);
    box.setDefaultButton(agree);
    box.setEscapeButton(box.addButton(tr("Cancel"), QMessageBox::RejectRole));
    box.exec();
    return box.clickedButton() == agree;
}

RecoveryAnswer DialogChooser::recovery(const QList<RecoveryEntry>& entries)
{
    RecoveryDialog dialog(entries, m_window);
    dialog.exec();
    return dialog.answer();
}

void DialogChooser::report(Severity severity, const QString& text)
{
    if (m_banner)
        m_banner->showMessage(severity, text);
}

} // namespace ramure
