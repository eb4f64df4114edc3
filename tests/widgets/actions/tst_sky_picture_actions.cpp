#include "core/io/exr_file.h"
#include "core/qt/document/document.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/sky_picture_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/view/view_settings.h"
#include "widgets/view/viewport_host.h"
#include <QDir>
#include <QTemporaryDir>

namespace tst_sky_picture_actions {

using namespace ramure;

class TestSkyPictureActions : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;

private slots:
    void init() { test::failOnWidgetWarning(); }
    void aPictureIsChosenOrTheSkyStays()
    {
        Preferences preferences;
        Document document;
        test::FakeChooser chooser;
        ActionSet set;
        ViewportHost host(&document);
        SkyPictureActions skies(&host, &preferences, &chooser, &set, nullptr);
        QSignalSpy messages(&skies, &SkyPictureActions::messageRaised);
        skies.choose(); // and no file is chosen
        QCOMPARE(chooser.opens, 1);
        QVERIFY(!skies.job()->isRunning());
        QTemporaryDir folder;
        const auto choose = [&](const QString& path) {
            chooser.answer = path;
            skies.choose();
            QTRY_VERIFY_WITH_TIMEOUT(!skies.job()->isRunning(), test::patience(5'000));
        };
        choose(folder.filePath("missing.hdr"));
        QTRY_COMPARE(chooser.reports.size(), 1);
        QVERIFY(chooser.reports.front().contains("missing.hdr"));
        QCOMPARE(host.settings()->light(), SceneLight());

        std::vector<glm::vec4> pixels(64 * 32, glm::vec4(1.0f));
        const QString soft = folder.filePath("soft.exr");
        QVERIFY(writeExr(soft.toStdString(), 64, 32, pixels));
        choose(soft);
        QTRY_COMPARE(messages.size(), 1);
        QVERIFY(messages.back().front().toString().contains("no sun"));
        QCOMPARE(host.settings()->light().backdrop, Backdrop::Picture);
        QCOMPARE(host.settings()->light().picture->file, soft.toStdString());
        QCOMPARE(preferences.lastFolder(), QDir(folder.path()).absolutePath());

        pixels[10 * 64 + 32] = glm::vec4(6e4f); // in the east
        const QString sunny = folder.filePath("sunny.exr");
        QVERIFY(writeExr(sunny.toStdString(), 64, 32, pixels));
        choose(sunny);
        QTRY_COMPARE(messages.size(), 2);
        QVERIFY2(messages.back().front().toString().contains("93"),
                 qPrintable(messages.back().front().toString()));
        host.settings()->beginDocument();
        QVERIFY(!host.settings()->light().picture);
    }
};

RAMURE_SUITE(TestSkyPictureActions)

} // namespace tst_sky_picture_actions

#include "tst_sky_picture_actions.moc"
