#include "widgets/view/render/passes/gl_setup.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLDebugLogger>
#include <QOpenGLFunctions>

namespace ramure {

QSurfaceFormat openGlFormat()
{
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setOption(QSurfaceFormat::DebugContext, qEnvironmentVariableIsSet("RAMURE_GL_DEBUG"));
    return format;
}

void prepareOpenGl()
{
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat format = openGlFormat();
    format.setDepthBufferSize(24);
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
}

bool isSoftwareRenderer(const QByteArray& renderer)
{
    const QByteArray name = renderer.toLower();
    return name.contains("llvmpipe") || name.contains("softpipe") || name.contains("swrast") ||
           name.contains("software");
}

OpenGlProbe probeOpenGl()
{
    OpenGlProbe probe;
    const auto refuse = [&probe](const char* text) {
        probe.reason = QCoreApplication::translate("render", text);
        return probe;
    };
    const QString platform = QGuiApplication::platformName();
    // These platforms crash when a window merely contains an OpenGL widget.
    for (const char* without : {"offscreen", "minimal", "minimalegl", "linuxfb", "vnc"}) {
        if (platform == QLatin1String(without))
            return refuse(QT_TRANSLATE_NOOP("render", "This display cannot show OpenGL."));
    }
    QOpenGLContext context;
    context.setFormat(openGlFormat());
    if (!context.create())
        return refuse(QT_TRANSLATE_NOOP("render", "The graphics driver gives no OpenGL."));
    if (context.isOpenGLES() || context.format().version() < std::pair(3, 3))
        return refuse(QT_TRANSLATE_NOOP("render", "The graphics driver's OpenGL is older than 3.3."));
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return refuse(QT_TRANSLATE_NOOP("render", "The graphics driver gives no OpenGL."));
    const QByteArray renderer(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
    context.doneCurrent();
    probe.available = true;
    probe.software = isSoftwareRenderer(renderer);
    probe.renderer = QString::fromLatin1(renderer);
    return probe;
}

bool openGlAvailable(QString* reason)
{
    const OpenGlProbe probe = probeOpenGl();
    if (reason)
        *reason = probe.reason;
    return probe.available;
}

std::unique_ptr<QOpenGLDebugLogger> driverMessages(const QOpenGLContext& context)
{
    if (!context.format().testOption(QSurfaceFormat::DebugContext))
        return nullptr;
    auto logger = std::make_unique<QOpenGLDebugLogger>();
    QObject::connect(logger.get(), &QOpenGLDebugLogger::messageLogged,
                     [](const QOpenGLDebugMessage& message) {
                         using M = QOpenGLDebugMessage;
                         if (M::Types(M::ErrorType | M::DeprecatedBehaviorType | M::UndefinedBehaviorType |
                                      M::PortabilityType)
                                 .testFlag(message.type()))
                             qWarning("OpenGL: %s", qPrintable(message.message()));
                     });
    if (logger->initialize())
        logger->startLogging(QOpenGLDebugLogger::SynchronousLogging);
    return logger;
}

} // namespace ramure
