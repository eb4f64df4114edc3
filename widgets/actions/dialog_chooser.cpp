#include "widgets/actions/dialog_chooser.h"

#include "widgets/main_window/message_banner.h"
#include "widgets/recovery/recovery_dialog.h"
#include "widgets/theme/icons.h"
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace ramure {
void DialogChooser::setWindow(QWidget* window, MessageBanner* banner)
{
    m_window = window;
    m_banner = banner;
}

QString DialogChooser::openFile(const QString& title, const QString& folder, const QString& filter)
{
    return QFileDialog::getOpenFileName(m_window, title, folder, filter);
}

QString DialogChooser::saveFile(const QString& title, const QString& suggestion, const QString& filter,
                                const QString& suffix)
{
    QFileDialog dialog(m_window, title, QFileInfo(suggestion).absolutePath(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(QFileInfo(suggestion).fileName());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    return dialog.selectedFiles().constFirst();
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
