/// \file
/// What the player's thread is asked for: one frame, with all that it needs to know of the document.
#pragma once

#include "core/qt/session/motion/motion.h"
#include <algorithm>

namespace ramure {

/// What the thread needs to know of one tree.
struct MotionTree
{
    const Node* node = nullptr; ///< of the request's scene
    TreeResult tree;
    std::optional<Pull> pull;
    std::vector<Index> shaken; ///< apples let go at the frame before this one
    std::string bakeFile;      ///< of this tree; empty: there is none
    int bakeVersion = 0;       ///< another number: the file is another
};

struct MotionRequest
{
    std::int64_t frame = 0;
    int document = 0; ///< counted by the player: what comes late from one that was left is of no use
    TimelineSettings timeline;
    std::vector<MotionTree> trees;
    std::vector<const Node*> arms;      ///< of the scene
    std::shared_ptr<const Scene> scene; ///< copied once per change: requests of one scene share it
    std::size_t memoryBytes = std::size_t(1) << 30; ///< for the runs of all trees together
    /// Playing: changed parameters and the hand act from the present step on. Otherwise the whole run is that
    /// of the present parameters.
    bool live = false;
    bool sketches = true;    ///< a sketch of a frame that takes long may come before it
    bool forgetHand = false; ///< the hand's pulls and the shaken apples of the run are forgotten first
};

/// Trees that tracks reshape are drafts at rest: the same frame comes again as soon as they are whole.
inline bool isSketch(const MotionFrame& frame)
{
    return std::ranges::any_of(frame.trees,
                               [](const auto& tree) { return tree.second.draftTubes != nullptr; });
}

} // namespace ramure
