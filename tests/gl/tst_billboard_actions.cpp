// Billboards from the window.
#include "core/io/mesh_file.h"
#include "core/scene/preset_scene.h"
#include "tests/support/cannot_run.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/billboard_actions.h"
#include "widgets/base/action_set.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/billboard_dialog.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/viewport_host.h"
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QImage>
#include <QJsonDocument>
#include <QProcess>
#include <QSignalSpy>
#include <QSpinBox>
#include <functional>
#include <memory>

namespace tst_billboard_actions {

using namespace ramure;

namespace {

constexpr int patienceMs = test::patience(60'000);

/// The actions on a document, without their window.
struct Bench
{
    Preferences preferences;
    Document document;
    test::FakeChooser chooser;
    ActionSet set;
    ViewportHost host{&document};
    BillboardActions billboards{&document, &host, &preferences, &chooser, &set, nullptr};
    QSignalSpy messages{&billboards, &BillboardActions::messageRaised};
    QSignalSpy exported{&billboards, &BillboardActions::exported};
    QTemporaryDir folder;

    /// Small pictures, and what \p change makes of that; then until the end of the work.
    void save(const QVariantMap& change = {})
    {
        start(change);
        QTRY_VERIFY_WITH_TIMEOUT(!billboards.job()->isRunning(), patienceMs);
    }
    void start(QVariantMap change)
    {
        if (!change.contains("size"))
            change.insert("size", 256);
        preferences.setExportSettings({{"billboard", change}});
        set.find("file.billboard")->trigger();
        auto* asked = dialog();
        QVERIFY(asked);
        asked->accept();
        QTRY_VERIFY(!dialog());
    }
    [[nodiscard]] BillboardDialog* dialog() const { return host.window()->findChild<BillboardDialog*>(); }
    [[nodiscard]] QString path(const char* name) const { return folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QStringList files() const
    {
        return QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
    }
};

QByteArray bytes(const QString& file)
{
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

} // namespace

class TestBillboardActions : public QObject
{
    Q_OBJECT
private:
    test::OwnSettings m_settings;
    std::unique_ptr<Bench> m_bench;

private slots:
    void initTestCase()
    {
        if (!openGlAvailable(nullptr))
            RAMURE_CANNOT_RUN("no OpenGL here");
    }
    void init()
    {
        test::failOnWidgetWarning();
        m_bench = std::make_unique<Bench>();
        m_bench->document.reset(*presetScene("TinyTree"), {});
    }
    void cleanup() { m_bench.reset(); }

    void placesThatCannotBeWrittenAreNamed()
    {
        Bench& bench = *m_bench;
        bench.save(); // and no file is chosen
        QCOMPARE(bench.chooser.saves, 1);
        bench.save({{"folder", true}}); // nor a folder
        QVERIFY(bench.chooser.reports.isEmpty() && bench.messages.isEmpty());
        QVERIFY(
            QDir(bench.folder.path()).mkpath("there/cards_colour.png")); // a folder where a file should be
        const auto isRefused = [&bench](const QVariantMap& wish, const char* named) {
            bench.chooser.reports.clear();
            bench.save(wish);
            const QString told = bench.chooser.reports.value(0);
            QVERIFY2(bench.chooser.reports.size() == 1 && told.contains(QLatin1String(named)),
                     qPrintable(told));
        };
        bench.chooser.answer = bench.path("tree.obj");
        isRefused({}, "tree.obj");
        bench.chooser.answer = bench.path("none/tree.glb");
        isRefused({}, "tree.glb");
        bench.chooser.folderAnswer = bench.path("gone");
        isRefused({{"atlas", true}, {"views", 2}}, "atlas_colour.png");
        bench.chooser.folderAnswer = bench.path("there");
        isRefused({{"folder", true}}, "cards_colour.png");
        QVERIFY(bench.exported.isEmpty());
    }
    void theActionSaysWhyItIsOff()
    {
        Bench& bench = *m_bench;
        const QAction* action = bench.set.find(QStringLiteral("file.billboard"));
        QCOMPARE(action, bench.set.find("file.billboard"));
        const QString usual = action->toolTip();
        QVERIFY(action->isEnabled());
        bench.document.reset({}, {});
        QVERIFY(!action->isEnabled());
        QVERIFY2(action->toolTip().contains("visible"), qPrintable(action->toolTip()));
        bench.document.reset(*presetScene("TinyTree"), {});
        QVERIFY(action->isEnabled());
        QCOMPARE(action->toolTip(), usual);
        QVERIFY(edit::setNodeVisible(bench.document, {1}, false));
        QVERIFY(!action->isEnabled());
        bench.document.undo();
        QVERIFY(action->isEnabled());
        bench.chooser.answer = bench.path("tree.glb");
        bench.start({});
        QVERIFY(!action->isEnabled()); // one at a time
        QVERIFY(action->toolTip() != usual);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.billboards.job()->isRunning(), patienceMs);
        QVERIFY(action->isEnabled());
        QCOMPARE(action->toolTip(), usual);
    }
    void cancelledNothingStays()
    {
        Bench& bench = *m_bench;
        bench.chooser.answer = bench.path("tree.glb");
        bench.chooser.folderAnswer = bench.folder.path();
        int ends = 0;
        for (const QVariantMap& wish :
             {QVariantMap{{"size", 2048}}, QVariantMap{{"atlas", true}, {"size", 2048}}}) {
            bench.start(wish);
            bench.billboards.job()->cancel();
            QTRY_VERIFY_WITH_TIMEOUT(!bench.billboards.job()->isRunning(), patienceMs);
            QCOMPARE(bench.files(), QStringList());
            QCOMPARE(bench.messages.count(), ++ends);
        }
        // Within the drawing, too.
        QSignalSpy progress(bench.billboards.job(), &Job::progress);
        bench.start({{"atlas", true}, {"size", 2048}, {"views", 16}});
        QVERIFY(QTest::qWaitFor(
            [&] { return !progress.isEmpty() && progress.constLast()[0].toDouble() > 0.1; }, patienceMs));
        bench.billboards.job()->cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.billboards.job()->isRunning(), patienceMs);
        QCOMPARE(bench.files(), QStringList());
        QCOMPARE(bench.messages.count(), ends + 1);
        QVERIFY(bench.exported.isEmpty() && bench.chooser.reports.isEmpty());
    }

    void cardsAreThoseOfTheCommandLine()
    {
        Bench& bench = *m_bench;
        bench.chooser.answer = bench.path("tree.glb");
        bench.save({{"cards", 3}, {"lying", true}});
        QVERIFY2(bench.chooser.reports.isEmpty(), qPrintable(bench.chooser.reports.value(0)));
        QCOMPARE(bench.exported.count(), 1);
        QCOMPARE(bench.exported[0][0].toString(), bench.chooser.answer);
        QCOMPARE(bench.preferences.lastFolder(), bench.folder.path());
        const auto mesh = readMeshFile(bench.chooser.answer.toStdString());
        QVERIFY2(mesh, test::why(mesh).constData());
        QCOMPARE(int(mesh->joined().faceCount()), 8);
        QProcess cli;
        cli.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        cli.start(QStringLiteral(RAMURE_CLI), {"billboard", "preset:TinyTree", "--size", "256", "--cards",
                                               "3", "--lying", "-o", bench.path("cli.glb")});
        QVERIFY(cli.waitForFinished(patienceMs));
        QCOMPARE(cli.exitCode(), 0);
        const QByteArray one = bytes(bench.chooser.answer);
        QVERIFY(one.startsWith("glTF"));
        QVERIFY(one == bytes(bench.path("cli.glb")));

        bench.chooser.folderAnswer = bench.path("cards");
        QVERIFY(QDir().mkpath(bench.chooser.folderAnswer));
        bench.save({{"cards", 3}, {"lying", true}, {"folder", true}});
        QVERIFY(one == bytes(bench.path("cards/cards.glb")));
        QCOMPARE(QImage(bench.path("cards/cards_colour.png")).size(), QSize(256, 256));
        QCOMPARE(QImage(bench.path("cards/cards_normal.png")).size(), QSize(256, 256));
        QCOMPARE(bench.exported[1][0].toString(), bench.path("cards/"));
    }
    void anAtlasIsThreeFilesWhichAreReplacedOnAgreementOnly()
    {
        Bench& bench = *m_bench;
        bench.chooser.folderAnswer = bench.folder.path();
        bench.save({{"atlas", true}, {"views", 4}});
        QVERIFY(bench.chooser.reasons.isEmpty()); // there was nothing to ask
        QCOMPARE(bench.files(), (QStringList{"atlas.json", "atlas_colour.png", "atlas_normal.png"}));
        QCOMPARE(bench.exported.count(), 1);
        QCOMPARE(bench.exported[0][0].toString(), bench.path("") + '/');
        QCOMPARE(QImage(bench.path("atlas_colour.png")).size(), QSize(256, 256));
        QCOMPARE(QImage(bench.path("atlas_normal.png")).size(), QSize(256, 256));
        const auto views = [&bench] {
            return QJsonDocument::fromJson(bytes(bench.path("atlas.json"))).object().value("views").toInt();
        };
        QCOMPARE(views(), 4);
        bench.chooser.agreed = false;
        bench.save({{"atlas", true}, {"views", 2}});
        QCOMPARE(bench.chooser.reasons.size(), 1);
        QVERIFY(bench.chooser.reasons[0].contains("atlas_normal.png"));
        QCOMPARE(views(), 4);
        bench.chooser.agreed = true;
        bench.save({{"atlas", true}, {"views", 2}});
        QCOMPARE(views(), 2);
        QCOMPARE(bench.exported.count(), 2);
    }
    void whatIsSelectedIsDrawnAlone()
    {
        Bench& bench = *m_bench;
        Node small = test::treeNode(2, "Small");
        small.params.tree.translation = {20.0, 0.0, 0.0};
        test::openNodes(bench.document, {bench.document.scene().nodes().front(), small});
        const auto width = [&bench](const char* name, bool selectionOnly) {
            bench.chooser.answer = bench.path(name);
            bench.save({{"selection", selectionOnly}});
            const auto mesh = readMeshFile(bench.chooser.answer.toStdString());
            if (!mesh)
                return 0.0;
            Box box;
            for (const auto& position : mesh->joined().positions)
                box.add(position);
            return box.size().x;
        };
        QVERIFY(width("all.glb", false) > 20.0);
        const double alone = width("alone.glb", true);
        QVERIFY(alone > 0.0 && alone < 10.0);
        bench.document.setSelection({});
        QVERIFY(width("none.glb", true) > 20.0); // there is nothing selected
        QVERIFY(bench.document.scene().isShown(2));
    }
    void theDialogIsAsTheLastTime()
    {
        Bench& bench = *m_bench;
        bench.set.find("file.billboard")->trigger();
        bench.dialog()->findChild<QSpinBox*>(QStringLiteral("billboardCards"))->setValue(7);
        bench.dialog()->findChild<QCheckBox*>(QStringLiteral("billboardLying"))->setChecked(true);
        bench.dialog()->accept();
        QTRY_VERIFY(!bench.dialog());
        bench.set.find("file.billboard")->trigger();
        QCOMPARE(bench.dialog()->wish().cards, 7);
        QVERIFY(bench.dialog()->wish().lying);
        bench.dialog()->findChild<QSpinBox*>(QStringLiteral("billboardCards"))->setValue(9);
        bench.dialog()->reject();
        QTRY_VERIFY(!bench.dialog());
        QCOMPARE(bench.chooser.saves, 1);
        QCOMPARE(bench.preferences.exportSettings().value("billboard").toMap().value("cards").toInt(), 7);
    }
};

RAMURE_SUITE(TestBillboardActions)

} // namespace tst_billboard_actions

#include "tst_billboard_actions.moc"
