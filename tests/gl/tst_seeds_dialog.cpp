#include "widgets/dialogs/variations/seeds_dialog.h"

#include "core/generators/variety.h"
#include "core/presets/named_seeds.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/job.h"
#include "core/scene/preset_scene.h"
#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/presets/picture_button.h"
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

namespace tst_seeds_dialog {

using namespace ramure;

/// Nine trees that chance grew otherwise.
class TestSeedsDialog : public QObject
{
    Q_OBJECT

    static int drawnOf(const SeedsDialog& dialog)
    {
        return int(std::ranges::count_if(dialog.choices(), [](auto* each) { return each->hasPicture(); }));
    }

    /// Pixels of the tree: beside it a row is of one colour.
    static int treePixels(const PictureButton* button)
    {
        const QImage image = button->picture().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += qAbs(qGray(image.pixel(x, y)) - qGray(image.pixel(0, y))) > 12 ? 1 : 0;
        return count;
    }

    /// Drawing leaves the processor to every other suite that runs.
    static constexpr int patienceMs = test::patience(280'000);

private slots:
    void init() { test::failOnAnyWarning(); }
    /// What a closed dialog left to itself uses what the end of the program takes apart.
    void cleanup() { QTRY_COMPARE_WITH_TIMEOUT(Job::abandonedCount(), 0, patienceMs); }

    void aTreeThatCannotGrowSaysWhy()
    {
        Document document;
        SeedsDialog dialog(&document, nullptr);
        Node broken = *presetTree("SmallTree");
        broken.params.grammar.rules = "A -> [";
        dialog.offerNew(broken);
        const auto* hint = dialog.findChild<QLabel*>();
        const auto saysWhy = [hint] {
            return hint->text().contains(u"bracket") || hint->text().contains(u'[');
        };
        QTRY_VERIFY2_WITH_TIMEOUT(saysWhy(), qPrintable(hint->text()), patienceMs);
        QCOMPARE(drawnOf(dialog), 0);
        dialog.offerFor(77); // there is no such tree: nothing changes
        QCOMPARE(dialog.windowTitle(), QStringLiteral("More like Small Tree"));
    }
    void lockedTreesStayAsTheyAre()
    {
        test::TreeDocument trees;
        const NodeId tree = trees.add(*presetParams("TinyTree"));
        QVERIFY(edit::setNodeLocked(trees.document(), {tree}, true));
        SeedsDialog dialog(&trees.document(), nullptr);
        dialog.offerFor(tree);
        const int steps = trees.document().undoStack()->count();
        dialog.choices()[3]->click();
        QCOMPARE(trees.document().undoStack()->count(), steps);
        QVERIFY(dialog.findChild<QLabel*>()->text().contains(QStringLiteral("lock")));
    }
    void namedSeedsComeFirst()
    {
        Document document;
        SeedsDialog dialog(&document, nullptr);
        dialog.offerNew(*presetTree("SilverBirch1995"));
        const auto& named = *namedSeeds("SilverBirch1995");
        for (int i = 0; i < int(namedSeedCount); ++i) {
            QCOMPARE(dialog.seedOf(i), named[std::size_t(i)]);
            QVERIFY(
                dialog.choices()[std::size_t(i)]->text().contains(QLatin1String(seedNames[std::size_t(i)])));
        }
        const std::int64_t last = dialog.seedOf(SeedsDialog::count - 1);
        dialog.otherButton()->click();
        QCOMPARE(dialog.seedOf(0), last + 1);
        QVERIFY(!dialog.choices()[0]->text().contains(QLatin1String(seedNames[0])));
        Node other = *presetTree("SilverBirch1995");
        other.params.weberPenn.scale *= 2.0; // the names are those of other trees
        dialog.offerNew(other);
        QCOMPARE(dialog.seedOf(0), other.params.grammar.seed + 1);
    }
    void eachPictureIsAnother()
    {
        Document document;
        SeedsDialog dialog(&document, nullptr);
        dialog.offerNew(*presetTree("TinyTree"));
        QCOMPARE(drawnOf(dialog), 0);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.drawn(), SeedsDialog::count, patienceMs);
        QCOMPARE(drawnOf(dialog), SeedsDialog::count);
        QImage first = dialog.choices()[0]->grab().toImage(), second = dialog.choices()[1]->grab().toImage();
        QVERIFY(first != second);
        const std::int64_t before = dialog.seedOf(0);
        dialog.otherButton()->click();
        QCOMPARE(dialog.seedOf(0), before + SeedsDialog::count);
        QCOMPARE(drawnOf(dialog), 0);
        dialog.close(); // while it draws: the rest is left undone
    }
    /// What is added, and what a tree becomes, is the tree of the picture; one step of undo each.
    void choicesAreTreesOfTheirSeed()
    {
        test::TreeDocument trees;
        Document& document = trees.document();
        SeedsDialog dialog(&document, nullptr);
        const Node like = *presetTree("SilverBirch1995");
        dialog.offerNew(like);
        dialog.choices()[4]->click();
        dialog.choices()[5]->click();
        const std::int64_t chosen = dialog.seedOf(4);
        QCOMPARE(document.scene().nodes().size(), std::size_t(2));
        NodeParams expected = reseeded(like.params, dialog.seedOf(4));
        QVERIFY(document.scene().nodes().front().params == expected);
        QVERIFY(document.scene().nodes().back().params.grammar.seed == dialog.seedOf(5));
        document.undo();
        QCOMPARE(document.scene().nodes().size(), std::size_t(1));

        const NodeId tree = document.scene().nodes().front().id;
        dialog.offerFor(tree);
        dialog.choices()[8]->click();
        expected = reseeded(expected, dialog.seedOf(8));
        QVERIFY(document.scene().find(tree)->params == expected);
        document.undo();
        QCOMPARE(document.scene().find(tree)->params.grammar.seed, chosen);
    }
    void grownTreesAreOfferedAtThreeAges()
    {
        test::TreeDocument trees;
        Document& document = trees.document();
        SeedsDialog dialog(&document, nullptr);
        dialog.offerNew(*presetTree("SilverBirch1995"));
        QVERIFY(dialog.agesBox()->isHidden());
        const Node like = *presetTree("SilverBirch");
        const auto ages = std::ranges::find(presets(), std::string_view("SilverBirch"), &Preset::name)->ages;
        dialog.offerNew(like);
        QVERIFY(!dialog.agesBox()->isHidden());
        dialog.agesBox()->setChecked(true);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.drawn() >= 3, patienceMs);
        const auto& row = dialog.choices(); // a young tree is small beside an old one
        QVERIFY(row[0]->hasPicture() && row[1]->hasPicture() && row[2]->hasPicture());
        QVERIFY2(3 * treePixels(row[0]) < treePixels(row[2]),
                 qPrintable(QString::number(treePixels(row[0]))));
        QVERIFY(treePixels(row[1]) > treePixels(row[0]));
        QVERIFY(row[0]->text().contains(QString::number(ages[0])));
        QCOMPARE(dialog.seedOf(3), dialog.seedOf(5));
        QVERIFY(dialog.seedOf(2) != dialog.seedOf(3));
        dialog.choices()[5]->click();
        NodeParams expected = reseeded(like.params, dialog.seedOf(5));
        expected.growth.age = ages[2];
        QVERIFY(document.scene().nodes().front().params == expected);
        const NodeId tree = document.scene().nodes().front().id;
        dialog.offerFor(tree);
        dialog.choices()[0]->click();
        QCOMPARE(document.scene().find(tree)->params.growth.age, double(ages[0]));
        document.undo();
        QVERIFY(document.scene().find(tree)->params == expected);
    }
    void aTreeWithoutChanceSaysThatOnlyLeavesVary()
    {
        Document document;
        SeedsDialog dialog(&document, nullptr);
        Node like = *presetTree("TernaryTree");
        like.params.variation = {0.0, 0.0, 0.0};
        dialog.offerNew(like);
        QVERIFY(dialog.findChild<QLabel*>()->text().contains(QStringLiteral("leaves varies")));
    }
};

RAMURE_SUITE(TestSeedsDialog)

} // namespace tst_seeds_dialog

#include "tst_seeds_dialog.moc"
