/// \file
/// Reads objects, and scenes from Blender, on a thread of its own, and puts them into the document as one
/// undo step, or into a scene of their own. On an error the document is unchanged.
#pragma once

#include "core/io/formats/text/blender_scene.h"
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/job.h"
#include <QObject>

namespace ramure {

class ImportTask : public QObject
{
    Q_OBJECT
public:
    /// \param document must outlive this object.
    explicit ImportTask(Document* document, QObject* parent = nullptr);

    /// A file or a folder, see importObjects. Returns at once; nothing happens while another one is running.
    void start(const QString& path);
    /// Reads the file without changing the document: takeScene() returns the result.
    void startScene(const QString& path);
    [[nodiscard]] Scene takeScene() { return std::move(m_scene); }
    void cancel() { m_job.cancel(); }
    [[nodiscard]] bool isRunning() const { return m_job.isRunning(); }
    /// If set, imported objects keep the place that the file gives them, even if something stands there.
    void setStays(bool stays) { m_stays = stays; }
    /// m: how far beside its place the last one stands (edit::moveBeside), a step of undo of its own.
    [[nodiscard]] double movedBy() const { return m_movedBy; }
    /// Notes on things guessed or mended in the last import that ended.
    [[nodiscard]] const std::vector<Note>& notes() const { return m_notes; }

signals:
    void progress(double fraction);
    /// \param top the added node, or the first of the scene; noNode on an error (those of importObjects and
    /// edit::insertNodes).
    void finished(ramure::NodeId top, const std::optional<ramure::Error>& error);

private:
    void read(const QString& path);
    void finish(Expected<BlenderImport>&& result);
    [[nodiscard]] Expected<NodeId> apply(const BlenderImport& result);
    [[nodiscard]] Expected<NodeId> keep(const BlenderImport& result);

    Document* m_document;
    bool m_isScene = false; ///< the file is read as a scene of its own, not into the document
    bool m_stays = false;
    double m_movedBy = 0.0;
    Scene m_scene;
    std::vector<Note> m_notes;
    Job m_job;
};

} // namespace ramure
