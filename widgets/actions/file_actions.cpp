#include "widgets/actions/file_actions.h"

#include "core/base/file_writer.h"
#include "core/io/formats/file_format.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/own_presets.h"
#include "core/qt/document/project/project_file.h"
#include "core/qt/session/export/packing.h"
#include "core/scene/demo_scenes.h"
#include "widgets/actions/import_actions.h"
#include "widgets/actions/preset_menu.h"
#include "widgets/base/action_set.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/render/surface_images.h"
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenu>

namespace ramure {
namespace {

constexpr int mostBadPictures = 5; ///< that are named when a project is opened

const QString projectSuffix = QStringLiteral("ramure");

} // namespace

FileActions::FileActions(Document* document, Preferences* preferences, Chooser* chooser, ActionSet* set,
                         QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_set(set)
{
    for (const Preset& preset : presets()) {
        auto* action = new QAction(icon("tree"), QString(), this);
        action->setObjectName(QStringLiteral("file.new.") + QLatin1String(preset.name));
        if (m_presets.empty())
            action->setShortcut(QKeySequence::New);
        const QString name = QString::fromLatin1(preset.name);
        connect(action, &QAction::triggered, this, [this, name] { newFromPreset(name); });
        describePreset(preset, action);
        m_presets.push_back(action);
    }
    for (const DemoScene& demo : demoScenes()) {
        auto* action = new QAction(coreText(demo.label), this);
        const QString name = QString::fromLatin1(demo.name);
        action->setObjectName(QStringLiteral("file.demo.") + name);
        connect(action, &QAction::triggered, this, [this, name] { newFromDemo(name); });
        m_demos.push_back(action);
    }
    set->add(
        this,
        {{"file.newEmpty", Actions::tr("New e&mpty scene"), "new", Qt::CTRL | Qt::ALT | Qt::Key_N,
          Actions::tr("Begin a scene with nothing in it"), [this] { newEmpty(); }},
         {"file.open", Actions::tr("&Open…"), "open", QKeySequence::Open,
          Actions::tr("Open a Ramure file, or objects into a new scene"), [this] { open(); }},
         {"file.save", Actions::tr("&Save"), "save", QKeySequence::Save, Actions::tr("Save the scene"),
          [this] { save(); }},
         {"file.saveAs", Actions::tr("Save &as…"), "save-as", Qt::CTRL | Qt::SHIFT | Qt::Key_S,
          Actions::tr("Save the scene under another name"), [this] { saveAs(); }},
         {"file.packPictures", Actions::tr("Pac&k pictures"), nullptr, noKeys,
          Actions::tr("Copy all image files that the scene uses into a folder beside the project, to give "
                      "both away"),
          [this] { packPictures(); }},
         {"file.export", Actions::tr("&Export…"), "export", Qt::CTRL | Qt::Key_E,
          Actions::tr("Write meshes, sequences of frames or pictures"), [this] { emit exportRequested(); }},
         {"file.exportAgain", Actions::tr("Export a&gain"), nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_E,
          Actions::tr("Write the last export once more, over its files"),
          [this] { emit exportAgainRequested(); }},
         {"file.quit", Actions::tr("&Quit"), "quit", QKeySequence::Quit, QString(),
          [this] { emit quitRequested(); }}});
    set->find("file.quit")->setMenuRole(QAction::QuitRole);
    setLastExport({});
}

void FileActions::fillNewMenus(QMenu* menu)
{
    m_set->fill(menu, {"file.newEmpty"});
    QMenu* newMenu = menu->addMenu(tr("&New from preset"));
    newMenu->setToolTipsVisible(true);
    for (std::size_t i = 0; i < m_presets.size(); ++i)
        addPreset(newMenu, presets()[i], m_presets[i]);
    sortGroups(newMenu);
    menu->addMenu(tr("New from &demo"))->addActions(m_demos);
    m_set->fill(menu, {"file.open"});
    m_recentMenu = menu->addMenu(tr("Open &recent"));
    connect(m_recentMenu, &QMenu::aboutToShow, this, &FileActions::fillRecentMenu);
    fillRecentMenu();
}

void FileActions::setLastExport(const QString& path)
{
    QAction* again = m_set->find("file.exportAgain");
    again->setEnabled(!path.isEmpty());
    QString name = QFileInfo(path).fileName();
    name.replace(u'&', QStringLiteral("&&"));
    m_set->setText(again, path.isEmpty() ? QString() : tr("Export “%1” a&gain").arg(name));
    m_set->setTip(again,
                  path.isEmpty()
                      ? tr("Nothing was exported yet since this scene was opened: there is nothing to repeat")
                      : tr("Write %1 once more, with the same choices").arg(QDir::toNativeSeparators(path)));
}

void FileActions::fillRecentMenu()
{
    m_recentMenu->clear();
    int number = 1;
    for (const QString& path : m_preferences->recentFiles()) {
        QString shown = QDir::toNativeSeparators(path);
        const QString text =
            QStringLiteral("&%1  %2").arg(number++).arg(shown.replace(u'&', QStringLiteral("&&")));
        connect(m_recentMenu->addAction(text), &QAction::triggered, this, [this, path] { openFile(path); });
    }
    if (m_recentMenu->isEmpty()) {
        m_recentMenu->addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("Forget these files")), &QAction::triggered, m_preferences,
            [this] { m_preferences->recentFiles.set({}); });
}

QString FileActions::projectFilter() const
{
    return tr("Ramure files (*.ramure)") + QStringLiteral(";;") + tr("All files (*)");
}

QString FileActions::documentName() const
{
    const QString path = m_document->filePath();
    return path.isEmpty() ? tr("Untitled") : QFileInfo(path).fileName();
}

void FileActions::reportError(const QString& what, const Error& error)
{
    Error inside = error;
    inside.file.clear(); // the sentence before names it
    m_chooser->report(Severity::Error, QStringLiteral("%1\n%2").arg(what, errorTextWithPlace(inside)));
}

bool FileActions::mayDiscard()
{
    m_document->history().settle();
    if (!m_document->isModified())
        return true;
    switch (m_chooser->unsavedChanges(documentName())) {
    case Chooser::Unsaved::Save:
        return save();
    case Chooser::Unsaved::Discard:
        return true;
    case Chooser::Unsaved::Cancel:
        break;
    }
    return false;
}

bool FileActions::newEmpty()
{
    return startWith(Scene(), QString());
}

bool FileActions::newFromPreset(const QString& preset)
{
    return startWith(namedTree(preset).and_then([](Node&& tree) {
        tree.id = 1;
        giveTitle(tree);
        return Scene::fromNodes({std::move(tree)});
    }),
                     tr("There is no such preset."));
}

bool FileActions::newFromDemo(const QString& demo)
{
    return startWith(demoScene(demo.toStdString()), tr("There is no such demo."));
}

bool FileActions::startWith(Expected<Scene> scene, const QString& why)
{
    if (!scene) {
        reportError(why, scene.error());
        return false;
    }
    if (!mayDiscard())
        return false;
    resetTo(std::move(*scene), QString());
    return true;
}

/// Its first node is selected.
void FileActions::resetTo(Scene scene, const QString& path, std::string extras)
{
    Selection selection;
    if (!scene.empty())
        selection.nodes = {scene.nodes().front().id};
    m_document->reset(std::move(scene), path, std::move(extras));
    m_document->setSelection(selection);
}

bool FileActions::open()
{
    const QString filter = tr("All that can be opened (%1)")
                               .arg(QStringLiteral("*.ramure ") +
                                    QString::fromStdString(endingList(FormatUse::Import, "*.", " "))) +
                           QStringLiteral(";;") + tr("Ramure files (*.ramure)") + QStringLiteral(";;") +
                           ImportActions::fileFilter() + QStringLiteral(";;") + tr("All files (*)");
    const QString path = m_chooser->openFile(tr("Open"), m_preferences->lastFolder(), filter);
    return !path.isEmpty() && openFile(path);
}

bool FileActions::openFile(const QString& path)
{
    if (isOpening()) {
        emit openEnded(false); // its progress is shown
        return false;
    }
    if (m_imports && ImportActions::canImport(path)) {
        m_imports->openPath(
            path, [this, path](std::optional<Scene> scene) { return takeObjects(path, std::move(scene)); });
        return isOpening();
    }
    const bool opened = openProject(path);
    emit openEnded(opened);
    return opened;
}

bool FileActions::isOpening() const
{
    return m_imports && m_imports->isRunning();
}

/// Nothing: they could not be read.
bool FileActions::takeObjects(const QString& path, std::optional<Scene> scene)
{
    if (!scene && !QFileInfo::exists(path))
        m_preferences->removeRecentFile(QFileInfo(path).absoluteFilePath());
    const bool opened = scene && startWith(std::move(*scene), QString());
    if (opened)
        remember(path);
    emit openEnded(opened);
    return opened;
}

/// The image files of a scene that cannot be drawn, each once, with the reason.
static QStringList badPictures(const Scene& scene)
{
    QStringList out;
    for (const Node& node : scene.nodes())
        for (const auto part : {&NodeParams::barkPictures, &NodeParams::leafPictures,
                                &NodeParams::fruitPictures, &NodeParams::surfacePictures})
            for (const Error& error : pictureProblems(node.params.*part))
                out += errorTextWithPlace(error);
    out.removeDuplicates();
    return out;
}

bool FileActions::openProject(const QString& path)
{
    // Read first: a file that cannot be read must not cost the open document a question.
    auto project = loadProjectFile(path);
    if (!project) {
        const QFileInfo info(path);
        Error error = project.error();
        const QString ending = info.suffix().isEmpty() ? QString() : u'.' + info.suffix();
        if (error.code == ErrorCode::Syntax && info.suffix().toLower() != projectSuffix)
            error = fail(ErrorCode::Unknown, RAMURE_NOOP("unknown file ending \"%1\": %2 can be read"),
                         {ending.toStdString(), ".ramure, " + endingList(FormatUse::Import)})
                        .value();
        reportError(tr("“%1” cannot be opened.").arg(info.fileName()), error);
        if (!info.exists())
            m_preferences->removeRecentFile(info.absoluteFilePath());
        return false;
    }
    if (!mayDiscard())
        return false;
    removeAbandonedParts(QFile::encodeName(path).toStdString()); // of a program that was killed while saving
    resetTo(std::move(project->scene), QFileInfo(path).absoluteFilePath(), std::move(project->extras));
    remember(path);
    if (const QStringList bad = badPictures(m_document->scene()); !bad.isEmpty())
        m_chooser->report(Severity::Warning, tr("Pictures that cannot be shown; their paths are kept:") +
                                                 u'\n' + bad.mid(0, mostBadPictures).join(u'\n'));
    return true;
}

/// A file was opened or saved.
void FileActions::remember(const QString& path)
{
    m_preferences->addRecentFile(path);
    m_preferences->setLastFolder(QFileInfo(path).absolutePath());
    emit succeeded();
}

bool FileActions::save()
{
    return m_document->filePath().isEmpty() ? saveAs() : saveTo(m_document->filePath());
}

void FileActions::packPictures()
{
    if (m_document->filePath().isEmpty() && !saveAs())
        return;
    const auto packed = edit::packPictures(*m_document);
    if (!packed)
        return reportError(tr("The pictures could not be packed."), packed.error());
    m_chooser->report(Severity::Info, *packed == 0
                                          ? tr("All pictures of the scene lie beside the project already.")
                                          : tr("%n picture(s) copied into “%1”.", nullptr, int(*packed))
                                                .arg(QDir(packedFolder(m_document->filePath())).dirName()));
}

bool FileActions::saveAs()
{
    QString suggestion = m_document->filePath();
    if (suggestion.isEmpty()) {
        const auto& nodes = m_document->scene().nodes();
        const QString name = nodes.empty() ? documentName() : QString::fromStdString(nodes.front().name);
        suggestion = QDir(m_preferences->lastFolder()).filePath(name + u'.' + projectSuffix);
    }
    const QString path = m_chooser->saveFile(tr("Save as"), suggestion, projectFilter(), projectSuffix);
    return !path.isEmpty() && saveTo(path);
}

bool FileActions::saveTo(const QString& path)
{
    m_document->history().settle();
    if (const auto done = saveProjectFile(m_document->project(), path); !done) {
        reportError(tr("“%1” could not be saved. Nothing is lost: the file on disk is as it was, and your "
                       "changes are "
                       "still open here.")
                        .arg(QFileInfo(path).fileName()),
                    done.error());
        return false;
    }
    m_document->setFilePath(QFileInfo(path).absoluteFilePath());
    m_document->markSaved();
    remember(path);
    return true;
}

} // namespace ramure
