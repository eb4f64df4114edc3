#include "widgets/actions/billboard_actions.h"

#include "core/qt/document/document.h"
#include "core/scene/shown_nodes.h"
#include "widgets/base/action_set.h"
#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/billboard_dialog.h"
#include "widgets/dialogs/export/export_task.h"
#include "widgets/view/render/scene_at.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QDir>
#include <QFileInfo>
#include <QOpenGLContext>

namespace ramure {
namespace {

constexpr double sceneShare = 0.1,
                 drawnShare = 0.9; ///< of the work, when the scene and the pictures are there

/// All that a billboard is drawn from, on any thread.
struct BillboardSource
{
    Scene scene;
    TreeSource trees;
    double timeSeconds = 0.0;
};

/// Trees that the document has not computed yet are computed here.
TreeSource completeSource(const Document& document)
{
    return [there = snapshotOf(document)](const Node& node, Stage last, const Progress& progress) {
        auto result = there(node, last, progress);
        return result ? result : TreePipeline().evaluate(node.params, last, progress);
    };
}

/// Nothing is written before everything is drawn; from then on it is finished.
Expected<void> drawBillboard(const BillboardSource& source, const BillboardWish& wish, const QString& place,
                             OffscreenRenderer& renderer, const Progress& progress)
{
    Evaluator evaluator(source.trees, source.scene.timeline());
    EvaluatedScene now = evaluator.at(source.scene, source.timeSeconds);
    const auto scene = renderSceneAt(now, {}, progress.part(0.0, sceneShare));
    RAMURE_TRY(scene);
    const DrawSurfaces draw = [&](const Camera& camera, QSize size, double reach, bool sparing) {
        return renderer.drawSurfaces(*scene, camera, size, reach, sparing);
    };
    const auto write = [](const auto& baked, const auto& writer) -> Expected<void> {
        RAMURE_TRY(baked);
        return writer(*baked).map([](const QStringList&) {});
    };
    const SceneBall ball = ballOf(*scene);
    const Progress drawing = progress.part(sceneShare, drawnShare);
    if (wish.isAtlas)
        return write(bakeAtlas(draw, ball, wish.size, wish.views, drawing),
                     [&](const BillboardAtlas& atlas) { return writeAtlas(atlas, place); });
    return write(bakeCards(draw, ball, wish.size, wish.cards, wish.lying, drawing),
                 [&](const BillboardCards& cards) { return writeCards(cards, place); });
}

} // namespace

BillboardActions::BillboardActions(Document* document, ViewportHost* host, Preferences* preferences,
                                   Chooser* chooser, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_host(host)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_set(set)
{
    set->add(this, {"file.billboard", Actions::tr("&Billboard…"), nullptr, noKeys,
                    Actions::tr("Write crossed cards or an atlas of views, which stand for trees far away"),
                    [this] { ask(); }});
    connect(&m_job, &Job::runningChanged, this, &BillboardActions::update);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeStructure | changeNodeState | changeReset))
            update();
    });
    update();
}

QString BillboardActions::reasonAgainst() const
{
    if (!m_host->viewport())
        return tr("Billboard: there is no OpenGL here to draw it");
    if (m_job.isRunning())
        return tr("Billboard: one is being drawn; the next can follow it");
    return showsAnything(m_document->scene()) ? QString() : tr("Billboard: nothing is visible in the scene");
}

void BillboardActions::update()
{
    const QString reason = reasonAgainst();
    QAction* action = m_set->find("file.billboard");
    action->setEnabled(reason.isEmpty());
    m_set->setTip(action, reason);
}

/// What, then where to.
void BillboardActions::ask()
{
    const auto key = QStringLiteral("billboard");
    auto* dialog = new BillboardDialog(!m_document->selection().nodes.empty(),
                                       m_preferences->exportSettings().value(key).toMap(), m_host->window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, key] {
        QVariantMap kept = m_preferences->exportSettings();
        kept.insert(key, dialog->settings());
        m_preferences->setExportSettings(kept);
        const BillboardWish wish = dialog->wish();
        if (const QString place = chosenPlace(wish.isAtlas, dialog->isFolder()); !place.isEmpty())
            draw(wish, dialog->isSelectionOnly(), place);
    });
    dialog->open();
}

/// \returns a file that ends in .glb, or a folder; empty: nothing is to be written
QString BillboardActions::chosenPlace(bool isAtlas, bool isFolder)
{
    const QString last = m_preferences->lastFolder();
    if (!isFolder) {
        const QString file = m_chooser->saveFile(
            tr("Billboard"), QDir(last).filePath(tr("tree_cards") + QStringLiteral(".glb")),
            tr("glTF binary (*.glb)"), QStringLiteral("glb"));
        if (file.isEmpty() || isCardFile(file))
            return file;
        m_chooser->report(Severity::Error,
                          tr("%1: cards are written as a GLB file; the name has to end in .glb")
                              .arg(QDir::toNativeSeparators(file)));
        return {};
    }
    const QString folder = m_chooser->openFolder(tr("Folder for the billboard"), last);
    if (folder.isEmpty())
        return {};
    QStringList there = billboardFiles(isAtlas);
    there.removeIf(
        [&folder](const QString& name) { return !QFileInfo::exists(QDir(folder).filePath(name)); });
    const bool mayWrite =
        there.isEmpty() ||
        m_chooser->agrees(
            tr("Billboard"), tr("Replace the files of an earlier billboard?"),
            tr("In %1: %2").arg(QDir::toNativeSeparators(folder), there.join(QStringLiteral(", "))),
            tr("Replace"));
    return mayWrite ? QDir(folder).absolutePath() + u'/' : QString();
}

void BillboardActions::draw(const BillboardWish& wish, bool selectionOnly, const QString& place)
{
    BillboardSource source{m_document->scene(), completeSource(*m_document),
                           m_host->viewport()->shownSeconds()};
    if (selectionOnly)
        showOnly(source.scene, m_document->selection().nodes);
    m_renderer = rendererForJob();
    auto work = [source = std::move(source), wish, place,
                 renderer = m_renderer](const Progress& progress) -> Expected<void> {
        RAMURE_TRY(renderer->begin());
        auto done = drawBillboard(source, wish, place, *renderer, progress);
        renderer->end();
        return done;
    };
    if (!QOpenGLContext::supportsThreadedOpenGL())
        return taken(work({}), place);
    m_job.start(std::move(work), [this, place](const Expected<void>& done) { taken(done, place); });
}

void BillboardActions::taken(const Expected<void>& done, const QString& place)
{
    m_renderer.reset();
    if (!done && done.error().code == ErrorCode::Cancelled) {
        emit messageRaised(tr("No billboard was written"));
        return;
    }
    if (!done) {
        m_chooser->report(Severity::Error, errorTextWithPlace(done.error()));
        return;
    }
    m_preferences->setLastFolder(QFileInfo(place).absolutePath());
    emit exported(place);
}

} // namespace ramure
