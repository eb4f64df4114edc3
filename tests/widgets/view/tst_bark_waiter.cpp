// The picture of bark needs texture coordinates, which take their time: nobody waits for them.
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include "widgets/view/bark_waiter.h"

#include <QSignalSpy>

namespace tst_bark_waiter {

using namespace ramure;

namespace {

/// One tree with bark as the view would have it drawn. \param alpha another one gives another mesh.
SceneWish wishOf(double alpha, BarkFamily family = BarkFamily::Furrowed)
{
    Node node;
    node.id = 1;
    node.kind = NodeKind::Tree;
    node.params = *presetParams("TinyTree");
    node.params.turtle.alpha = alpha;
    node.params.bark.family = family;
    SceneWish wish;
    wish.results.emplace(1, *TreePipeline().evaluate(node.params));
    wish.scene = *Scene::fromNodes({node});
    wish.view.waitsForBark = false;
    return wish;
}

bool showsBark(const SceneWish& wish)
{
    const RenderScene scene = SceneBuilder().build(
        wish.scene, [&wish](NodeId id) { return &wish.results.at(id); }, wish.view);
    return std::ranges::any_of(scene.meshes, [](const MeshItem& item) { return item.bark != nullptr; });
}

} // namespace

class TestBarkWaiter : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingToWaitFor()
    {
        BarkWaiter waiter;
        QSignalSpy ready(&waiter, &BarkWaiter::ready);
        waiter.follow({});
        waiter.follow(wishOf(0.2, BarkFamily::Plain));
        SceneWish draft = wishOf(0.2);
        draft.results.at(1).texture.reset();
        waiter.follow(draft);
        QVERIFY(!showsBark(draft));
        waiter.wait();
        QVERIFY(!waiter.isBusy());
        QCOMPARE(ready.count(), 0);
    }

    void barkComesWhenItIsReady()
    {
        BarkWaiter waiter;
        QSignalSpy ready(&waiter, &BarkWaiter::ready), busy(waiter.job(), &Job::runningChanged);
        SceneWish wish = wishOf(0.2);
        QVERIFY(!showsBark(wish));
        waiter.follow(wish);
        QVERIFY(waiter.isBusy());
        QCOMPARE(busy.count(), 1);
        QTRY_COMPARE(ready.count(), 1);
        QVERIFY(!waiter.isBusy());
        QCOMPARE(busy.count(), 2);
        QCOMPARE(busy.back().front().toBool(), false);
        QVERIFY(showsBark(wish));
        waiter.follow(wish);
        QVERIFY(!waiter.isBusy()); // it is there
        // Pictures that must be whole wait for it themselves.
        SceneWish other = wishOf(0.21);
        other.view.waitsForBark = true;
        QVERIFY(showsBark(other));
    }

    void treesThatChangedAreGivenUp()
    {
        BarkWaiter waiter;
        SceneWish last;
        for (int i = 0; i < 5; ++i) {
            last = wishOf(0.2 + 0.01 * i);
            waiter.follow(last);
            waiter.follow(last); // as while the pointer moves
        }
        waiter.wait();
        QVERIFY(!waiter.isBusy());
        QVERIFY(showsBark(last)); // ready() is not told where the second wish already found its bark
        waiter.follow(wishOf(0.3));
        waiter.follow({}); // another document
        QVERIFY(!waiter.isBusy());
    }
};

RAMURE_SUITE(TestBarkWaiter)

} // namespace tst_bark_waiter

#include "tst_bark_waiter.moc"
