/// \file
/// Has the forms made in which the prototypes of scatters are seen. They take some tenths of a second for a
/// tree; the scene is drawn with eggs, or with the forms that a tree had before it changed, meanwhile.
#pragma once

#include "widgets/view/background_builder.h"

namespace ramure {

class CrowdWaiter : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Gives the wish what is known of its prototypes, and has the rest made. Prototypes that are not in the
    /// wish any more are forgotten.
    void follow(SceneWish& wish);
    [[nodiscard]] bool isBusy() const { return m_job.isRunning(); }
    /// Until all are made.
    void wait() { m_job.wait(); }

signals:
    /// All that was wanted is there: another scene would show it.
    void ready();

private:
    /// What forms are made of.
    struct Source
    {
        TreeResult tree;
        NodeParams params;
        [[nodiscard]] bool isLike(const Source& other) const;
    };
    struct Known
    {
        Source of;
        std::shared_ptr<const CrowdForms> forms; ///< null: they cannot be made
    };
    using Made = std::map<NodeId, std::shared_ptr<const CrowdForms>>;
    void keep(const std::map<NodeId, Source>& wanted, Made&& made);

    std::map<NodeId, Known> m_known;
    std::map<NodeId, Source> m_wanted;
    Job m_job;
};

} // namespace ramure
