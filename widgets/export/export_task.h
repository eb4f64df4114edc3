/// \file
/// One export on a thread of its own.
#pragma once

#include "core/document/exporter.h"
#include <QObject>
#include <QString>
#include <optional>
#include <thread>

namespace ramure {

class ExportTask : public QObject
{
    Q_OBJECT
public:
    explicit ExportTask(QObject* parent = nullptr);
    ~ExportTask() override; ///< stops the thread and waits for it

    /// Takes what it needs from the document and returns at once; nothing happens while another export is
    /// running.
    void start(const Document& document, const ExportOptions& options, const QString& path);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }

signals:
    void progress(double fraction);
    /// Nothing: it is done.
    void finished(const std::optional<ramure::Error>& error);

private:
    void finish(quint64 run, const std::optional<Error>& error);

    std::jthread m_thread;
    bool m_running = false;
    quint64 m_run = 0;
};

} // namespace ramure
