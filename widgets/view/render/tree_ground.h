/// \file
/// The ground around the feet of trees that stand on roots: litter, grass and fallen leaves. A tree alone
/// that grows on a slope of its own stands on a hillside, which runs out into the level ground. Nothing of it
/// is exported.
#pragma once

#include "core/params/ground_plane.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/scene/scene.h"
#include "widgets/view/render/scene_part_cache.h"
#include <optional>

namespace ramure {

/// m, in the tree's space: the tree's plane around the foot, grass with litter between the roots; with
/// normals and colours. \param foot where the trunk stands; \param reach of its roots
TriangleMesh hillsideUnder(const GroundPlane& ground, const glm::dvec3& foot, double reach);
/// m, in the tree's space: the height of the level ground that a hillside runs out into.
double hillsideBase(const GroundPlane& ground, const glm::dvec3& foot, double reach);
/// m, in the tree's space: the height of the hillside at (x, z).
double hillsideHeight(const GroundPlane& ground, const glm::dvec3& foot, double reach, const glm::dvec2& at);

class TreeGrounds
{
public:
    /// \param hasMeadow grass and fallen leaves are shown
    TreeGrounds(ScenePartCache& cache, RenderScene& built, bool hasMeadow)
        : m_cache(cache)
        , m_built(built)
        , m_hasMeadow(hasMeadow)
    {
    }
    /// The feet of a tree that is shown. \param params of the time; \param world of the tree
    void add(const Node& node, const NodeParams& params, const TreeResult& tree, const glm::dmat4& world);
    /// Once all trees are there. \param level m, of the ground without hillsides; litter lies on it alone
    void finish(double level);

private:
    void addHillside();
    void addMeadow(bool isHill);
    void addCopies(std::shared_ptr<const MeshCopies> copies, Material material, const glm::dmat4& world);

    /// A tree whose leaves may have fallen.
    struct Shedding
    {
        std::shared_ptr<const Foliage> foliage, placed;
        double alpha = 0.0; ///< m
        glm::dmat4 world{1.0};
        Foot foot; ///< in the tree's space
    };

    ScenePartCache& m_cache;
    RenderScene& m_built;
    bool m_hasMeadow;
    std::vector<Shedding> m_shedding;
    int m_trees = 0;
    // Of the last tree with roots.
    NodeId m_node = noNode;
    glm::dmat4 m_world{1.0};
    std::optional<GroundPlane> m_ground;
    glm::dvec3 m_foot{0.0};
    double m_reach = 0.0;
};

} // namespace ramure
