#include "widgets/actions/sky_picture_actions.h"

#include "core/math/angle.h"
#include "core/qt/base/system_path.h"
#include "widgets/base/action_set.h"
#include "widgets/base/chooser.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/render/passes/picture_light.h"
#include "widgets/view/view_settings.h"
#include "widgets/view/viewport_host.h"
#include <QFileInfo>
#include <cmath>

namespace ramure {

SkyPictureActions::SkyPictureActions(ViewportHost* host, Preferences* preferences, Chooser* chooser,
                                     ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_host(host)
    , m_preferences(preferences)
    , m_chooser(chooser)
{
    set->add(this, {"view.skyPicture",
                    Actions::tr("S&ky picture…"),
                    nullptr,
                    {},
                    Actions::tr("An own picture all around (HDR or EXR) as background, sun and light"),
                    [this] { choose(); },
                    [host] { return host->viewport() != nullptr; }});
}

void SkyPictureActions::choose()
{
    const QString path = m_chooser->openFile(tr("Sky picture"), m_preferences->lastFolder(),
                                             tr("Pictures of light (*.hdr *.exr);;All files (*)"));
    if (path.isEmpty())
        return;
    m_preferences->setLastFolder(QFileInfo(path).absolutePath());
    m_job.start(
        [file = systemPath(path)](const Progress& progress) { return readPictureSky(file, progress); },
        [this](Expected<std::shared_ptr<const PictureSky>>&& read) { take(read); });
}

void SkyPictureActions::take(const Expected<std::shared_ptr<const PictureSky>>& read)
{
    if (!read && read.error().code == ErrorCode::Cancelled)
        return emit messageRaised(tr("The sky stays as it was"));
    if (!read)
        return m_chooser->report(Severity::Error, errorTextWithPlace(read.error()));
    SceneLight light = m_host->settings()->light();
    light.picture = *read;
    light.backdrop = Backdrop::Picture;
    m_host->settings()->light.set(light);
    if ((*read)->sunlight == glm::dvec3(0.0))
        return emit messageRaised(tr("The picture has no sun: the light is soft and casts no shadow"));
    const glm::dvec3 sun = lightOf(light).sun;
    const double around = std::fmod(std::atan2(sun.x, -sun.z) / oneDegree + 360.0, 360.0);
    emit messageRaised(tr("The picture's sun stands at %1°, %2° high")
                           .arg(around, 0, 'f', 0)
                           .arg(std::asin(sun.y) / oneDegree, 0, 'f', 0));
}

} // namespace ramure
