/// \file
/// Sequences of meshes and of pictures, written on a thread of their own while the work goes on.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "core/qt/session/motion/sequence.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/renderer_options.h"
#include "widgets/view/render/scene_builder.h"
#include <QSize>
#include <QString>

namespace ramure {

class Document;
class OffscreenRenderer;

/// How all pictures of a sequence are drawn.
struct PictureLook
{
    QSize size{1920, 1080}; ///< pixels
    Camera camera;
    NodeId through = noNode; ///< a camera node in its place, wherever that is at the time
    bool allAround = false;  ///< the camera's place is that from which everything is seen as it turns
    RenderOptions options;
    SceneView view;
    std::string film; ///< the pictures go into this film; empty: each into its own file
    double framesPerSecond = 24.0;
};

/// One picture: when, how far the camera is turned about its target, and where to.
struct PictureShot
{
    double timeSeconds = 0.0;
    double turnRad = 0.0;
    std::string file;
};

/// A picture for every frame; all around, as `ramure-cli render --turntable` does, \p count at one moment.
std::vector<PictureShot> frameShots(const FrameSequence& frames, const std::string& path);
std::vector<PictureShot> turntableShots(int count, double timeSeconds, const std::string& path);

class SequenceTask : public Job
{
    Q_OBJECT
public:
    using Job::Job;

    /// Both copy their inputs from the document and return at once; they do nothing while another sequence is
    /// being written.
    void startMeshes(const Document& document, const ExportOptions& options, const FrameSequence& frames,
                     const QString& path);
    void startPictures(const Document& document, const PictureLook& look, std::vector<PictureShot> shots);
    /// Facts about the sequence that runs, or that ran last.
    [[nodiscard]] std::int64_t fileCount() const { return m_files; }
    /// Path as it was asked for, without numbers.
    [[nodiscard]] const QString& path() const { return m_path; }

private:
    std::int64_t m_files = 0;
    QString m_path;
    std::shared_ptr<OffscreenRenderer> m_renderer; ///< its surface belongs to the application's thread
};

} // namespace ramure
