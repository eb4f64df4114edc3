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

/// What every context here asks for: the default format, and 3.3 core. With RAMURE_GL_DEBUG in the
/// environment the driver also tells of errors and deprecated calls: they become warnings.
QSurfaceFormat openGlFormat();

/// Shared contexts and the default surface format (3.3 core, 24-bit depth, 4 samples). Call in main() before
/// the application object is made.
void prepareOpenGl();

/// What OpenGL this process can open a window with.
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

/// Where the context was asked to tell (see openGlFormat), what the driver finds wrong becomes a warning.
std::unique_ptr<QOpenGLDebugLogger> driverMessages(const QOpenGLContext& context);

} // namespace ramure
