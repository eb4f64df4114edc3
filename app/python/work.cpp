#include "app/python/work.h"

#include "core/scene/growth_spaces.h"

namespace ramure::python {

Work::Work(cli::Input input, std::string name, std::string extras)
    : m_input(std::make_unique<cli::Input>(std::move(input)))
    , m_pipeline(std::make_unique<TreePipeline>())
    , m_name(std::move(name))
    , m_extras(std::move(extras))
{
    // Nobody undoes here: what a loop over seeds leaves behind would fill the memory.
    const Scene* const scene = m_input->scene();
    m_pipeline->setCacheSize(1 + (scene ? scene->nodes().size() : 0));
}

Work::Turn::Turn(Work& work)
    : m_work(work)
{
    if (work.m_owner.load() == std::this_thread::get_id())
        raise(ErrorCode::Invalid, "a callback cannot use the tree that is at work");
    m_lock = std::unique_lock(work.m_mutex);
    if (!work.m_input)
        raise(ErrorCode::Invalid, "it is closed");
    work.m_owner = std::this_thread::get_id();
}

void Work::close()
{
    const pybind11::gil_scoped_release released;
    if (m_owner.load() == std::this_thread::get_id())
        raise(ErrorCode::Invalid, "a callback cannot close the tree that is at work");
    const std::scoped_lock lock(m_mutex);
    m_pipeline.reset();
    m_input.reset();
}

Expected<Scene*> Work::scene()
{
    if (auto* const scene = std::get_if<Scene>(&m_input->content))
        return scene;
    return fail(ErrorCode::Invalid, "\"%1\" is a mesh: it has no trees", {m_name});
}

Expected<Node*> Work::tree(NodeId id)
{
    const auto found = scene();
    RAMURE_TRY(found);
    if (Node* const node = (*found)->find(id); node && node->kind == NodeKind::Tree)
        return node;
    return fail(ErrorCode::Unknown, "there is no such tree");
}

void Work::touched()
{
    if (auto* const scene = std::get_if<Scene>(&m_input->content))
        linkGrowthSpaces(*scene);
}

Expected<TreeResult> Work::grown(NodeId id, Stage last, const Progress& progress)
{
    const auto node = tree(id);
    RAMURE_TRY(node);
    return m_pipeline->evaluate((*node)->params, last, progress);
}

} // namespace ramure::python
