#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include "tests/support/waits.h"
#include "widgets/view/background_builder.h"
#include <QSignalSpy>
#include <QThread>

namespace tst_background_builder {

using namespace ramure;

namespace {

SceneWish wish(quint64 serial, DisplayMode mode = DisplayMode::Mesh)
{
    static const TreeResult tree = *TreePipeline().evaluate(*presetParams("TinyTree"));
    SceneWish wished;
    Node node;
    node.id = wished.scene.newId();
    node.kind = NodeKind::Tree;
    node.params = *presetParams("TinyTree");
    (void)wished.scene.insert({node}, noNode, 0);
    wished.results.emplace(node.id, tree);
    wished.view.mode = mode;
    wished.serial = serial;
    wished.revision = 7;
    return wished;
}

/// Something that knows on which thread it ended.
struct Witness
{
    explicit Witness(std::atomic<QThread*>& where)
        : m_where(where)
    {
    }
    ~Witness() { m_where = QThread::currentThread(); }
    std::atomic<QThread*>& m_where;
};

} // namespace

class TestBackgroundBuilder : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingWasWished()
    {
        BackgroundBuilder builder;
        QVERIFY(!builder.isBusy());
        QVERIFY(!builder.take());
        QVERIFY(!builder.finish());
        builder.dispose(nullptr);
    }
    void scenesWithoutTrees()
    {
        BackgroundBuilder builder;
        builder.wish({});
        const auto built = builder.finish();
        QVERIFY(built && built->scene->box.empty());
    }
    void wishesAreBuiltAndTakenOnce()
    {
        BackgroundBuilder builder;
        QSignalSpy news(&builder, &BackgroundBuilder::built);
        builder.wish(wish(1));
        QVERIFY(builder.isBusy());
        QTRY_COMPARE(news.count(), 1);
        QVERIFY(builder.isBusy()); // not taken
        const auto built = builder.take();
        QVERIFY(built && !built->scene->meshes.empty());
        QCOMPARE(built->serial, quint64(1));
        QCOMPARE(built->revision, quint64(7));
        QVERIFY(!builder.take());
        QVERIFY(!builder.isBusy());
    }
    void theNewestWishWins()
    {
        BackgroundBuilder builder;
        for (quint64 serial = 1; serial <= 50; ++serial)
            builder.wish(wish(serial, serial == 50 ? DisplayMode::Skeleton : DisplayMode::Rough));
        const auto built = builder.finish();
        QVERIFY(built);
        QCOMPARE(built->serial, quint64(50));
        QVERIFY(built->scene->meshes.empty() && !built->scene->lines.empty());
        QVERIFY(!builder.isBusy());
    }
    void everyBegunSceneIsFinished()
    {
        BackgroundBuilder builder;
        quint64 last = 0;
        int taken = 0;
        connect(&builder, &BackgroundBuilder::built, &builder, [&] {
            if (const auto built = builder.take()) {
                QVERIFY(built->serial > last); // nothing goes back
                last = built->serial;
                ++taken;
            }
        });
        for (quint64 serial = 1; serial <= 200; ++serial) {
            builder.wish(wish(serial, DisplayMode::Sections));
            const int before = taken;
            if (serial % 10 == 0)
                QTRY_VERIFY(taken > before);
        }
        QTRY_COMPARE(last, quint64(200));
        QVERIFY(taken > 1); // pictures while wishes come
    }
    void unchangedBlocksAreMadeOnce()
    {
        BackgroundBuilder builder;
        builder.wish(wish(1, DisplayMode::Sections));
        const auto first = builder.finish();
        builder.wish(wish(2, DisplayMode::Sections));
        const auto second = builder.finish();
        QVERIFY(first->scene->lines.front().lines == second->scene->lines.front().lines);
    }
    void largeThingsEndOnTheThread()
    {
        std::atomic<QThread*> where = nullptr;
        BackgroundBuilder builder;
        builder.dispose(std::make_shared<Witness>(where));
        QTRY_VERIFY(where.load() != nullptr);
        QVERIFY(where.load() != QThread::currentThread());
    }
    void diesWhileBusy()
    {
        for (int i = 0; i < 20; ++i) {
            BackgroundBuilder builder;
            builder.wish(wish(1, DisplayMode::Sections));
            if (i % 2 == 0)
                test::anyMoment(1);
        }
    }
};

RAMURE_SUITE(TestBackgroundBuilder)

} // namespace tst_background_builder

#include "tst_background_builder.moc"
