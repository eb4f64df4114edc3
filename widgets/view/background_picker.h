/// \file
/// Builds the pick scene on a thread of its own, after the render scene has been still for a moment; a click
/// that comes earlier waits for it.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/pick/pick_scene.h"
#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>

namespace ramure {

class BackgroundPicker : public QObject
{
    Q_OBJECT
public:
    explicit BackgroundPicker(QObject* parent = nullptr);

    /// Who lets go of large structures that are out of date; without one it happens here.
    void setDisposal(std::function<void(std::shared_ptr<const void>)> dispose);
    /// The scene to pick in from now on. Where nothing that can be picked differs, what was built stays.
    void setScene(std::shared_ptr<const RenderScene> scene);
    /// The structure built last, perhaps for an older scene; null before the first. For what has not changed
    /// since, surfaces that only move above all.
    [[nodiscard]] const std::shared_ptr<const PickScene>& latest() const { return m_latest; }
    /// The structure for the present scene, or null while it is not built.
    [[nodiscard]] std::shared_ptr<const PickScene> ready();
    /// The same; where it is not built, building starts at once and gets this long. Null where that is not
    /// enough: readyChanged follows.
    [[nodiscard]] std::shared_ptr<const PickScene> readyWithin(std::chrono::milliseconds patience);
    /// Everything in a rectangle, see PickScene::inRectangle: in the background, as it can be all branches of
    /// a large tree. \p done is called on this object's thread, unless another box or this object's end
    /// comes first. False while there is nothing to pick in.
    bool pickBox(const PickView& view, const glm::dvec2& cornerA, const glm::dvec2& cornerB,
                 std::function<void(std::vector<PickedBranches>)> done);

signals:
    void readyChanged();
    /// What was to be built, or picked, is not.
    void failed(const ramure::Error& error);

private:
    [[nodiscard]] bool picksTheSame(const RenderScene& scene) const;
    void start();
    void take(Expected<std::shared_ptr<const PickScene>>&& made);
    void dispose(std::shared_ptr<const void> last);

    std::function<void(std::shared_ptr<const void>)> m_dispose;
    std::shared_ptr<const RenderScene> m_scene;
    std::shared_ptr<const PickScene> m_latest; ///< built last, perhaps of an older scene
    bool m_current = true;                     ///< m_latest belongs to m_scene
    Job m_build, m_box;
    QTimer m_rest;
};

} // namespace ramure
