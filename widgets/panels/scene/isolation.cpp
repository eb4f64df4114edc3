#include "widgets/panels/scene/isolation.h"

#include "core/skeleton/edit_places.h"

#include <algorithm>
#include <utility>

namespace ramure {

Isolation::Isolation(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(document, &Document::changed, this, &Isolation::follow);
}

const TreeResult* Isolation::tree() const
{
    const NodeResult* result = m_document->result(m_node);
    return result && result->tree.skeleton && result->tree.simplified ? &result->tree : nullptr;
}

std::vector<Index> Isolation::present() const
{
    const TreeResult* grown = tree();
    if (!grown)
        return {};
    std::vector<Index> found = findBranches(*grown->skeleton, *grown->simplified, m_places);
    std::ranges::sort(found);
    found.erase(std::ranges::find(found, noIndex), found.end()); // the largest of all
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void Isolation::toggleSelected()
{
    const Selection& selection = m_document->selection();
    if (selection.branches.empty() || (m_node == selection.branchNode && m_branches == selection.branches))
        return clear();
    m_node = selection.branchNode;
    const TreeResult* grown = tree();
    if (!grown)
        return clear();
    const TreeAxes axes = axesOf(*grown->skeleton);
    m_places.clear();
    for (const Index branch : selection.branches)
        m_places.push_back(placeOf(axes, grown->simplified->skeleton.source[branch], 0));
    m_seen = grown->simplified;
    m_branches = selection.branches;
    emit changed();
}

void Isolation::clear()
{
    if (!isActive())
        return;
    m_node = noNode;
    m_places.clear();
    m_seen.reset();
    m_branches.clear();
    emit changed();
}

void Isolation::follow(const Change& change)
{
    if (!isActive())
        return;
    if (change.has(changeReset) || !m_document->scene().find(m_node))
        return clear();
    const TreeResult* grown = tree();
    const auto simplified = grown ? grown->simplified : nullptr;
    if (!change.has(changeResults) || m_seen == simplified)
        return;
    m_seen = simplified;
    std::vector<Index> now = present();
    if (std::exchange(m_branches, std::move(now)) != m_branches)
        emit changed();
}

} // namespace ramure
