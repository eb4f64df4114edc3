/// \file
/// A print as it will stand on the table: drawn in the background, turned, moved and enlarged with the mouse
/// or the keys, with a ring around its thinnest place.
#pragma once

#include "core/session/job.h"
#include "widgets/dialogs/print_scene.h"
#include "widgets/view/camera_flight.h"
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>

namespace ramure {

class PrintView : public QWidget
{
    Q_OBJECT
public:
    explicit PrintView(QWidget* parent = nullptr);
    ~PrintView() override;

    /// \param print null: nothing is shown. All of it comes into the picture.
    void setPrint(std::shared_ptr<const PrintedTree> print);
    [[nodiscard]] const Camera& camera() const { return m_flight.camera(); }
    /// Where the camera stands, or is on its way to.
    [[nodiscard]] const Camera& goal() const { return m_flight.goal(); }
    /// Null until the first one is drawn.
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] QSize sizeHint() const override { return {360, 360}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 200}; }

public slots:
    void showThinnest(); ///< flies there
    void showWhole();

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Drawer;
    void draw(bool hurried);
    void setCamera(const Camera& camera) { m_flight.setCamera(camera); }
    void paintThinnest(QPainter& painter) const;
    [[nodiscard]] double aspect() const { return double(width()) / std::max(1, height()); }
    [[nodiscard]] glm::dvec2 ndc(const QPointF& at) const;
    void retranslate();

    std::shared_ptr<Drawer> m_drawer; ///< only the job's thread draws with it; null: nothing was drawn yet
    std::shared_ptr<const PrintedTree> m_print;
    CameraFlight m_flight;
    Camera m_drawn; ///< of the picture
    QPointF m_last; ///< of the mouse
    QImage m_picture;
    QString m_problem;
    QTimer m_rest; ///< after the last move: the picture is drawn finer
    Job m_job;
};

} // namespace ramure
