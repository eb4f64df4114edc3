/// \file
/// The camera of a view, and its way to another one: at once, or in a short flight.
#pragma once

#include "widgets/view/render/camera.h"
#include <QVariantAnimation>

namespace ramure {

class CameraFlight : public QObject
{
    Q_OBJECT
public:
    explicit CameraFlight(QObject* parent = nullptr);

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Returns the camera at the end of the flight, or the present one if it stands.
    [[nodiscard]] const Camera& goal() const { return isFlying() ? m_to : m_camera; }
    [[nodiscard]] bool isFlying() const { return m_animation.state() == QAbstractAnimation::Running; }
    void setCamera(const Camera& camera); ///< at once; a flight ends
    void flyTo(const Camera& camera);
    void stop() { m_animation.stop(); } ///< stops at the present camera
    void setOrthographic(bool on);      ///< a flight goes on

signals:
    void moved();

private:
    Camera m_camera, m_from, m_to;
    QVariantAnimation m_animation;
};

} // namespace ramure
