#include "tests/support/suite.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/history/history_dock.h"
#include <QListView>

namespace tst_history_dock {

using namespace ramure;

class TestHistoryDock : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void aClickGoesToThatStep();
    void theDotMarksWhatIsInTheFile();
    void isTranslatedAndFollowsTheTheme();
};

void TestHistoryDock::aClickGoesToThatStep()
{
    test::TreeDocument trees;
    HistoryDock dock(&trees.document());
    dock.resize(260, 240);
    dock.show();
    auto* view = dock.findChild<QListView*>();
    QCOMPARE(view->model()->rowCount(), 1);
    const NodeId tree = trees.add(test::smallForks(), "one");
    for (const char* name : {"two", "three", "four"})
        QVERIFY(edit::setNodeName(trees.document(), tree, QLatin1String(name)));
    QCOMPARE(view->model()->rowCount(), 5);
    QCOMPARE(view->currentIndex().row(), 4);
    const auto click = [view](int row) {
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                          view->visualRect(view->model()->index(row, 0)).center());
    };
    click(2);
    QCOMPARE(trees.document().undoStack()->index(), 2);
    QCOMPARE(trees.document().scene().find(tree)->name, std::string("two"));
    click(4);
    QCOMPARE(trees.document().scene().find(tree)->name, std::string("four"));
    click(0);
    QVERIFY(trees.document().scene().empty());
    trees.document().reset({}, {});
    QCOMPARE(view->model()->rowCount(), 1);
}

void TestHistoryDock::theDotMarksWhatIsInTheFile()
{
    test::TreeDocument trees;
    HistoryDock dock(&trees.document());
    auto* view = dock.findChild<QListView*>();
    const auto hasDot = [view](int row) {
        return !view->model()->index(row, 0).data(Qt::DecorationRole).value<QIcon>().isNull();
    };
    const NodeId tree = trees.add(test::smallForks());
    QVERIFY(edit::setNodeName(trees.document(), tree, QStringLiteral("two")));
    QVERIFY(hasDot(0) && !hasDot(1) && !hasDot(2));
    trees.document().markSaved();
    QVERIFY(!hasDot(0) && !hasDot(1) && hasDot(2));
    trees.document().undo();
    QVERIFY(!hasDot(1) && hasDot(2));
    // Crisp at every scale: a picture of the exact size for each.
    const QIcon icon = view->model()->index(2, 0).data(Qt::DecorationRole).value<QIcon>();
    for (const qreal scale : {1.0, 1.5, 2.0, 3.0})
        QCOMPARE(icon.pixmap(QSize(16, 16), scale).size(), (QSizeF(16, 16) * scale).toSize());
}

void TestHistoryDock::isTranslatedAndFollowsTheTheme()
{
    const test::InStars stars;
    test::TreeDocument trees;
    HistoryDock dock(&trees.document());
    auto* view = dock.findChild<QListView*>();
    const auto first = [view](int role) { return view->model()->index(0, 0).data(role); };
    QVERIFY(first(Qt::DisplayRole).toString().startsWith(u'★'));
    QVERIFY(view->toolTip().startsWith(u'★'));

    const auto middle = [&first] {
        return first(Qt::DecorationRole).value<QIcon>().pixmap(16).toImage().pixelColor(8, 8);
    };
    QPalette palette = dock.palette();
    palette.setColor(QPalette::Highlight, QColor(10, 200, 30));
    dock.setPalette(palette);
    QCOMPARE(middle(), QColor(10, 200, 30));
}

RAMURE_SUITE(TestHistoryDock)

} // namespace tst_history_dock

#include "tst_history_dock.moc"
