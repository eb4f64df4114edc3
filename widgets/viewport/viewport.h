/// \file
/// The 3D view of a document. Follows the document's signals and the ViewSettings; changes only the
/// selection. All shortcuts belong to actions of the main window; the viewport offers slots.
///
/// Left click selects (Shift adds or removes), left drag over the scene selects by box, Esc (an action)
/// clears; the wheel zooms to the cursor; Alt+left drag orbits in both navigation styles.
#pragma once

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/scene/scene.h"
#include "widgets/render/camera.h"
#include "widgets/viewport/view_settings.h"
#include <QImage>
#include <QOpenGLWidget>
#include <memory>

namespace ramure {

class Document;
struct Change;

/// Times of the last picture, in milliseconds; for the bench and the status bar.
struct FrameTimes
{
    double buildMs = 0.0;  ///< document to render scene
    double uploadMs = 0.0; ///< render scene to the graphics card
    double drawMs = 0.0;   ///< commands issued, not waited for
    quint64 frame = 0;     ///< counts pictures
};

class Viewport : public QOpenGLWidget
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the viewport.
    Viewport(Document* document, ViewSettings* settings, QWidget* parent = nullptr);
    ~Viewport() override;

    [[nodiscard]] const Camera& camera() const;
    [[nodiscard]] FrameTimes frameTimes() const;
    [[nodiscard]] QSize sizeHint() const override;

    /// A picture of the scene as it is seen, without cube and overlays. Null image where there is no context.
    [[nodiscard]] QImage screenshot();
    /// The picture as a file (PNG by the ending). Errors: Io, Unknown (ending).
    Expected<void> saveScreenshot(const QString& path);

public slots:
    void setCamera(const ramure::Camera& camera); ///< at once, without animation
    void frameAll();                              ///< Home
    void frameSelection();                        ///< F: branches, else nodes, else all
    void frameBox(const ramure::Box& box);        ///< world
    void setAxisView(ramure::AxisView view);
    void clearSelection();
    void selectAllBranches(); ///< of the active tree
    void copyScreenshot();
    /// The section's plane, circle and frame are shown until cleared.
    void setInspectedSection(ramure::NodeId node, ramure::Index branch, ramure::Index section);
    void clearInspectedSection();

signals:
    void cameraChanged();
    /// noNode, noIndex where nothing is under the cursor.
    void hovered(ramure::NodeId node, ramure::Index branch);
    /// After every picture.
    void frameDrawn(const ramure::FrameTimes& times);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
