/// \file
/// Imports scenes from Blender on a thread of its own, and puts them into the document as one undo step. On
/// an error the document is unchanged.
#pragma once

#include "core/document/document.h"
#include "core/io/blender_scene.h"
#include <QObject>
#include <thread>

namespace ramure {

class ImportTask : public QObject
{
    Q_OBJECT
public:
    /// \param document must outlive this object.
    explicit ImportTask(Document* document, QObject* parent = nullptr);
    ~ImportTask() override; ///< stops the thread and waits for it

    /// A file or a folder, see importBlender. Returns at once; nothing happens while another one is running.
    void start(const QString& path);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }
    /// What was guessed or mended in the last one that came to its end.
    [[nodiscard]] const std::vector<Note>& notes() const { return m_notes; }

signals:
    void progress(double fraction);
    /// \param top the node that was added, noNode on an error (those of importBlender and edit::insertNodes).
    void finished(ramure::NodeId top, const std::optional<ramure::Error>& error);

private:
    void finish(const Expected<BlenderImport>& result);
    [[nodiscard]] Expected<NodeId> apply(const BlenderImport& result);

    Document* m_document;
    bool m_running = false;
    std::vector<Note> m_notes;
    std::jthread m_thread;
};

} // namespace ramure
