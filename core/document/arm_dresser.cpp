#include "core/document/arm_dresser.h"

#include "core/arm/arm_chain.h"
#include "core/arm/arm_shape.h"
#include "core/document/document_command.h"
#include "core/document/exporter.h"
#include "core/scene/places.h"
#include <glm/matrix.hpp>

namespace ramure {

/// What is put on, and what it was when that began.
struct ArmDresser::Work
{
    NodeId arm = noNode;
    NodeId worn = noNode; ///< whose mesh it is, to be hidden; noNode: the arm's own one
    SharedValue<TriangleMesh> source;
    glm::dmat4 intoArm = glm::dmat4(1.0);
    std::vector<ArmJoint> joints; ///< it is fitted to; empty: it stays where it is
    SharedValue<TriangleMesh> before;
    SharedValue<TriangleMesh> made;

    Expected<void> make(const Progress& progress = {});
    Expected<void> putOn(Document& document) const;
    [[nodiscard]] bool holds(const Scene& scene) const;
};

namespace {

Expected<const Node*> armToDress(const Scene& scene, NodeId id)
{
    if (auto allowed = checkEditable(scene, id); !allowed)
        return fail(std::move(allowed.error()));
    const Node* node = scene.find(id);
    if (node->kind != NodeKind::Arm)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no arm"), {node->name});
    return node;
}

/// From the space of a node with a mesh into the arm's own, both at rest.
Expected<glm::dmat4> wayIntoArm(const Scene& scene, NodeId arm, NodeId worn)
{
    const glm::dmat4 place = placeAt(scene, arm, 0.0).geometry * armUpright();
    const glm::dmat4 from = placeAt(scene, worn, 0.0).geometry;
    if (glm::determinant(glm::dmat3(place)) == 0.0 || glm::determinant(glm::dmat3(from)) == 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a scale of zero leaves nothing to wear"));
    return glm::inverse(place) * from;
}

} // namespace

Expected<void> ArmDresser::Work::make(const Progress& progress)
{
    TriangleMesh mesh = worn == noNode ? *source : transformed(*source, intoArm);
    progress.report(0.5);
    if (!joints.empty() && !progress.cancelled())
        mesh = fittedToArm(std::move(mesh), joints);
    progress.report(0.8);
    if (auto checked = checkArmMesh(mesh); !checked)
        return checked;
    made = SharedValue<TriangleMesh>(std::move(mesh));
    return {};
}

Expected<void> ArmDresser::Work::putOn(Document& document) const
{
    if (worn == noNode)
        return edit::setArmMesh(document, arm, made, DocumentCommand::tr("Fit the worn mesh again"));
    const QString name = QString::fromStdString(document.scene().find(worn)->name);
    const QString text = DocumentCommand::tr("Wear \"%1\"").arg(name);
    document.undoStack()->beginMacro(text);
    auto done = edit::setArmMesh(document, arm, made, text);
    // Refused where it is locked: it stays, and is only in the way.
    [[maybe_unused]] const auto hidden = edit::setNodeVisible(document, {worn}, false);
    document.undoStack()->endMacro();
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
    connect(&m_job, &BackgroundJob::finished, this, &ArmDresser::take);
}

Expected<void> ArmDresser::wear(NodeId arm, NodeId mesh, bool fitted)
{
    const Scene& scene = m_document->scene();
    const Node* worn = scene.find(mesh);
    if (!worn || !worn->mesh || worn->mesh->vertexCount() < fewVertices) {
        auto done = edit::wearMesh(*m_document, arm, mesh, fitted); // or what is wrong with it
        if (done)
            emit finished(std::nullopt);
        return done;
    }
    const auto node = armToDress(scene, arm);
    if (!node)
        return fail(node.error());
    if (worn->kind != NodeKind::Mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no imported mesh"), {worn->name});
    const auto way = wayIntoArm(scene, arm, mesh);
    if (!way)
        return fail(way.error());
    auto work = std::make_shared<Work>();
    work->arm = arm;
    work->worn = mesh;
    work->source = worn->mesh;
    work->intoArm = *way;
    work->before = (*node)->mesh;
    if (fitted)
        work->joints = (*node)->params.joints;
    return begin(std::move(work));
}

Expected<void> ArmDresser::fitAgain(NodeId arm)
{
    const auto node = armToDress(m_document->scene(), arm);
    if (!node)
        return fail(node.error());
    if (!(*node)->mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" wears no mesh"), {(*node)->name});
    auto work = std::make_shared<Work>();
    work->arm = arm;
    work->source = work->before = (*node)->mesh;
    work->joints = (*node)->params.joints;
    if (work->source->vertexCount() >= fewVertices)
        return begin(std::move(work));
    if (auto made = work->make(); !made)
        return made;
    auto done = work->putOn(*m_document);
    if (done)
        emit finished(std::nullopt);
    return done;
}

Expected<void> ArmDresser::begin(std::shared_ptr<Work> work)
{
    if (m_job.isRunning())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("another mesh is being put on"));
    m_work = std::move(work);
    m_job.start([work = m_work](const Progress& progress) -> Expected<void> {
        if (auto made = work->make(progress); !made)
            return made;
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        return {};
    });
    return {};
}

void ArmDresser::take(const std::optional<Error>& error)
{
    const std::shared_ptr<Work> work = std::move(m_work);
    if (error)
        return emit finished(error);
    Expected<void> done = fail(ErrorCode::Invalid, RAMURE_NOOP("the arm was changed meanwhile"));
    if (work->holds(m_document->scene()))
        done = work->putOn(*m_document);
    emit finished(done ? std::nullopt : std::optional(done.error()));
}

Expected<void> edit::wearMesh(Document& document, NodeId arm, NodeId mesh, bool fitted)
{
    ArmDresser::Work work;
    if (const auto node = armToDress(document.scene(), arm); !node)
        return fail(node.error());
    else if (fitted)
        work.joints = (*node)->params.joints;
    const Node* worn = document.scene().find(mesh);
    if (!worn)
        return unknownNode(mesh);
    if (worn->kind != NodeKind::Mesh || !worn->mesh)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no imported mesh"), {worn->name});
    const auto way = wayIntoArm(document.scene(), arm, mesh);
    if (!way)
        return fail(way.error());
    work.arm = arm;
    work.worn = mesh;
    work.source = worn->mesh;
    work.intoArm = *way;
    if (auto made = work.make(); !made)
        return made;
    return work.putOn(document);
}

} // namespace ramure

#include "moc_arm_dresser.cpp"
