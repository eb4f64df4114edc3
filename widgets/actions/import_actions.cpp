#include "widgets/actions/import_actions.h"

#include "core/io/formats/file_format.h"
#include "core/qt/session/jobs/import_task.h"
#include "widgets/base/action_set.h"
#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include <QFileInfo>
#include <QLocale>
#include <QProgressDialog>
#include <algorithm>
#include <utility>

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
{
    set->add(this, {{"file.import", Actions::tr("&Import…"), "open", Qt::CTRL | Qt::Key_I,
                     Actions::tr("Add objects to the scene: meshes, keys from Blender, trees of Arbaro and "
                                 "ez-tree"),
                     [this] { chooseFile(); }},
                    {"file.importFolder", Actions::tr("Import &folder…"), "open", noKeys,
                     Actions::tr("Add all objects of a folder that a script for Blender wrote"),
                     [this] { chooseFolder(); }}});
    connect(m_task, &ImportTask::progress, this, &ImportActions::showProgress);
    connect(m_task, &ImportTask::finished, this, &ImportActions::finish);
}

bool ImportActions::canImport(const QString& path)
{
    return QFileInfo(path).isDir() || findFormat(path.toStdString(), FormatUse::Import).has_value();
}

QString ImportActions::fileFilter()
{
    return tr("Objects, keys and trees (%1)")
        .arg(QString::fromStdString(endingList(FormatUse::Import, "*.", " ")));
}

bool ImportActions::isRunning() const
{
    return m_task->isRunning();
}

void ImportActions::chooseFile()
{
    choose(false);
}

void ImportActions::chooseToWear()
{
    choose(true);
}

/// \param stays at the place that the file has it
void ImportActions::choose(bool stays)
{
    const QString path = m_chooser->openFile(tr("Import"), m_preferences->lastFolder(),
                                             fileFilter() + QStringLiteral(";;") + tr("All files (*)"));
    if (!path.isEmpty())
        importPath(path, stays);
}

void ImportActions::chooseFolder()
{
    const QString path = m_chooser->openFolder(tr("Import folder"), m_preferences->lastFolder());
    if (!path.isEmpty())
        importPath(path);
}

void ImportActions::importPath(const QString& path, bool stays)
{
    if (m_task->isRunning())
        return;
    m_task->setStays(stays);
    begin(path, tr("Import"), tr("Importing “%1”…"));
    m_task->start(path);
}

void ImportActions::openPath(const QString& path, std::function<bool(std::optional<Scene>)> take)
{
    if (m_task->isRunning()) {
        take(std::nullopt);
        return;
    }
    m_take = std::move(take);
    begin(path, tr("Open"), tr("Opening “%1”…"));
    m_task->startScene(path);
}

void ImportActions::begin(const QString& path, const QString& title, const QString& text)
{
    m_path = path;
    m_preferences->setLastFolder(QFileInfo(path).absolutePath());
    m_progress = new QProgressDialog(text.arg(QFileInfo(path).fileName()), tr("Cancel"), 0, 100, m_window);
    m_progress->setWindowTitle(title);
    m_progress->setMinimumDuration(300);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, m_task, &ImportTask::cancel);
}

void ImportActions::showProgress(double fraction)
{
    if (m_progress)
        m_progress->setValue(static_cast<int>(100.0 * fraction));
}

void ImportActions::finish(NodeId top, const std::optional<Error>& error)
{
    delete m_progress;
    const QString name = QFileInfo(m_path).fileName();
    const auto take = std::exchange(m_take, nullptr);
    if (error) {
        const QString what = take ? tr("“%1” cannot be opened; the scene is as it was.")
                                  : tr("“%1” cannot be imported; the scene is as it was.");
        if (error->code != ErrorCode::Cancelled)
            m_chooser->report(Severity::Error, what.arg(name) + u'\n' + errorTextWithPlace(*error));
        if (take)
            take(std::nullopt);
        return;
    }
    if (!take) {
        QString text = tr("“%1” was imported.").arg(name);
        if (const double by = m_task->movedBy(); by != 0.0)
            text += u'\n' + tr("Something stands at its place: it was put %1 m beside it. Undo once puts it "
                               "where the file has it.")
                                .arg(QLocale().toString(by, 'f', by < 10.0 ? 1 : 0));
        tellNotes(text);
        emit imported(top);
    } else if (take(m_task->takeScene()) && !m_task->notes().empty()) {
        tellNotes(tr("“%1” was opened.").arg(name));
    }
}

/// What was guessed, below a text that says what was done.
void ImportActions::tellNotes(const QString& text)
{
    const std::vector<Note>& notes = m_task->notes();
    QString told = text;
    for (std::size_t i = 0; i < notes.size() && i < mostNotes; ++i) {
        Note note = notes[i];
        note.file = QFileInfo(QString::fromStdString(note.file)).fileName().toStdString();
        told += u'\n' + errorTextWithPlace(note);
    }
    if (notes.size() > mostNotes)
        told += u'\n' + tr("… and %n more note(s)", nullptr, static_cast<int>(notes.size() - mostNotes));
    const bool isFine = std::ranges::all_of(notes, [](const Note& note) { return note.code == remark; });
    m_chooser->report(isFine ? Severity::Info : Severity::Warning, told);
}

} // namespace ramure
