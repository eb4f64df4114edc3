/// \file
/// A leaf and a twig, drawn large in the background and turned with the mouse or the arrow keys.
#pragma once

#include "core/params/node_params.h"
#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/camera.h"
#include <QImage>
#include <QWidget>
#include <memory>

namespace ramure {

class LeafView : public QWidget
{
    Q_OBJECT
public:
    explicit LeafView(QWidget* parent = nullptr);
    ~LeafView() override;

    /// Draws nothing anew where the leaves are the same.
    void setParams(const NodeParams& params);
    /// Null until the first one is drawn.
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    [[nodiscard]] bool isBusy() const { return m_job.isRunning(); }
    [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 160}; }
    /// From the front, as large as the window allows.
    void resetView();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Drawer;
    void draw();
    void turn(double yawRad, double pitchRad);
    void zoom(double factor);

    std::shared_ptr<Drawer> m_drawer; ///< only the job's thread draws with it
    NodeParams m_params;
    double m_yawRad = 0.0, m_pitchRad = 0.0, m_nearness = 1.0;
    QPointF m_last; ///< of the mouse
    QImage m_picture;
    QString m_problem;
    Job m_job;
};

} // namespace ramure
