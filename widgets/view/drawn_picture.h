/// \file
/// A widget that shows a picture of a scene, drawn in the background by a context of its own. Subclasses say
/// what is drawn and how mouse and keys change it.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>

namespace ramure {

inline constexpr int mostPicturePixels = 2000; ///< a side
/// Turn of the scene per pixel of the mouse and per arrow key, rad.
inline constexpr double turnPerPixel = 0.01, turnPerKey = 0.15;

class DrawnPicture : public QWidget
{
    Q_OBJECT
public:
    explicit DrawnPicture(QWidget* parent = nullptr);
    ~DrawnPicture() override;

    /// Null until the first one is drawn.
    [[nodiscard]] const QImage& picture() const { return m_picture; }

protected:
    /// On the thread of the job. \param pixels of the picture
    using Draw = std::function<Expected<QImage>(OffscreenRenderer& renderer, QSize pixels, const Progress&)>;
    /// Nothing where the widget is not to be seen. One picture at a time, the last wish counts.
    /// \param finer pixels drawn a side for one shown \param shown the picture is there, or the reason why
    /// not
    void start(Draw draw, int finer, std::function<void()> shown);
    /// Removes the picture and the reason. \param forget runs on the thread of the job, after its drawing,
    /// and releases the drawn data
    void clear(std::function<void()> forget);
    [[nodiscard]] bool isDrawing() const { return m_job.isRunning(); }
    /// \pre a mouse button was pressed before. \return by how much the mouse has moved since it was last
    /// asked.
    QPointF movedBy(const QMouseEvent& event);

    virtual void redraw() = 0; ///< it has another size, or is seen
    /// Returns the text over the picture: the reason why there is none, or what it waits for.
    [[nodiscard]] virtual QString waitText() const = 0;
    virtual void paintOver(QPainter& /*painter*/) {}

    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Context;

    std::shared_ptr<Context> m_context; ///< only the job's thread draws with it; null: nothing was drawn yet
    QPointF m_last;                     ///< last place of the mouse
    QImage m_picture;
    QString m_problem;
    Job m_job;
};

} // namespace ramure
