/// \file
/// What changed in a document: small and copyable, the only news that views get.
#pragma once

#include "core/params/param_def.h"
#include "core/scene/scene.h"
#include <QMetaType>
#include <QtGlobal>
#include <vector>

namespace ramure {

enum ChangeKind : quint32 {
    changeStructure = 1,    ///< nodes added, removed, moved
    changeParams = 2,       ///< values of parameters (Change::params) of nodes (Change::nodes)
    changeNodeState = 4,    ///< name, visible, locked
    changeSelection = 8,    ///< not part of undo
    changeResults = 16,     ///< a computation finished, or failed, for nodes (Change::nodes)
    changeFile = 32,        ///< path or modified state
    changeReset = 64,       ///< another document: everything
    changeBranches = 128,   ///< steps of trees
    changeTimeline = 256,   ///< frames and frame rate of the scene
    changeTracks = 512,     ///< keys or extrapolation of tracks of nodes (Change::nodes)
    changeJoints = 1024,    ///< joints of arms, or what they wear (Change::nodes)
    changeBookmarks = 2048, ///< views that are kept
};

struct Change
{
    quint32 kinds = 0;
    std::vector<NodeId> nodes;
    std::vector<ParamId> params;
    Stage firstStale = Stage::Placement; ///< the first stage whose result is no longer that of the parameters
    quint64 revision = 0;                ///< of the document after the change

    [[nodiscard]] bool has(quint32 mask) const { return (kinds & mask) != 0; }
};

} // namespace ramure

Q_DECLARE_METATYPE(ramure::Change)
