#include "widgets/base/texts/node_words.h"

#include "core/scene/kinds/node_kinds.h"
#include "widgets/base/texts/core_text.h"
#include <QCoreApplication>

namespace ramure {
namespace {

struct NodeWords
{
    Q_DECLARE_TR_FUNCTIONS(NodeWords)
};

} // namespace

QString nodeWords(const Scene& scene, const std::vector<NodeId>& nodes)
{
    if (nodes.size() > 1)
        return NodeWords::tr("%n node(s)", nullptr, static_cast<int>(nodes.size()));
    const Node* node = nodes.empty() ? nullptr : scene.find(nodes.front());
    return node ? coreText(kindRow(node->kind).word) : QString();
}

} // namespace ramure
