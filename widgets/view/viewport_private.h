/// \file
/// The state of a viewport, shared by its drawing half (viewport.cpp) and its mouse half
/// (viewport_input.cpp).
#pragma once

#include "core/document/document.h"
#include "core/session/arm_reach.h"
#include "core/session/player.h"
#include "core/surface/mesh/mesh_rays.h"
#include "widgets/base/hint_source.h"
#include "widgets/view/background_builder.h"
#include "widgets/view/background_picker.h"
#include "widgets/view/defect_mark.h"
#include "widgets/view/gizmo_trail.h"
#include "widgets/view/moving_scene.h"
#include "widgets/view/render/renderer.h"
#include "widgets/view/tools/arm_rings.h"
#include "widgets/view/tools/gizmo_tool.h"
#include "widgets/view/tools/limb_drag.h"
#include "widgets/view/tools/limb_pose.h"
#include "widgets/view/tools/motion_tools.h"
#include "widgets/view/tools/tool_manager.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_hint.h"
#include <QTimer>
#include <QVariantAnimation>

namespace ramure {

struct Viewport::Private final : ToolHost
{
    Private(Viewport* viewport, Document* ofDocument, ViewSettings* ofView)
        : widget(viewport)
        , document(ofDocument)
        , settings(ofView)
    {
    }
    Viewport* widget;
    Document* document;
    ViewSettings* settings;

    Camera camera;
    Camera from, to; ///< of the animation
    QVariantAnimation flight;
    bool frameNext = true; ///< the next scene that has something in it is framed
    /// The camera shows all, and nobody has moved it since: it still does when the view gets another size.
    bool framed = false;
    quint64 frameAfter = 0; ///< serial number of a wish: scenes up to it are of another document
    enum class Framing : std::uint8_t { None, All, Selection };
    Framing framing = Framing::None; ///< waits for the scene of now

    BackgroundBuilder builder;
    quint64 wishes = 0;
    std::vector<const void*> wishedBlocks; ///< identities of what the last wish was made from
    std::optional<BuiltScene> next;        ///< on its way to the graphics card
    QTimer uploading;
    double uploadedMs = 0.0; ///< of next
    std::shared_ptr<const RenderScene> scene = std::make_shared<const RenderScene>();
    bool sceneIsNew = false; ///< not drawn yet
    bool highlightsStale = false;
    InspectedSection inspected;
    NodeId isolatedNode = noNode;
    std::vector<Index> isolatedBranches;
    DefectMark defect;

    std::unique_ptr<Renderer> renderer;
    bool software = false;
    QString failure; ///< why there is no renderer
    QMetaObject::Connection contextGone;
    FrameTimes times;

    // What moves, see viewport_motion.cpp.
    Player* player = nullptr;
    MovingScene moving;
    std::shared_ptr<const RenderScene> shown; ///< what is drawn: the scene with all in its place of now
    std::shared_ptr<const RenderScene> shownOf;
    std::shared_ptr<const MotionFrame> shownMotion;
    quint64 shownTrail = 0, shownDefect = 0;
    std::shared_ptr<const MotionFrame> wishedMotion; ///< whose trees the scene is made of, where it has any
    GrabbedBranch grabbed;
    glm::dvec3 handAt{0.0};        ///< world
    std::optional<WindArrow> wind; ///< while its head is dragged
    quint64 windGesture = 0;
    std::unique_ptr<LimbDrag> limb;     ///< while a limb follows the hand
    std::unique_ptr<LimbPose> limbPose; ///< from then on until its mesh is shown
    QTimer limbRest;
    std::size_t limbBranches = LimbDrag::usualBranches;
    ArmReach reach{document};
    std::shared_ptr<const MotionFrame> reachFrame, reachOf; ///< with the arm on its way; made from
    NodeId aimingArm = noNode;                              ///< while its target is dragged
    NodeId aimedAt = noNode;                                ///< the surface on which the target moves
    std::shared_ptr<const PickScene> aimedScene;            ///< in which it is met; null: aimedRays
    MeshRays aimedRays;                                     ///< of a small surface that no pick scene has yet
    quint64 aimGesture = 0;
    std::optional<std::size_t> ring; ///< of the active arm, while it is turned
    ArmRing ringAtPress;
    double ringFrom = 0.0; ///< rad, where it was taken
    quint64 ringGesture = 0;

    // What is said in the status bar, see viewport_hints.cpp.
    HintSource hints;
    Qt::KeyboardModifiers held;
    std::function<QString()> gestureKeys;
    [[nodiscard]] ViewportSituation situation(QSize size) const;
    [[nodiscard]] ToolPoint pointAt(QPointF position) const;
    [[nodiscard]] ToolPoint pointOf(const QMouseEvent& event) const;

    // Paths and ghosts, see viewport_trail.cpp.
    GizmoTrail trail;

    BackgroundPicker picker;
    QTimer hoverRest;
    QPointF hoverPosition;
    NodeId hoverNode = noNode;
    Index hoverBranch = noIndex;
    NodeId pointedNode = noNode; ///< by a row of the scene panel
    std::vector<Index> pointedBranches;

    Gesture gesture = Gesture::None;
    Qt::MouseButton button = Qt::NoButton;
    QPointF pressed, last;
    bool dragging = false; ///< the pointer has left the place of the press

    ToolContext context{*this, *document, *settings->gizmo(), reach};
    ToolManager tools{context};

    /// As tracks shape it now, or as the document has it.
    [[nodiscard]] const TreeResult* resultOf(NodeId id) const
    {
        if (wishedMotion)
            if (const auto now = wishedMotion->trees.find(id); now != wishedMotion->trees.end())
                return &now->second;
        const NodeResult* result = document->result(id);
        return result ? &result->tree : nullptr;
    }

    // As the host of the tools, see viewport_tools.cpp.
    [[nodiscard]] PickView view() const override;
    void setCamera(const Camera& moved) override;
    void stopFlight() override { flight.stop(); }
    void flyToSide(AxisView side) override { widget->setAxisView(side); }
    [[nodiscard]] NavigationStyle navigationStyle() const override { return settings->navigationStyle(); }
    [[nodiscard]] bool isWindVisible() const override { return settings->windVisible(); }
    [[nodiscard]] const RenderScene& shownScene() const override { return shown ? *shown : *scene; }
    [[nodiscard]] const RenderScene& sceneAtRest() const override { return *scene; }
    [[nodiscard]] bool isStale() const override { return builder.isBusy() || next; }
    [[nodiscard]] std::shared_ptr<const PickScene> pickScene(std::chrono::milliseconds patience) override;
    [[nodiscard]] std::shared_ptr<const PickScene> latestPickScene() const override
    {
        return picker.latest();
    }
    bool pickBox(QPointF cornerA, QPointF cornerB,
                 std::function<void(const std::vector<PickedBranches>&)> done) override;
    void dispose(std::shared_ptr<const void> block) override { builder.dispose(std::move(block)); }
    void repaint() override { widget->update(); }
    void updateHint() override { widget->updateHint(); }
    void raiseMessage(const QString& text) override { emit widget->messageRaised(text); }

    void updateShown();
    [[nodiscard]] std::shared_ptr<const MotionFrame> motionOfNow();
    /// The arm that a target is meant for: the active one, else the first that is shown.
    [[nodiscard]] NodeId armForTarget() const;
    [[nodiscard]] double timeNow() const; ///< s, of the player's frame
    /// Looks for the surface of a node that can be met at once. \p scene may be null. \return its item
    const MeshItem* aimAt(NodeId surface, std::shared_ptr<const PickScene> scene);
    /// The item that shows the surface, where it is now.
    [[nodiscard]] const MeshItem* surfaceOf(NodeId node) const;
    [[nodiscard]] std::optional<glm::dvec3> aimedPoint(const PickView& view, const glm::dvec2& pixel) const;
    /// Of the active arm at rest; empty while it moves.
    [[nodiscard]] std::vector<ArmRing> rings() const;
    [[nodiscard]] std::vector<glm::dvec3> targets() const;
    [[nodiscard]] Box treeBox(NodeId node) const;
    [[nodiscard]] std::vector<WindArrow> windArrows(QSize size) const;
    [[nodiscard]] SceneView sceneView() const;
    [[nodiscard]] SceneWish wish();
    [[nodiscard]] RenderOptions options(double pixelRatio) const;
};

} // namespace ramure
