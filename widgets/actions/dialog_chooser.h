/// \file
/// The chooser of the program: file dialogs, message boxes, and the banner of the main window.
#pragma once

#include "widgets/base/chooser.h"
#include <QCoreApplication>
#include <QPointer>
#include <QWidget>

namespace ramure {

class MessageBanner;

class DialogChooser : public Chooser
{
    Q_DECLARE_TR_FUNCTIONS(DialogChooser)
public:
    /// The window the dialogs belong to and the banner for reports; may be given after the chooser was made.
    void setWindow(QWidget* window, MessageBanner* banner);

    QString openFile(const QString& title, const QString& folder, const QString& filter) override;
    QString openFolder(const QString& title, const QString& folder) override;
    QString saveFile(const QString& title, const QString& suggestion, const QString& filter,
                     const QString& suffix) override;
    bool agrees(const QString& title, const QString& question, const QString& why,
                const QString& yes) override;
    Unsaved unsavedChanges(const QString& documentName) override;
    RecoveryAnswer recovery(const QList<RecoveryEntry>& entries) override;
    void report(Severity severity, const QString& text) override;

private:
    QPointer<QWidget> m_window;
    QPointer<MessageBanner> m_banner;
};

} // namespace ramure
