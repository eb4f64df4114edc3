#include "widgets/actions/picture_actions.h"

#include "core/evaluate/evaluator.h"
#include "core/qt/document/document.h"
#include "widgets/base/action_set.h"
#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/lens_form.h"
#include "widgets/dialogs/picture_dialog.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/render/passes/offscreen_renderer.h"
#include "widgets/view/render/passes/picture_file.h"
#include "widgets/view/screenshot.h"
#include "widgets/view/tools/gizmo_settings.h"
#include "widgets/view/tools/hand_settings.h"
#include "widgets/view/view_click.h"
#include "widgets/view/viewport_host.h"
#include <QDir>
#include <QFileInfo>
#include <QOpenGLContext>
#include <QPointer>

namespace ramure {

PictureActions::PictureActions(Document* document, ViewportHost* host, Preferences* preferences,
                               Chooser* chooser, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_host(host)
    , m_preferences(preferences)
    , m_chooser(chooser)
{
    Viewport* view = host->viewport();
    const auto exists = [view] { return view != nullptr; };
    const auto clear = [view, hand = host->settings()->hand(), own = host->settings()->gizmo()] {
        // The first Escape lays a tool down.
        if (hand->tool() != HandTool::None)
            hand->setTool(HandTool::None);
        else if (own->tool() == TransformTool::Measure)
            own->tool.set(TransformTool::Select);
        else
            view->clearSelection();
    };
    set->add(
        this,
        {{"view.savePicture", Actions::tr("Save a &picture…"), "camera", Qt::CTRL | Qt::SHIFT | Qt::Key_P,
          Actions::tr("Write the view as a picture"), [this] { ask(); }, exists},
         {"view.copyPicture", Actions::tr("&Copy the picture"), "copy", Qt::CTRL | Qt::SHIFT | Qt::Key_C,
          Actions::tr("Put the view on the clipboard as a picture"),
          [this, view] {
              copyScreenshot(*view);
              emit messageRaised(tr("The picture is on the clipboard"));
          },
          exists}});
    m_selectionActions =
        set->add(this, {{"edit.selectAll", Actions::tr("Select all &branches"), nullptr, Qt::CTRL | Qt::Key_A,
                         Actions::tr("Select every branch of the active tree"),
                         [view] { view->selectAllBranches(); }, exists},
                        {"edit.clearSelection", Actions::tr("Select n&othing"), nullptr, Qt::Key_Escape,
                         Actions::tr("Lay the tool down; without one, go from branches to their tree, and "
                                     "from there to nothing"),
                         clear, exists}});
    // Only in the view: lists, fields and messages have their own Ctrl+A and Escape.
    for (QAction* action : m_selectionActions) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        host->addAction(action);
    }
    set->update(this);
}

/// How large, then where to.
void PictureActions::ask()
{
    const auto key = QStringLiteral("picture");
    const Viewport* view = m_host->viewport();
    EvaluatedScene now(m_document->scene(), view->shownSeconds());
    const NodeView seen = viewThrough(now, view->seenThrough()).value_or(NodeView{view->camera(), {}});
    auto* dialog = new PictureDialog(view->pixelSize(), seen,
                                     m_preferences->exportSettings().value(key).toMap(), m_host->window());
    connect(dialog->lensForm(), &LensForm::pickWanted, this, [this, dialog] { pickFocus(dialog); });
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, key] {
        QVariantMap kept = m_preferences->exportSettings();
        kept.insert(key, dialog->settings());
        m_preferences->setExportSettings(kept);
        save(dialog->wish());
    });
    dialog->open();
}

/// The dialog comes back after the click, or after Esc.
void PictureActions::pickFocus(PictureDialog* dialog)
{
    Viewport* view = m_host->viewport();
    dialog->hide();
    emit messageRaised(tr("Click what is to be sharp · Esc: back to the picture"));
    new ViewClick(view, [this, view, dialog = QPointer(dialog)](std::optional<QPointF> at) {
        if (!dialog)
            return;
        const auto hit = at ? view->hitAt(*at) : std::nullopt;
        const auto place = hit ? std::optional(hit->point) : at ? view->groundAt(*at) : std::nullopt;
        const Camera& camera = view->camera();
        if (place)
            dialog->lensForm()->setFocus(glm::dot(camera.eye() - *place, camera.backward()));
        emit messageRaised(at && !place ? tr("Nothing is there: the focus stays as it was") : QString());
        dialog->open();
    });
}

void PictureActions::save(const ViewPicture& wish)
{
    const QString path = m_chooser->saveFile(
        tr("Save a picture"), QDir(m_preferences->lastFolder()).filePath(tr("tree") + QStringLiteral(".png")),
        tr("Pictures (*.png *.jpg);;All files (*)"), QStringLiteral("png"));
    if (path.isEmpty())
        return;
    Viewport* view = m_host->viewport();
    if (!QOpenGLContext::supportsThreadedOpenGL())
        return taken(saveScreenshot(*view, path, wish), path);
    m_renderer = rendererForJob();
    m_job.start(
        [shot = view->shot(wish), renderer = m_renderer,
         file = QFile::encodeName(path).toStdString()](const Progress& progress) -> Expected<void> {
            RAMURE_TRY(renderer->begin());
            const auto image =
                renderer->draw(*shot.scene, shot.camera, shot.pixels, shot.options, progress.part(0.0, 0.95));
            renderer->end();
            return image ? savePicture(*image, file) : Expected<void>(fail(image.error()));
        },
        [this, path](const Expected<void>& done) { taken(done, path); });
}

void PictureActions::taken(const Expected<void>& done, const QString& path)
{
    m_renderer.reset();
    if (!done && done.error().code == ErrorCode::Cancelled) {
        emit messageRaised(tr("No picture was written"));
        return;
    }
    if (!done) {
        m_chooser->report(Severity::Error, errorTextWithPlace(done.error()));
        return;
    }
    m_preferences->setLastFolder(QFileInfo(path).absolutePath());
    emit messageRaised(tr("Picture written to %1").arg(QDir::toNativeSeparators(path)));
}

} // namespace ramure
