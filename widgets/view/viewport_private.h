/// \file
/// The state of a viewport, shared by its files: camera and pictures (viewport.cpp), the way of a scene
/// (viewport_scene.cpp), what moves (viewport_motion.cpp), mouse and keys (viewport_input.cpp).
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/arm/arm_reach.h"
#include "core/qt/session/motion/player.h"
#include "widgets/base/hint_source.h"
#include "widgets/view/background_builder.h"
#include "widgets/view/background_picker.h"
#include "widgets/view/bark_waiter.h"
#include "widgets/view/camera_flight.h"
#include "widgets/view/crowd_waiter.h"
#include "widgets/view/outline_key.h"
#include "widgets/view/render/passes/renderer.h"
#include "widgets/view/shown_scene.h"
#include "widgets/view/tools/gizmo/gizmo_tool.h"
#include "widgets/view/tools/tool_manager.h"
#include "widgets/view/view_marks.h"
#include "widgets/view/viewport.h"
#include <QElapsedTimer>
#include <QTimer>

namespace ramure {

struct Viewport::Private final : ToolHost
{
    Private(Viewport* viewport, Document* ofDocument, ViewSettings* ofView)
        : widget(viewport)
        , document(ofDocument)
        , settings(ofView)
    {
        for (QTimer* timer : {&upload.turns, &fine.turns, &settling, &hoverRest, &upload.late})
            timer->setSingleShot(true);
        QObject::connect(&pending.crowds, &CrowdWaiter::ready, viewport, &Viewport::wishScene);
        QObject::connect(&upload.late, &QTimer::timeout, viewport, [this] {
            widget->setAccessibleDescription(Viewport::tr("This picture is out of date"));
            widget->update();
        });
    }
    Viewport* widget;
    Document* document;
    ViewSettings* settings;

    CameraFlight flight;
    NodeId through = noNode; ///< the camera node that the view follows
    Lens lens;               ///< its
    /// The picture at rest that is as good as was chosen.
    struct Fine
    {
        /// What it is of.
        struct Subject
        {
            std::shared_ptr<const RenderScene> scene;
            Camera camera;
            QSize size;
            RenderOptions options;
            bool operator==(const Subject&) const = default;
        };
        Subject of;
        int whole = 0; ///< pictures of it: with a lens many, of which the mean is shown
        QTimer turns;  ///< runs while one is made in parts
    } fine;
    /// What the camera shows of the scene.
    struct Frame
    {
        enum class Wish : std::uint8_t { None, All, Selection };
        Wish wanted = Wish::None; ///< waits for the scene of now
        bool next = true;         ///< the next scene that has something in it is framed
        /// The camera shows all, and nobody has moved it since: it still does when the view gets another
        /// size.
        bool isAll = false;
        bool again = false; ///< nodes have come or gone since, and are not all seen yet
        quint64 after = 0;  ///< serial number of a wish: scenes up to it are of another document
        /// From where the last document was looked at means nothing for this one.
        bool isOfLast = false;
        Camera own;                     ///< that of the artist, before it followed trees that grow
        std::optional<Camera> followed; ///< where that has brought it; another one is the artist's again

        /// The camera for a tree that has grown: see viewport_camera.cpp.
        [[nodiscard]] Camera follow(const Camera& now, double aspect, bool isDraft,
                                    const std::vector<glm::dvec3>& before,
                                    const std::vector<glm::dvec3>& points);
    } frame;

    BackgroundBuilder builder;
    /// What a scene is drawn without until it is made.
    struct Pending
    {
        BarkWaiter barks;
        CrowdWaiter crowds;
        [[nodiscard]] bool isBusy() const { return barks.isBusy() || crowds.isBusy(); }
        void wait()
        {
            barks.wait();
            crowds.wait();
        }
        void follow(SceneWish& wish)
        {
            barks.follow(wish);
            crowds.follow(wish);
        }
    } pending;
    quint64 wishes = 0;
    std::vector<const void*> wishedBlocks; ///< identities of what the last wish was made from
    /// A scene on its way to the graphics card.
    struct Upload
    {
        std::optional<BuiltScene> next;
        QTimer turns;
        double pastMs = 0.0; ///< spent on it so far
        QTimer late;         ///< runs while the picture is out of date, and that is not said yet
    } upload;
    QElapsedTimer windClock; ///< runs while trees stand in the wind of a game
    OutlineKey outline;
    bool outlineIsNew = false; ///< something else is selected than the scene shows
    QTimer settling; ///< runs while something moves: software rasterisers then do less for a picture
    std::shared_ptr<const RenderScene> scene = std::make_shared<const RenderScene>();
    std::map<NodeId, TreeResult> trees; ///< in the scene
    bool sceneIsNew = false;            ///< not drawn yet
    bool highlightsStale = false;

    ViewMarks marks;
    DefectMark defect;

    std::unique_ptr<Renderer> renderer;
    bool software = false;
    QString failure; ///< why there is no renderer
    QMetaObject::Connection contextGone;
    FrameTimes times;

    ShownScene shown;
    std::shared_ptr<const MotionFrame> wishedMotion; ///< whose trees the scene is made of, where it has any
    GizmoTrail trail;                                ///< paths and ghosts
    ArmReach reach{document};
    ReachPose reachPose;

    BackgroundPicker picker;
    QTimer hoverRest;
    struct Pointer
    {
        QPointF at;
        Qt::KeyboardModifiers held;
        std::optional<double> pressure; ///< of the pen that touches
        bool isEraser = false;
    } pointer;
    HintSource hints;
    ToolContext context{*this, *document, *settings->gizmo(), *settings->hand(), reach};
    ToolManager tools{context}; ///< last: it uses the above

    [[nodiscard]] const Camera& camera() const { return flight.camera(); }
    [[nodiscard]] ToolPoint pointAt(QPointF position) const;
    [[nodiscard]] ToolPoint pointOf(const QMouseEvent& event) const;
    /// As tracks shape it now, or as the document has it.
    [[nodiscard]] const TreeResult* resultOf(NodeId id) const;
    void updateShown();
    void followCamera();
    [[nodiscard]] bool isWindy() const;
    void draw(QSize pixels, const RenderOptions& options);
    [[nodiscard]] bool isMadeInParts(const RenderOptions& options) const
    {
        return software && options.quality == Quality::Best;
    }
    void drawPart();
    void forgetPicture();
    void leaveCamera();
    [[nodiscard]] std::shared_ptr<const MotionFrame> motionOfNow();
    [[nodiscard]] SceneView sceneView() const;
    [[nodiscard]] SceneWish wish();
    [[nodiscard]] bool showsBranchesOf(NodeId node) const;
    void noteAge();
    [[nodiscard]] bool isPosedDraft(const Change& change) const;
    [[nodiscard]] RenderOptions options(double pixelRatio) const;

    // As the host of the tools.
    [[nodiscard]] PickView view() const override;
    void setCamera(const Camera& moved) override;
    void stopFlight() override { flight.stop(); }
    void flyToSide(AxisView side) override
    {
        widget->steer([side](Camera& to) { to.setAxisView(side); });
    }
    [[nodiscard]] NavigationStyle navigationStyle() const override { return settings->navigationStyle(); }
    [[nodiscard]] bool isWindVisible() const override { return settings->windVisible(); }
    [[nodiscard]] const RenderScene& shownScene() const override
    {
        return shown.scene() ? *shown.scene() : *scene;
    }
    [[nodiscard]] const RenderScene& sceneAtRest() const override { return *scene; }
    [[nodiscard]] bool isStale() const override { return builder.isBusy() || upload.next; }
    [[nodiscard]] const TreeResult* shownTree(NodeId node) const override;
    [[nodiscard]] std::shared_ptr<const PickScene> pickScene(std::chrono::milliseconds patience) override;
    [[nodiscard]] std::shared_ptr<const PickScene> latestPickScene() const override
    {
        return picker.latest();
    }
    bool pickBox(QPointF cornerA, QPointF cornerB,
                 std::function<void(const std::vector<PickedBranches>&)> done) override;
    void dispose(std::shared_ptr<const void> block) override { builder.dispose(std::move(block)); }
    void markBranches(NodeId node, std::vector<Index> branches, bool go) override
    {
        marks.mark(node, std::move(branches), go);
    }
    void repaint() override { widget->update(); }
    void updateHint() override;
    void showOrgans(EditOrgan kind) override
    {
        (kind == EditOrgan::Leaf ? settings->leavesVisible : settings->applesVisible).set(true);
    }
    void raiseMessage(const QString& text) override { emit widget->messageRaised(text); }
};

} // namespace ramure
