#include "widgets/view/bark_waiter.h"

#include <algorithm>

namespace ramure {

void BarkWaiter::follow(const SceneWish& wish)
{
    std::vector<Wanted> wanted;
    for (const auto& [id, tree] : wish.results) {
        const Node* node = wish.scene.find(id);
        if (node && tree.texture && isPictured(node->params) && !isBarkReady(*tree.texture, node->params))
            wanted.push_back({tree.texture, node->params});
    }
    const auto isSame = [](const Wanted& a, const Wanted& b) {
        return a.stage == b.stage && a.params.texture == b.params.texture;
    };
    if (std::ranges::equal(wanted, m_wanted, isSame))
        return;
    m_wanted = std::move(wanted);
    if (m_wanted.empty())
        return m_job.forget();
    m_job.start(
        [all = m_wanted](const Progress& progress) -> Expected<void> {
            for (const Wanted& one : all)
                RAMURE_TRY(
                    one.stage->coordinates(one.params.texture, progress)); // the check of the mesh tells why
            return {};
        },
        [this](const Expected<void>& done) {
            if (done)
                emit ready();
        });
}

} // namespace ramure

#include "moc_bark_waiter.cpp"
