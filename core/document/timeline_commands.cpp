// The frames of the scene.
#include "core/document/document_command.h"

namespace ramure {

namespace {

class TimelineCommand final : public DocumentCommand
{
public:
    TimelineCommand(Document& document, const TimelineSettings& settings, GestureId gesture)
        : DocumentCommand(document, CommandId::SetTimeline, gesture, DocumentCommand::tr("Change Timeline"))
        , m_settings(settings)
    {
    }
    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = dynamic_cast<const TimelineCommand*>(other);
        if (!next || next->gesture() != gesture())
            return false;
        setObsolete(m_settings == document().scene().timeline());
        return true;
    }

private:
    void swap() override
    {
        Change change;
        change.kinds = changeTimeline;
        document().applyChange(change, [this](Scene& scene) {
            const TimelineSettings before = scene.timeline();
            scene.setTimeline(m_settings);
            m_settings = before;
        });
    }

    TimelineSettings m_settings;
};

} // namespace

Expected<void> edit::setTimeline(Document& document, const TimelineSettings& settings, GestureId gesture)
{
    if (auto fine = checkTimeline(settings); !fine)
        return fine;
    if (!(settings == document.scene().timeline()))
        document.undoStack()->push(new TimelineCommand(document, settings, gesture));
    return {};
}

} // namespace ramure
