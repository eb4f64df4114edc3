#include "widgets/base/node_words.h"

#include <QCoreApplication>

namespace ramure {
namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(NodeWords)
};

} // namespace

QString nodeWords(const Scene& scene, const std::vector<NodeId>& nodes)
{
    if (nodes.size() > 1)
        return Words::tr("%n node(s)", nullptr, static_cast<int>(nodes.size()));
    const Node* node = nodes.empty() ? nullptr : scene.find(nodes.front());
    if (!node)
        return {};
    switch (node->kind) {
    case NodeKind::Group:
        return Words::tr("group", "behind a verb: Delete group");
    case NodeKind::Tree:
        return Words::tr("tree", "behind a verb: Delete tree");
    case NodeKind::Primitive:
        return Words::tr("primitive", "behind a verb: Delete primitive");
    case NodeKind::Mesh:
        return Words::tr("mesh", "behind a verb: Delete mesh");
    case NodeKind::Arm:
        return Words::tr("arm", "behind a verb: Delete arm");
    case NodeKind::Terrain:
        return Words::tr("terrain", "behind a verb: Delete terrain");
    }
    return {};
}

} // namespace ramure
