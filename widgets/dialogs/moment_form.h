/// \file
/// Which moments an export writes: at rest, the frame on show, a sequence of frames, or (of pictures) a view
/// from all sides.
#pragma once

#include "core/session/sequence.h"
#include <QWidget>

class QComboBox;
class QLabel;
class QSpinBox;

namespace ramure {

enum class ExportMoment : std::uint8_t { Rest, Shown, Sequence, Turntable };

class MomentForm : public QWidget
{
    Q_OBJECT
public:
    /// \param shown the frame on show.
    MomentForm(const TimelineSettings& timeline, std::int64_t shown, QWidget* parent = nullptr);

    /// Pictures have a turntable too.
    void setPictures(bool pictures);
    void setMoment(ExportMoment moment);
    [[nodiscard]] ExportMoment moment() const;
    /// Of one moment a sequence of one.
    [[nodiscard]] FrameSequence frames() const;
    [[nodiscard]] double timeSeconds() const; ///< of one moment and of a turntable
    [[nodiscard]] int turns() const;
    /// More than one file: their names are numbered.
    [[nodiscard]] bool isNumbered() const;

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void update();

    TimelineSettings m_timeline;
    std::int64_t m_shown;
    bool m_pictures = false;
    QComboBox* m_moment;
    QWidget* m_range;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QSpinBox* m_step;
    QSpinBox* m_turns;
    QLabel* m_dash;
    QLabel* m_stepLabel;
    QLabel* m_rate;
};

} // namespace ramure
