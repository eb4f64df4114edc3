#include "widgets/view/crowd_waiter.h"

#include "core/scatter/scatter.h"
#include "core/surface/bark/bark_maps.h"
#include <algorithm>
#include <utility>

namespace ramure {

/// Levels are made of the branches and of the parameters of leaves, fruit and bark.
bool CrowdWaiter::Source::isLike(const Source& other) const
{
    return tree.simplified == other.tree.simplified && tree.foliage == other.tree.foliage &&
           params.bark == other.params.bark && params.leafPictures == other.params.leafPictures &&
           params.barkPictures == other.params.barkPictures &&
           params.fruitPictures == other.params.fruitPictures;
}

void CrowdWaiter::follow(SceneWish& wish)
{
    std::map<NodeId, Source> wanted;
    std::erase_if(m_known, [&wish](const auto& entry) { return !wish.scene.find(entry.first); });
    for (const Node& node : wish.scene.nodes()) {
        const auto tree = wish.results.find(node.id);
        if (node.kind != NodeKind::Tree || tree == wish.results.end() || !tree->second.simplified ||
            !isPrototype(wish.scene, node.id))
            continue;
        Source source{tree->second, node.params};
        const auto known = m_known.find(node.id);
        if (known != m_known.end() && known->second.forms)
            wish.view.crowdForms[node.id] = known->second.forms;
        if (known == m_known.end() || !known->second.of.isLike(source))
            wanted.emplace(node.id, std::move(source));
    }
    const auto isSame = [](const auto& a, const auto& b) {
        return a.first == b.first && a.second.isLike(b.second);
    };
    if (std::ranges::equal(wanted, m_wanted, isSame))
        return;
    m_wanted = std::move(wanted);
    if (m_wanted.empty())
        return m_job.forget();
    m_job.start(
        [all = m_wanted](const Progress& progress) -> Expected<Made> {
            Made made;
            for (const auto& [node, source] : all) {
                auto forms = crowdForms(source.tree, source.params, progress);
                if (!forms && forms.error().code == ErrorCode::Cancelled)
                    return tl::unexpected(forms.error());
                // A tree without levels keeps the egg: the check of the mesh tells why.
                made[node] = forms ? std::make_shared<const CrowdForms>(std::move(*forms)) : nullptr;
            }
            return made;
        },
        [this](Expected<Made>&& made) {
            const auto done = std::exchange(m_wanted, {});
            if (made)
                keep(done, std::move(*made));
        });
}

void CrowdWaiter::keep(const std::map<NodeId, Source>& wanted, Made&& made)
{
    for (const auto& [node, source] : wanted)
        m_known[node] = {source, made[node]};
    emit ready();
}

} // namespace ramure

#include "moc_crowd_waiter.cpp"
