/// \file
/// How an action names the nodes it acts on, before it does.
#pragma once

#include "core/scene/scene.h"
#include <QString>
#include <vector>

namespace ramure {

/// "tree", "group", "3 nodes"; to stand behind a verb. Empty where there is no such node.
QString nodeWords(const Scene& scene, const std::vector<NodeId>& nodes);

} // namespace ramure
