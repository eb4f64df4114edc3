// What is no mesh: sky and ground, ghosts, lines and points, and the line around what is selected.
#include "widgets/view/render/passes/renderer_picture.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

namespace ramure {
namespace {

/// Side of a small cell, m: a power of ten, so that ten small cells make a large one.
double gridStep(double height)
{
    return std::pow(10.0, std::floor(std::log10(std::max(height, 1e-6) / 4.0)));
}

/// Of a level plane "height" below the eye, met by rays x * across + y * along + forward; everything is
/// eye-relative. One over a plane's distance is linear over a picture in perspective, and so is its depth.
/// \param projected to clip space, in perspective.
/// \return what (x, y, 1) is multiplied by; the far plane where the eye is not above.
glm::vec3 planeDepth(const glm::dmat4& projected, const glm::dmat3& rays, double height)
{
    if (height <= 0.0)
        return {0.0f, 0.0f, 1.0f};
    const glm::dvec4 depth = glm::transpose(projected)[2];
    const double perSlope = depth.w / height;
    return glm::dvec3(depth) * rays - perSlope * glm::dvec3(rays[0].y, rays[1].y, rays[2].y);
}

} // namespace

/// The feet that look largest.
static void setFeet(ShaderProgram& world, std::vector<Foot> feet, const glm::dvec3& eye)
{
    constexpr std::array names{"uFeet[0]",  "uFeet[1]",  "uFeet[2]",  "uFeet[3]", "uFeet[4]",  "uFeet[5]",
                               "uFeet[6]",  "uFeet[7]",  "uFeet[8]",  "uFeet[9]", "uFeet[10]", "uFeet[11]",
                               "uFeet[12]", "uFeet[13]", "uFeet[14]", "uFeet[15]"};
    const std::size_t count = std::min(feet.size(), names.size());
    std::ranges::partial_sort(
        feet, feet.begin() + std::ptrdiff_t(count), std::less(),
        [&eye](const Foot& foot) { return glm::distance(foot.place, eye) / std::max(foot.reach, 1e-6); });
    world.set("uFeetCount", int(count));
    for (std::size_t i = 0; i < count; ++i)
        world.set(names[i], glm::vec3(feet[i].place.x, feet[i].place.z, feet[i].reach));
}

void Renderer::drawWorld(const Picture& picture, bool depthOnly)
{
    const Camera& camera = picture.camera;
    const Box& box = picture.scene.box;
    const double half = 0.5 * camera.heightAtTarget();
    const double perDistance = camera.orthographic ? 1.0 : 1.0 / camera.distance;
    const double reach = std::max(box.empty() ? 1.0 : box.radius(), 0.05);
    const double height = std::abs(camera.eye().y - picture.scene.ground);
    const bool meadow = picture.light.studio.r < 0.0f && !picture.light.isNatural();
    ShaderProgram& world = m_programs.world->with(meadow, switches::meadow)
                               .with(picture.isLevel(), switches::level)
                               .with(!picture.near, switches::one)
                               .with(depthOnly, switches::depthOnly)
                               .with(picture.light.around != nullptr, switches::picture);
    world.bind();
    setLight(world, picture);
    const glm::dvec3 across = half * picture.aspect * perDistance * camera.right();
    const glm::dvec3 along = half * perDistance * camera.up();
    const glm::dvec3 forward = -camera.backward() - camera.shift.x * across - camera.shift.y * along;
    world.set("uForward", glm::vec3(forward));
    world.set("uAcross", glm::vec3(across));
    world.set("uAlong", glm::vec3(along));
    world.set("uPlaneDepth", planeDepth(picture.projectedView, {across, along, forward},
                                        camera.eye().y - picture.scene.ground));
    world.set("uOrthographic", camera.orthographic);
    world.set("uEye", glm::vec3(camera.eye()));
    world.set("uGround", float(picture.scene.ground));
    world.set("uGroundShown", picture.options.ground);
    world.set("uCentre", glm::vec2(box.centre().x, box.centre().z));
    world.set("uFade", float(12.0 * reach + 4.0 * height + 2.0 * camera.distance));
    const double step = gridStep(camera.heightAtTarget());
    world.set("uGridStep", picture.options.grid ? float(step) : 0.0f);
    world.set("uPixelRatio", float(picture.options.pixelRatio));
    setFeet(world, picture.scene.feet, camera.eye());
    world.set("uMottle", float(0.35 * reach));
    world.set("uClip", glm::mat4(picture.projectedView));
    m_gl.glBindVertexArray(m_emptyArray);
    m_gl.glEnable(GL_DEPTH_CLAMP); // above the horizon, and before the near plane
    m_parts.rows([this] { m_gl.glDrawArrays(GL_TRIANGLES, 0, 3); });
    m_gl.glDisable(GL_DEPTH_CLAMP);
}

/// Each hides its own inside, but nothing else: what stands behind it shines through.
void Renderer::drawGhosts(const Picture& picture)
{
    if (picture.scene.ghosts.empty())
        return;
    m_programs.ghost->bind();
    m_programs.ghost->set("uBackward", glm::vec4(glm::vec3(picture.camera.backward()),
                                                 picture.camera.orthographic ? 1.0f : 0.0f));
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glEnable(GL_CULL_FACE);
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL); // where it lies in a surface, that is seen
    m_gl.glPolygonOffset(1.0f, 2.0f);
    for (const GhostItem& item : picture.scene.ghosts) {
        const GpuBlock& block = m_cache.mesh(item.mesh, nullptr);
        const glm::dmat4 relative = picture.relative(item.world);
        m_programs.ghost->set("uClip", glm::mat4(picture.projectedView * relative));
        m_programs.ghost->set("uRelative", glm::mat4(relative));
        m_programs.ghost->set("uNormal", glm::mat3(glm::inverseTranspose(glm::dmat3(item.world))));
        m_programs.ghost->set("uColour", glm::vec4(item.colour) / 255.0f);
        m_gl.glFrontFace(glm::determinant(glm::dmat3(item.world)) < 0.0 ? GL_CW : GL_CCW);
        m_gl.glBindVertexArray(block.vertexArray);
        m_parts.rows([&] { m_gl.glDrawElements(GL_TRIANGLES, block.count, GL_UNSIGNED_INT, nullptr); });
    }
    m_gl.glFrontFace(GL_CCW);
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDepthMask(GL_TRUE);
}

void Renderer::drawLines(const Picture& picture, bool hidden)
{
    m_programs.line->bind();
    m_programs.line->set("uViewport", picture.viewport);
    m_programs.line->set("uPixelRatio", float(picture.options.pixelRatio));
    m_programs.line->set("uLift", hidden ? 0.0f : picture.lift());
    m_gl.glDepthFunc(hidden ? GL_GREATER : GL_LEQUAL);
    m_gl.glDepthMask(hidden ? GL_FALSE : GL_TRUE);
    for (const LineItem& item : picture.scene.lines) {
        if (hidden && !item.throughSurfaces)
            continue;
        m_programs.line->set("uOpacity", hidden ? item.hidden : 1.0f);
        drawLineItem(picture, item);
    }
}

void Renderer::drawLineItem(const Picture& picture, const LineItem& item)
{
    const GpuBlock& block = m_cache.lines(item.lines);
    setStates(*m_programs.line, picture.scene, item.node);
    m_cache.bindBones(*m_programs.line, item.motion);
    m_programs.line->set("uClip", glm::mat4(picture.projectedView * picture.relative(item.world)));
    m_gl.glBindVertexArray(block.vertexArray);
    m_parts.rows([&] { m_gl.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block.count); });
}

void Renderer::drawPoints(const Picture& picture, bool hidden)
{
    m_programs.point->bind();
    m_programs.point->set("uViewport", picture.viewport);
    m_programs.point->set("uPixelRatio", float(picture.options.pixelRatio));
    m_programs.point->set("uLift", hidden ? 0.0f : 1.5f * picture.lift());
    m_gl.glDepthFunc(hidden ? GL_GREATER : GL_LEQUAL);
    m_gl.glDepthMask(hidden ? GL_FALSE : GL_TRUE);
    for (const PointItem& item : picture.scene.points) {
        if (hidden && !item.throughSurfaces)
            continue;
        m_programs.point->set("uOpacity", hidden ? item.hidden : 1.0f);
        const GpuBlock& block = m_cache.points(item.points);
        setStates(*m_programs.point, picture.scene, item.node);
        m_cache.bindBones(*m_programs.point, item.motion);
        m_programs.point->set("uClip", glm::mat4(picture.projectedView * picture.relative(item.world)));
        m_gl.glBindVertexArray(block.vertexArray);
        m_parts.rows([&] { m_gl.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block.count); });
    }
}

void Renderer::outline(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
                       const RenderOptions& options)
{
    m_cache.restAttributes();
    beginState(size, false);
    drawOutline(arrange(scene, camera, size, options), framebuffer);
    resetState();
}

/// What is selected is masked as if nothing stood before it, and a line is drawn around the mask.
void Renderer::drawOutline(const Picture& picture, GLuint target)
{
    const auto extent = outlineExtent(picture.scene, picture.camera, picture.viewport);
    if (!extent || !m_outline.begin(*extent, picture.viewport, picture.options.pixelRatio))
        return;
    for (const MeshItem& item : picture.scene.meshes) {
        if (!item.outlined)
            continue;
        const GpuBlock& block = m_cache.item(item);
        ShaderProgram& program = m_programs.shadow->with(item.motion.isStill(), switches::still);
        program.bind();
        m_cache.bindMotion(program, item.motion);
        program.set("uClip", glm::mat4(picture.projectedView * picture.relative(item.world)));
        if (item.copies) {
            m_cache.drawTriangles(block, m_parts, std::min(picture.detailOf(item), LeafDetail::Few));
        } else {
            m_gl.glBindVertexArray(block.vertexArray);
            m_outline.mask(*item.outlined, block.count);
        }
    }
    m_programs.line->bind();
    m_programs.line->set("uViewport", m_outline.maskSize());
    m_programs.line->set("uPixelRatio", 1.0f);
    m_programs.line->set("uLift", 0.0f);
    for (const LineItem& item : picture.scene.lines) {
        if (item.outlined == OutlinedLines::None)
            continue;
        m_programs.line->set("uOnlySelected", item.outlined == OutlinedLines::Selected);
        drawLineItem(picture, item);
    }
    m_programs.line->set("uOnlySelected", false);
    m_gl.glBindVertexArray(m_emptyArray);
    m_outline.end(target,
                  {*m_programs.outlineRows, *m_programs.outlineColumns, *m_programs.outlineClosing,
                   *m_programs.outlineInk},
                  picture.options.outlineOpacity);
}

// A mesh that is no copy is large.
double Renderer::Picture::copyPixels(const MeshItem& item) const
{
    if (!item.copies || item.places)
        return std::numeric_limits<double>::infinity();
    const Box box = item.box.transformed(item.world);
    const double away = camera.orthographic
                            ? camera.distance
                            : glm::distance(camera.eye(), glm::clamp(camera.eye(), box.min, box.max));
    return double(viewport.y) * item.copies->reach * glm::length(glm::dvec3(item.world[0])) *
           camera.distance / (camera.heightAtTarget() * std::max(away, 1e-9));
}

bool Renderer::Picture::isOfSmall(const MeshItem& item) const
{
    constexpr double fewPixels = 40.0;
    return item.places || (options.sparing && copyPixels(item) < fewPixels);
}

LeafDetail Renderer::Picture::detailOf(const MeshItem& item) const
{
    if (item.places || (options.quality == Quality::Best && !options.hurried))
        return LeafDetail::All;
    if (isOfSmall(item) && !item.images)
        return LeafDetail::Least;
    return options.hurried || isOfSmall(item) ? LeafDetail::Few : LeafDetail::All;
}

} // namespace ramure
