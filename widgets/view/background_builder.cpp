#include "widgets/view/background_builder.h"

#include "core/base/stopwatch.h"
#include <utility>

namespace ramure {

static BuiltScene builtScene(SceneBuilder& builder, SceneWish&& wish)
{
    const Stopwatch watch;
    const auto resultOf = [&wish](NodeId id) -> const TreeResult* {
        const auto it = wish.results.find(id);
        return it == wish.results.end() ? nullptr : &it->second;
    };
    BuiltScene built;
    built.scene = std::make_shared<RenderScene>(builder.build(wish.scene, resultOf, wish.view));
    built.view = std::move(wish.view);
    built.revision = wish.revision;
    built.serial = wish.serial;
    built.buildMs = watch.elapsed().wallMs;
    return built;
}

BackgroundBuilder::BackgroundBuilder(QObject* parent)
    : QObject(parent)
    , m_thread([this](const std::stop_token& quit) { loop(quit); })
{
}

BackgroundBuilder::~BackgroundBuilder()
{
    m_thread.request_stop();
    m_thread.join();
}

void BackgroundBuilder::wish(SceneWish wish)
{
    const std::scoped_lock lock(m_mutex);
    m_waiting = std::move(wish);
    m_wake.notify_one();
}

bool BackgroundBuilder::isBusy() const
{
    const std::scoped_lock lock(m_mutex);
    return m_waiting || m_building || m_built;
}

std::optional<BuiltScene> BackgroundBuilder::take()
{
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_built, std::nullopt);
}

std::optional<BuiltScene> BackgroundBuilder::finish()
{
    std::unique_lock lock(m_mutex);
    m_done.wait(lock, [this] { return !m_waiting && !m_building; });
    return std::exchange(m_built, std::nullopt);
}

void BackgroundBuilder::dispose(std::shared_ptr<const void> last)
{
    if (!last)
        return;
    const std::scoped_lock lock(m_mutex);
    m_disposed.push_back(std::move(last));
    m_wake.notify_one();
}

void BackgroundBuilder::loop(const std::stop_token& quit)
{
    for (;;) {
        std::optional<SceneWish> wish;
        std::vector<std::shared_ptr<const void>> disposed;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, quit, [this] { return m_waiting || !m_disposed.empty(); });
            if (quit.stop_requested())
                return;
            wish = std::exchange(m_waiting, std::nullopt);
            m_building = wish.has_value();
            disposed.swap(m_disposed);
        }
        if (!wish)
            continue; // what was disposed of goes at the end of this turn
        std::optional<BuiltScene> made = builtScene(m_builder, std::move(*wish));
        {
            const std::scoped_lock lock(m_mutex);
            std::swap(m_built, made); // one that nobody took goes here too
            m_building = false;
            m_done.notify_all();
        }
        emit built();
    }
}

} // namespace ramure

#include "moc_background_builder.cpp"
