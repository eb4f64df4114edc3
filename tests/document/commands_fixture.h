/// \file
/// A small document for the suites of commands.
#pragma once

#include "core/qt/document/commands.h"
#include "tests/document/recorder.h"

namespace ramure::test {

using Ids = std::vector<NodeId>;

inline Node makeNode(NodeId id, NodeId parent = noNode, NodeKind kind = NodeKind::Tree)
{
    Node node;
    node.id = id;
    node.parent = parent;
    node.kind = kind;
    node.name = std::string("n").append(std::to_string(id));
    return node;
}
inline Ids idsOf(const Document& document)
{
    Ids ids;
    for (const Node& node : document.scene().nodes())
        ids.push_back(node.id);
    return ids;
}
inline QByteArray fileOf(const Document& document)
{
    return writeProject(document.project());
}

/// Group 1 with trees 2 and 3, tree 4 beside it.
struct Fixture
{
    explicit Fixture(NodeKind kind = NodeKind::Tree)
    {
        document.reset(*Scene::fromNodes({makeNode(1, noNode, NodeKind::Group), makeNode(2, 1, kind),
                                          makeNode(3, 1, kind), makeNode(4, noNode, kind)}),
                       {});
        recorder.changes.clear();
    }
    Document document;
    Recorder recorder{document};
    const QUndoStack& stack = *document.undoStack();
};

} // namespace ramure::test
