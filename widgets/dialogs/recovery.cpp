#include "widgets/dialogs/recovery.h"

#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include <utility>

namespace ramure {

Recovery::Recovery(Document* document, Preferences* preferences, Chooser* chooser, const QString& folder,
                   QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_folder(folder)
    , m_autosave(document, folder)
{
    connect(preferences, &Preferences::changed, this, &Recovery::takePreferences);
    connect(&m_autosave, &Autosave::failed, this, [this](const Error& error) {
        m_chooser->report(
            Severity::Warning,
            tr("Unsaved changes cannot be kept aside, so a crash would lose them. Please save often.") +
                u'\n' + errorTextWithPlace(error));
    });
    connect(&m_autosave, &Autosave::worksAgain, this,
            [this] { m_chooser->report(Severity::Info, tr("Unsaved changes are kept aside again.")); });
    takePreferences();
}

void Recovery::takePreferences()
{
    // Only when it is another one: the clock begins anew.
    const int interval = m_preferences->autosaveMs();
    if (std::exchange(m_intervalMs, interval) != interval)
        m_autosave.setInterval(interval);
}

bool Recovery::offer()
{
    std::vector<Recoverable> lost = recoverableProjects(m_folder);
    while (!lost.empty()) {
        QList<RecoveryEntry> entries;
        for (const Recoverable& each : lost)
            entries += {each.originalPath, each.time, each.savedLater};
        const RecoveryAnswer answer = m_chooser->recovery(entries);
        const auto chosen = static_cast<std::size_t>(answer.index);
        if (answer.action == RecoveryAnswer::Action::Later || chosen >= lost.size())
            return false;
        if (answer.action == RecoveryAnswer::Action::Recover)
            return recover(lost[chosen]);
        discardRecoverable(lost[chosen]);
        lost.erase(lost.begin() + answer.index);
    }
    return false;
}

bool Recovery::recover(Recoverable& lost)
{
    auto project = loadRecoverable(lost);
    if (!project) {
        m_chooser->report(Severity::Error, tr("The unsaved work could not be read.") + u'\n' +
                                               errorTextWithPlace(project.error()));
        return false;
    }
    Selection selection;
    if (!project->scene.empty())
        selection.nodes = {project->scene.nodes().front().id};
    m_document->reset(std::move(project->scene), lost.originalPath, std::move(project->extras));
    m_document->setSelection(selection);
    m_document->markModified();
    // The old file goes only when the new one is there: a second crash must not lose what the first spared.
    if (m_autosave.saveNow())
        discardRecoverable(lost);
    return true;
}

} // namespace ramure
