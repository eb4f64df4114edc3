#include "core/qt/session/arm/arm_dresser.h"

#include "core/evaluate/evaluator.h"
#include "core/math/drag_maths.h"
#include "core/math/reproducible.h"
#include "core/qt/document/document_command.h"
#include "core/rig/arm/arm_chain.h"
#include "core/rig/arm/arm_shape.h"
#include "core/surface/mesh/transformed.h"
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace ramure {

/// What is put on, and what it was when that began.
struct ArmDresser::Work
{
    NodeId arm = noNode;
    NodeId worn = noNode; ///< whose mesh it is, to be hidden; noNode: the arm's own one
    SharedValue<TriangleMesh> source;
    glm::dmat4 intoArm = glm::dmat4(1.0);
    std::vector<ArmJoint> joints;      ///< it is fitted to; empty: it stays where it is
    MeshAxis axis = MeshAxis::Longest; ///< of the source that comes to lie along the arm, where it is fitted
    SharedValue<TriangleMesh> before;
    SharedValue<TriangleMesh> made;

    /// Errors: those of edit::wearMesh.
    static Expected<std::shared_ptr<Work>> of(const Scene& scene, NodeId arm, NodeId mesh, bool fitted,
                                              std::optional<MeshAxis> axis = {});
    Expected<void> make(const Progress& progress = {});
    Expected<void> putOn(Document& document) const;
    [[nodiscard]] std::vector<std::pair<const ParamDef*, ParamValue>> looksOf(const Node& from) const;
    [[nodiscard]] bool holds(const Scene& scene) const;
};

namespace {

/// From the space of a node with a mesh into the arm's own, both at rest.
Expected<glm::dmat4> wayIntoArm(const Scene& scene, NodeId arm, NodeId worn)
{
    const EvaluatedScene atRest(scene);
    const glm::dmat4 place = atRest.transforms(arm).geometry * armUpright();
    const glm::dmat4 from = atRest.transforms(worn).geometry;
    if (glm::determinant(glm::dmat3(place)) == 0.0 || glm::determinant(glm::dmat3(from)) == 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a scale of zero leaves nothing to wear"));
    return glm::inverse(place) * from;
}

/// The way turned on until an axis of what it moves lies along the arm's Z.
glm::dmat4 turnedAlong(const glm::dmat4& way, MeshAxis axis)
{
    if (axis == MeshAxis::Longest)
        return way;
    const glm::dvec3 along(0.0, 0.0, 1.0);
    const glm::dvec3 now =
        glm::normalize(glm::dvec3(way[static_cast<int>(axis) - static_cast<int>(MeshAxis::X)]));
    const glm::dvec3 across = glm::cross(now, along);
    const double sine = glm::length(across), cosine = glm::dot(now, along);
    if (sine < 1e-12)
        return cosine > 0.0 ? way : glm::dmat4(turnAbout({1.0, 0.0, 0.0}, std::numbers::pi)) * way;
    return glm::dmat4(turnAbout(across / sine, maths::atan2(sine, cosine))) * way;
}

} // namespace

Expected<std::shared_ptr<ArmDresser::Work>> ArmDresser::Work::of(const Scene& scene, NodeId arm, NodeId mesh,
                                                                 bool fitted, std::optional<MeshAxis> axis)
{
    const auto node = editableArm(scene, arm);
    RAMURE_TRY(node);
    const Node* from = scene.find(mesh);
    if (!from)
        return unknownNode(mesh);
    if (from->kind != NodeKind::Mesh || !from->mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no imported mesh"), {from->name});
    const auto way = wayIntoArm(scene, arm, mesh);
    RAMURE_TRY(way);
    auto work = std::make_shared<Work>();
    work->arm = arm;
    work->worn = mesh;
    work->source = from->mesh;
    work->before = (*node)->mesh;
    work->intoArm = *way;
    if (fitted) {
        work->axis = axis.value_or((*node)->params.armSkin.axis);
        work->joints = (*node)->params.joints;
        work->intoArm = turnedAlong(*way, work->axis);
    }
    return work;
}

Expected<void> ArmDresser::Work::make(const Progress& progress)
{
    TriangleMesh mesh = worn == noNode ? *source : transformed(*source, intoArm);
    progress.report(0.5);
    if (!joints.empty() && !progress.cancelled())
        mesh = fittedToArm(std::move(mesh), joints, axis == MeshAxis::Longest ? axis : MeshAxis::Z);
    progress.report(0.8);
    if (auto checked = checkArmMesh(mesh); !checked)
        return checked;
    made = SharedValue<TriangleMesh>(std::move(mesh));
    return {};
}

/// What the arm takes over besides the mesh: its colour, and how it was turned.
std::vector<std::pair<const ParamDef*, ParamValue>> ArmDresser::Work::looksOf(const Node& from) const
{
    const ParamDef* axisDef = findParam("armSkin.axis");
    NodeParams turned;
    turned.armSkin.axis = axis;
    std::vector<std::pair<const ParamDef*, ParamValue>> looks{
        {findParam("surface.color"), from.params.surface.color}};
    if (!joints.empty())
        looks.emplace_back(axisDef, axisDef->get(turned));
    return looks;
}

Expected<void> ArmDresser::Work::putOn(Document& document) const
{
    if (worn == noNode)
        return edit::setArmMesh(document, arm, made, DocumentCommand::tr("Fit the worn mesh again"));
    const Node& from = *document.scene().find(worn);
    const QString text = DocumentCommand::tr("Wear \"%1\"").arg(QString::fromStdString(from.name));
    const std::vector<std::pair<const ParamDef*, ParamValue>> looks = looksOf(from);
    const OneStep step(document, text);
    auto done = edit::setArmMesh(document, arm, made, text);
    if (done)
        done = edit::setParams(document, {arm}, looks, text);
    // Refused where it is locked: it stays, and is only in the way.
    [[maybe_unused]] const auto hidden = edit::setNodeVisible(document, {worn}, false);
    return done;
}

/// Is everything as it was when the work began?
bool ArmDresser::Work::holds(const Scene& scene) const
{
    const Node* node = scene.find(arm);
    const Node* from = scene.find(worn == noNode ? arm : worn);
    return node && from && node->kind == NodeKind::Arm && !scene.isLocked(arm) &&
           node->mesh.pointer() == before.pointer() && from->mesh.pointer() == source.pointer() &&
           (joints.empty() || joints == node->params.joints);
}

ArmDresser::ArmDresser(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
}

Expected<void> ArmDresser::wear(NodeId arm, NodeId mesh, bool fitted, std::optional<MeshAxis> axis)
{
    auto work = Work::of(m_document->scene(), arm, mesh, fitted, axis);
    return work ? doOrBegin(*work) : fail(work.error());
}

Expected<void> ArmDresser::fitAgain(NodeId arm)
{
    const auto node = editableArm(m_document->scene(), arm);
    RAMURE_TRY(node);
    if (!(*node)->mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" wears no mesh"), {(*node)->name});
    auto work = std::make_shared<Work>();
    work->arm = arm;
    work->source = work->before = (*node)->mesh;
    work->joints = (*node)->params.joints;
    work->axis = (*node)->params.armSkin.axis;
    return doOrBegin(work);
}

/// Small ones at once.
Expected<void> ArmDresser::doOrBegin(const std::shared_ptr<Work>& work)
{
    if (work->source->vertexCount() < fewVertices) {
        if (auto made = work->make(); !made)
            return made;
        auto done = work->putOn(*m_document);
        if (done)
            emit finished(std::nullopt);
        return done;
    }
    if (m_job.isRunning())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("another mesh is being put on"));
    m_job.start(
        [work](const Progress& progress) { return work->make(progress).map([work] { return work; }); },
        [this](const Expected<std::shared_ptr<Work>>& made) {
            Expected<void> done = fail(ErrorCode::Invalid, RAMURE_NOOP("the arm was changed meanwhile"));
            if (!made)
                done = fail(made.error());
            else if ((*made)->holds(m_document->scene()))
                done = (*made)->putOn(*m_document);
            emit finished(done ? std::nullopt : std::optional(done.error()));
        });
    return {};
}

Expected<void> edit::wearMesh(Document& document, NodeId arm, NodeId mesh, bool fitted)
{
    const auto work = ArmDresser::Work::of(document.scene(), arm, mesh, fitted);
    RAMURE_TRY(work);
    if (auto made = (*work)->make(); !made)
        return made;
    return (*work)->putOn(document);
}

} // namespace ramure

#include "moc_arm_dresser.cpp"
