#include "widgets/view/render/passes/renderer.h"

#include "core/base/stopwatch.h"
#include "core/surface/season/leaf_pigments.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/renderer_picture.h"
#include <QOpenGLContext>
#include <QOpenGLDebugLogger>
#include <QOpenGLVersionFunctionsFactory>
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <utility>

namespace ramure {
namespace {

constexpr GLenum shadowUnit = 0;
constexpr GLenum shadowDepthUnit = 1;
constexpr GLenum statesUnit = 2;
constexpr GLenum nearUnit = 8; // those between are the cache's
constexpr GLenum nearDepthUnit = 9;
constexpr GLenum occlusionUnit = 10;
constexpr GLenum skyUnit = 12;

constexpr float exposure = 0.8f; ///< with which a film shows a surface in the middle as it is

/// What shines through leaves whose pigments nobody knows, of the colour that they show: yellower.
constexpr glm::vec3 usualPassed(1.5f, 1.25f, 0.4f);

glm::vec3 srgb(const glm::u8vec3& bytes)
{
    return glm::vec3(bytes) / 255.0f;
}

} // namespace

/// Twice as large each way, where the card can.
static bool isDrawnLarge(QSize size, const RenderOptions& options)
{
    constexpr int largestSide = 4096; // of which software rasterisers still have the memory
    return options.quality == Quality::Best && !options.hurried && size.width() <= largestSide &&
           size.height() <= largestSide;
}

Renderer::Renderer(Gl& gl)
    : m_gl(gl)
    , m_cache(gl)
    , m_shadowMap(gl)
    , m_nearShadow(gl)
    , m_parts(gl)
    , m_smoothing(gl)
    , m_large(gl)
    , m_lensPicture(gl)
    , m_lensSum(gl, GL_RGBA32F)
    , m_outline(gl)
    , m_occlusion(gl)
    , m_sky(gl)
{
}

Renderer::~Renderer()
{
    m_gl.glDeleteVertexArrays(1, &m_emptyArray);
    m_gl.glDeleteTextures(1, &m_noStates);
}

Expected<std::unique_ptr<Renderer>> Renderer::make()
{
    QOpenGLContext* context = QOpenGLContext::currentContext();
    auto* gl = context ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
    if (!gl || !gl->initializeOpenGLFunctions())
        return fail(ErrorCode::Unknown, RAMURE_NOOP("No OpenGL 3.3 context is available here"));
    std::unique_ptr<Renderer> made(new Renderer(*gl));
    made->m_messages = driverMessages(*context);
    RAMURE_TRY(made->compile());
    return made;
}

Expected<void> Renderer::compile()
{
    m_software = isSoftwareRenderer(reinterpret_cast<const char*>(m_gl.glGetString(GL_RENDERER)));
    RAMURE_TRY(m_programs.compile(m_gl));
    m_gl.glGenVertexArrays(1, &m_emptyArray);
    m_gl.glGenTextures(1, &m_noStates);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_noStates);
    const std::uint32_t none = 0;
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R8UI, 1, 1, 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &none);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    return {};
}

void Renderer::draw(const RenderScene& scene, const Camera& camera, QSize size, GLuint framebuffer,
                    const RenderOptions& options)
{
    m_parts.restart();
    if (drawAside(scene, camera, size, framebuffer, options))
        show(size, framebuffer);
}

/// The scene without ground that stands out of the level one, where that is not shown either.
static std::optional<RenderScene> withoutGround(const RenderScene& scene, const RenderOptions& options)
{
    const Backdrop backdrop = options.light.backdrop;
    const bool hasGround = options.world && options.ground && backdrop != Backdrop::LightStudio &&
                           backdrop != Backdrop::DarkStudio;
    if (hasGround || std::ranges::none_of(scene.meshes, &MeshItem::isGround))
        return std::nullopt;
    RenderScene bare = scene;
    std::erase_if(bare.meshes, [](const MeshItem& item) { return item.isGround; });
    return bare;
}

/// \returns whether there is a picture aside: else it is in the framebuffer, or not whole.
bool Renderer::drawAside(const RenderScene& whole, const Camera& camera, QSize size, GLuint framebuffer,
                         const RenderOptions& options)
{
    const std::optional<RenderScene> bare = withoutGround(whole, options);
    const RenderScene& scene = m_crowds.of(bare ? *bare : whole, camera, size, options);
    Stopwatch watch;
    m_drawn = 0;
    m_cache.beginPicture(options.wind);
    m_cache.restAttributes();
    upload(scene);
    m_stats.uploadMs = watch.elapsed().wallMs;
    watch.restart();

    const bool inParts = m_parts.isActive();
    const bool shrinks = isDrawnLarge(size, options);
    const QSize drawn = shrinks ? 2 * size : size;
    RenderOptions own = options;
    if (shrinks)
        own.pixelRatio *= 2.0;
    Smoothing& place = shrinks || inParts ? m_large : m_smoothing; // what is shown meanwhile stays
    const GLuint aside = shrinks || inParts || options.smoothing ? place.begin(drawn) : 0;
    if (inParts && aside == 0)
        return false;
    const bool large = shrinks && aside != 0;
    Picture picture = arrange(scene, camera, large ? drawn : size, large ? own : options);
    occlude(picture, size);
    castShadows(picture);
    drawInto(aside != 0 ? aside : framebuffer, picture, large ? drawn : size);
    m_cache.freeUnused();
    resetState();
    m_stats.pictures += m_parts.isWhole() ? 1 : 0;
    m_stats.drawMs = watch.elapsed().wallMs;
    m_stats.drawCpuMs = watch.elapsed().cpuMs;
    if (aside == 0 || !m_parts.isWhole())
        return false;
    m_shown = large               ? Shown::Shrunk
              : !inParts          ? Shown::Smoothed
              : options.smoothing ? Shown::PartSmoothed
                                  : Shown::Part;
    return true;
}

bool Renderer::drawPart(const RenderScene& scene, const Camera& camera, QSize size,
                        const RenderOptions& options, int sample, double ms)
{
    const bool hasLens = options.lens.diameter > 0.0;
    const Camera seenBy = hasLens ? throughLens(camera, options.lens, size, sample, lensSamples) : camera;
    m_parts.begin(ms);
    const bool isAside = drawAside(scene, seenBy, size, 0, options);
    if (!m_parts.end())
        return false;
    m_parts.restart();
    if (isAside && hasLens)
        addThroughLens(size, sample);
    return true;
}

/// The picture that is shown now joins those of the samples before.
void Renderer::addThroughLens(QSize size, int sample)
{
    const GLuint aside = m_lensPicture.begin(size), sum = m_lensSum.begin(size);
    if (aside == 0 || sum == 0)
        return;
    show(size, aside);
    m_gl.glViewport(0, 0, size.width(), size.height());
    m_gl.glBindVertexArray(m_emptyArray);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, sum);
    m_gl.glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    if (sample == 0)
        m_gl.glClear(GL_COLOR_BUFFER_BIT);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE);
    m_lensPicture.end(sum, *m_programs.lensAdd);
    m_gl.glDisable(GL_BLEND);
    resetState();
    m_shown = Shown::Lens;
    m_lensPictures = sample + 1;
}

void Renderer::show(QSize size, GLuint framebuffer)
{
    m_gl.glViewport(0, 0, size.width(), size.height());
    m_gl.glBindVertexArray(m_emptyArray);
    if (m_shown == Shown::Lens) {
        m_programs.lensShow->bind();
        m_programs.lensShow->set("uShare", 1.0f / float(m_lensPictures));
        m_lensSum.end(framebuffer, *m_programs.lensShow);
    } else if (m_shown == Shown::Part) {
        m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_large.begin(size));
        m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        m_gl.glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    } else {
        Smoothing& aside = m_shown == Shown::Smoothed ? m_smoothing : m_large;
        aside.end(framebuffer, m_shown == Shown::Shrunk ? *m_programs.shrink : *m_programs.smooth);
    }
    resetState();
}

void Renderer::drawInto(GLuint framebuffer, const Picture& picture, QSize size)
{
    const RenderOptions& options = picture.options;
    if (!m_parts.enter(PictureParts::Pass::Picture, size))
        return;
    m_nearShadow.bind(nearUnit, nearDepthUnit); // first: what is new is made in the first unit
    m_shadowMap.bind(shadowUnit, shadowDepthUnit);
    m_sky.bind(skyUnit, picture.light.around);
    m_gl.glActiveTexture(GL_TEXTURE0 + occlusionUnit);
    m_gl.glBindTexture(GL_TEXTURE_2D, picture.occluded ? m_occlusion.texture() : 0);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    beginState(size, m_parts.isFirst());
    m_gl.glGetIntegerv(GL_SAMPLES, &m_samples);
    if (options.world && !picture.isLevel())
        drawWorld(picture);
    if (options.shading == ShadingMode::Solid) // the wireframe's other program would not give the same depths
        drawDepth(picture);
    drawMeshes(picture, options.shading, false);
    if (options.world && picture.isLevel()) // after what hides it: the ground's light costs much
        drawWorld(picture);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    drawGhosts(picture);
    drawLines(picture, true);
    drawPoints(picture, true);
    drawLines(picture, false);
    drawPoints(picture, false);
    drawFaded(picture);
    if (options.outline)
        m_parts.share(1, [&](int, int) { drawOutline(picture, framebuffer); });
}

Renderer::Picture Renderer::arrange(const RenderScene& scene, const Camera& camera, QSize size,
                                    const RenderOptions& options)
{
    Picture picture{scene, camera, options, {}};
    picture.viewport = {float(size.width()), float(size.height())};
    picture.aspect = double(size.width()) / std::max(1, size.height());
    glm::dmat4 rotation = camera.viewMatrix();
    rotation[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    Box box = scene.box;
    box.add(scene.trailBox);
    picture.projectedView = camera.projectionMatrix(picture.aspect, camera.depthRange(box)) * rotation;
    if (!m_light || m_light->first != options.light)
        m_light = {options.light, lightOf(options.light)};
    picture.light = m_light->second;
    return picture;
}

/// In pictures at rest.
void Renderer::occlude(Picture& picture, QSize size)
{
    constexpr double ofScene = 0.06, ofView = 0.08; // how far what counts as close is away
    const RenderOptions& options = picture.options;
    const Box& box = picture.scene.box;
    const bool draft =
        options.quality == Quality::Draft || (options.sparing && options.quality == Quality::Good);
    if (draft || options.hurried || options.shading != ShadingMode::Solid || box.empty())
        return;
    const bool isDue = m_parts.enter(PictureParts::Pass::Occlusion, size);
    picture.occluded = isDue ? m_occlusion.begin(size, m_parts.isFirst()) : m_occlusion.texture() != 0;
    if (!isDue || !picture.occluded)
        return;
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_TRUE);
    if (options.world && options.ground)
        drawWorld(picture, true);
    m_gl.glDepthFunc(GL_LEQUAL);
    const DepthPrograms programs{*m_programs.shadow, *m_programs.shadowCut};
    for (const MeshItem& item : picture.scene.meshes) {
        if (item.opacity < 1.0f)
            continue;
        ShaderProgram& program = programs.of(item);
        program.bind();
        if (DepthPrograms::cuts(item))
            m_cache.bindPictures(program, item);
        m_cache.bindMotion(program, item.motion);
        program.set("uClip", glm::mat4(picture.projectedView * picture.relative(item.world)));
        drawItem(picture, item, m_cache.item(item));
    }
    m_gl.glBindVertexArray(m_emptyArray);
    m_occlusion.end(picture.camera, picture.projectedView,
                    std::min(ofScene * box.radius(), ofView * picture.camera.heightAtTarget()),
                    {*m_programs.occlude, *m_programs.occludeBlur}, m_parts);
}

void Renderer::castShadows(Picture& picture)
{
    const RenderOptions& options = picture.options;
    if (!options.shadows || options.shading == ShadingMode::Wire || picture.light.sunlight == glm::vec3(0.0f))
        return;
    const bool finest = options.quality == Quality::Best && !options.hurried;
    const auto fit = m_shadowMap.update(
        picture.scene, picture.light.sun, m_cache, {*m_programs.shadow, *m_programs.shadowCut}, m_parts,
        PictureParts::Pass::Shadow, finest ? LeafDetail::All : LeafDetail::Few);
    if (!fit)
        return;
    picture.shadow = placeOf(*fit, picture.camera.eye());
    picture.shadowTaps = options.shadowTaps > 0 ? options.shadowTaps : (m_software ? 12 : 20);
    if (finest)
        picture.shadowTaps = std::max(picture.shadowTaps, 32);
    if (options.quality != Quality::Draft && !options.hurried)
        castNear(picture, fit->side);
}

/// Where the view shows but a part of what there is, that gets a map of its own.
void Renderer::castNear(Picture& picture, double side)
{
    constexpr double around = 0.75, worthwhile = 0.5;
    const Camera& camera = picture.camera;
    const double radius = around * camera.heightAtTarget() * std::max(picture.aspect, 1.0);
    if (2.0 * radius > worthwhile * side)
        return;
    const auto fit = m_nearShadow.update(
        picture.scene, picture.light.sun, m_cache, {*m_programs.shadow, *m_programs.shadowCut}, m_parts,
        PictureParts::Pass::NearShadow, LeafDetail::All, ShadowFocus{camera.target, radius});
    if (fit)
        picture.near = placeOf(*fit, picture.camera.eye());
}

void Renderer::beginState(QSize size, bool clears)
{
    m_gl.glViewport(0, 0, size.width(), size.height());
    m_gl.glEnable(GL_MULTISAMPLE);
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDisable(GL_SCISSOR_TEST);
    m_gl.glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    if (clears)
        m_gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::upload(const RenderScene& scene)
{
    m_cache.keep(scene.crowds);
    for (const MeshItem& item : scene.meshes)
        m_cache.item(item);
    for (const GhostItem& item : scene.ghosts)
        m_cache.mesh(item.mesh, nullptr);
    for (const LineItem& item : scene.lines)
        m_cache.lines(item.lines);
    for (const PointItem& item : scene.points)
        m_cache.points(item.points);
    for (const Highlight& highlight : scene.highlights)
        m_cache.states(highlight.states);
}

void Renderer::setLight(ShaderProgram& program, const Picture& picture)
{
    picture.light.set(program);
    program.set("uExposure", picture.options.quality == Quality::Draft ? 0.0f : exposure);
    program.set("uShadowTaps", picture.shadowTaps);
    program.set("uShadow", picture.shadow.place);
    program.set("uShadowScale", picture.shadow.scale);
    program.set("uHasNear", picture.near.has_value());
    if (picture.near) {
        program.set("uNear", picture.near->place);
        program.set("uNearScale", picture.near->scale);
    }
    program.set("uOcclusionScale", picture.occluded ? 1.0f / picture.viewport : glm::vec2(0.0f));
}

void Renderer::setStates(ShaderProgram& program, const RenderScene& scene, NodeId node, bool hasBranches)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + statesUnit);
    GLuint texture = m_noStates;
    int count = 0;
    for (const Highlight& highlight : scene.highlights) {
        if (highlight.node == node && node != noNode && (hasBranches || highlight.whole)) {
            const GpuBlock& block = m_cache.states(highlight.states);
            texture = block.texture != 0 ? block.texture : m_noStates;
            count = block.count;
        }
    }
    m_gl.glBindTexture(GL_TEXTURE_2D, texture);
    m_gl.glActiveTexture(GL_TEXTURE0);
    program.set("uStateCount", count);
}

/// The depth pass and the shading pass must draw the same triangles.
void Renderer::drawItem(const Picture& picture, const MeshItem& item, const GpuBlock& block)
{
    if (m_progress && m_progress->cancelled())
        return;
    const bool culls = item.closed && picture.options.shading == ShadingMode::Solid;
    m_gl.glFrontFace(glm::determinant(glm::dmat3(item.world)) < 0.0 ? GL_CW : GL_CCW);
    culls ? m_gl.glEnable(GL_CULL_FACE) : m_gl.glDisable(GL_CULL_FACE);
    m_cache.drawTriangles(block, m_parts, picture.detailOf(item));
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glFrontFace(GL_CCW);
    if (!m_progress)
        return;
    constexpr double passes = 3.0; // what is close, depth, colour
    m_gl.glFinish();               // drivers only note down what is to be drawn
    m_progress->report(std::min(1.0, double(++m_drawn) / (passes * double(picture.scene.meshes.size()))));
}

void Renderer::drawMeshDepth(const Picture& picture, const MeshItem& item)
{
    ShaderProgram& program = m_programs.shadow->with(item.motion.isStill(), switches::still);
    program.bind();
    m_cache.bindMotion(program, item.motion);
    program.set("uClip", glm::mat4(picture.projectedView * picture.relative(item.world)));
    drawItem(picture, item, m_cache.item(item));
}

// Leaves cover each other many times over: with the depth known, only what is seen is shaded. Of small ones
// drawing them twice costs more than shading what is hidden.
void Renderer::drawDepth(const Picture& picture)
{
    m_gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const MeshItem& item : picture.scene.meshes)
        if (item.opacity >= 1.0f && !(item.images && item.images->isCut) && !picture.isOfSmall(item))
            drawMeshDepth(picture, item);
    m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Renderer::beginMeshes(ShaderProgram& program, const Picture& picture, ShadingMode shading)
{
    program.bind();
    setLight(program, picture);
    program.set("uViewport", picture.viewport);
    program.set("uWireOnly", shading == ShadingMode::Wire);
    program.set("uLineWidth", float(1.2 * picture.options.pixelRatio));
    program.set("uBackward",
                glm::vec4(glm::vec3(picture.camera.backward()), picture.camera.orthographic ? 1.0f : 0.0f));
}

void Renderer::drawMesh(ShaderProgram& program, const Picture& picture, const MeshItem& item)
{
    const GpuBlock& block = m_cache.item(item);
    m_cache.bindMotion(program, item.motion);
    m_cache.bindColours(program, block);
    m_cache.bindPictures(program, item);
    const glm::dmat4 relative = picture.relative(item.world);
    const bool hasCrown = item.crown && picture.options.quality != Quality::Draft;
    m_cache.bindCrown(program, hasCrown ? item.crown : nullptr);
    if (item.places)
        setCrowd(program, item);
    else if (hasCrown)
        program.set("uCrownPlace", glm::mat4(item.crown->place * glm::inverse(relative)));
    setStates(program, picture.scene, item.node, item.hasBranches());
    // What lies on the level ground is as bright as that is, whose colour a landscape shows as it is.
    const bool isPlain = item.isGround && !picture.light.isNatural();
    program.set("uExposure", isPlain || picture.options.quality == Quality::Draft ? 0.0f : exposure);
    program.set("uStanding", isPlain ? 1.0f : picture.light.standing());
    program.set("uClip", glm::mat4(picture.projectedView * relative));
    program.set("uRelative", glm::mat4(relative));
    program.set("uNormal", glm::mat3(glm::inverseTranspose(glm::dmat3(item.world))));
    program.set("uColour", srgb(item.material.colour));
    program.set("uShininess", item.material.phong ? 26.0f : 0.0f);
    program.set("uGlint", item.material.glint);
    program.set("uThrough", item.material.through);
    const bool pigments = item.material.pigments;
    program.set("uSheen", pigments ? surfaceSheen : glm::vec3(0.0f));
    program.set("uPassed", pigments ? glm::vec3(passedOn) : usualPassed);
    program.set("uVariety", item.hasBranches() ? item.material.variety : 0.0f);
    program.set("uTwoSided", item.material.twoSided);
    program.set("uPaint", int(item.paint));
    program.set("uOpacity", item.opacity);
    const bool covers = m_samples > 1 && item.images && item.images->isCut && item.opacity >= 1.0f;
    program.set("uCovers", covers);
    for (const GLenum how : {GLenum(GL_SAMPLE_ALPHA_TO_COVERAGE), GLenum(GL_SAMPLE_ALPHA_TO_ONE)})
        covers ? m_gl.glEnable(how) : m_gl.glDisable(how);
    drawItem(picture, item, block);
}

/// Where triangles have colours of their own they are counted, which costs software rasterisers time: only
/// for the meshes that have some.
ShaderProgram& Renderer::programOf(const Picture& picture, const MeshItem& item, ShadingMode shading)
{
    if (shading != ShadingMode::Solid)
        return *m_programs.meshWire;
    if (m_cache.item(item).hasColours())
        return *m_programs.meshColours;
    if (item.places)
        return m_programs.crowd->with(true, switches::still)
            .with(picture.scene.highlights.empty(), switches::unmarked)
            .with(!picture.near, switches::one);
    if (item.paint != Paint::Material || item.images)
        return *m_programs.mesh;
    const bool isFar = picture.detailOf(item) == LeafDetail::Least;
    return (isFar       ? *m_programs.far
            : item.bark ? *m_programs.bark
            : item.leaf ? *m_programs.leaf
                        : *m_programs.plain)
        .with(item.motion.isStill(), switches::still)
        .with(picture.scene.highlights.empty(), switches::unmarked)
        .with(!picture.near, switches::one);
}

/// Those that are opaque, or those that are not.
void Renderer::drawMeshes(const Picture& picture, ShadingMode shading, bool faded)
{
    const ShaderProgram* last = nullptr;
    for (const MeshItem& item : picture.scene.meshes) {
        if ((item.opacity < 1.0f) != faded)
            continue;
        ShaderProgram& program = programOf(picture, item, shading);
        if (&program != std::exchange(last, &program))
            beginMeshes(program, picture, shading);
        drawMesh(program, picture, item);
    }
}

/// Over everything else, but only what is nearest of it: a hundred leaves hide no more than one.
void Renderer::drawFaded(const Picture& picture)
{
    const auto isFaded = [](const MeshItem& item) { return item.opacity < 1.0f; };
    if (std::ranges::none_of(picture.scene.meshes, isFaded))
        return;
    const bool wire = picture.options.shading == ShadingMode::Wire;
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const MeshItem& item : picture.scene.meshes)
        if (isFaded(item) && !wire)
            drawMeshDepth(picture, item);
    m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawMeshes(picture, wire ? ShadingMode::Wire : ShadingMode::Solid, true);
}

void Renderer::resetState()
{
    m_gl.glBindVertexArray(0);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
    m_gl.glUseProgram(0);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_BLEND);
    for (const GLenum unit : {shadowUnit, shadowDepthUnit, nearUnit, nearDepthUnit, occlusionUnit, statesUnit,
                              skyUnit, GpuCache::bonesUnit, GpuCache::coloursUnit, GpuCache::barkUnit,
                              GpuCache::barkNormalsUnit, GpuCache::elementsUnit}) {
        m_gl.glActiveTexture(GL_TEXTURE0 + unit);
        m_gl.glBindTexture(GL_TEXTURE_2D, 0);
        m_gl.glBindSampler(unit, 0);
    }
    m_gl.glActiveTexture(GL_TEXTURE0 + GpuCache::crownUnit);
    m_gl.glBindTexture(GL_TEXTURE_3D, 0);
    m_gl.glActiveTexture(GL_TEXTURE0);
}

RenderStats Renderer::stats() const
{
    RenderStats stats = m_stats;
    stats.shadowRedraws = m_shadowMap.redraws() + m_nearShadow.redraws();
    stats.uploads = m_cache.stats();
    stats.crowd = m_crowds.counts();
    return stats;
}

} // namespace ramure
