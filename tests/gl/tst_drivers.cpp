#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/passes/renderer.h"
#include <QGuiApplication>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QProcess>
#include <QTemporaryDir>

namespace tst_drivers {

using namespace ramure;

/// Stand-ins for the graphics cards that are not at hand: run once as it is, and once each for another way to
/// the driver and another driver (tests/CMakeLists.txt). The pictures must be the same.
class TestDrivers : public QObject
{
    Q_OBJECT

    static QImage picture(const QString& preset, const QProcessEnvironment& environment)
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("picture.png"));
        QProcess program;
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::ForwardedChannels);
        program.start(QStringLiteral(RAMURE_CLI),
                      {QStringLiteral("render"), QStringLiteral("preset:") + preset, QStringLiteral("-o"),
                       file, QStringLiteral("--size"), QStringLiteral("240x180")});
        program.waitForFinished(120'000);
        return QImage(file).convertToFormat(QImage::Format_RGB32);
    }

private slots:
    void initTestCase()
    {
        if (const OpenGlProbe probe = probeOpenGl(); !probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
    }
    void init() { test::failOnAnyWarning(); }

    void theDriversComplaintsAreWarnings()
    {
        qputenv("RAMURE_GL_DEBUG", "1");
        QOpenGLContext context;
        context.setFormat(openGlFormat());
        QVERIFY(context.create());
        QOffscreenSurface surface;
        surface.setFormat(context.format());
        surface.create();
        QVERIFY(context.makeCurrent(&surface));
        const auto renderer = Renderer::make();
        QVERIFY2(renderer, test::why(renderer));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("^OpenGL: GL_INVALID_ENUM")));
        context.functions()->glEnable(GL_POINT); // no capability
        // Refused in a core profile that looks forward.
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("^OpenGL: GL_INVALID_VALUE")));
        context.functions()->glLineWidth(3.0f);
    }
    void theOneAskedForDraws()
    {
        const QString driver = qEnvironmentVariable("GALLIUM_DRIVER");
        QVERIFY2(probeOpenGl().renderer.contains(driver), qPrintable(driver));
        QOpenGLContext context;
        QVERIFY(context.create());
        QCOMPARE(context.nativeInterface<QNativeInterface::QEGLContext>() != nullptr,
                 qEnvironmentVariable("QT_XCB_GL_INTEGRATION") == QLatin1String("xcb_egl"));
    }
    void picturesAreTheSame_data()
    {
        QTest::addColumn<QString>("preset");
        for (const char* preset : {"TinyTree", "Fern2D"})
            QTest::newRow(preset) << QString::fromLatin1(preset);
    }
    void picturesAreTheSame()
    {
        QFETCH(const QString, preset);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        const QImage here = picture(preset, environment);
        for (const char* name : {"GALLIUM_DRIVER", "QT_XCB_GL_INTEGRATION"})
            environment.remove(QLatin1String(name));
        const QImage usual = picture(preset, environment);
        QCOMPARE(here.size(), QSize(240, 180));
        QCOMPARE(usual.size(), here.size());
        double apart = 0.0;
        for (int y = 0; y < here.height(); ++y) {
            for (int x = 0; x < here.width(); ++x) {
                const QColor a = here.pixelColor(x, y), b = usual.pixelColor(x, y);
                apart += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                         std::abs(a.blue() - b.blue());
            }
        }
        apart /= 3.0 * 255.0 * here.width() * here.height();
        QVERIFY2(apart <= 0.03, qPrintable(QString::number(apart)));
    }
};

RAMURE_SUITE(TestDrivers)

} // namespace tst_drivers

#include "tst_drivers.moc"
