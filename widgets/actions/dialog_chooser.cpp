#include "widgets/actions/dialog_chooser.h"

#include "widgets/main_window/message_banner.h"
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace ramure {
namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("DialogChooser", text);
}

} // namespace

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
    box.setIcon(QMessageBox::Warning);
    box.setWindowTitle(tr(QT_TRANSLATE_NOOP("DialogChooser", "Unsaved changes")));
    box.setText(tr(QT_TRANSLATE_NOOP("DialogChooser", "Save the changes to “%1”?")).arg(documentName));
    box.setInformativeText(tr(QT_TRANSLATE_NOOP("DialogChooser", "They are lost if you do not save them.")));
    QPushButton* save =
        box.addButton(tr(QT_TRANSLATE_NOOP("DialogChooser", "Save")), QMessageBox::AcceptRole);
    QPushButton* discard =
        box.addButton(tr(QT_TRANSLATE_NOOP("DialogChooser", "Don’t save")), QMessageBox::DestructiveRole);
    QPushButton* cancel =
        box.addButton(tr(QT_TRANSLATE_NOOP("DialogChooser", "Cancel")), QMessageBox::RejectRole);
    box.setDefaultButton(save);
    box.setEscapeButton(cancel);
    box.exec();
    if (box.clickedButton() == save)
        return Unsaved::Save;
    return box.clickedButton() == discard ? Unsaved::Discard : Unsaved::Cancel;
}

void DialogChooser::report(Severity severity, const QString& text)
{
    if (m_banner)
        m_banner->showMessage(severity, text);
}

} // namespace ramure
