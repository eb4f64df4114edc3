#include "core/mesh/mesh_scratch.h"

namespace ramure {

std::unique_ptr<MeshSink> MeshScratch::takeSink()
{
    if (m_sinks.empty())
        return std::make_unique<MeshSink>();
    std::unique_ptr<MeshSink> sink = std::move(m_sinks.back());
    m_sinks.pop_back();
    sink->clear();
    return sink;
}

void MeshScratch::keepSink(std::unique_ptr<MeshSink> sink)
{
    m_sinks.push_back(std::move(sink));
}

} // namespace ramure
