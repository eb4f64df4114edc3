/// \file
/// What moves in a GLB: nodes, and joints that meshes follow. Internal to glb_format.cpp.
#pragma once

#include "core/io/formats/glb/glb_parts.h"
#include <functional>
#include <span>

namespace ramure::glb {

/// Which joint each bone of a node is, when there are to be no more than so many: the thickest bones, each
/// with what carries it; the others go with what carries them.
struct Joints
{
    std::vector<Index> bones;   ///< that are joints, ascending
    std::vector<Index> jointOf; ///< per bone
};
/// \param limit 0: every bone that has a size. \pre parents stand before their children.
Joints jointsOf(std::span<const ExportBone> bones, std::size_t count, std::size_t limit);
/// m: how far a tip is at most from where its own bone would have it.
double jointError(const Joints& joints, std::span<const ExportBone> bones,
                  std::span<const std::vector<RigidTransform>* const> poses);

/// Per vertex of the file up to four joints, most first.
struct Weights
{
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> weights;
};
/// \param from per vertex of the file its vertex in the mesh
Weights weightsOf(const Skin& skin, const Joints& joints, std::span<const Index> from);

/// Returns a place in the world as seen from another one.
glm::dmat4 inSpaceOf(const glm::dmat4& above, const glm::dmat4& world);
/// Returns true if two places differ by no more than rounding does.
bool isNear(const glm::dmat4& a, const glm::dmat4& b);

/// One animation: for each node the places that it takes one after the other.
class Animation
{
public:
    /// \param seconds of the places, ascending.
    Animation(Buffer& buffer, std::vector<float> seconds)
        : m_buffer(buffer)
        , m_seconds(std::move(seconds))
    {
    }

    /// A node at its first place; channels for what changes. \param places as many as there are moments.
    /// Error: Invalid (a shear, a flat scale).
    Expected<void> place(Json& node, std::size_t number, std::span<const glm::dmat4> places);
    /// The same of a joint.
    void place(Json& node, std::size_t number, std::span<const RigidTransform> places);
    /// The weights of a node's key shapes, each 1 at the times when the mesh has it.
    void shapes(std::size_t number, const ExportShapes& shapes);
    void addTo(Json& root);

private:
    template <class Value>
    void channel(Json& node, std::size_t number, const char* path, const char* type,
                 const std::vector<Value>& values);
    std::size_t addInput(const std::vector<float>& seconds);
    [[nodiscard]] bool moves() const { return m_seconds.size() > 1; }

    Buffer& m_buffer;
    std::vector<float> m_seconds;
    std::optional<std::size_t> m_input;
    Json m_channels = Json::array(), m_samplers = Json::array();
};

} // namespace ramure::glb
