/// \file
/// A scene at rest and a frame of motion make the scene as it is now. Meshes are shared: only bones are new.
#pragma once

#include "core/qt/session/motion/motion.h"
#include "widgets/view/render/render_scene.h"
#include <map>

namespace ramure {

class MovingScene
{
public:
    /// \p rest with everything that moves in its place of now. Meshes that the frame has no skin for follow
    /// their vertices' branches rigidly; lines and marks follow theirs; what belongs to no branch is left out
    /// while its tree moves, as nobody knows where it is.
    [[nodiscard]] RenderScene moved(const RenderScene& rest, const MotionFrame& frame);
    /// Is anything of the scene somewhere else than at rest?
    [[nodiscard]] static bool moves(const RenderScene& rest, const MotionFrame& frame);

private:
    struct Bound
    {
        std::shared_ptr<const void> mesh; ///< its key
        std::shared_ptr<const Skin> skin;
        std::shared_ptr<const Skin> whole; ///< what the skin of a split mesh was made of
        bool used = false;
    };
    std::shared_ptr<const Skin> skinOf(const MeshItem& item, const NodeMotion& motion);
    std::shared_ptr<const Skin> rigidSkin(const MeshItem& item);
    std::shared_ptr<const Skin> splitSkin(const MeshItem& item, const std::shared_ptr<const Skin>& whole);

    std::map<const void*, Bound> m_bound; ///< rigid skins and those of split meshes, made here
};

/// The scene with its meshes and lines deformed on the processor: to pick in. Takes some time.
RenderScene posed(const RenderScene& scene);

} // namespace ramure
