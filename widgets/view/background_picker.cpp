#include "widgets/view/background_picker.h"

#include "widgets/view/moving_scene.h"
#include <algorithm>
#include <utility>

namespace ramure {
namespace {
constexpr int pickRestMs = 150;
}

BackgroundPicker::BackgroundPicker(QObject* parent)
    : QObject(parent)
    , m_latest(std::make_shared<const PickScene>())
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(pickRestMs);
    connect(&m_rest, &QTimer::timeout, this, &BackgroundPicker::start);
}

void BackgroundPicker::setDisposal(std::function<void(std::shared_ptr<const void>)> dispose)
{
    m_dispose = std::move(dispose);
}

void BackgroundPicker::dispose(std::shared_ptr<const void> last)
{
    if (m_dispose)
        m_dispose(std::move(last));
}

bool BackgroundPicker::picksTheSame(const RenderScene& scene) const
{
    const auto sameMesh = [](const MeshItem& a, const MeshItem& b) {
        return a.mesh == b.mesh && a.motion == b.motion && a.world == b.world && a.node == b.node &&
               a.pickable == b.pickable;
    };
    const auto linesOf = [](const RenderScene& of) {
        std::vector<const LineItem*> lines;
        for (const LineItem& item : of.lines) {
            if (item.pickable)
                lines.push_back(&item);
        }
        return lines;
    };
    const auto sameLines = [](const LineItem* a, const LineItem* b) {
        return a->lines == b->lines && a->motion == b->motion && a->world == b->world && a->node == b->node;
    };
    return m_scene && std::ranges::equal(m_scene->meshes, scene.meshes, sameMesh) &&
           m_scene->crowds == scene.crowds &&
           std::ranges::equal(linesOf(*m_scene), linesOf(scene), sameLines);
}

void BackgroundPicker::setScene(std::shared_ptr<const RenderScene> scene)
{
    const bool same = picksTheSame(*scene);
    dispose(std::exchange(m_scene, std::move(scene)));
    if (same)
        return;
    m_build.forget();
    m_current = false;
    m_rest.start();
}

void BackgroundPicker::start()
{
    if (m_current || m_build.isRunning())
        return;
    using Made = Expected<std::shared_ptr<const PickScene>>;
    m_build.start(
        [scene = m_scene, previous = m_latest](const Progress& progress) -> Made {
            return std::make_shared<const PickScene>(posed(*scene), previous.get(), progress.stop);
        },
        [this](Made&& made) { take(std::move(made)); });
}

void BackgroundPicker::take(Expected<std::shared_ptr<const PickScene>>&& made)
{
    if (!made)
        return emit failed(made.error()); // the next click tries again
    dispose(std::exchange(m_latest, std::move(*made)));
    m_current = true;
    emit readyChanged();
}

bool BackgroundPicker::pickBox(const PickView& view, const glm::dvec2& cornerA, const glm::dvec2& cornerB,
                               std::function<void(std::vector<PickedBranches>)> done)
{
    if (!m_current)
        return false;
    using Picked = Expected<std::vector<PickedBranches>>;
    m_box.start(
        [view, cornerA, cornerB, scene = m_latest](const Progress& /*progress*/) -> Picked {
            return scene->inRectangle(view, cornerA, cornerB);
        },
        [this, call = std::move(done)](Picked&& picked) {
            if (!picked)
                emit failed(picked.error());
            call(std::move(picked).value_or(std::vector<PickedBranches>()));
        });
    return true;
}

std::shared_ptr<const PickScene> BackgroundPicker::ready()
{
    return m_current ? m_latest : nullptr;
}

std::shared_ptr<const PickScene> BackgroundPicker::readyWithin(std::chrono::milliseconds patience)
{
    if (!m_current && m_scene) {
        m_rest.stop();
        start();
        m_build.wait(patience);
    }
    return ready();
}

} // namespace ramure
