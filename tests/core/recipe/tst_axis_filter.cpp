#include "core/recipe/axis_filter.h"
#include "tests/support/shaped_tree.h"

namespace tst_axis_filter {

using namespace ramure;
using namespace ramure::test;

/// The condition of a step.
class TestAxisFilter : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void badTextIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("column");
        QTest::newRow("unknown name") << QByteArray("colour = 1") << 1;
        QTest::newRow("no right side") << QByteArray("order =") << 8;
        QTest::newRow("two conditions") << QByteArray("order = 1 share > 0.2") << 11;
        QTest::newRow("bracket") << QByteArray("(order = 1") << 11;
        QTest::newRow("word alone") << QByteArray("and") << 1;
        QTest::newRow("list of none") << QByteArray("axes ") << 6;
        QTest::newRow("no address") << QByteArray("axes 1f, trunk") << 10;
        QTest::newRow("too many digits") << QByteArray("axes 12345678901234567") << 6;
        QTest::newRow("too deep") << QByteArray(200, '(') + "1" << 102;
    }
    void badTextIsRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, column);
        const auto filter = AxisFilter::parse(text.constData());
        QVERIFY(!filter);
        QCOMPARE(filter.error().path, std::string("step.where"));
        QCOMPARE(filter.error().column, column);
    }

    /// The plain tree: trunk, limb, twig, upper limb.
    void namesAxes_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("axes");
        QTest::newRow("empty") << QByteArray("  ") << QByteArray("1111");
        QTest::newRow("order") << QByteArray("order = 1") << QByteArray("0101");
        QTest::newRow("not") << QByteArray("not (order = 1)") << QByteArray("1010");
        QTest::newRow("and") << QByteArray("order = 1 and share > 0.4") << QByteArray("0001");
        QTest::newRow("or") << QByteArray("order = 0 or order = 2") << QByteArray("1010");
        QTest::newRow("signs") << QByteArray("order >= 1 && !(order > 1)") << QByteArray("0101");
        QTest::newRow("length") << QByteArray("length > 1.5 and order > 0") << QByteArray("0100");
        QTest::newRow("height") << QByteArray("height < 0.001") << QByteArray("1000");
        QTest::newRow("forks") << QByteArray("forks = 0") << QByteArray("0011");
        QTest::newRow("none") << QByteArray("order = 7") << QByteArray("0000");
        QTest::newRow("no number") << QByteArray("1 / (order - order) > 0") << QByteArray("0000");
    }
    void namesAxes()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, axes);
        const Skeleton grown = *grownTree(plainTree(), Stage::Skeleton).grown;
        const EditTree tree(grown, axesOf(grown));
        const auto filter = AxisFilter::parse(text.constData());
        QVERIFY2(filter, why(filter).constData());
        QByteArray found;
        for (const bool isMeant : filter->axesOf(tree))
            found += isMeant ? '1' : '0';
        QCOMPARE(found, axes);
    }
    void listsNameAxes()
    {
        const Skeleton grown = *grownTree(plainTree(), Stage::Skeleton).grown;
        const TreeAxes axes = axesOf(grown);
        const EditTree tree(grown, axes);
        const std::array addresses{axes.axes[3].address, axes.axes[1].address, std::uint64_t(7)};
        const auto filter = AxisFilter::parse(AxisFilter::ofAxes(addresses));
        QVERIFY2(filter, why(filter).constData());
        QCOMPARE(filter->axesOf(tree), (std::vector{false, true, false, true}));
    }
};

RAMURE_SUITE(TestAxisFilter)

} // namespace tst_axis_filter

#include "tst_axis_filter.moc"
