/// \file
/// The editor as the program makes it, in a real window, with what is needed to measure it.
#pragma once

#include "core/qt/session/jobs/recompute.h"
#include "tests/bench/interaction/watched_application.h"
#include "widgets/actions/dialog_chooser.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/view_settings.h"
#include "widgets/window/main_window.h"
#include <vector>

namespace ramure::bench {

/// One change of a slider, milliseconds. All without drawing and composing (llvmpipe).
struct ChangeTimes
{
    double edit = 0.0;       ///< the mouse event, up to the posted computation
    double result = 0.0;     ///< from the event until the first result is taken
    double build = 0.0;      ///< document to render scene
    double upload = 0.0;     ///< render scene to the graphics card
    double first = 0.0;      ///< from the event until the first picture's commands are issued
    double firstCpu = 0.0;   ///< time of all threads together in that while
    double full = 0.0;       ///< until the first picture of the full result
    double block = 0.0;      ///< longest event of the interface's thread, wall
    double blockCpu = 0.0;   ///< longest event of the interface's thread, its own time
    double rasteriser = 0.0; ///< what the software rasteriser took beside, all pictures together
    QString blockName;
};

class EditorBench
{
public:
    explicit EditorBench(WatchedApplication* application);

    /// Null viewport: no OpenGL.
    [[nodiscard]] bool isReady() const;
    void setIterations(int iterations);
    void setMode(DisplayMode mode);
    /// Drags the slider to \p changes places, waiting for the full picture after each.
    std::vector<ChangeTimes> singleChanges(const QString& key, double from, double to, int changes);
    /// Drags without waiting, 60 moves a second. Pictures per second, and the longest block.
    struct DragTimes
    {
        double picturesPerSecond = 0.0;
        double latency = 0.0; ///< median from a move until a picture of it or a later one, all included
        ChangeTimes longest;  ///< only block, blockCpu
    };
    DragTimes drag(const QString& key, double from, double to, int moves);
    /// Ctrl+drag of a twig, 60 moves a second. The latency is from a move to its picture.
    DragTimes bend(int moves);
    /// Plays every frame as fast as it goes. Without the software rasteriser, whose threads do not count.
    struct PlayTimes
    {
        int frames = 0;
        double framesPerSecond = 0.0; ///< rasteriser included
        double cpuPerFrame = 0.0; ///< ms of all threads together: step, pose, upload, the window around it
        double stepMs = 0.0;      ///< of that, the physics, on the wall
        ChangeTimes longest;      ///< only block, blockCpu
    };
    PlayTimes play(int milliseconds);
    /// Of the tree.
    void setParam(const char* key, ParamValue value);
    /// One picture of the view at rest, the median of \p times; the rasteriser is what is measured.
    /// \param selected whether the tree is, which draws a line around it.
    double frameMs(Quality quality, QSize size, int times, bool selected);

private:
    [[nodiscard]] Viewport* view() const;
    [[nodiscard]] bool shows(quint64 revision, bool full) const;
    void settle();
    ChangeTimes measure(const std::function<void()>& move);

    WatchedApplication* m_application;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute;
    DialogChooser m_chooser;
    MainWindow m_window;
};

} // namespace ramure::bench
