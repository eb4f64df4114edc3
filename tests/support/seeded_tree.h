/// \file
/// A document of one tree whose seed counts the edits, for suites that kill and recover.
#pragma once

#include "core/qt/document/commands.h"

namespace ramure::test {

inline Scene oneTree()
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.name = "Oak";
    return *Scene::fromNodes({node});
}
inline void setSeed(Document& document, std::int64_t seed)
{
    edit::setParam(document, {1}, *findParam("grammar.seed"), seed);
}
inline std::int64_t seedOf(const Project& project)
{
    return project.scene.find(1)->params.grammar.seed;
}

} // namespace ramure::test
