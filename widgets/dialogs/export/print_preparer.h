/// \file
/// Makes what an export dialog has chosen ready for a printer, in the background.
#pragma once

#include "core/qt/session/export/print_export.h"
#include "core/qt/session/jobs/job.h"
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace ramure {

class Document;
class PrintForm;

/// Keeps the print until something changes from which it was made.
class PrintPreparer : public QObject
{
    Q_OBJECT
public:
    /// \param form says how and shows what comes of it \param options what the dialog has chosen. All must
    /// outlive the object.
    PrintPreparer(const Document* document, PrintForm* form, std::function<ExportOptions()> options,
                  QObject* parent = nullptr);

    /// Null: it is not prepared.
    [[nodiscard]] const std::shared_ptr<const ScenePrint>& print() const { return m_print; }
    [[nodiscard]] bool isRunning() const { return m_rest.isActive() || m_job.isRunning(); }
    void prepare();
    /// What was prepared is another print's. One that is being prepared is begun anew with what is wanted
    /// now.
    void forget();
    void cancel();

signals:
    void began();
    void progress(double fraction);
    /// Without an error print() is there.
    void finished(const std::optional<ramure::Error>& error);

private:
    void take(const Expected<std::shared_ptr<const ScenePrint>>& made);

    const Document* m_document;
    PrintForm* m_form;
    std::function<ExportOptions()> m_options;
    std::shared_ptr<const ScenePrint> m_print;
    Job m_job;
    QTimer m_rest; ///< after a change while it is being made
};

} // namespace ramure
