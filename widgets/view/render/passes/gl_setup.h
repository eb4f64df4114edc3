/// \file
/// OpenGL before and around the application object.
#pragma once

#include <QByteArray>
#include <QString>
#include <QSurfaceFormat>
#include <memory>

class QOpenGLContext;
class QOpenGLDebugLogger;

namespace ramure {

/// The format of every OpenGL context here: the default format, and 3.3 core. With RAMURE_GL_DEBUG in the
/// environment the driver also reports errors and deprecated calls, which become warnings.
QSurfaceFormat openGlFormat();

/// Shared contexts and the default surface format (3.3 core, 24-bit depth, 4 samples). Call in main() before
/// the application object is made.
void prepareOpenGl();

/// The OpenGL with which this process can open a window.
struct OpenGlProbe
{
    bool available = false; ///< a 3.3 core context
    bool software = false;  ///< drawn by the processor (llvmpipe ...)
    QString renderer;       ///< the driver's name for itself
    QString reason;         ///< why it is not available, translated (context "render")
};
/// Makes a context and throws it away. Needs an application object.
OpenGlProbe probeOpenGl();
/// The probe's answer and reason alone.
bool openGlAvailable(QString* reason = nullptr);

/// Does this name of a renderer stand for a software rasteriser?
bool isSoftwareRenderer(const QByteArray& renderer);

/// If the context was asked to report (see openGlFormat), the driver's messages become warnings.
std::unique_ptr<QOpenGLDebugLogger> driverMessages(const QOpenGLContext& context);

} // namespace ramure
