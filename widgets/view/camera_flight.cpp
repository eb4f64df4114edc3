#include "widgets/view/camera_flight.h"

namespace ramure {
namespace {

constexpr int flightMs = 180;

} // namespace

CameraFlight::CameraFlight(QObject* parent)
    : QObject(parent)
{
    m_animation.setDuration(flightMs);
    m_animation.setStartValue(0.0);
    m_animation.setEndValue(1.0);
    m_animation.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_animation, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
        m_camera = mixed(m_from, m_to, value.toDouble());
        emit moved();
    });
}

void CameraFlight::setCamera(const Camera& camera)
{
    m_animation.stop();
    m_camera = camera;
    emit moved();
}

void CameraFlight::flyTo(const Camera& camera)
{
    m_animation.stop();
    m_from = m_camera;
    m_to = camera;
    m_animation.start();
}

void CameraFlight::setOrthographic(bool on)
{
    m_to.orthographic = on;
    if (m_camera.orthographic == on)
        return;
    m_camera.orthographic = on;
    emit moved();
}

} // namespace ramure
