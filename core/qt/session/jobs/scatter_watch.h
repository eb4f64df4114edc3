/// \file
/// Tells why a scatter of the open document makes no copies, and how many it makes otherwise.
#pragma once

#include "core/qt/document/document.h"
#include "core/qt/session/jobs/job.h"
#include "core/scatter/scatter.h"
#include <map>

namespace ramure {

/// Works out the places of scatters in the background when they, or what they follow from, have changed. An
/// error becomes the problem of the scatter (Document::problem), at the parameter that is to blame.
class ScatterWatch : public QObject
{
    Q_OBJECT
public:
    /// \param document must outlive this object.
    explicit ScatterWatch(Document* document, QObject* parent = nullptr);

    /// The number of copies; nothing where it is not known yet or there is an error.
    [[nodiscard]] std::optional<std::size_t> count(NodeId scatter) const;
    /// Until all is known. False on time-out.
    bool wait(std::chrono::milliseconds most) { return m_job.wait(most); }

signals:
    void counted(ramure::NodeId scatter);

private:
    struct Known
    {
        std::uint64_t hash = 0;
        std::optional<std::size_t> count;
    };
    using Found = std::vector<std::pair<NodeId, Expected<SharedPlaces>>>;

    void follow(const Change& change);
    void take(const Found& found, quint64 revision);

    Document* m_document;
    std::shared_ptr<ScatterMemory> m_memory = std::make_shared<ScatterMemory>();
    std::map<NodeId, Known> m_known;
    Job m_job;
};

} // namespace ramure
