/// \file
/// Has the texture coordinates made that the bark of the trees in view needs. They take seconds for a large
/// tree; the scene is drawn without them meanwhile.
#pragma once

#include "widgets/view/background_builder.h"

namespace ramure {

class BarkWaiter : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Trees that are not in the wish any more are given up.
    void follow(const SceneWish& wish);
    [[nodiscard]] const Job* job() const { return &m_job; }
    [[nodiscard]] bool isBusy() const { return m_job.isRunning(); }
    /// Until all are made.
    void wait() { m_job.wait(); }

signals:
    /// All that was wanted is there: another scene would show it.
    void ready();

private:
    struct Wanted
    {
        std::shared_ptr<const TextureStage> stage;
        NodeParams params;
    };

    std::vector<Wanted> m_wanted; ///< also those that could not be made
    Job m_job;
};

} // namespace ramure
