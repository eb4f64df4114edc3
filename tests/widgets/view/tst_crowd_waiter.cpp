// The forms of a scatter's prototypes take their time: nobody waits for them.
#include "core/pipeline/tree_pipeline.h"
#include "core/presets/presets.h"
#include "tests/support/suite.h"
#include "widgets/view/crowd_waiter.h"
#include "widgets/view/render/pick/pick_scene.h"

#include <QSignalSpy>

namespace tst_crowd_waiter {

using namespace ramure;

namespace {

constexpr NodeId wood = 1, prototype = 2;

/// A scatter of some small trees as the view would have it drawn. \param grown its prototype has a result
SceneWish wishOf(std::int64_t count, bool grown = true)
{
    Node scatter, tree;
    scatter.id = wood;
    scatter.kind = NodeKind::Scatter;
    scatter.params.scatter.count = count;
    scatter.params.scatter.width = scatter.params.scatter.depth = 40.0;
    tree.id = prototype;
    tree.parent = wood;
    tree.kind = NodeKind::Tree;
    tree.params = *presetParams("TinyTree");
    SceneWish wish;
    wish.scene = *Scene::fromNodes({scatter, tree});
    wish.view.waitsForBark = false;
    wish.view.meadow = false;
    if (grown)
        wish.results.emplace(prototype, *TreePipeline().evaluate(tree.params));
    return wish;
}

RenderScene sceneOf(const SceneWish& wish)
{
    const auto resultOf = [&wish](NodeId id) {
        const auto found = wish.results.find(id);
        return found == wish.results.end() ? nullptr : &found->second;
    };
    return SceneBuilder().build(wish.scene, resultOf, wish.view);
}

} // namespace

class TestCrowdWaiter : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingToShow()
    {
        CrowdWaiter waiter;
        QSignalSpy ready(&waiter, &CrowdWaiter::ready);
        for (SceneWish wish : {SceneWish(), wishOf(20, false)}) {
            waiter.follow(wish);
            const RenderScene scene = sceneOf(wish);
            QVERIFY(scene.crowds.empty() && scene.meshes.empty());
        }
        SceneWish wrong = wishOf(20);
        Node scatter = *wrong.scene.find(wood);
        scatter.params.scatter.count = 0;
        scatter.params.scatter.spacing = 0.0;
        wrong.scene = *Scene::fromNodes({scatter, *wrong.scene.find(prototype)});
        QVERIFY(sceneOf(wrong).crowds.empty());
        waiter.wait();
        QCOMPARE(ready.count(), 0);
    }
    void aPrototypeStandsInItsPlacesAlone()
    {
        const RenderScene scene = sceneOf(wishOf(20));
        QVERIFY(scene.meshes.empty());
        QCOMPARE(scene.crowds.size(), std::size_t(1));
        const CrowdItem& item = scene.crowds.front();
        QCOMPARE(item.node, wood);
        QVERIFY(!item.crowd->places().empty());
        QVERIFY(!item.whole.front()->empty());
        QCOMPARE(item.crowd->prototypes().front().forms.size(), std::size_t(1)); // the egg
        QVERIFY(!scene.box.empty() && scene.framePoints().size() > 8);
    }
    void formsComeLater()
    {
        CrowdWaiter waiter;
        QSignalSpy ready(&waiter, &CrowdWaiter::ready);
        SceneWish wish = wishOf(20);
        waiter.follow(wish);
        QVERIFY(wish.view.crowdForms.empty());
        waiter.wait();
        QCOMPARE(ready.count(), 1);
        waiter.follow(wish);
        QVERIFY(!waiter.isBusy());
        QVERIFY(sceneOf(wish).crowds.front().crowd->prototypes().front().forms.size() > 1);
        // Another tree has the old forms until its own are there.
        SceneWish changed = wishOf(20);
        waiter.follow(changed);
        QVERIFY(waiter.isBusy());
        QCOMPARE(changed.view.crowdForms, wish.view.crowdForms);
        waiter.wait();
        waiter.follow(changed);
        QVERIFY(changed.view.crowdForms != wish.view.crowdForms);
    }
    void aTreeOfACrowdIsPicked()
    {
        SceneWish wish = wishOf(20);
        const RenderScene scene = sceneOf(wish);
        const PickScene picks(scene, nullptr);
        const CrowdItem& item = scene.crowds.front();
        const Box box = item.crowd->boxOf(item.crowd->places()[3]);
        PickView view;
        view.size = {400.0, 300.0};
        view.camera.target = box.centre();
        view.camera.distance = 0.6 * box.radius(); // none stands between
        const auto hit = picks.pick(view, {200.0, 150.0});
        QVERIFY(hit);
        QCOMPARE(hit->node, wood);
        QVERIFY(hit->copy == item.crowd->places()[3].key);
        QCOMPARE(hit->branch, noIndex);
    }
};

RAMURE_SUITE(TestCrowdWaiter)

} // namespace tst_crowd_waiter

#include "tst_crowd_waiter.moc"
