// The frames of the scene.
#include "core/qt/document/document_command.h"

namespace ramure {

namespace {

class TimelineCommand final : public DocumentCommand
{
public:
    TimelineCommand(Document& document, const TimelineSettings& settings, GestureId gesture)
        : DocumentCommand(document, gesture, DocumentCommand::tr("Change Timeline"))
        , m_settings(settings)
    {
    }
    bool mergeWith(const DocumentCommand& next) override
    {
        if (!dynamic_cast<const TimelineCommand*>(&next) || next.gesture() != gesture())
            return false;
        setObsolete(m_settings == document().scene().timeline());
        return true;
    }
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
    void countMemory(MemoryCount& memory) const override { memory.add(sizeof(*this)); }

private:
    TimelineSettings m_settings;
};

} // namespace

Expected<void> edit::setTimeline(Document& document, const TimelineSettings& settings, GestureId gesture)
{
    if (auto fine = checkTimeline(settings); !fine)
        return fine;
    if (!(settings == document.scene().timeline()))
        document.push(std::make_unique<TimelineCommand>(document, settings, gesture));
    return {};
}

} // namespace ramure
