/// \file
/// The tools of the view with a document and a mouse, without a window: for suites of tools.
#pragma once

#include "widgets/view/render/scene_builder.h"
#include "widgets/view/tools/tool_manager.h"
#include <QKeyEvent>

namespace ramure::test {

struct ToolBench : ToolHost
{
    Document document;
    GizmoSettings gizmo;
    HandSettings hand;
    ArmReach reach{&document};
    ToolContext context{*this, document, gizmo, hand, reach};
    ToolManager tools{context};

    // What the host has, and what it was asked for.
    Camera camera;
    glm::dvec2 size{800.0, 600.0};
    NavigationStyle style = NavigationStyle::Blender;
    bool windVisible = false;
    DisplayMode mode = DisplayMode::Simplified; ///< of show()
    std::shared_ptr<RenderScene> scene = std::make_shared<RenderScene>();
    std::map<NodeId, TreeResult> trees; ///< in it
    bool stale = false;
    bool ready = true; ///< what is picked in
    std::optional<AxisView> side;
    QStringList messages;
    std::vector<Index> marked; ///< branches
    bool markedGo = false;     ///< they would be taken away
    int repaints = 0;
    QList<EditOrgan> organsShown;
    /// Says what is in the box that is looked at.
    std::function<void(const std::vector<PickedBranches>&)> answerBox;

    [[nodiscard]] PickView view() const override { return {camera, size}; }
    void setCamera(const Camera& to) override { camera = to; }
    void stopFlight() override {}
    void flyToSide(AxisView to) override { side = to; }
    [[nodiscard]] NavigationStyle navigationStyle() const override { return style; }
    [[nodiscard]] bool isWindVisible() const override { return windVisible; }
    [[nodiscard]] const RenderScene& shownScene() const override { return *scene; }
    [[nodiscard]] const RenderScene& sceneAtRest() const override { return *scene; }
    [[nodiscard]] bool isStale() const override { return stale; }
    [[nodiscard]] const TreeResult* shownTree(NodeId node) const override
    {
        const auto found = trees.find(node);
        return found == trees.end() ? nullptr : &found->second;
    }
    [[nodiscard]] std::shared_ptr<const PickScene> pickScene(std::chrono::milliseconds) override
    {
        return ready ? latestPickScene() : nullptr;
    }
    [[nodiscard]] std::shared_ptr<const PickScene> latestPickScene() const override
    {
        return std::make_shared<const PickScene>(*scene, nullptr);
    }
    bool pickBox(QPointF, QPointF, std::function<void(const std::vector<PickedBranches>&)> done) override
    {
        answerBox = std::move(done);
        return ready;
    }
    void dispose(std::shared_ptr<const void>) override {}
    void markBranches(NodeId, std::vector<Index> branches, bool go) override
    {
        marked = std::move(branches);
        markedGo = go;
    }
    void repaint() override { ++repaints; }
    void updateHint() override {}
    void showOrgans(EditOrgan kind) override { organsShown += kind; }
    void raiseMessage(const QString& text) override { messages << text; }

    /// Fills the document, and shows it.
    void open(const Scene& of)
    {
        document.reset(of, {});
        show();
    }
    /// The document of now becomes what is shown.
    void show()
    {
        SceneView how;
        how.mode = mode;
        trees.clear();
        for (const Node& node : document.scene().nodes())
            if (const NodeResult* result = document.result(node.id))
                trees[node.id] = result->tree;
        const auto resultOf = [this](NodeId id) { return shownTree(id); };
        scene = std::make_shared<RenderScene>(SceneBuilder().build(document.scene(), resultOf, how));
        camera.frame(scene->box, view().aspect());
    }
    [[nodiscard]] ToolPoint at(QPointF place, Qt::MouseButton button = Qt::NoButton,
                               Qt::KeyboardModifiers held = {}) const
    {
        return {view(), place, button, held, place, std::nullopt, false, 0};
    }
    /// Logical pixels of a point of the world.
    [[nodiscard]] QPointF pixelOf(const glm::dvec3& world) const
    {
        const glm::dvec2 ndc = camera.project(world, view().aspect()).value_or(glm::dvec2(9.0));
        return {0.5 * (ndc.x + 1.0) * size.x, 0.5 * (1.0 - ndc.y) * size.y};
    }
    bool press(QPointF place, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers held = {})
    {
        return tools.press(at(place, button, held));
    }
    bool move(QPointF place, Qt::KeyboardModifiers held = {})
    {
        return tools.move(at(place, Qt::NoButton, held));
    }
    void release(QPointF place, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers held = {})
    {
        tools.release(at(place, button, held));
    }
    /// From the press to the release, in a few steps.
    void drag(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers held = {})
    {
        press(from, button, held);
        for (int i = 1; i <= 4; ++i)
            move(from + (to - from) * i / 4.0, held);
        release(to, button, held);
    }
    /// \return whether it was taken
    bool key(Qt::Key key, const QString& text = {}, Qt::KeyboardModifiers held = {})
    {
        return tools.key(QKeyEvent(QEvent::KeyPress, key, held, text), true);
    }
    [[nodiscard]] QString hint(QPointF place = {}, Qt::KeyboardModifiers held = {}) const
    {
        return tools.hint(at(place, Qt::NoButton, held));
    }
    [[nodiscard]] bool says(const char* what, QPointF place = {}, Qt::KeyboardModifiers held = {}) const
    {
        return hint(place, held).contains(QLatin1String(what));
    }
};

} // namespace ramure::test
