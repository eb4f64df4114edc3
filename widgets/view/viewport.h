/// \file
/// The 3D view of a document. Follows the document's signals and the ViewSettings; changes the selection,
/// and what its tools change. All shortcuts belong to actions of the main window; the viewport offers slots.
///
/// Left click selects (Shift adds or removes), left drag over the scene selects by box, Esc (an action)
/// clears; Ctrl+drag on a branch of a tree at rest bends the limb after the hand (the wheel sets how many
/// branches follow), on a terrain or another surface it sets and drags the target of the arm; a tool that
/// shapes trees, where one is chosen (ViewSettings::hand), gets presses before all these; the wheel zooms to
/// the cursor; Alt+left drag orbits in both navigation styles; the arrow keys orbit; a right click asks for a
/// menu.
#pragma once

#include "core/base/index.h"
#include "core/scene/scene.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/pick/pick_scene.h"
#include "widgets/view/render/renderer_options.h"
#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/view_settings.h"
#include <QOpenGLWidget>
#include <functional>
#include <memory>
#include <optional>

namespace ramure {

class ArmReach;
class AutoKey;
class Document;
class HintSource;
class OutlineKey;
class Player;
class ViewMarks;
struct Change;
struct DefectPlace;

/// Times of the last picture, in milliseconds; for measuring.
struct FrameTimes
{
    double buildMs = 0.0;   ///< document to render scene
    double uploadMs = 0.0;  ///< render scene to the graphics card
    double drawMs = 0.0;    ///< commands issued, not waited for
    double drawCpuMs = 0.0; ///< the same, as the thread's own time
    bool rebuilt = false;   ///< the scene is another one than in the picture before
    quint64 frame = 0;      ///< counts pictures
    quint64 revision = 0;   ///< document revision of the oldest result that is shown
};

/// What goes on in a view.
struct ViewWork
{
    /// The picture is of an older state: the scene of now is being made in the background, or will be drawn
    /// in a moment.
    bool picture = false;
    /// Something moved just now; in a moment the picture is drawn once more, as good as was chosen.
    bool settling = false;
    /// Nothing moves, and the picture that is as good as was chosen is being made in parts; a quick one is
    /// shown.
    bool parts = false;
    /// A click on a large tree takes effect when the structure to pick in is ready.
    bool pick = false;
    bool transforming = false; ///< nodes are being moved, by the mouse or by keys
};

/// Differences between a picture and the view.
struct ViewPicture
{
    QSize size{};             ///< pixels; empty: the view's size
    bool transparent = false; ///< no background behind the scene
    std::optional<bool> grid; ///< with its axes; nothing: as the view has it
    int samples = 1;          ///< pictures that become one, each a part of a pixel beside the other
    Lens lens{};              ///< closed: everything is sharp
};

struct RenderScene;

/// All that a picture is drawn from, on any thread.
struct ViewShot
{
    std::shared_ptr<const RenderScene> scene;
    Camera camera;
    QSize pixels;
    RenderOptions options;
};

class Viewport : public QOpenGLWidget
{
    Q_OBJECT
public:
    static constexpr double orbitStepRad = 0.2617993877991494; ///< turn of one key press: 15 degrees
    static constexpr double zoomStep = 1.25;                   ///< factor of one key press

    /// Neither is owned; both must outlive the viewport.
    Viewport(Document* document, ViewSettings* settings, QWidget* parent = nullptr);
    ~Viewport() override;
    /// Trees are shown as the player moves them; while it plays, a drag on a branch pulls it and a double
    /// click on an apple lets it fall. Not owned; must outlive the viewport.
    void setPlayer(Player* player);
    /// Edits by hand become keys where it takes them. Not owned; must outlive the viewport.
    void setKeys(AutoKey* keys);
    /// Sets the names of the keys of beginTransform, for the hint: "G R S".
    void setGestureKeys(std::function<QString()> keys);
    /// Describes the present use of mouse and keys.
    [[nodiscard]] HintSource* hints() const;
    /// What panels point at in the view.
    [[nodiscard]] ViewMarks* marks() const;
    /// The words beside the line around the selection.
    [[nodiscard]] OutlineKey* outlineKey() const;

    [[nodiscard]] const Camera& camera() const;
    [[nodiscard]] FrameTimes frameTimes() const;
    [[nodiscard]] QSize sizeHint() const override;
    /// Before the widget is shown: the processor draws, so cheaper anti-aliasing is used.
    void setSoftware(bool software);

    [[nodiscard]] ViewWork work() const;

    /// The scene as it is seen now.
    [[nodiscard]] ViewShot shot(const ViewPicture& wish = {});
    [[nodiscard]] QSize pixelSize() const; ///< device pixels

    /// The camera node that the view is that of, as time goes on; noNode: none, the view is the artist's.
    [[nodiscard]] NodeId seenThrough() const;
    [[nodiscard]] double shownSeconds() const; ///< the time of the picture

    /// Returns the point on the ground under \p position; nothing if it is far away, or sky.
    [[nodiscard]] std::optional<glm::dvec3> groundAt(QPointF position) const;

    /// Returns what is under \p position; nothing if there is nothing, or if it is not yet known.
    [[nodiscard]] std::optional<PickHit> hitAt(QPointF position) const;

    /// The arm that is on its way to a target while nothing plays.
    [[nodiscard]] ArmReach* armReach() const;

public slots:
    void setCamera(const ramure::Camera& camera); ///< at once, without animation
    void frameAll();                              ///< Home: with all places that keys move it to
    void frameSelection();                        ///< F: branches, else nodes, else all, as they stand now
    void flyTo(const ramure::Camera& camera);     ///< like setCamera, with an animation
    /// Flies to where \p change takes the camera; a flight is changed at its goal.
    void steer(const std::function<void(ramure::Camera&)>& change);
    /// Follows a camera node until the view is moved; noNode stops following it.
    void lookThrough(ramure::NodeId camera);
    void clearSelection();
    void selectAllBranches(); ///< branches of the active tree
    /// Moves, turns or scales the selected nodes with mouse and keys until Enter or a click; Esc takes it
    /// back.
    void beginTransform(ramure::TransformTool tool);
    /// Moves the selected nodes, which are copies just made: one step of undo together with making them. Esc
    /// leaves them where their originals are.
    void beginMovingCopies();
    /// Frames the place and marks it until cleared.
    void showDefect(ramure::NodeId node, const ramure::DefectPlace& place);
    void clearDefect();

signals:
    void cameraChanged();
    void seenThroughChanged();
    /// noNode, noIndex where nothing is under the cursor.
    void hovered(ramure::NodeId node, ramure::Index branch);
    /// A right click, or the menu key, on a branch, a node (noIndex), or nothing (noNode). The clicked object
    /// is selected.
    void menuRequested(const QPoint& globalPosition, ramure::NodeId node, ramure::Index branch);
    /// Says why the hand could not do what it tried.
    void messageRaised(const QString& text);
    /// The picture of a bark is being made, or no longer.
    void barkMissing(bool missing);
    /// After every picture.
    void frameDrawn(const ramure::FrameTimes& times);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    void onDocumentChanged(const Change& change);
    void onSettingsChanged();
    void wishScene();
    void takeScene();
    void uploadScene();
    void drawOn();
    void finishScene();
    void showScene();
    void rebuildHighlights();
    void releaseRenderer();
    void paintOverlay();
    void paintLabels(QPainter& painter) const;
    void updateTrail();
    void explainWind();
    void beginGameWind();
    void moveCamera(const Camera& to);
    void frameBox(const Box& box);
    void hoverAt(QPointF position);
    void hover(const PickHit& hit);
    bool giveToTools(QEvent* event);

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
