#include "core/qt/document/document.h"
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport_host.h"
#include <QFile>
#include <QLabel>
#include <QMainWindow>
#include <QSignalSpy>
#include <QStackedWidget>

namespace tst_viewport_host {

using namespace ramure;

class TestViewportHost : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void withoutOpenGlThereIsAMessage()
    {
        if (QGuiApplication::platformName() != QLatin1String("offscreen"))
            RAMURE_CANNOT_RUN("the offscreen platform is the one without OpenGL windows");
        QString reason;
        QVERIFY(!openGlAvailable(&reason));
        QVERIFY(!reason.isEmpty());
        Document document;
        QMainWindow window;
        auto* stack = new QStackedWidget(&window);
        auto* host = new ViewportHost(&document, stack);
        stack->addWidget(host);
        window.setCentralWidget(stack);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(!host->viewport());
        QVERIFY(host->settings());
        const auto* label = host->findChild<QLabel*>(QStringLiteral("viewportPlaceholder"));
        QVERIFY(label && label->isVisible() && label->text().contains(reason));
    }
    void softwareRenderersAreKnown()
    {
        QVERIFY(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
        QVERIFY(isSoftwareRenderer("softpipe"));
        QVERIFY(!isSoftwareRenderer("Mesa Intel(R) UHD Graphics 620"));
        QVERIFY(!isSoftwareRenderer({}));
    }
    void settingsTellOnce()
    {
        ViewSettings settings;
        QSignalSpy changed(&settings, &ViewSettings::changed);
        int modes = 0;
        settings.displayMode.follow(&settings, [&modes] { ++modes; });
        settings.displayMode.set(settings.displayMode());
        QCOMPARE(changed.count(), 0);
        settings.displayMode.set(DisplayMode::Sections);
        QCOMPARE(modes, 1);
        QCOMPARE(settings.displayMode(), DisplayMode::Sections);
        settings.shadingMode.set(ShadingMode::Wire);
        settings.frameDisplay.set(FrameDisplay::All);
        settings.navigationStyle.set(NavigationStyle::Maya);
        settings.leavesVisible.set(false);
        settings.applesVisible.set(false);
        settings.gridVisible.set(false);
        settings.orthographic.set(true);
        QCOMPARE(changed.count(), 8);
        QCOMPARE(modes, 1);
    }
    void displayModesHaveNames()
    {
        for (const DisplayModeRow& row : displayModes()) {
            QCOMPARE(displayModeFromName(row.name()), row.mode);
            QVERIFY2(
                QFile::exists(
                    QStringLiteral(RAMURE_SOURCE_DIR "/resources/icons/%1.svg").arg(QLatin1String(row.icon))),
                row.name());
        }
        QVERIFY(!displayModeFromName("Mesh"));
        QVERIFY(!displayModeFromName(""));
    }
};

RAMURE_SUITE(TestViewportHost)

} // namespace tst_viewport_host

#include "tst_viewport_host.moc"
