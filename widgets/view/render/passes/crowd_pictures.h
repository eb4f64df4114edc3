/// \file
/// What is drawn in the place of the crowds of a scene: the forms that one picture needs. They are chosen
/// anew when the camera, the crowds or the quality are others than in the picture before; else all lists
/// stay, and nothing is uploaded.
#pragma once

#include "widgets/view/render/camera.h"
#include "widgets/view/render/crowd/crowd_choice.h"
#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/renderer_options.h"
#include <QSize>

namespace ramure {

/// Of all crowds in one picture.
struct CrowdCounts
{
    std::size_t all = 0;        ///< that the crowds have
    std::size_t seen = 0;       ///< that the picture has room for
    std::size_t whole = 0;      ///< of these, drawn as they are alone
    std::int64_t triangles = 0; ///< of those that are seen
    bool operator==(const CrowdCounts&) const = default;
};

class CrowdPictures
{
public:
    /// Returns the scene with items in the place of its crowds, or the scene itself if it has none. It is
    /// valid until the next call. What is far throws the shadow of its last form, what is near the camera's
    /// target that of a form one step coarser than it is seen in; none of it is in a draft.
    const RenderScene& of(const RenderScene& scene, const Camera& camera, QSize size,
                          const RenderOptions& options);
    [[nodiscard]] const CrowdCounts& counts() const { return m_counts; }

private:
    struct Key
    {
        std::vector<CrowdItem> crowds;
        Camera camera;
        QSize size;
        CrowdBudget budget;
        glm::dvec3 sun{0.0}; ///< 0: no shadows of what is near
        bool operator==(const Key&) const = default;
    };
    void choose(const Key& key);

    Key m_key;
    std::vector<MeshItem> m_seen, m_far, m_near;
    CrowdCounts m_counts;
    RenderScene m_scene;
};

} // namespace ramure
