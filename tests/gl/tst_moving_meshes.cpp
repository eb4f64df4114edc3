#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/rig/arm/arm_skin.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include "tests/support/preset_trees.h"
#include "tests/support/solids.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/renderer.h"
#include "widgets/view/render/stream/gpu_cache.h"
#include <QApplication>
#include <QFile>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLVersionFunctionsFactory>
#include <cmath>

namespace tst_moving_meshes {

using namespace ramure;

/// Moving meshes on the graphics card: the vertex shader against the processor, and what a frame uploads.
class TestMovingMeshes : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { test::failOnAnyWarning(); }
    void shaderMatchesTheProcessor_data() { addRows({"tree", "arm", "worn mesh"}); }
    void shaderMatchesTheProcessor();
    void pictureIsThatOfTheDeformedMesh_data() { addRows({"tree", "arm"}); }
    void pictureIsThatOfTheDeformedMesh();
    void linesFollowTheirBranches();
    void aFrameUploadsOnlyItsBones();
    void restComesBack();

private:
    static void addRows(std::initializer_list<const char*> kinds);
};

namespace {

const QSize pictureSize(400, 300);

struct Tree
{
    Skeleton skeleton;
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const Skin> skin;
    std::shared_ptr<const std::vector<RigidTransform>> bones;
};

std::shared_ptr<const std::vector<RigidTransform>> swaying(const Skeleton& skeleton, double mostRad)
{
    std::vector<RigidTransform> bones(skeleton.size());
    for (Index b = 0; b < skeleton.size(); ++b) {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(std::sin(b), 0.3, std::cos(3.0 * b)));
        const RigidTransform own =
            turnAbout(skeleton.p0[b], glm::angleAxis(mostRad * std::sin(7.0 * b + 1.0), axis));
        bones[b] = skeleton.parent[b] == noIndex ? own : bones[skeleton.parent[b]] * own;
        if (b % 5 == 0)
            bones[b].rotation = -bones[b].rotation; // the same rotation
    }
    return std::make_shared<const std::vector<RigidTransform>>(std::move(bones));
}

Tree swayingTree(SkinMethod method)
{
    Tree tree;
    tree.skeleton = test::presetSkeleton({"SmallTree"}).value_or(Skeleton{});
    const auto made =
        std::make_shared<const BranchMesh>(buildBranchMesh(tree.skeleton, {}).value_or(BranchMesh{}));
    tree.mesh = DeferredMesh::Pointer(made, &made->mesh);
    tree.skin = std::make_shared<const Skin>(
        bindBranches(*made, tree.skeleton, method != SkinMethod::Rigid).value_or(Skin{}));
    tree.bones = swaying(tree.skeleton, 0.12);
    return tree;
}

/// The default arm, its second joint bent by 100 degrees.
Tree bentArm(SkinMethod method)
{
    Tree arm;
    std::vector<ArmJoint> joints = defaultArmJoints();
    joints[1].theta.angleRad = 1.75;
    arm.mesh = std::make_shared<const TriangleMesh>(armCylinder(joints, {}).value_or(TriangleMesh{}));
    arm.skin = std::make_shared<const Skin>(bindArm(*arm.mesh, joints, method != SkinMethod::Rigid, 0.2));
    std::vector<RigidTransform> bones;
    ArmChain(joints).pose(bones);
    arm.bones = std::make_shared<const std::vector<RigidTransform>>(std::move(bones));
    return arm;
}

/// The same arm in a mesh of any making: one with edges of all directions, not around the axis alone.
Tree bentWorn(SkinMethod method)
{
    Tree arm = bentArm(method);
    NodeParams params;
    params.skin.method = method;
    const TriangleMesh worn = fittedToArm(test::torus(48, 24), params.joints);
    const auto shape =
        std::make_shared<const ArmShape>(armShape(params, &worn, ArmPart::Skin).value_or(ArmShape{}));
    arm.mesh = DeferredMesh::Pointer(shape, &shape->mesh);
    arm.skin = {shape, &shape->skin};
    return arm;
}

Tree treeOf(const QString& what, SkinMethod method)
{
    return what == QLatin1String("tree")  ? swayingTree(method)
           : what == QLatin1String("arm") ? bentArm(method)
                                          : bentWorn(method);
}

RenderScene sceneOf(const std::shared_ptr<const TriangleMesh>& mesh, const ItemMotion& motion, const Box& box)
{
    RenderScene scene;
    MeshItem item;
    item.mesh = mesh;
    item.motion = motion;
    item.box = box;
    item.material = barkMaterial();
    scene.meshes.push_back(std::move(item));
    scene.updateBoxes();
    return scene;
}

Camera cameraFor(const RenderScene& scene)
{
    Camera camera;
    camera.pitchRad = 0.18;
    camera.frame(scene.box, double(pictureSize.width()) / pictureSize.height(), 1.1);
    return camera;
}

QImage picture(const RenderScene& scene, const Camera& camera)
{
    return renderImage(scene, camera, pictureSize, {}).value_or(QImage());
}

int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) > 24 ? 1 : 0;
        }
    return count;
}

QByteArray shaderText(const char* name)
{
    QFile file(QStringLiteral(":/shaders/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A program that only moves vertices and gives them back.
GLuint feedbackProgram(Gl& gl)
{
    const QByteArray text =
        "#version 330 core\nlayout(location = 0) in vec3 aPosition;\n"
        "layout(location = 1) in vec3 aNormal;\nout vec3 oPosition;\nout vec3 oNormal;\n" +
        shaderText("skin.glsl") + shaderText("copy.glsl") + shaderText("wind.glsl") +
        shaderText("skin_mesh.glsl") +
        "void main() { vec3 p = aPosition, n = aNormal; skin(p, n); oPosition = p; "
        "oNormal = normalize(n); gl_Position = vec4(p, 1.0); }\n";
    const GLuint shader = gl.glCreateShader(GL_VERTEX_SHADER);
    const char* source = text.constData();
    gl.glShaderSource(shader, 1, &source, nullptr);
    gl.glCompileShader(shader);
    const GLuint program = gl.glCreateProgram();
    gl.glAttachShader(program, shader);
    const char* varyings[] = {"oPosition", "oNormal"};
    gl.glTransformFeedbackVaryings(program, 2, varyings, GL_INTERLEAVED_ATTRIBS);
    gl.glLinkProgram(program);
    gl.glDeleteShader(shader);
    GLint linked = 0;
    gl.glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        char log[1024] = "";
        gl.glGetProgramInfoLog(program, sizeof log, nullptr, log);
        qWarning("%s", log);
    }
    return program;
}

struct Context
{
    QOffscreenSurface surface;
    QOpenGLContext context;

    Context()
    {
        context.setFormat(openGlFormat());
        context.create();
        surface.setFormat(context.format());
        surface.create();
        context.makeCurrent(&surface);
    }
    [[nodiscard]] Gl& gl()
    {
        auto* functions = QOpenGLVersionFunctionsFactory::get<Gl>(&context);
        functions->initializeOpenGLFunctions();
        return *functions;
    }
};

} // namespace

void TestMovingMeshes::initTestCase()
{
    Context current;
    QVERIFY(Renderer::make()); // links the shaders in, too
}

/// Vertices of the worn mesh are compared, pictures are not: it runs through itself, and a rounding of the
/// last bit then changes more pixels than the bound allows.
void TestMovingMeshes::addRows(std::initializer_list<const char*> kinds)
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("method");
    for (const char* what : kinds) {
        QTest::addRow("%s, rigid", what) << QString(what) << int(SkinMethod::Rigid);
        QTest::addRow("%s, linear", what) << QString(what) << int(SkinMethod::Linear);
        QTest::addRow("%s, dual quaternion", what) << QString(what) << int(SkinMethod::DualQuaternion);
    }
}

void TestMovingMeshes::shaderMatchesTheProcessor()
{
    QFETCH(QString, what);
    QFETCH(int, method);
    const Tree tree = treeOf(what, SkinMethod(method));
    const TriangleMesh meant = deformed(*tree.mesh, *tree.skin, *tree.bones, SkinMethod(method));

    Context current;
    Gl& gl = current.gl();
    {
        GpuCache cache(gl);
        cache.beginPicture({});
        const GLuint program = feedbackProgram(gl);
        gl.glUseProgram(program);
        const GpuBlock& block = cache.mesh(tree.mesh, tree.skin);
        gl.glActiveTexture(GL_TEXTURE0);
        gl.glBindTexture(GL_TEXTURE_2D, cache.bones(tree.bones).texture);
        gl.glUniform1i(gl.glGetUniformLocation(program, "uBones"), 0);
        gl.glUniform1i(gl.glGetUniformLocation(program, "uBoneCount"), int(tree.bones->size()));
        gl.glUniform1i(gl.glGetUniformLocation(program, "uSkinMethod"), method);
        const auto count = static_cast<GLsizei>(tree.mesh->vertexCount());
        std::vector<glm::vec3> back(2 * std::size_t(count));
        GLuint buffer = 0;
        gl.glGenBuffers(1, &buffer);
        gl.glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
        gl.glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizeiptr(back.size() * sizeof(glm::vec3)), nullptr,
                        GL_STATIC_READ);
        gl.glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        gl.glEnable(GL_RASTERIZER_DISCARD);
        gl.glBindVertexArray(block.vertexArray);
        gl.glBeginTransformFeedback(GL_POINTS);
        gl.glDrawArrays(GL_POINTS, 0, count);
        gl.glEndTransformFeedback();
        gl.glDisable(GL_RASTERIZER_DISCARD);
        gl.glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizeiptr(back.size() * sizeof(glm::vec3)),
                              back.data());
        gl.glDeleteBuffers(1, &buffer);
        gl.glDeleteProgram(program);
        const double height = 2.0 * meshBox(*tree.mesh).radius();
        double worst = 0.0, worstNormal = 0.0, moved = 0.0;
        for (std::size_t v = 0; v < std::size_t(count); ++v) {
            worst = std::max(worst, double(glm::length(back[2 * v] - meant.positions[v])));
            worstNormal = std::max(worstNormal, double(glm::length(back[2 * v + 1] - meant.normals[v])));
            moved = std::max(moved, double(glm::length(meant.positions[v] - tree.mesh->positions[v])));
        }
        QVERIFY(moved > 0.1 * height); // it is a pose worth comparing
        QVERIFY2(worst < 1e-5 * height, qPrintable(QString::number(worst / height)));
        QVERIFY2(worstNormal < 1e-4, qPrintable(QString::number(worstNormal)));
    }
}

void TestMovingMeshes::pictureIsThatOfTheDeformedMesh()
{
    QFETCH(QString, what);
    QFETCH(int, method);
    const Tree tree = treeOf(what, SkinMethod(method));
    const auto moved = std::make_shared<const TriangleMesh>(
        deformed(*tree.mesh, *tree.skin, *tree.bones, SkinMethod(method)));
    const Box box = meshBox(*moved);
    const RenderScene meant = sceneOf(moved, {}, box);
    const Camera camera = cameraFor(meant);
    const QImage expected = picture(meant, camera);
    const QImage shown =
        picture(sceneOf(tree.mesh, {tree.skin, tree.bones, SkinMethod(method)}, box), camera);
    QVERIFY(differing(shown, expected) < pictureSize.width() * pictureSize.height() / 500);
    const QImage rest = picture(sceneOf(tree.mesh, {}, box), camera);
    QVERIFY(differing(rest, expected) > 1000);
}

/// Lines of a skeleton move with it: its picture is that of the moved ends.
void TestMovingMeshes::linesFollowTheirBranches()
{
    const Tree tree = swayingTree(SkinMethod::Rigid);
    auto rest = std::make_shared<LineSet>(), meant = std::make_shared<LineSet>();
    for (Index b = 0; b < tree.skeleton.size(); ++b) {
        const RigidTransform& bone = (*tree.bones)[b];
        LineSegment line{glm::vec3(tree.skeleton.p0[b]),
                         glm::vec3(tree.skeleton.p1[b]),
                         3.0f,
                         3.0f,
                         {255, 40, 40, 255},
                         b};
        rest->segments.push_back(line);
        line.a = glm::vec3(bone.point(tree.skeleton.p0[b]));
        line.b = glm::vec3(bone.point(tree.skeleton.p1[b]));
        meant->segments.push_back(line);
    }
    const Box box = meshBox(*tree.mesh);
    const auto sceneWith = [&](const std::shared_ptr<const LineSet>& lines, const ItemMotion& motion) {
        RenderScene scene = sceneOf(tree.mesh, {}, box);
        scene.meshes.clear();
        LineItem item;
        item.lines = lines;
        item.motion = motion;
        item.node = 1;
        scene.lines.push_back(std::move(item));
        scene.box = box;
        return scene;
    };
    const RenderScene expected = sceneWith(meant, {});
    const Camera camera = cameraFor(expected);
    const QImage shown = picture(sceneWith(rest, {nullptr, tree.bones, SkinMethod::Rigid}), camera);
    QVERIFY(differing(shown, picture(expected, camera)) < 200);
    QVERIFY(differing(picture(sceneWith(rest, {}), camera), picture(expected, camera)) > 400);
}

void TestMovingMeshes::aFrameUploadsOnlyItsBones()
{
    const Tree tree = swayingTree(SkinMethod::DualQuaternion);
    Context current;
    QOpenGLFramebufferObject target(pictureSize, QOpenGLFramebufferObject::CombinedDepthStencil);
    auto renderer = Renderer::make();
    QVERIFY(renderer);
    const Box box = meshBox(*tree.mesh);
    const auto draw = [&](const std::shared_ptr<const std::vector<RigidTransform>>& bones) {
        const RenderScene scene = sceneOf(tree.mesh, {tree.skin, bones, SkinMethod::DualQuaternion}, box);
        (*renderer)->draw(scene, cameraFor(scene), pictureSize, target.handle(), {});
        return (*renderer)->stats();
    };
    const RenderStats first = draw(tree.bones);
    const RenderStats next = draw(swaying(tree.skeleton, 0.1));
    QCOMPARE(next.uploads.uploads - first.uploads.uploads, std::uint64_t(1));
    QVERIFY(next.uploads.bytes - first.uploads.bytes < 64 * (tree.bones->size() + 2048));
    QCOMPARE(next.uploads.alive, first.uploads.alive);
    QCOMPARE(next.shadowRedraws - first.shadowRedraws, std::uint64_t(1));
    renderer->reset();
}

void TestMovingMeshes::restComesBack()
{
    const Tree tree = swayingTree(SkinMethod::Linear);
    const Box box = meshBox(*tree.mesh);
    const RenderScene rest = sceneOf(tree.mesh, {}, box);
    const auto still = std::make_shared<const std::vector<RigidTransform>>(tree.skeleton.size());
    const Camera camera = cameraFor(rest);
    QCOMPARE(differing(picture(rest, camera),
                       picture(sceneOf(tree.mesh, {tree.skin, still, SkinMethod::Linear}, box), camera)),
             0);
}

RAMURE_SUITE(TestMovingMeshes)

} // namespace tst_moving_meshes

#include "tst_moving_meshes.moc"
