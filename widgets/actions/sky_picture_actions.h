/// \file
/// An artist's own sky behind the trees: reads its picture in the background.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/light/picture_sky.h"
#include <QObject>

namespace ramure {

class ActionSet;
class Chooser;
class Preferences;
class ViewportHost;

class SkyPictureActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    SkyPictureActions(ViewportHost* host, Preferences* preferences, Chooser* chooser, ActionSet* set,
                      QObject* parent);

    /// Asks for a file. Where it cannot be read, the sky stays as it is.
    void choose();
    /// The job that reads a picture, for its progress and for cancelling it.
    [[nodiscard]] Job* job() { return &m_job; }

signals:
    /// Says where the sun of a new sky stands, or why there is none.
    void messageRaised(const QString& text);

private:
    void take(const Expected<std::shared_ptr<const PictureSky>>& read);

    ViewportHost* m_host;
    Preferences* m_preferences;
    Chooser* m_chooser;
    Job m_job;
};

} // namespace ramure
