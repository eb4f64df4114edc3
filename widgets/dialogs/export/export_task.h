/// \file
/// One export on a thread of its own.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/qt/session/export/export_options.h"
#include "core/qt/session/export/print_export.h"
#include "core/qt/session/jobs/job.h"
#include <QString>
#include <optional>

namespace ramure {

class Document;

/// Returns the document's results for use on a thread; the document itself is not shared.
TreeSource snapshotOf(const Document& document);

class ExportTask : public Job
{
    Q_OBJECT
public:
    using Job::Job;

    /// Copies its inputs from the document and returns at once; does nothing while another export is running.
    /// The trees are as their physics has moved them at \p timeSeconds. \param timeline replaces the scene's
    void startExport(const Document& document, const ExportOptions& options, const QString& path,
                     double timeSeconds = 0.0, const std::optional<TimelineSettings>& timeline = {});
    /// Writes a print with Z up, in mm.
    void startPrint(const std::shared_ptr<const ScenePrint>& print, const WriteOptions& options,
                    const QString& path);
};

} // namespace ramure
