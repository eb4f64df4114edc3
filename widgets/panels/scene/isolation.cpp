#include "widgets/panels/scene/isolation.h"

#include <utility>

namespace ramure {

Isolation::Isolation(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(document, &Document::changed, this, &Isolation::follow);
}

const Skeleton* Isolation::skeleton() const
{
    const NodeResult* result = m_document->result(m_node);
    return result && result->tree.simplified ? &result->tree.simplified->skeleton : nullptr;
}

std::vector<Index> Isolation::present() const
{
    std::vector<Index> found;
    const Skeleton* bones = skeleton();
    for (Index branch = 0; bones && branch < bones->size(); ++branch)
        if (m_keys.contains(bones->key[branch]))
            found.push_back(branch);
    return found;
}

void Isolation::toggleSelected()
{
    const Selection& selection = m_document->selection();
    const NodeResult* result = m_document->result(selection.branchNode);
    std::set<std::uint64_t> wanted;
    if (result && result->tree.simplified) {
        const Skeleton& bones = result->tree.simplified->skeleton;
        for (const Index branch : selection.branches)
            if (branch < bones.size())
                wanted.insert(bones.key[branch]);
    }
    if (wanted.empty() || (m_node == selection.branchNode && m_keys == wanted))
        return clear();
    m_node = selection.branchNode;
    m_keys = std::move(wanted);
    m_branches = present();
    emit changed();
}

void Isolation::clear()
{
    if (!isActive())
        return;
    m_node = noNode;
    m_keys.clear();
    m_branches.clear();
    emit changed();
}

void Isolation::follow(const Change& change)
{
    if (!isActive())
        return;
    if (change.has(changeReset) || !m_document->scene().find(m_node))
        return clear();
    if (!change.has(changeResults))
        return;
    std::vector<Index> now = present();
    if (std::exchange(m_branches, std::move(now)) != m_branches)
        emit changed();
}

} // namespace ramure
