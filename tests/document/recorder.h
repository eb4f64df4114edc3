/// \file
/// Writes down the news of a document and checks that they come in pairs.
#pragma once

#include "core/qt/document/document.h"

#include <vector>

namespace ramure::test {

class Recorder : public QObject
{
public:
    explicit Recorder(const Document& document)
    {
        connect(&document, &Document::aboutToBeChanged, this, [this](const Change& change) {
            m_paired = m_paired && !m_open;
            m_open = true;
            m_announced = change;
        });
        connect(&document, &Document::changed, this, [this](const Change& change) {
            m_paired = m_paired && m_open && change.kinds == m_announced.kinds &&
                       change.nodes == m_announced.nodes && change.params == m_announced.params &&
                       change.firstStale == m_announced.firstStale && change.revision == m_announced.revision;
            m_open = false;
            changes.push_back(change);
        });
    }
    /// Every announcement was followed by its news, before the next one.
    [[nodiscard]] bool paired() const { return m_paired && !m_open; }
    /// The only news since the last call; without kinds where there were none or several.
    Change take()
    {
        const Change only = changes.size() == 1 ? changes.front() : Change{};
        changes.clear();
        return only;
    }
    /// News of edits and selection, without those of the file's state.
    Change takeEdit()
    {
        std::erase_if(changes, [](const Change& change) { return change.kinds == changeFile; });
        return take();
    }

    std::vector<Change> changes;

private:
    bool m_paired = true;
    bool m_open = false;
    Change m_announced;
};

} // namespace ramure::test
