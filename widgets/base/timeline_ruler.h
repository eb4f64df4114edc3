/// \file
/// The ruler of the timeline: ticks, the range with its two handles, keys, the band of computed frames, the
/// playhead.
///
/// Left drag scrubs; dragging a handle changes the range; the wheel zooms to the cursor, middle drag or
/// Shift+wheel scrolls, a double click shows the whole range again. Arrow keys step (Shift: ten frames, Page
/// Up and Down: a second, Home and End: the range's ends). A right click asks for a menu about the frame.
#pragma once

#include "core/qt/session/motion/motion.h"
#include "core/rig/tracks/timeline_settings.h"
#include "widgets/base/texts/time_text.h"
#include <QTimer>
#include <QWidget>
#include <vector>

namespace ramure {

class TimelineRuler : public QWidget
{
    Q_OBJECT
public:
    explicit TimelineRuler(QWidget* parent = nullptr);

    void setTimeline(const TimelineSettings& settings);
    void setFrame(qint64 frame);
    void setBand(std::vector<FrameRange> band);
    void setDisplay(TimeDisplay display);
    /// Sets the places of the diamonds, in frames, ascending; they may lie between whole frames.
    void setKeys(std::vector<double> frames);
    [[nodiscard]] const std::vector<double>& keys() const { return m_keys; }

    [[nodiscard]] double xOf(double frame) const;
    [[nodiscard]] qint64 frameAt(double x) const;
    /// The moment at x in frames, between whole ones too.
    [[nodiscard]] double framesAt(double x) const;
    /// Frames at the edges.
    [[nodiscard]] double from() const { return m_from; }
    [[nodiscard]] double to() const { return m_to; }
    /// Shows these frames, until a double click shows the range again.
    void showFrames(double from, double to);
    void scrollBy(double frames) { showFrames(m_from + frames, m_to + frames); }
    /// Zooms: \p frame keeps its place, and \p factor times as many frames become visible.
    void zoomAbout(double frame, double factor);
    void showRange() { fit(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void frameSought(qint64 frame);
    void viewChanged(); ///< other frames are in sight, or at other places
    /// \p begins: with the first one of a drag, so that all of it is one step of undo.
    void rangeDragged(qint64 first, qint64 last, bool begins);
    void menuRequested(const QPoint& place, qint64 frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag { None, Scrub, First, Last, Scroll };

    void fit();
    void setView(double from, double to);
    void dragTo(double x);
    void paintTicks(QPainter& painter) const;
    void paintBand(QPainter& painter) const;
    void paintKeys(QPainter& painter) const;
    [[nodiscard]] bool hasKeyAt(qint64 frame) const;
    void paintRange(QPainter& painter) const;
    void paintPlayhead(QPainter& painter) const;
    [[nodiscard]] Drag handleAt(const QPointF& position) const;
    [[nodiscard]] double pixelsPerFrame() const;
    [[nodiscard]] QString labelOf(qint64 frame) const;

    TimelineSettings m_timeline;
    std::vector<FrameRange> m_band;
    std::vector<double> m_keys;
    TimeDisplay m_display = TimeDisplay::Frames;
    qint64 m_frame = 0;
    double m_from = 0.0, m_to = 100.0; ///< frames at the edges
    bool m_zoomed = false;             ///< by the user: the range does not decide
    Drag m_drag = Drag::None;
    bool m_dragBegins = false;
    double m_dragX = 0.0;
    QTimer m_edgeScroll; ///< while the pointer is held beyond an edge
};

} // namespace ramure
