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

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/scene/scene.h"
#include "widgets/view/render/camera.h"
#include "widgets/view/render/renderer_options.h"
#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/view_settings.h"
#include <QImage>
#include <QOpenGLWidget>
#include <functional>
#include <memory>
#include <optional>

namespace ramure {

class ArmReach;
class AutoKey;
class Document;
class HintSource;
class Player;
struct PickHit;
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
    quint64 revision = 0;   ///< of the document, of the oldest result that is shown
};

/// How a picture of the view differs from what the view shows.
struct ViewPicture
{
    QSize size{};             ///< pixels; empty: those of the view
    bool transparent = false; ///< nothing behind what is in the scene
    std::optional<bool> grid; ///< with its axes; nothing: as the view has it
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
    static constexpr double orbitStepRad = 0.2617993877991494; ///< of one key: 15 degrees
    static constexpr double zoomStep = 1.25;                   ///< of one key

    /// Neither is owned; both must outlive the viewport.
    Viewport(Document* document, ViewSettings* settings, QWidget* parent = nullptr);
    ~Viewport() override;
    /// Trees are shown as the player moves them; while it plays, a drag on a branch pulls it and a double
    /// click on an apple lets it fall. Not owned; must outlive the viewport.
    void setPlayer(Player* player);
    /// Edits by hand become keys where it takes them. Not owned; may be null.
    void setKeys(AutoKey* keys);
    /// What the keys of beginTransform are called, for the hint: "G R S".
    void setGestureKeys(std::function<QString()> keys);
    /// What the key of the line around the selection is called, for the words beside it: "Shift+E".
    void setOutlineKey(std::function<QString()> key);
    /// What mouse and keys do right now.
    [[nodiscard]] HintSource* hints() const;
    /// Nodes are being moved, by the mouse or by keys.
    [[nodiscard]] bool isTransforming() const;

    [[nodiscard]] const Camera& camera() const;
    [[nodiscard]] FrameTimes frameTimes() const;
    [[nodiscard]] QSize sizeHint() const override;
    /// Before the widget is shown: the processor draws, so cheaper anti-aliasing is used.
    void setSoftware(bool software);

    /// The picture is of an older state: the scene of now is being made in the background, or will be drawn
    /// in a moment.
    [[nodiscard]] bool isPicturePending() const;
    /// Something moved just now; in a moment the picture is drawn once more, as good as was chosen.
    [[nodiscard]] bool isSettling() const;
    /// Nothing moves, and the picture that is as good as was chosen is being made in parts; a quick one is
    /// shown.
    [[nodiscard]] bool isPictureInMaking() const;
    /// A click on a large tree takes effect when the structure to pick in is ready; true until then.
    [[nodiscard]] bool isPickPending() const;

    /// The scene as it is seen now.
    [[nodiscard]] ViewShot shot(const ViewPicture& wish = {});
    /// A picture of the scene as it is seen, without cube and overlays. Null image where there is no context.
    [[nodiscard]] QImage screenshot(const ViewPicture& wish = {});
    /// The picture as a file (PNG by the ending). Errors: Io, Unknown (ending).
    Expected<void> saveScreenshot(const QString& path, const ViewPicture& wish = {});
    [[nodiscard]] QSize pixelSize() const; ///< device pixels

    /// The camera node that the view is that of, as time goes on; noNode: none, the view is the artist's.
    [[nodiscard]] NodeId seenThrough() const;
    [[nodiscard]] double shownSeconds() const; ///< the time of the picture

    /// What the cursor at \p position points at on the ground; nothing where that is far away, or the sky.
    [[nodiscard]] std::optional<glm::dvec3> groundAt(QPointF position) const;

    /// What is seen at \p position; noNode: nothing, or it is not yet known.
    [[nodiscard]] NodeId nodeAt(QPointF position) const;

    /// The arm that is on its way to a target while nothing plays.
    [[nodiscard]] ArmReach* armReach() const;

public slots:
    void setCamera(const ramure::Camera& camera); ///< at once, without animation
    void frameAll();                              ///< Home: with all places that keys move it to
    void frameSelection();                        ///< F: branches, else nodes, else all, as they stand now
    void setAxisView(ramure::AxisView view);
    void turnOpposite();                      ///< to the other side, from above to below
    void flyTo(const ramure::Camera& camera); ///< as setCamera, on the way there
    /// The view becomes that of a camera node, until it is moved; noNode leaves it where it is.
    void lookThrough(ramure::NodeId camera);
    /// For keys: steps of the camera without the mouse.
    void orbitBy(double yawRad, double pitchRad);
    void zoomBy(double factor);
    void clearSelection();
    void selectAllBranches(); ///< of the active tree
    /// Moves, turns or scales the selected nodes with mouse and keys until Enter or a click; Esc takes it
    /// back.
    void beginTransform(ramure::TransformTool tool);
    /// Moves the selected nodes, which are copies just made: one step of undo together with making them. Esc
    /// leaves them where their originals are.
    void beginMovingCopies();
    void copyScreenshot();
    /// The section's plane, circle and frame are shown, until noNode is given.
    void setInspectedSection(ramure::NodeId node, ramure::Index branch, ramure::Index section);
    /// Of this tree only these branches are shown, until noNode or no branch is given.
    void setIsolated(ramure::NodeId node, const std::vector<ramure::Index>& branches);
    /// Shown as if the mouse were over them, until noNode is given: of a row that it is over elsewhere.
    void pointAt(ramure::NodeId node, const std::vector<ramure::Index>& branches);
    /// Frames the place and marks it until cleared.
    void showDefect(ramure::NodeId node, const ramure::DefectPlace& place);
    void clearDefect();

signals:
    void cameraChanged();
    void seenThroughChanged();
    /// noNode, noIndex where nothing is under the cursor.
    void hovered(ramure::NodeId node, ramure::Index branch);
    /// A right click, or the menu key: on a branch, a node (noIndex), or nothing (noNode). What was clicked
    /// is selected.
    void menuRequested(const QPoint& globalPosition, ramure::NodeId node, ramure::Index branch);
    /// What the hand wanted and could not have, and why.
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
