/// \file
/// A print as it will stand on the table: drawn in the background, turned, moved and enlarged with the mouse
/// or the keys, with a ring around its thinnest place.
#pragma once

#include "widgets/dialogs/export/print_scene.h"
#include "widgets/view/camera_flight.h"
#include "widgets/view/drawn_picture.h"
#include <QTimer>
#include <memory>

namespace ramure {

class PrintView : public DrawnPicture
{
    Q_OBJECT
public:
    explicit PrintView(QWidget* parent = nullptr);

    /// \param print null: nothing is shown. All of it comes into the picture.
    void setPrint(std::shared_ptr<const PrintedTree> print);
    [[nodiscard]] const Camera& camera() const { return m_flight.camera(); }
    /// Where the camera stands, or is on its way to.
    [[nodiscard]] const Camera& goal() const { return m_flight.goal(); }
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] QSize sizeHint() const override { return {360, 360}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 200}; }

public slots:
    void showThinnest(); ///< flies there
    void showWhole();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Drawn;
    void redraw() override { draw(true); }
    void setTexts();
    [[nodiscard]] QString waitText() const override;
    void paintOver(QPainter& painter) override;
    void draw(bool hurried);
    void setCamera(const Camera& camera) { m_flight.setCamera(camera); }
    [[nodiscard]] double aspect() const { return double(width()) / std::max(1, height()); }
    [[nodiscard]] glm::dvec2 ndc(const QPointF& at) const;

    std::shared_ptr<Drawn> m_kept; ///< only the thread that draws looks at it
    std::shared_ptr<const PrintedTree> m_print;
    CameraFlight m_flight;
    Camera m_drawn; ///< of the picture
    QTimer m_rest;  ///< after the last move: the picture is drawn finer
};

} // namespace ramure
