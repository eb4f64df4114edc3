/// \file
/// A field for one moment: shows and takes frames, seconds or timecode; arrow keys step by frames.
#pragma once

#include "widgets/base/texts/time_text.h"
#include <QAbstractSpinBox>

namespace ramure {

class TimeField : public QAbstractSpinBox
{
    Q_OBJECT
public:
    explicit TimeField(QWidget* parent = nullptr);

    void setDisplay(TimeDisplay display, double framesPerSecond);
    /// Never emits. A text being typed stays.
    void setFrame(qint64 frame);
    [[nodiscard]] qint64 frame() const { return m_frame; }

    void stepBy(int steps) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void frameEdited(qint64 frame);

protected:
    void wheelEvent(QWheelEvent* event) override;
    [[nodiscard]] StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }

private:
    void commit();
    void showFrame();

    TimeDisplay m_display = TimeDisplay::Frames;
    double m_rate = 24.0;
    qint64 m_frame = 0;
    QString m_shown; ///< another text is one that is being typed
};

} // namespace ramure
