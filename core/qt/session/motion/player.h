/// \file
/// Plays a document's trees: which frame it is, and the moving state of the scene at it. Time belongs to the
/// player: playing makes no undo step and no change to the document. Frames are computed on a thread of their
/// own; the interface's thread only takes them.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/motion/motion.h"
#include <QObject>
#include <memory>

namespace ramure {

enum class PlayPace : std::uint8_t {
    RealTime,   ///< frames that come too late are dropped
    EveryFrame, ///< all frames are shown, if need be slower
};

class Player : public QObject
{
    Q_OBJECT
public:
    static constexpr double leastSpeed = 0.1, mostSpeed = 4.0;
    /// A longer stall (a menu held open, a laptop asleep) counts as this much.
    static constexpr double mostSecondsAtOnce = 0.1;

    /// \p document is not owned and must outlive the player.
    explicit Player(Document* document, QObject* parent = nullptr);
    ~Player() override; ///< stops and joins the thread

    [[nodiscard]] bool isPlaying() const;
    /// The frame asked for last. motion() follows as soon as it is computed.
    [[nodiscard]] std::int64_t frame() const;
    [[nodiscard]] double timeSeconds() const;
    /// Never null; of a scene at rest it has no nodes.
    [[nodiscard]] std::shared_ptr<const MotionFrame> motion() const;
    /// Returns the frames of the timeline's range by state: cached, stale and missing.
    [[nodiscard]] const std::vector<FrameRange>& band() const;
    /// A frame is being computed.
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] double speed() const;
    [[nodiscard]] PlayPace pace() const;
    /// Frames dropped since playing began; only in RealTime.
    [[nodiscard]] std::int64_t droppedFrames() const;

    void setSpeed(double factor); ///< clamped to leastSpeed .. mostSpeed
    void setPace(PlayPace pace);
    void setMemoryLimit(std::size_t bytes); ///< for all runs together; at once
    [[nodiscard]] std::size_t memoryLimit() const;
    /// Baked motion beside the project (see baker.h) is loaded when the project is opened. It is used if it
    /// was made from the present trees and parameters.
    [[nodiscard]] BakeState bakeState() const;

    /// While playing: the hand on one branch, until it is let go with an empty pull.
    void setPull(NodeId node, const std::optional<Pull>& pull);
    /// While playing: one apple falls.
    void shakeOff(NodeId node, Index apple);

    /// Blocks until nothing is being computed, and tells what came of it; for the CLI and tests. False on
    /// time-out.
    bool waitForIdle(int timeoutMs);

public slots:
    void play();
    void pause();
    void toggle() { isPlaying() ? pause() : play(); }
    /// Back to the first frame; the hand's pulls and the shaken apples are forgotten.
    void stop();
    /// To any frame, also outside the range; clamped to leastFrame .. mostFrame. Playing goes on from there.
    void seek(qint64 frame);
    /// Gives up computations that take long; the last frame stays on show.
    void cancel();
    /// The files of baked motion are others than before.
    void reloadBakes();

signals:
    void playingChanged(bool playing);
    void frameChanged(qint64 frame); ///< asked for
    void motionChanged();            ///< computed, after frameChanged
    void bandChanged();
    void busyChanged(bool busy);    ///< after 150 ms, so that quick frames do not flicker
    void progress(double fraction); ///< progress of a frame that takes long
    void settingsChanged();         ///< speed or pace
    void failed(const ramure::Error& error);
    void bakeStateChanged(ramure::BakeState state);
    /// A file of baked motion is not used: stale, damaged, or something else under its name.
    void bakeRefused(const ramure::Error& error);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
