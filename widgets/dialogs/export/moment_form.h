/// \file
/// Which moments an export writes: at rest, the frame on show, a sequence of frames, (of pictures) a view
/// from all sides, or (of files that move) a loop of wind without a seam.
#pragma once

#include "core/qt/session/motion/sequence.h"
#include <QWidget>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace ramure {

enum class ExportMoment : std::uint8_t { Rest, Shown, Sequence, Turntable, WindLoop };

class MomentForm : public QWidget
{
    Q_OBJECT
public:
    /// \param shown the frame on show.
    MomentForm(const TimelineSettings& timeline, std::int64_t shown, QWidget* parent = nullptr);

    /// Pictures have a turntable too.
    void setPictures(bool pictures);
    /// Files that move have a loop of wind.
    void setClips(bool clips);
    void setFrames(int first, int last, int step);
    void setTurns(int turns);
    void setLoopSeconds(double seconds);
    [[nodiscard]] double loopSeconds() const;
    /// Returns the timeline of a loop of wind: its last second blends into its first frame.
    [[nodiscard]] std::optional<TimelineSettings> loop() const;
    void setMoment(ExportMoment moment);
    [[nodiscard]] ExportMoment moment() const;
    /// Returns the frames; one moment is a sequence of one frame.
    [[nodiscard]] FrameSequence frames() const;
    /// What the fields say, whatever the moment.
    [[nodiscard]] FrameSequence range() const;
    [[nodiscard]] double timeSeconds() const; ///< of one moment and of a turntable
    [[nodiscard]] int turns() const;
    /// More than one file: their names are numbered.
    [[nodiscard]] bool isNumbered() const;

signals:
    void changed();

private:
    void setTexts();
    void update();
    void enableMoment(ExportMoment moment, bool enabled);

    TimelineSettings m_timeline;
    std::int64_t m_shown;
    bool m_pictures = false;
    QComboBox* m_moment;
    QWidget* m_range;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QSpinBox* m_step;
    QSpinBox* m_turns;
    QDoubleSpinBox* m_seconds;
    QLabel* m_dash;
    QLabel* m_stepLabel;
    QLabel* m_rate;
};

} // namespace ramure
