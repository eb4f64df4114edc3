#include "widgets/actions/import_actions.h"

#include "core/document/import_task.h"
#include "widgets/actions/action_set.h"
#include "widgets/actions/chooser.h"
#include "widgets/support/core_text.h"
#include "widgets/support/preferences.h"
#include <QFileInfo>
#include <QProgressDialog>

namespace ramure {

/// More notes than these are counted, not shown.
static constexpr std::size_t mostNotes = 8;

ImportActions::ImportActions(Document* document, Preferences* preferences, Chooser* chooser, ActionSet* set,
                             QWidget* window)
    : QObject(window)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_task(new ImportTask(document, this))
    , m_window(window)
    , m_file(set->add({"file.import", QT_TRANSLATE_NOOP("Actions", "&Import…"), "open",
                       QKeySequence(Qt::CTRL | Qt::Key_I),
                       QT_TRANSLATE_NOOP("Actions", "Add an object from Blender: .obj and .animation")}))
    , m_folder(set->add(
          {"file.importFolder",
           QT_TRANSLATE_NOOP("Actions", "Import &folder…"),
           "open",
           {},
           QT_TRANSLATE_NOOP("Actions", "Add all objects of a folder that a script for Blender wrote")}))
{
    connect(m_file, &QAction::triggered, this, &ImportActions::chooseFile);
    connect(m_folder, &QAction::triggered, this, &ImportActions::chooseFolder);
    connect(m_task, &ImportTask::progress, this, &ImportActions::showProgress);
    connect(m_task, &ImportTask::finished, this, [this](NodeId top, const std::optional<Error>& error) {
        finish(error);
        if (!error)
            emit imported(top);
    });
}

bool ImportActions::canImport(const QString& path)
{
    const QFileInfo info(path);
    const QString ending = info.suffix().toLower();
    return info.isDir() || ending == QLatin1String("obj") || ending == QLatin1String("animation");
}

bool ImportActions::isRunning() const
{
    return m_task->isRunning();
}

void ImportActions::chooseFile()
{
    const QString path = m_chooser->openFile(tr("Import"), m_preferences->lastFolder(),
                                             tr("Objects and keys (*.obj *.animation);;All files (*)"));
    if (!path.isEmpty())
        importPath(path);
}

void ImportActions::chooseFolder()
{
    const QString path = m_chooser->openFolder(tr("Import folder"), m_preferences->lastFolder());
    if (!path.isEmpty())
        importPath(path);
}

void ImportActions::importPath(const QString& path)
{
    if (m_task->isRunning())
        return;
    m_path = path;
    m_preferences->setLastFolder(QFileInfo(path).absolutePath());
    m_progress = new QProgressDialog(tr("Importing “%1”…").arg(QFileInfo(path).fileName()), tr("Cancel"), 0,
                                     100, m_window);
    m_progress->setWindowTitle(tr("Import"));
    m_progress->setMinimumDuration(300);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, m_task, &ImportTask::cancel);
    m_task->start(path);
}

void ImportActions::showProgress(double fraction)
{
    if (m_progress)
        m_progress->setValue(static_cast<int>(100.0 * fraction));
}

void ImportActions::finish(const std::optional<Error>& error)
{
    delete m_progress;
    const QString name = QFileInfo(m_path).fileName();
    if (error) {
        if (error->code != ErrorCode::Cancelled)
            m_chooser->report(Severity::Error,
                              tr("“%1” cannot be imported; the scene is as it was.").arg(name) + u'\n' +
                                  errorTextWithPlace(*error));
        return;
    }
    const std::vector<Note>& notes = m_task->notes();
    QString text = tr("“%1” was imported.").arg(name);
    for (std::size_t i = 0; i < notes.size() && i < mostNotes; ++i) {
        Note note = notes[i];
        note.file = QFileInfo(QString::fromStdString(note.file)).fileName().toStdString();
        text += u'\n' + errorTextWithPlace(note);
    }
    if (notes.size() > mostNotes)
        text += u'\n' + tr("… and %n more note(s)", nullptr, static_cast<int>(notes.size() - mostNotes));
    m_chooser->report(notes.empty() ? Severity::Info : Severity::Warning, text);
}

} // namespace ramure
