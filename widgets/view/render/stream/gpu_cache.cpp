#include "widgets/view/render/stream/gpu_cache.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace ramure {

static constexpr glm::vec4 usualYouth(0.01f, 0.06f, 1.0f, 2.0f); ///< m, under pictures that an artist brings
namespace {

using gpu::offset;
using gpu::stateWidth;

} // namespace

GpuCache::GpuCache(Gl& gl)
    : m_gl(gl)
    , m_pool(gl)
{
    m_gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &m_largestTexture);
    const QOpenGLContext& context = *QOpenGLContext::currentContext();
    if (context.format().version() >= qMakePair(4, 2) || context.hasExtension("GL_ARB_base_instance"))
        m_drawCopiesFrom =
            reinterpret_cast<DrawFrom>(context.getProcAddress("glDrawElementsInstancedBaseInstance"));
}

GpuCache::~GpuCache()
{
    for (auto& [key, block] : m_blocks)
        free(block);
    for (const GLuint texture : {m_restTexture, m_restCrown})
        if (texture != 0)
            m_gl.glDeleteTextures(1, &texture);
}

std::size_t GpuCache::textureRows(std::size_t texels, int largest)
{
    const std::size_t rows = std::max<std::size_t>(1, (texels + stateWidth - 1) / stateWidth);
    return std::max<std::size_t>(rows, stateWidth) <= static_cast<std::size_t>(largest) ? rows : 0;
}

std::pair<GpuBlock&, bool> GpuCache::slot(const std::shared_ptr<const void>& source)
{
    const auto [it, isNew] = m_blocks.try_emplace(source.get());
    GpuBlock& block = it->second;
    block.usedIn = m_picture;
    if (isNew) {
        block.source = source;
        ++m_stats.uploads;
    }
    return {block, isNew};
}

void GpuCache::addBuffer(GpuBlock& block, GLenum target, const void* data, std::size_t bytes)
{
    const GpuBuffer buffer = m_pool.take(bytes);
    m_gl.glBindBuffer(target, buffer.name);
    block.waiting.push_back({block.buffers.size(), static_cast<const char*>(data), bytes, 0});
    block.buffers.push_back(buffer);
}

std::size_t GpuCache::fill(GpuBlock& block, std::size_t most)
{
    while (!block.waiting.empty() && most > 0) {
        GpuBlock::Piece& piece = block.waiting.back();
        GpuBuffer& buffer = block.buffers[piece.buffer];
        // Getting memory may take as long as filling it.
        if (m_pool.allocate(buffer, piece.bytes)) {
            most -= std::min(most, piece.bytes);
            continue;
        }
        const std::size_t bytes = std::min(most, piece.bytes - piece.done);
        // A target that belongs to no vertex array.
        m_gl.glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.name);
        m_gl.glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(piece.done),
                             static_cast<GLsizeiptr>(bytes), piece.data + piece.done);
        piece.done += bytes;
        most -= bytes;
        m_stats.bytes += bytes;
        if (piece.done == piece.bytes)
            block.waiting.pop_back();
    }
    m_gl.glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return most;
}

const GpuBlock& GpuCache::drawn(GpuBlock& block)
{
    if (!block.waiting.empty())
        fill(block, std::numeric_limits<std::size_t>::max());
    block.prepared = false;
    return block;
}

const GpuBlock& GpuCache::mesh(const std::shared_ptr<const TriangleMesh>& mesh,
                               const std::shared_ptr<const Skin>& skin)
{
    GpuBlock& block = meshBlock(mesh);
    attachSkin(block, skin, nullptr);
    return drawn(block);
}

const GpuBlock& GpuCache::item(const MeshItem& item)
{
    GpuBlock& block = itemBlock(item);
    attachSkin(block, item.motion.skin, item.copies.get());
    attachWind(block, item.motion.wind, item.copies != nullptr);
    attachPlaces(block, item.places);
    return drawn(block);
}

void GpuCache::restAttributes()
{
    // The functions of 3.3 core leave them out, though the profile has them.
    QOpenGLFunctions& gl = *QOpenGLContext::currentContext()->functions();
    for (const GLuint white : {4u, 10u})
        gl.glVertexAttrib4f(white, 1.0f, 1.0f, 1.0f, 1.0f);
    gl.glVertexAttrib4f(12, 1.0f, 0.0f, 0.0f, 1.0f); // thick wood
    for (const GLuint place : {8u, 9u})
        gl.glVertexAttrib4f(place, 0.0f, 0.0f, 0.0f, 1.0f);
}

void GpuCache::drawTriangles(const GpuBlock& block, PictureParts& parts, LeafDetail detail)
{
    constexpr int few = 4096; // their corners cost so little that they may be computed anew for some rows
    m_gl.glBindVertexArray(block.vertexArray);
    const MeshCopies::Faces faces = block.detail[std::size_t(detail)];
    const bool isOfCopies = block.copies > 0;
    const int all = isOfCopies ? block.copies : block.count / 3;
    const auto draw = [&](int first, int count) {
        if (isOfCopies)
            drawCopies(faces, first, count);
        else
            m_gl.glDrawElements(GL_TRIANGLES, 3 * count, GL_UNSIGNED_INT,
                                offset(sizeof(glm::uvec3) * std::size_t(first)));
    };
    // Colours are found by the number of the triangle in its draw.
    if (std::int64_t(all) * (isOfCopies ? faces.count : 1) <= few || block.hasColours() ||
        (isOfCopies && !m_drawCopiesFrom))
        parts.rows([&] { draw(0, all); });
    else
        parts.share(all, draw);
}

void GpuCache::drawCopies(const MeshCopies::Faces& faces, int first, int count)
{
    const auto corners = static_cast<GLsizei>(3 * faces.count);
    const void* from = offset(sizeof(glm::uvec3) * faces.from);
    if (first > 0)
        m_drawCopiesFrom(GL_TRIANGLES, corners, GL_UNSIGNED_INT, from, count, GLuint(first));
    else
        m_gl.glDrawElementsInstanced(GL_TRIANGLES, corners, GL_UNSIGNED_INT, from, count);
}

const GpuBlock& GpuCache::lines(const std::shared_ptr<const LineSet>& lines)
{
    return drawn(lineBlock(lines));
}

const GpuBlock& GpuCache::points(const std::shared_ptr<const PointSet>& points)
{
    return drawn(pointBlock(points));
}

bool GpuCache::prepare(const RenderScene& scene, std::size_t bytes)
{
    bool ready = true;
    for (auto& [key, block] : m_blocks)
        block.prepared = false;
    const auto add = [&](GpuBlock& block) {
        block.prepared = true;
        if (!block.waiting.empty())
            bytes = fill(block, bytes);
        ready = ready && block.waiting.empty();
    };
    for (const MeshItem& item : scene.meshes)
        add(itemBlock(item));
    for (const CrowdItem& item : scene.crowds)
        for (const CrowdPrototype& prototype : item.crowd->prototypes())
            for (const CrowdForm& form : prototype.forms)
                for (const CrowdPart& part : form.parts)
                    add(copiesBlock(part.shape));
    for (const LineItem& item : scene.lines)
        add(lineBlock(item.lines));
    for (const PointItem& item : scene.points)
        add(pointBlock(item.points));
    return ready;
}

GpuBlock& GpuCache::itemBlock(const MeshItem& item)
{
    return item.copies ? copiesBlock(item.copies) : meshBlock(item.mesh);
}

GpuBlock& GpuCache::copiesBlock(const std::shared_ptr<const MeshCopies>& copies)
{
    const auto [block, isNew] = slot(copies);
    if (isNew)
        fillCopies(block, *copies);
    return block;
}

void GpuCache::keep(const std::vector<CrowdItem>& crowds)
{
    const auto touch = [this](const void* source) {
        if (const auto found = m_blocks.find(source); found != m_blocks.end())
            found->second.usedIn = m_picture;
    };
    for (const CrowdItem& item : crowds)
        for (const CrowdPrototype& prototype : item.crowd->prototypes())
            for (const CrowdForm& form : prototype.forms)
                for (const CrowdPart& part : form.parts)
                    for (const void* source : {static_cast<const void*>(part.shape.get()),
                                               static_cast<const void*>(part.images.get()),
                                               static_cast<const void*>(part.bark.get())})
                        touch(source);
}

GpuBlock& GpuCache::meshBlock(const std::shared_ptr<const TriangleMesh>& mesh)
{
    const auto [block, isNew] = slot(mesh);
    if (isNew)
        fillMesh(block, *mesh);
    return block;
}

void GpuCache::fillMesh(GpuBlock& block, const TriangleMesh& mesh)
{
    m_gl.glGenVertexArrays(1, &block.vertexArray);
    m_gl.glBindVertexArray(block.vertexArray);
    const auto vectors = [&, &target = block](GLuint index, const std::vector<glm::vec3>& values) {
        addBuffer(target, GL_ARRAY_BUFFER, values.data(), values.size() * sizeof(glm::vec3));
        m_gl.glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        m_gl.glEnableVertexAttribArray(index);
    };
    vectors(0, mesh.positions);
    if (mesh.normals.size() == mesh.positions.size())
        vectors(1, mesh.normals);
    if (mesh.branch.size() == mesh.positions.size()) {
        addBuffer(block, GL_ARRAY_BUFFER, mesh.branch.data(), mesh.branch.size() * sizeof(Index));
        m_gl.glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, 0, nullptr);
        m_gl.glEnableVertexAttribArray(2);
    }
    if (mesh.uv.size() == mesh.positions.size() && mesh.uvTriangles.empty()) {
        addBuffer(block, GL_ARRAY_BUFFER, mesh.uv.data(), mesh.uv.size() * sizeof(glm::vec2));
        m_gl.glVertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        m_gl.glEnableVertexAttribArray(3);
    }
    if (mesh.radius.size() == mesh.positions.size()) {
        addBuffer(block, GL_ARRAY_BUFFER, mesh.radius.data(), mesh.radius.size() * sizeof(float));
        m_gl.glVertexAttribPointer(12, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
        m_gl.glEnableVertexAttribArray(12);
    }
    addBuffer(block, GL_ELEMENT_ARRAY_BUFFER, mesh.triangles.data(),
              mesh.triangles.size() * sizeof(glm::uvec3));
    block.count = static_cast<GLsizei>(3 * mesh.triangles.size());
    m_gl.glBindVertexArray(0);
    if (!mesh.colours.empty() && mesh.colours.size() == mesh.triangles.size())
        fillColours(block, mesh.colours);
}

void GpuCache::fillCopies(GpuBlock& block, const MeshCopies& copies)
{
    fillMesh(block, copies.shape);
    block.copies = static_cast<GLsizei>(copies.copies.size());
    block.count = static_cast<GLsizei>(3 * copies.faces().count);
    block.detail = copies.detail;
    m_gl.glBindVertexArray(block.vertexArray);
    if (!copies.copies.empty()) {
        addBuffer(block, GL_ARRAY_BUFFER, copies.copies.data(), copies.copies.size() * sizeof(MeshCopy));
        readCopies();
    }
    if (!copies.colours.empty()) {
        addBuffer(block, GL_ARRAY_BUFFER, copies.colours.data(), copies.colours.size() * sizeof(glm::u8vec4));
        m_gl.glVertexAttribPointer(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
        m_gl.glEnableVertexAttribArray(4);
    }
    m_gl.glBindVertexArray(0);
}

/// The vertex array that is bound has its copies from the buffer that is bound.
void GpuCache::readCopies()
{
    constexpr GLsizei stride = sizeof(MeshCopy);
    m_gl.glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, stride, offset(offsetof(MeshCopy, branch)));
    m_gl.glVertexAttribPointer(8, 4, GL_FLOAT, GL_FALSE, stride, offset(offsetof(MeshCopy, position)));
    m_gl.glVertexAttribPointer(9, 4, GL_FLOAT, GL_FALSE, stride, offset(offsetof(MeshCopy, turn)));
    m_gl.glVertexAttribPointer(10, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(MeshCopy, tint)));
    for (const GLuint attribute : {2u, 8u, 9u, 10u}) {
        m_gl.glEnableVertexAttribArray(attribute);
        m_gl.glVertexAttribDivisor(attribute, 1);
    }
}

/// The shape stands in these places from now on.
void GpuCache::attachPlaces(GpuBlock& block, const std::shared_ptr<const std::vector<MeshCopy>>& places)
{
    if (!places)
        return;
    const auto [list, isNew] = slot(places);
    if (isNew)
        addBuffer(list, GL_ARRAY_BUFFER, places->data(), places->size() * sizeof(MeshCopy));
    drawn(list);
    if (block.places == places)
        return;
    m_gl.glBindVertexArray(block.vertexArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, list.buffers.front().name);
    readCopies();
    m_gl.glBindVertexArray(0);
    block.places = places;
    block.copies = static_cast<GLsizei>(places->size());
}

/// A texture: the colours of the triangles, row after row.
void GpuCache::fillColours(GpuBlock& block, const std::vector<glm::u8vec3>& colours)
{
    const std::size_t rows = textureRows(colours.size(), m_largestTexture);
    if (rows == 0)
        return;
    std::vector<glm::u8vec3> padded(colours);
    padded.resize(rows * stateWidth);
    m_gl.glGenTextures(1, &block.texture);
    m_gl.glBindTexture(GL_TEXTURE_2D, block.texture);
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, stateWidth, static_cast<GLsizei>(rows), 0, GL_RGB,
                      GL_UNSIGNED_BYTE, padded.data());
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_stats.bytes += padded.size() * sizeof(glm::u8vec3);
}

GLuint GpuCache::restTexture()
{
    if (m_restTexture == 0) {
        const glm::vec4 none(0.0f);
        m_gl.glGenTextures(1, &m_restTexture);
        m_gl.glBindTexture(GL_TEXTURE_2D, m_restTexture);
        m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, &none);
        m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    return m_restTexture;
}

void GpuCache::bindColours(ShaderProgram& program, const GpuBlock& mesh)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + coloursUnit);
    m_gl.glBindTexture(GL_TEXTURE_2D, mesh.texture != 0 ? mesh.texture : restTexture());
    m_gl.glActiveTexture(GL_TEXTURE0);
    program.set("uHasColours", mesh.texture != 0);
}

GLuint GpuCache::picture(int size, const std::vector<glm::u8vec3>& rgb,
                         const std::vector<std::uint8_t>& alpha)
{
    std::vector<glm::u8vec4> pixels(rgb.size());
    std::transform(rgb.begin(), rgb.end(), alpha.begin(), pixels.begin(),
                   [](const glm::u8vec3& c, std::uint8_t a) { return glm::u8vec4(c, a); });
    return picture(size, pixels);
}

GLuint GpuCache::picture(int size, const std::vector<glm::u8vec4>& pixels)
{
    GLuint texture = 0;
    m_gl.glGenTextures(1, &texture);
    m_gl.glBindTexture(GL_TEXTURE_2D, texture);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    m_gl.glGenerateMipmap(GL_TEXTURE_2D);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    m_stats.bytes += pixels.size() * sizeof(glm::u8vec4);
    return texture;
}

/// Colour and occlusion in one texture; normal and roughness in the other.
const GpuBlock& GpuCache::bark(const std::shared_ptr<const BarkMaps>& maps)
{
    const auto [block, isNew] = slot(maps);
    if (isNew) {
        block.texture = picture(maps->size, maps->colour, maps->occlusion);
        block.normals = picture(maps->size, maps->normal, maps->roughness);
    }
    return block;
}

/// Colour and light that shines through; normal and height.
const GpuBlock& GpuCache::leaf(const std::shared_ptr<const LeafMaps>& maps)
{
    const auto [block, isNew] = slot(maps);
    if (isNew) {
        block.texture = picture(maps->size, maps->colour, maps->through);
        block.normals = picture(maps->size, maps->normal, maps->height);
    }
    return block;
}

const GpuBlock& GpuCache::images(const std::shared_ptr<const SurfaceImages>& images)
{
    const auto [block, isNew] = slot(images);
    if (isNew) {
        block.texture = picture(images->size, images->colour);
        GLint level = 0, size = images->size;
        for (const auto& smaller : images->isCut ? smallerPictures(size, images->colour)
                                                 : std::vector<std::vector<glm::u8vec4>>()) {
            size = std::max(1, size / 2);
            m_gl.glTexImage2D(GL_TEXTURE_2D, ++level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                              smaller.data());
        }
        block.normals = picture(images->size, images->normal);
    }
    return block;
}

void GpuCache::bindPictures(ShaderProgram& program, const MeshItem& item)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + barkUnit);
    const GpuBlock* block = item.images ? &images(item.images)
                            : item.bark ? &bark(item.bark)
                            : item.leaf ? &leaf(item.leaf)
                                        : nullptr;
    m_gl.glBindTexture(GL_TEXTURE_2D, block ? block->texture : restTexture());
    m_gl.glActiveTexture(GL_TEXTURE0 + barkNormalsUnit);
    m_gl.glBindTexture(GL_TEXTURE_2D, block ? block->normals : restTexture());
    m_gl.glActiveTexture(GL_TEXTURE0);
    const bool isBark = !item.images && item.bark;
    program.set("uHasBark", isBark);
    program.set("uYouth", isBark ? glm::vec4(item.bark->youngRadius, item.bark->oldRadius,
                                             item.bark->limbRadius, item.bark->ripeRadius)
                                 : usualYouth);
    program.set("uLimb", isBark ? item.bark->limb : glm::vec3(1.0f));
    program.set("uGrey", isBark ? std::max(item.bark->grey, 0.01f) : 1.0f);
    program.set("uWeathers", isBark);
    program.set("uYoung", isBark ? glm::vec3(item.bark->young) / 255.0f : glm::vec3(-1.0f));
    const bool isLeaf = !item.images && !item.bark && item.leaf;
    program.set("uVeins", isLeaf);
    program.set("uImages", item.images ? (item.images->isAged ? 2 : 1) : 0);
    if (isLeaf || item.images)
        program.set("uBlade", glm::vec3(isLeaf ? item.leaf->blade : item.images->base) / 255.0f);
}

GLuint GpuCache::crownTexture(const CrownLight& crown)
{
    GLuint texture = 0;
    m_gl.glGenTextures(1, &texture);
    m_gl.glBindTexture(GL_TEXTURE_3D, texture);
    m_gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, crown.cells.x, crown.cells.y, crown.cells.z, 0, GL_RGBA,
                      GL_UNSIGNED_BYTE, crown.light.data());
    for (const GLenum filter : {GLenum(GL_TEXTURE_MIN_FILTER), GLenum(GL_TEXTURE_MAG_FILTER)})
        m_gl.glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    for (const GLenum wrap :
         {GLenum(GL_TEXTURE_WRAP_S), GLenum(GL_TEXTURE_WRAP_T), GLenum(GL_TEXTURE_WRAP_R)})
        m_gl.glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    m_stats.bytes += crown.light.size() * sizeof(glm::u8vec4);
    return texture;
}

void GpuCache::bindCrown(ShaderProgram& program, const std::shared_ptr<const CrownLight>& crown)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + crownUnit);
    if (m_restCrown == 0)
        m_restCrown = crownTexture({glm::ivec3(1), glm::dmat4(1.0), {glm::u8vec4(255)}});
    GLuint texture = m_restCrown;
    if (crown) {
        const auto [block, isNew] = slot(crown);
        if (isNew)
            block.texture = crownTexture(*crown);
        texture = block.texture;
    }
    m_gl.glBindTexture(GL_TEXTURE_3D, texture);
    m_gl.glActiveTexture(GL_TEXTURE0);
    program.set("uHasCrown", crown != nullptr);
}

GpuBlock& GpuCache::lineBlock(const std::shared_ptr<const LineSet>& lines)
{
    const auto [block, isNew] = slot(lines);
    if (!isNew)
        return block;
    using S = LineSegment;
    m_gl.glGenVertexArrays(1, &block.vertexArray);
    m_gl.glBindVertexArray(block.vertexArray);
    addBuffer(block, GL_ARRAY_BUFFER, lines->segments.data(), lines->segments.size() * sizeof(S));
    constexpr GLsizei stride = sizeof(S);
    m_gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(S, a)));
    m_gl.glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(S, b)));
    m_gl.glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(S, widthA)));
    m_gl.glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(S, colour)));
    m_gl.glVertexAttribIPointer(4, 1, GL_UNSIGNED_INT, stride, offset(offsetof(S, branch)));
    for (GLuint i = 0; i < 5; ++i) {
        m_gl.glEnableVertexAttribArray(i);
        m_gl.glVertexAttribDivisor(i, 1);
    }
    block.count = static_cast<GLsizei>(lines->segments.size());
    m_gl.glBindVertexArray(0);
    return block;
}

GpuBlock& GpuCache::pointBlock(const std::shared_ptr<const PointSet>& points)
{
    const auto [block, isNew] = slot(points);
    if (!isNew)
        return block;
    using P = PointMark;
    m_gl.glGenVertexArrays(1, &block.vertexArray);
    m_gl.glBindVertexArray(block.vertexArray);
    addBuffer(block, GL_ARRAY_BUFFER, points->points.data(), points->points.size() * sizeof(P));
    constexpr GLsizei stride = sizeof(P);
    m_gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(P, position)));
    m_gl.glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, stride, offset(offsetof(P, size)));
    m_gl.glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(P, colour)));
    m_gl.glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, stride, offset(offsetof(P, branch)));
    for (GLuint i = 0; i < 4; ++i) {
        m_gl.glEnableVertexAttribArray(i);
        m_gl.glVertexAttribDivisor(i, 1);
    }
    block.count = static_cast<GLsizei>(points->points.size());
    m_gl.glBindVertexArray(0);
    return block;
}

const GpuBlock& GpuCache::states(const std::shared_ptr<const BranchStates>& states)
{
    const auto [block, isNew] = slot(states);
    if (!isNew)
        return block;
    const std::size_t rows = textureRows(states->size(), m_largestTexture);
    if (rows == 0)
        return block;
    BranchStates padded(*states);
    padded.resize(rows * stateWidth);
    m_gl.glGenTextures(1, &block.texture);
    m_gl.glBindTexture(GL_TEXTURE_2D, block.texture);
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R8UI, stateWidth, static_cast<GLsizei>(rows), 0, GL_RED_INTEGER,
                      GL_UNSIGNED_BYTE, padded.data());
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    block.count = static_cast<GLsizei>(states->size());
    m_stats.bytes += padded.size();
    return block;
}

void GpuCache::freeUnused()
{
    for (auto it = m_blocks.begin(); it != m_blocks.end();) {
        if (it->second.usedIn == m_picture || it->second.prepared) {
            ++it;
            continue;
        }
        free(it->second);
        m_released.push_back(std::move(it->second.source));
        ++m_stats.freed;
        it = m_blocks.erase(it);
    }
}

void GpuCache::free(GpuBlock& block)
{
    if (block.vertexArray != 0)
        m_gl.glDeleteVertexArrays(1, &block.vertexArray);
    for (const GpuBuffer& buffer : block.buffers)
        m_pool.giveBack(buffer);
    for (const GLuint texture : {block.texture, block.normals})
        if (texture != 0)
            m_gl.glDeleteTextures(1, &texture);
}

std::vector<std::shared_ptr<const void>> GpuCache::takeReleased()
{
    return std::exchange(m_released, {});
}

UploadStats GpuCache::stats() const
{
    UploadStats stats = m_stats;
    stats.alive = m_blocks.size();
    return stats;
}

} // namespace ramure
