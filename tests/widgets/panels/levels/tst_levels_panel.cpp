#include "core/qt/session/export/level_export.h"
#include "core/qt/session/jobs/job.h"
#include "tests/support/waits.h"
#include "tests/widgets/base/fixture.h"
#include "tests/widgets/tree_document.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/base/theme/theme.h"
#include "widgets/panels/levels/level_model.h"
#include "widgets/panels/levels/level_view.h"
#include "widgets/panels/levels/levels_panel.h"
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <atomic>

namespace tst_levels_panel {

using namespace ramure;
using State = LevelWatch::State;

/// The panel of levels of detail.
class TestLevelsPanel : public QObject
{
    Q_OBJECT
private:
    static constexpr int patienceMs = test::patience(30'000);
    test::OwnSettings m_settings;

    /// A panel that looks at a document with a small tree.
    struct Bench
    {
        Preferences preferences;
        test::TreeDocument trees;
        NodeId tree = noNode;
        std::unique_ptr<LevelsPanel> panel;

        explicit Bench(const char* preset = "TinyTree", LevelWatch::Function function = {})
        {
            if (preset)
                tree = trees.add(*presetParams(preset), "Oak");
            if (function)
                panel = std::make_unique<LevelsPanel>(
                    &trees.document(), new LevelWatch(&trees.document(), std::move(function)), &preferences);
            else
                panel = std::make_unique<LevelsPanel>(&trees.document(), &preferences);
            panel->watch()->setRest(0);
            panel->resize(384, 640);
            panel->show();
        }
        [[nodiscard]] State state() const { return panel->watch()->state(); }
        [[nodiscard]] bool isDone() const { return state() == State::Done; }
        [[nodiscard]] QString cell(int row, int column) const
        {
            return panel->table()->model()->index(row, column).data().toString();
        }
        [[nodiscard]] int rows() const { return panel->table()->model()->rowCount(); }
        template <class T> [[nodiscard]] T* part(const char* name) const
        {
            return panel->findChild<T*>(QLatin1String(name));
        }
        /// Without the billboard, as the next one.
        void setCount(int count) const
        {
            part<QCheckBox>("exportBillboard")->setChecked(false);
            part<QSpinBox>("levelCount")->setValue(count);
        }
        void setBudgets(const QString& text, int count) const
        {
            setCount(count);
            part<QLineEdit>("levelBudgets")->setText(text);
        }
        [[nodiscard]] QString problem() const
        {
            const auto* label = part<QLabel>("problem");
            return label && label->isVisible() ? label->text() : QString();
        }
    };

private slots:
    void init()
    {
        QSettings().clear();
        test::failOnWidgetWarning();
    }

    void whatIsNoTreeHasNoLevels()
    {
        Bench bench(nullptr);
        const auto* empty = bench.panel->findChild<EmptyPage*>();
        QVERIFY(empty->isVisible() && empty->text().contains(QStringLiteral("Select a tree")));
        QCOMPARE(bench.state(), State::None);
        bench.trees.add(test::smallForks(), "Forks");
        const NodeId group = bench.trees.addGroup();
        bench.trees.document().setSelection({});
        QVERIFY(!empty->isVisible()); // the only tree
        bench.trees.selectNode(group);
        QVERIFY(empty->isVisible());
        bench.panel->setDistance(10.0); // of nothing
        QVERIFY(!bench.panel->level());
        QTRY_VERIFY(bench.state() == State::None && bench.rows() == 0);
    }
    void theTableFitsADockOfTheUsualWidth_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QStringLiteral("en");
        QTest::newRow("French") << QStringLiteral("fr");
    }
    void theTableFitsADockOfTheUsualWidth()
    {
        QFETCH(QString, language);
        Preferences preferences;
        preferences.language.set(language);
        const Language spoken(preferences);
        const Theme theme(qApp, &preferences); // its style sheet has the margins of the cells
        Bench bench;
        bench.setBudgets(QStringLiteral("80000, 20000, 5000, 1250"), 4);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 4, patienceMs);
        const QTreeView* table = bench.panel->table();
        const int wide = table->header()->length(), room = table->viewport()->width();
        QVERIFY2(wide <= room, qPrintable(QStringLiteral("%1 of %2").arg(wide).arg(room)));
        qApp->setStyleSheet({});
    }

    void wrongBudgetsAreTold_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("budgets");
        QTest::addColumn<QString>("about");
        QTest::newRow("no number") << 2 << "many, few"
                                   << "numbers of triangles";
        QTest::newRow("rising") << 2 << "300, 400"
                                << "must fall";
        QTest::newRow("too few") << 2 << "300, 10"
                                 << "the least, 50";
        QTest::newRow("too many") << 1 << "90000000"
                                  << "the most, 20000000";
        QTest::newRow("not as many") << 3 << "300, 200"
                                     << "as many budgets, not 2";
    }
    void wrongBudgetsAreTold()
    {
        QFETCH(int, count);
        QFETCH(QString, budgets);
        QFETCH(QString, about);
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        QVERIFY(bench.panel->watch()->options() == gameLevels());
        bench.setBudgets(budgets, count);
        QVERIFY2(bench.problem().contains(about), qPrintable(bench.problem()));
        QCOMPARE(bench.rows(), 0);
        QVERIFY(!bench.panel->table()->isVisible() && !bench.panel->levelView()->isVisible());
        bench.setBudgets({}, 3);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 3, patienceMs);
        QVERIFY(bench.problem().isEmpty());
        QVERIFY((bench.panel->watch()->options() == LevelOptions{.count = 3, .cards = true}));
    }
    void theBillboardIsARow()
    {
        Bench bench;
        bench.setBudgets(QStringLiteral("900, 300"), 2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 2, patienceMs);
        bench.part<QCheckBox>("exportBillboard")->setChecked(true);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 3, patienceMs);
        QCOMPARE(bench.cell(2, LevelModel::Triangles), QStringLiteral("6"));
        QCOMPARE(bench.cell(2, LevelModel::Bark), QStringLiteral("–"));
        QVERIFY(bench.panel->watch()->levels()->levels.back().billboard);
    }
    void whatTheTreeCannotKeepIsTold()
    {
        Bench bench;
        bench.setBudgets(QStringLiteral("15000000, 50"), 2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.state() == State::Failed, patienceMs);
        QVERIFY2(bench.problem().contains(QStringLiteral("the nearest has")), qPrintable(bench.problem()));
        QVERIFY(edit::setParam(bench.trees.document(), {bench.tree}, *findParam("grammar.axiom"),
                               std::string("F[[")));
        QTRY_COMPARE(bench.state(), State::Growing);
        QVERIFY(!bench.trees.compute(bench.tree));
        QCOMPARE(bench.state(), State::Failed);
        QVERIFY(!bench.problem().isEmpty() && !bench.problem().contains(QStringLiteral("nearest")));
    }
    void theTableSaysWhatAnExportWouldWrite()
    {
        Bench bench;
        bench.setBudgets(QStringLiteral("900, 300"), 2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 2, patienceMs);
        const TreeResult& tree = bench.trees.document().result(bench.tree)->tree;
        const LevelOptions wanted{.count = 2, .budgets = {900, 300}, .cards = true};
        const auto levels = treeLevels(tree, *presetParams("TinyTree"), wanted);
        QVERIFY2(levels, test::why(levels));
        const auto [distances, shares, coverage, unseen] = switchesOf(*levels, wanted, 1.0);
        for (int row = 0; row < 2; ++row) {
            const TreeLevel& level = (*levels)[std::size_t(row)];
            const qint64 bark = level.bark->faceCount(), leaves = level.triangles() - bark;
            QCOMPARE(bench.cell(row, LevelModel::Triangles), countText(level.triangles()));
            QCOMPARE(bench.cell(row, LevelModel::Bark), countText(bark));
            QCOMPARE(bench.cell(row, LevelModel::Leaves), countText(leaves));
            QCOMPARE(bench.cell(row, LevelModel::From), metresText(distances[std::size_t(row)]));
            QVERIFY(!bench.panel->table()->model()->index(row, 0).data(Qt::ToolTipRole).toString().isEmpty());
        }
        const auto made = bench.panel->watch()->levels();
        QCOMPARE(made->switches.coverage, coverage);
        QCOMPARE(made->switches.distances, distances);
        QVERIFY(coverage[0] > 0.0 && coverage[1] == 0.0);
        // A tree that is shown three times as large is seen so from three times as far.
        QVERIFY(
            edit::setParam(bench.trees.document(), {bench.tree}, *findParam("tree.scale"), glm::dvec3(3.0)));
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.panel->watch()->levels() != made, patienceMs);
        const double ratio = bench.panel->watch()->levels()->switches.distances[1] / distances[1];
        QVERIFY2(std::abs(ratio - 3.0) < 1e-6, QByteArray::number(ratio));
    }
    void wrongDistancesAreTold_data()
    {
        QTest::addColumn<QString>("switches");
        QTest::addColumn<QString>("about");
        QTest::newRow("no number") << "near; far"
                                   << "a distance in metres";
        QTest::newRow("falling") << "30; 20"
                                 << "distances must rise";
        QTest::newRow("rising shares") << "20 %; 30 %"
                                       << "must fall";
        QTest::newRow("both kinds") << "60 %; 30"
                                    << "not at both";
        QTest::newRow("not as many") << "30"
                                     << "as many distances";
    }
    void wrongDistancesAreTold()
    {
        QFETCH(QString, switches);
        QFETCH(QString, about);
        Bench bench;
        bench.setCount(3);
        bench.part<QLineEdit>("levelSwitches")->setText(switches);
        QVERIFY2(bench.problem().contains(about), qPrintable(bench.problem()));
        bench.part<QLineEdit>("levelSwitches")->clear();
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 3, patienceMs);
        QVERIFY(bench.problem().isEmpty());
    }
    /// Shares and budgets are for all.
    void metresBelongToOneTree()
    {
        Bench bench;
        const NodeId other = bench.trees.add(test::smallForks(), "Forks");
        bench.trees.selectNode(bench.tree);
        bench.setCount(3);
        auto* from = bench.part<QLineEdit>("levelSwitches");
        QVERIFY(!bench.panel->chosen() || bench.panel->chosen()->distances.empty());
        from->setText(QStringLiteral("20; 60"));
        QCOMPARE(bench.panel->chosen()->distances, (std::vector<double>{20.0, 60.0}));
        bench.trees.selectNode(other);
        QTRY_COMPARE(bench.panel->watch()->tree(), other);
        QTRY_VERIFY(from->text().isEmpty());
        QVERIFY(bench.panel->chosen()->distances.empty());
        QCOMPARE(bench.panel->chosen()->count, std::int64_t(3));
        bench.trees.selectNode(bench.tree);
        QTRY_COMPARE(from->text(), QStringLiteral("20; 60"));
        from->setText(QStringLiteral("50 %; 20 %"));
        bench.trees.selectNode(other);
        QTRY_COMPARE(bench.panel->watch()->tree(), other);
        QCOMPARE(from->text(), QStringLiteral("50 %; 20 %"));
    }
    void distancesAreEdited()
    {
        std::atomic<int> calls = 0;
        Bench bench("TinyTree", [&](const TreeResult& tree, const NodeParams& params,
                                    const LevelOptions& options, const Progress& progress) {
            ++calls;
            return treeLevels(tree, params, options, {}, progress);
        });
        bench.setCount(3);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 3, patienceMs);
        auto* model = bench.panel->table()->model();
        QCOMPARE(bench.cell(1, LevelModel::Height), QStringLiteral("60 %"));
        QCOMPARE(bench.cell(2, LevelModel::Height), QStringLiteral("30 %"));
        QVERIFY(!model->setData(model->index(0, LevelModel::From), 3.0));      // there is none before it
        QVERIFY(!model->setData(model->index(1, LevelModel::Triangles), 3.0)); // a budget says it
        QVERIFY(!model->setData(model->index(1, LevelModel::From), QStringLiteral("far")));
        QVERIFY(model->setData(model->index(2, LevelModel::From), 0.01)); // nearer than level 1
        QTRY_VERIFY2(bench.problem().contains(QStringLiteral("must rise")), qPrintable(bench.problem()));
        QCOMPARE(bench.rows(), 3);
        QCOMPARE(bench.cell(2, LevelModel::Height), QStringLiteral("30 %"));
        QVERIFY(model->setData(model->index(2, LevelModel::From), 90.0));
        QTRY_COMPARE(bench.cell(2, LevelModel::From), metresText(90.0));
        QVERIFY(bench.problem().isEmpty());
        QCOMPARE(bench.panel->watch()->options().distances.back(), 90.0);
        QVERIFY(bench.part<QLineEdit>("levelSwitches")->text().endsWith(QStringLiteral("; 90")));
        bench.panel->setDistance(89.0);
        QCOMPARE(*bench.panel->level(), std::size_t(1));
        bench.panel->setDistance(90.0);
        QCOMPARE(*bench.panel->level(), std::size_t(2));
        QVERIFY(model->setData(model->index(1, LevelModel::Height), 80.0));
        QTRY_COMPARE(bench.cell(1, LevelModel::Height), QStringLiteral("80 %"));
        QVERIFY(bench.panel->watch()->options().distances.empty());
        // One level more is seen from twice as far.
        bench.part<QLineEdit>("levelSwitches")->setText(QStringLiteral("15; 40.5"));
        bench.setCount(4);
        QCOMPARE(bench.part<QLineEdit>("levelSwitches")->text(), QStringLiteral("15; 40.5; 81"));
        bench.setCount(3);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 3, patienceMs);
        QCOMPARE(bench.cell(2, LevelModel::From), metresText(40.5));
        LevelsPanel again(&bench.trees.document(), &bench.preferences);
        QVERIFY(again.watch()->options().makesLike(bench.panel->watch()->options()));
        QVERIFY(again.watch()->options().distances.empty()); // of a tree of then
        QVERIFY(calls <= 3);                                 // for other meshes alone
    }
    void theDistanceChoosesTheLevel()
    {
        Bench bench;
        bench.setBudgets(QStringLiteral("1200, 400, 120, 60"), 4);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 4, patienceMs);
        const auto levels = bench.panel->watch()->levels();
        QCOMPARE(bench.panel->distance(), levels->switches.distances[1]);
        for (std::size_t i = 1; i < levels->switches.distances.size(); ++i) {
            const double at = levels->switches.distances[i];
            const bool isFirst = at > levels->switches.distances[i - 1];
            bench.panel->setDistance(at);
            QCOMPARE(*bench.panel->level(), levels->levelAt(at));
            QVERIFY(*bench.panel->level() >= i);
            if (isFirst) {
                bench.panel->setDistance(0.999 * at);
                QCOMPARE(*bench.panel->level(), i - 1);
            }
            bench.panel->table()->setCurrentIndex(bench.panel->table()->model()->index(int(i), 0));
            QCOMPARE(*bench.panel->level(), i);
            QCOMPARE(bench.panel->distance(), at);
        }
        bench.panel->setDistance(0.0);
        QCOMPARE(*bench.panel->level(), std::size_t(0));
        QVERIFY(bench.panel->distance() > 0.0);
        auto* slider = bench.part<NumberSlider>("levelDistance");
        const double least = bench.panel->distance();
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(*bench.panel->level(), std::size_t(3));
        QCOMPARE(bench.panel->table()->currentIndex().row(), 3);
        const double most = bench.panel->distance();
        QVERIFY(most > 99.0 * least);
        QTest::keyClick(slider, Qt::Key_Left);
        QVERIFY(std::abs(1.1 * bench.panel->distance() / most - 1.0) < 1e-6); // by the logarithm
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(bench.panel->distance(), least);
        emit bench.panel->table()->doubleClicked(bench.panel->table()->model()->index(2, 0));
        QCOMPARE(bench.panel->distance(), levels->switches.distances[2]);
    }
    void picturesAreTakenFromTheDistance()
    {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        const TreeLevels& levels = *bench.panel->watch()->levels();
        QCOMPARE(levelFovRad, Camera().fovRad);
        const double high = levels.box.size().y;
        LevelShot shot{40.0, false, 0.3, 0.0};
        const Camera real = levelCamera(levels, shot, {180, 240});
        // A pixel of the picture is one of the screen.
        QVERIFY(std::abs(high / real.heightAtTarget() * 240.0 - levelPixels(levels, 40.0)) < 1e-6);
        shot.enlarged = true;
        const Camera large = levelCamera(levels, shot, {180, 240});
        QVERIFY(large.fovRad < real.fovRad && large.distance == real.distance);
        for (int i = 0; i < 8; ++i) {
            const auto seen = large.project(levels.box.corner(i), 180.0 / 240.0);
            QVERIFY(seen && std::abs(seen->x) < 1.0 && std::abs(seen->y) < 1.0);
        }
        // They are turned together.
        QTest::keyClick(bench.panel->wholeView(), Qt::Key_Left);
        QCOMPARE(bench.panel->levelView()->shot(), bench.panel->wholeView()->shot());
        QVERIFY(bench.panel->levelView()->shot().yawRad != LevelShot().yawRad);
        test::drag(bench.panel->levelView(), {20, 20}, {60, 30});
        QCOMPARE(bench.panel->levelView()->shot(), bench.panel->wholeView()->shot());
        const double before = bench.panel->distance();
        QTest::keyClick(bench.panel->levelView(), Qt::Key_Minus);
        QVERIFY(bench.panel->distance() > before);
    }
    void scenesHaveWhatTheirLevelsHave()
    {
        Bench bench("SmallTree");
        bench.setBudgets(QStringLiteral("9000, 1500"), 2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 2, patienceMs);
        const TreeLevels& levels = *bench.panel->watch()->levels();
        SceneBuilder builder;
        for (std::size_t i = 0; i < 2; ++i) {
            std::int64_t drawn = 0;
            for (const MeshItem& item : levelScene(builder, levels, i).meshes)
                drawn += item.copies ? std::int64_t(item.copies->faces().count) *
                                           std::int64_t(item.copies->copies.size())
                                     : item.mesh->faceCount();
            QCOMPARE(drawn, levels.levels[i].triangles());
        }
        QVERIFY(!levelScene(builder, levels, std::nullopt).meshes.empty());
    }
    void editsMakeThemAnew()
    {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        const auto before = bench.panel->watch()->levels();
        const double at = 1.5 * bench.panel->distance();
        bench.panel->setDistance(at);
        QVERIFY(edit::setParam(bench.trees.document(), {bench.tree}, *findParam("grammar.seed"),
                               std::int64_t(17)));
        QVERIFY(edit::setParam(bench.trees.document(), {bench.tree}, *findParam("foliage.leavesDensity"),
                               std::int64_t(1)));
        QCOMPARE(bench.state(), State::Growing);
        QVERIFY(bench.panel->watch()->levels() == before); // still to be seen
        QVERIFY(bench.trees.compute(bench.tree));
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.panel->watch()->levels() != before, patienceMs);
        QCOMPARE(bench.panel->distance(), at); // of the same tree
        const auto after = bench.panel->watch()->levels();
        bench.trees.document().setSelection({{bench.tree}, noNode, {}, noIndex}); // no news
        QVERIFY(bench.isDone() && bench.panel->watch()->levels() == after);
    }
    void anotherDocumentBeginsAnew()
    {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        const std::weak_ptr<const TreeLevels> before = bench.panel->watch()->levels();
        Scene scene = bench.trees.document().scene();
        bench.trees.document().reset(std::move(scene), {}); // the same ids
        QCOMPARE(bench.state(), State::Growing);
        QCOMPARE(bench.rows(), 0);
        QTRY_VERIFY(before.expired());
        QVERIFY(bench.trees.compute(bench.tree));
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 5, patienceMs);
        bench.panel->hide();
        bench.trees.document().reset(Scene(), {}); // nobody looks, and yet nothing is kept
        QVERIFY(bench.state() == State::None && !bench.panel->watch()->levels());
    }
    void hiddenItRests()
    {
        std::atomic<int> calls = 0;
        Bench bench("TinyTree", [&](const TreeResult& tree, const NodeParams& params,
                                    const LevelOptions& options, const Progress& progress) {
            ++calls;
            return treeLevels(tree, params, options, {}, progress);
        });
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        bench.panel->setSeen(false); // behind another tab
        QVERIFY(edit::setParam(bench.trees.document(), {bench.tree}, *findParam("grammar.seed"),
                               std::int64_t(3)));
        QVERIFY(bench.trees.compute(bench.tree));
        test::letHappen(50);
        QCOMPARE(calls.load(), 1);
        bench.panel->hide();
        bench.panel->setSeen(true); // no: it is not even shown
        test::letHappen(50);
        QCOMPARE(calls.load(), 1);
        bench.panel->show();
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && calls == 2, patienceMs);
    }
    void itIsCancelled()
    {
        std::atomic<bool> goes = false;
        Bench bench("TinyTree",
                    [&](const TreeResult& tree, const NodeParams& params, const LevelOptions& options,
                        const Progress& progress) -> Expected<std::vector<TreeLevel>> {
                        while (!goes && !progress.cancelled())
                            test::work(1.0);
                        progress.report(0.5);
                        return treeLevels(tree, params, options, {}, progress);
                    });
        QTRY_VERIFY(bench.state() == State::Running);
        QVERIFY(bench.part<QProgressBar>("levelProgress")->isVisible());
        bench.part<QToolButton>("cancelLevels")->click();
        QCOMPARE(bench.state(), State::Cancelled);
        auto* again = bench.part<QPushButton>("startLevels");
        QVERIFY(again->isVisible() && !bench.part<QProgressBar>("levelProgress")->isVisible());
        goes = true;
        again->click();
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        QVERIFY(!again->isVisible() && bench.rows() == 5);
    }
    /// What does not look at its stop token is left to itself.
    void closingDoesNotWait()
    {
        const auto goes = std::make_shared<std::atomic<bool>>(false);
        const auto ended = std::make_shared<std::atomic<bool>>(false);
        {
            Bench bench("TinyTree",
                        [goes, ended](const TreeResult&, const NodeParams&, const LevelOptions&,
                                      const Progress&) -> Expected<std::vector<TreeLevel>> {
                            while (!*goes)
                                test::work(1.0);
                            *ended = true;
                            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
                        });
            QTRY_VERIFY(bench.state() == State::Running);
        }
        QVERIFY(!*ended); // or it would have waited
        *goes = true;
        QTRY_COMPARE(Job::abandonedCount(), 0);
    }
    void budgetsAreKeptAndExported()
    {
        Bench bench;
        bench.setBudgets(QStringLiteral("900, 300"), 2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone() && bench.rows() == 2, patienceMs);
        const LevelOptions wanted{.count = 2, .budgets = {900, 300}, .cards = true};
        LevelsPanel again(&bench.trees.document(), &bench.preferences);
        QVERIFY(again.watch()->options() == wanted && again.form()->options() == wanted);
        std::vector<LevelOptions> asked;
        connect(bench.panel.get(), &LevelsPanel::exportRequested, this,
                [&](const LevelOptions& options) { asked.push_back(options); });
        bench.part<QPushButton>("exportTheseLevels")->click();
        QVERIFY(asked.size() == 1 && asked.back() == wanted);
        emit bench.panel->table()->customContextMenuRequested(
            bench.panel->table()->visualRect(bench.panel->table()->model()->index(1, 0)).center());
        auto* menu = bench.panel->findChild<QMenu*>();
        QVERIFY(menu);
        const auto actions = menu->actions();
        actions.back()->trigger(); // this one alone
        QCOMPARE(asked.back().count, 1);
        QCOMPARE(asked.back().budgets.front(), bench.panel->watch()->levels()->levels[1].triangles());
        menu->close();
    }
    void figuresAreCopied()
    {
        Bench bench;
        QTRY_VERIFY_WITH_TIMEOUT(bench.isDone(), patienceMs);
        const QSignalSpy said(bench.panel.get(), &LevelsPanel::messageRaised);
        bench.panel->table()->setCurrentIndex(bench.panel->table()->model()->index(2, 0));
        QTest::keySequence(bench.panel->table(), QKeySequence::Copy);
        const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        QCOMPARE(lines[0].count(u'\t'), int(LevelModel::Columns) - 1);
        QVERIFY(lines[1].startsWith(QStringLiteral("2\t")));
        QCOMPARE(said.size(), 1);
    }
    void textsAreTranslated()
    {
        const test::InStars stars;
        Bench bench;
        QVERIFY(bench.part<QPushButton>("exportTheseLevels")->text().startsWith(u'★'));
        QVERIFY(bench.panel->table()->model()->headerData(1, Qt::Horizontal).toString().startsWith(u'★'));
    }
};

RAMURE_SUITE(TestLevelsPanel)

} // namespace tst_levels_panel

#include "tst_levels_panel.moc"
