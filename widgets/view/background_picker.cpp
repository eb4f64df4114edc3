#include "widgets/view/background_picker.h"

#include "widgets/view/moving_scene.h"
#include <algorithm>
#include <utility>

namespace ramure {
namespace {
constexpr int restMs = 150;
}

BackgroundPicker::BackgroundPicker(QObject* parent)
    : QObject(parent)
    , m_latest(std::make_shared<const PickScene>())
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, &BackgroundPicker::start);
}

BackgroundPicker::~BackgroundPicker()
{
    abandon(); // the members' destructors wait for what is still running
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
           std::ranges::equal(linesOf(*m_scene), linesOf(scene), sameLines);
}

void BackgroundPicker::setScene(std::shared_ptr<const RenderScene> scene)
{
    const bool same = picksTheSame(*scene);
    dispose(std::exchange(m_scene, std::move(scene)));
    if (same)
        return;
    abandon();
    m_current = false;
    m_rest.start();
}

void BackgroundPicker::abandon()
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    // A future of std::async waits when it is destroyed: keep those that are not done, the interface must not
    // wait.
    std::erase_if(m_abandoned, [](const auto& run) {
        return run.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    if (m_running.valid())
        m_abandoned.push_back(std::move(m_running));
    m_running = {};
}

void BackgroundPicker::start()
{
    if (m_current || m_running.valid())
        return;
    const quint64 build = ++m_build;
    m_running = std::async(
        std::launch::async, [this, build, scene = m_scene, previous = m_latest, stop = m_stop.get_token()] {
            auto made = std::make_shared<const PickScene>(posed(*scene), previous.get(), stop);
            QMetaObject::invokeMethod(
                this, [this, build] { finish(build); }, Qt::QueuedConnection);
            return made;
        });
}

void BackgroundPicker::finish(quint64 build)
{
    if (!m_running.valid() || build != m_build)
        return;
    dispose(std::exchange(m_latest, m_running.get()));
    m_current = true;
    emit readyChanged();
}

bool BackgroundPicker::pickBox(const PickView& view, const glm::dvec2& cornerA, const glm::dvec2& cornerB,
                               std::function<void(std::vector<PickedBranches>)> done)
{
    if (!m_current)
        return false;
    const quint64 box = ++m_box;
    auto run = [this, box, view, cornerA, cornerB, scene = m_latest, call = std::move(done)] {
        auto answer = [this, box, call, picked = scene->inRectangle(view, cornerA, cornerB)] {
            if (box == m_box)
                call(picked);
        };
        QMetaObject::invokeMethod(this, std::move(answer), Qt::QueuedConnection);
    };
    // Waits for a box before this one: nobody draws two within its time.
    m_boxRun = std::async(std::launch::async, std::move(run));
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
        if (m_running.wait_for(patience) == std::future_status::ready)
            finish(m_build);
    }
    return ready();
}

} // namespace ramure
