#include "widgets/view/background_builder.h"

#include "core/base/stopwatch.h"
#include <utility>

namespace ramure {

static constexpr int disposalLane = 1; ///< after the scenes

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
    built.trees = std::move(wish.results);
    built.revision = wish.revision;
    built.serial = wish.serial;
    built.buildMs = watch.elapsed().wallMs;
    return built;
}

BackgroundBuilder::BackgroundBuilder(QObject* parent)
    : QObject(parent)
    , m_builder(std::make_shared<SceneBuilder>())
{
}

void BackgroundBuilder::wish(SceneWish wish)
{
    m_job.start([builder = m_builder, wish = std::move(wish)](const Progress& /*progress*/) mutable
                -> Expected<BuiltScene> { return builtScene(*builder, std::move(wish)); },
                [this](Expected<BuiltScene>&& made) { keep(std::move(made)); }, Job::Running::GoesOn);
}

void BackgroundBuilder::keep(Expected<BuiltScene>&& made)
{
    if (!made) {
        m_builder = std::make_shared<SceneBuilder>(); // the other may have been left half-way
        return emit failed(made.error());
    }
    if (m_built) // nobody took it
        dispose(std::move(m_built->scene));
    m_built = std::move(*made);
    if (!m_isFinishing)
        emit built();
}

bool BackgroundBuilder::isBusy() const
{
    return m_job.isRunning() || m_built;
}

std::optional<BuiltScene> BackgroundBuilder::take()
{
    return std::exchange(m_built, std::nullopt);
}

std::optional<BuiltScene> BackgroundBuilder::finish()
{
    m_isFinishing = true;
    m_job.wait();
    m_isFinishing = false;
    return take();
}

void BackgroundBuilder::dispose(std::shared_ptr<const void> last)
{
    if (!last)
        return;
    if (!m_job.withdraw(disposalLane)) // the thread has the bin already
        m_bin = std::make_shared<std::vector<std::shared_ptr<const void>>>();
    m_bin->push_back(std::move(last));
    m_job.start(
        [bin = m_bin](const Progress& /*progress*/) {
            bin->clear();
            return Expected<void>();
        },
        [](const Expected<void>& /*done*/) {}, Job::Running::GoesOn, disposalLane);
}

} // namespace ramure

#include "moc_background_builder.cpp"
