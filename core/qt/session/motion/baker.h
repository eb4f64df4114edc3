/// \file
/// Baked motion beside a project: "oak.ramure" has "oak.motion-1.bake" for its tree with the number 1. The
/// run is that of the parameters over the timeline's range, what `ramure-cli --time` computes too; pulls and
/// shaken apples are not in it.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/jobs/job.h"
#include <QStringList>

namespace ramure {

/// Empty where the project has no file.
QString bakeFile(const QString& project, NodeId tree);
/// The files that are there, of any tree, also of one that is no longer in the scene.
QStringList bakeFiles(const QString& project);

class Baker : public QObject
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the baker.
    explicit Baker(const Document* document, QObject* parent = nullptr);

    /// Computes and writes on a thread, with the present trees and parameters; does nothing if it is running
    /// already. Errors: Invalid (the project has no file yet, no visible tree, a tree without a current
    /// result, a range that ends at rest, a foreign file of the same name). Later errors come with finished()
    /// of the job.
    Expected<void> start(std::size_t memoryBytes);
    /// Deletes the project's baked motion. Error: Io; a file of that name which is no baked motion stays.
    Expected<void> remove();
    [[nodiscard]] Job* job() { return &m_job; }
    /// Bytes of all files of baked motion of the project.
    [[nodiscard]] qint64 bytes() const;

signals:
    void filesChanged();

private:
    const Document* m_document;
    Job m_job;
};

} // namespace ramure
