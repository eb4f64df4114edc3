#include "widgets/render/gl_setup.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace ramure {

void prepareOpenGl()
{
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
}

bool openGlAvailable(QString* reason)
{
    const auto refuse = [reason](const char* text) {
        if (reason)
            *reason = QCoreApplication::translate("render", text);
        return false;
    };
    const QString platform = QGuiApplication::platformName();
    // These platforms crash when a window merely contains an OpenGL widget.
    if (platform == QLatin1String("offscreen") || platform == QLatin1String("minimal") ||
        platform == QLatin1String("minimalegl") || platform == QLatin1String("linuxfb") ||
        platform == QLatin1String("vnc"))
        return refuse(QT_TRANSLATE_NOOP("render", "This display cannot show OpenGL."));
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create())
        return refuse(QT_TRANSLATE_NOOP("render", "The graphics driver gives no OpenGL."));
    const auto version = context.format().version();
    if (context.isOpenGLES() || version < std::pair(3, 3))
        return refuse(QT_TRANSLATE_NOOP("render", "The graphics driver's OpenGL is older than 3.3."));
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return refuse(QT_TRANSLATE_NOOP("render", "The graphics driver gives no OpenGL."));
    context.doneCurrent();
    return true;
}

} // namespace ramure
