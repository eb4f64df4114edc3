/// \file
/// The blocks of a render scene on the graphics card. A block is uploaded when it is first asked for and
/// freed when a picture did not use it. The cache keeps the CPU block alive as long as its copy: an address
/// is never reused.
#pragma once

#include "widgets/view/render/crowd/mesh_copies.h"
#include "widgets/view/render/picture_parts.h"
#include "widgets/view/render/render_scene.h"
#include "widgets/view/render/renderer_options.h"
#include "widgets/view/render/shader_program.h"
#include "widgets/view/render/stream/buffer_pool.h"
#include <cstdint>
#include <map>
#include <vector>

namespace ramure {

namespace gpu {
/// Width of the textures of branch states, triangles' colours and bones.
inline constexpr int stateWidth = 2048;
inline const void* offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}
} // namespace gpu

/// Buffers and vertex array of one block.
struct GpuBlock
{
    std::shared_ptr<const void> source;
    GLuint vertexArray = 0;
    std::vector<GpuBuffer> buffers;
    GLuint texture = 0; ///< for a mesh: the colours of its triangles
    GLuint normals = 0; ///< for bark: a second texture
    GLsizei count = 0;  ///< indices, instances, or entries
    GLsizei copies = 0; ///< for a mesh: number of copies that are drawn; 0: the mesh itself is drawn
    std::array<MeshCopies::Faces, 3> detail{}; ///< for copies: faces by LeafDetail
    std::shared_ptr<const void> skin;   ///< for a mesh: the skin whose influences its vertex array reads
    std::shared_ptr<const void> wind;   ///< likewise
    std::shared_ptr<const void> places; ///< of a crowd, likewise
    std::uint64_t usedIn = 0;
    bool prepared = false; ///< kept for a picture to come

    /// Have the triangles of a mesh colours of their own?
    [[nodiscard]] bool hasColours() const { return texture != 0; }

    /// A part of a block that is not in its buffer yet.
    struct Piece
    {
        std::size_t buffer = 0; ///< among the block's
        const char* data = nullptr;
        std::size_t bytes = 0, done = 0;
    };
    std::vector<Piece> waiting;
};

struct UploadStats
{
    std::uint64_t uploads = 0; ///< blocks since the start
    std::uint64_t bytes = 0;
    std::uint64_t freed = 0; ///< blocks
    std::size_t alive = 0;   ///< blocks now on the card
};

/// Every function needs the cache's context current.
class GpuCache
{
public:
    explicit GpuCache(Gl& gl);
    ~GpuCache();
    GpuCache(const GpuCache&) = delete;
    GpuCache& operator=(const GpuCache&) = delete;

    /// \param wind for the trees that stand in it
    void beginPicture(const WindMoment& wind)
    {
        ++m_picture;
        m_wind = wind;
    }
    [[nodiscard]] const WindMoment& wind() const { return m_wind; }
    /// Uploads up to about \p bytes of the data that a scene needs. Call it until it returns true; then the
    /// scene can be drawn without a delay. Prepared data stay until they are drawn, or another scene is
    /// prepared.
    bool prepare(const RenderScene& scene, std::size_t bytes);
    /// \p skin may be null.
    const GpuBlock& mesh(const std::shared_ptr<const TriangleMesh>& mesh,
                         const std::shared_ptr<const Skin>& skin);
    /// What crowds may show in another picture stays on the card.
    void keep(const std::vector<CrowdItem>& crowds);
    /// Returns the block that is drawn for an item: its mesh, or the copies in its place.
    const GpuBlock& item(const MeshItem& item);
    /// All that is no copy stands where its mesh has it: to be called before triangles are drawn.
    void restAttributes();
    /// Leaves the block's vertex array bound. \param detail of copies.
    void drawTriangles(const GpuBlock& block, PictureParts& parts, LeafDetail detail);
    /// A texture: per bone the rotation (x, y, z, w) and the translation.
    const GpuBlock& bones(const std::shared_ptr<const std::vector<RigidTransform>>& bones);
    const GpuBlock& lines(const std::shared_ptr<const LineSet>& lines);
    const GpuBlock& points(const std::shared_ptr<const PointSet>& points);
    const GpuBlock& states(const std::shared_ptr<const BranchStates>& states);
    /// Hands the bones of an item, if it has any, to the program, which is bound. A texture made for it is
    /// bound to its own unit from the first, as in those below: on the shadow's it would be read in the
    /// shadow's place.
    void bindBones(ShaderProgram& program, const ItemMotion& motion);
    /// The same for meshes, which may stand in the wind of a game.
    void bindMotion(ShaderProgram& program, const ItemMotion& motion);
    /// The same for the colours of a mesh's triangles.
    void bindColours(ShaderProgram& program, const GpuBlock& mesh);
    /// The same for its bark, which may be null.
    void bindPictures(ShaderProgram& program, const MeshItem& item);
    /// The same for the light in its crown, which may be null.
    void bindCrown(ShaderProgram& program, const std::shared_ptr<const CrownLight>& crown);
    /// How many rows of a texture hold \p texels where the card's largest has \p largest a side; 0 where it
    /// cannot: then triangles have no colours, branches no states, bones rest.
    static std::size_t textureRows(std::size_t texels, int largest);
    /// The texture units that they use.
    static constexpr GLenum bonesUnit = 3, coloursUnit = 4, barkUnit = 5, barkNormalsUnit = 6, crownUnit = 7,
                            elementsUnit = 11;

    /// Frees all data that was not used since beginPicture.
    void freeUnused();
    [[nodiscard]] UploadStats stats() const;
    /// The blocks of the processor's memory that were let go of since the last call: the caller says where
    /// their memory is given back.
    std::vector<std::shared_ptr<const void>> takeReleased();

private:
    void drawCopies(const MeshCopies::Faces& faces, int first, int count);
    void fillMesh(GpuBlock& block, const TriangleMesh& mesh);
    void fillCopies(GpuBlock& block, const MeshCopies& copies);
    void fillColours(GpuBlock& block, const std::vector<glm::u8vec3>& colours);
    GLuint crownTexture(const CrownLight& crown);
    GLuint picture(int size, const std::vector<glm::u8vec4>& pixels);
    GLuint picture(int size, const std::vector<glm::u8vec3>& rgb, const std::vector<std::uint8_t>& alpha);
    const GpuBlock& bark(const std::shared_ptr<const BarkMaps>& maps);
    const GpuBlock& leaf(const std::shared_ptr<const LeafMaps>& maps);
    const GpuBlock& images(const std::shared_ptr<const SurfaceImages>& images);
    /// A sampler must have a texture even where the program does not read it.
    GLuint restTexture();
    const GpuBlock& influences(const std::shared_ptr<const Skin>& skin, const MeshCopies* copies);
    void attachSkin(GpuBlock& block, const std::shared_ptr<const Skin>& skin, const MeshCopies* copies);
    void attachWind(GpuBlock& block, const std::shared_ptr<const ItemWind>& wind, bool copies);
    void attachPlaces(GpuBlock& block, const std::shared_ptr<const std::vector<MeshCopy>>& places);
    void readCopies();
    const GpuBlock& elements(const std::shared_ptr<const TreeWind>& wind);
    void fillTexels(GpuBlock& block);
    GpuBlock& itemBlock(const MeshItem& item);
    GpuBlock& copiesBlock(const std::shared_ptr<const MeshCopies>& copies);
    GpuBlock& meshBlock(const std::shared_ptr<const TriangleMesh>& mesh);
    GpuBlock& lineBlock(const std::shared_ptr<const LineSet>& lines);
    GpuBlock& pointBlock(const std::shared_ptr<const PointSet>& points);
    const GpuBlock& drawn(GpuBlock& block);
    /// Returns how many bytes are left of \p most.
    std::size_t fill(GpuBlock& block, std::size_t most);
    /// The block of this source, and whether it has to be filled.
    std::pair<GpuBlock&, bool> slot(const std::shared_ptr<const void>& source);
    void addBuffer(GpuBlock& block, GLenum target, const void* data, std::size_t bytes);
    void free(GpuBlock& block);

    using DrawFrom = void(QOPENGLF_APIENTRYP)(GLenum, GLsizei, GLenum, const void*, GLsizei, GLuint);

    Gl& m_gl;
    DrawFrom m_drawCopiesFrom = nullptr; ///< function of OpenGL 4.2; null if the driver has none
    BufferPool m_pool;
    std::map<const void*, GpuBlock> m_blocks;
    std::vector<glm::vec4> m_texels; ///< texels of the bones, kept between pictures
    WindMoment m_wind;
    std::vector<std::shared_ptr<const void>> m_released;
    GLint m_largestTexture = 0;
    GLuint m_restCrown = 0;
    GLuint m_restTexture = 0; ///< for what has no bones or colours
    UploadStats m_stats;
    std::uint64_t m_picture = 0;
};

} // namespace ramure
