/// \file
/// Makes render scenes on a thread of its own: the lines of a large tree take longer than the interface may
/// wait. The newest wish is served; every one that was begun is finished, so that pictures keep coming while
/// wishes do.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/scene_builder.h"
#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace ramure {

/// Everything that a scene is made of, as it was in one moment.
struct SceneWish
{
    Scene scene;
    std::map<NodeId, TreeResult> results;
    SceneView view;
    quint64 revision = 0; ///< of the document, of the oldest result
    quint64 serial = 0;   ///< counts wishes
};

struct BuiltScene
{
    std::shared_ptr<RenderScene> scene; ///< nobody else has it
    SceneView view;                     ///< as it was wished
    std::map<NodeId, TreeResult> trees; ///< that it shows
    quint64 revision = 0;               ///< as it was wished
    quint64 serial = 0;                 ///< of the wish
    double buildMs = 0.0;
};

class BackgroundBuilder : public QObject
{
    Q_OBJECT
public:
    explicit BackgroundBuilder(QObject* parent = nullptr);

    /// Replaces a wish that still waits.
    void wish(SceneWish wish);
    /// Wishes that were not taken yet.
    [[nodiscard]] bool isBusy() const;
    /// The newest finished scene, once.
    [[nodiscard]] std::optional<BuiltScene> take();
    /// Waits until everything wished for is built, and takes it: for pictures that must be of now.
    [[nodiscard]] std::optional<BuiltScene> finish();
    /// Lets go of something large on the thread: giving back its memory can take longer than a frame.
    void dispose(std::shared_ptr<const void> last);

signals:
    /// take() has something.
    void built();
    /// A scene that was wished for cannot be made.
    void failed(const ramure::Error& error);

private:
    void keep(Expected<BuiltScene>&& made);

    std::shared_ptr<SceneBuilder> m_builder; ///< only the thread uses it
    std::optional<BuiltScene> m_built;
    bool m_isFinishing = false;
    /// Goes to the thread, where it is emptied.
    std::shared_ptr<std::vector<std::shared_ptr<const void>>> m_bin;
    Job m_job;
};

} // namespace ramure
