#include "core/print/print_skeleton.h"
#include "tests/support/suite.h"
#include <algorithm>

namespace tst_print_skeleton {

using namespace ramure;

namespace {

/// A trunk of 10 m, on it a limb that tapers away and one that is thin from the start.
Skeleton tree()
{
    Skeleton out;
    const Index trunk = out.add(noIndex, {1, 2, 3}, {1, 12, 3}, 0.5, 0.4);
    const Index limb = out.add(trunk, {1, 12, 3}, {5, 14, 3}, 0.3, 0.0, 1);
    out.add(limb, {5, 14, 3}, {5, 15, 3}, 0.3, 0.3, 1);
    out.add(trunk, {1, 12, 3}, {1, 22, 3}, 0.05, 0.05, 1);
    return out;
}

} // namespace

class TestPrintSkeleton : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void nothingToPrint()
    {
        QVERIFY(!printSkeleton({}, 0.18, 0.002));
        Skeleton flat;
        flat.add(noIndex, {0, 0, 0}, {1, 0, 0}, 0.1, 0.1);
        QCOMPARE(printSkeleton(flat, 0.18, 0.002).error().code, ErrorCode::Invalid);
        Skeleton wire;
        wire.add(noIndex, {0, 0, 0}, {0, 10, 0}, 0.001, 0.001);
        const auto thin = printSkeleton(wire, 0.18, 0.002);
        QVERIFY(!thin);
        QVERIFY(thin.error().plain().find("Print it higher") != std::string::npos);
        wire.a0[0] = wire.a1[0] = 0.0;
        QVERIFY(!printSkeleton(wire, 0.18, 0.002));
    }
    void whatIsThickEnoughStays()
    {
        const PrintSkeleton print = printSkeletonAt(tree(), 0.01, 0.001);
        QCOMPARE(print.thickened, Index(0));
        QCOMPARE(print.skeleton.p0[0], glm::dvec3(0.0));
        QCOMPARE(print.skeleton.a0[0], 0.005);
    }
    void twigsAreThickenedOrCut()
    {
        // At 1 : 100 the thin limb has 1 mm: of 1.4 mm asked for it is thickened, of 2 mm it is cut.
        const PrintSkeleton thick = printSkeletonAt(tree(), 0.01, 0.0014);
        QCOMPARE(thick.thickened, Index(1));
        const PrintSkeleton cut = printSkeletonAt(tree(), 0.01, 0.002);
        QCOMPARE(cut.thickened, Index(0));
        for (const PrintSkeleton* print : {&thick, &cut})
            for (Index i = 0; i < print->skeleton.size(); ++i)
                QVERIFY(std::min(print->skeleton.a0[i], print->skeleton.a1[i]) >=
                        (print == &cut ? 0.001 : 0.0007));
        // The tapering one ends where it would be too thin, and what grew on its end is gone.
        QCOMPARE(cut.skeleton.size(), Index(2));
        QVERIFY(cut.skeleton.length(1) < 0.01 * tree().length(1));
        QCOMPARE(cut.skeleton.a1[1], 0.001);
        QCOMPARE(cut.cut, Index(3));
    }
    void theHeightIsThatOfWhatIsLeft()
    {
        for (const double height : {0.05, 0.18, 0.6}) {
            const auto print = printSkeleton(tree(), height, 0.002);
            QVERIFY2(print, test::why(print));
            double top = 0.0;
            for (const glm::dvec3& p : print->skeleton.p1)
                top = std::max(top, p.y);
            QVERIFY(top <= height * (1.0 + 1e-9));
            QVERIFY(top > 0.5 * height);
        }
    }
};

RAMURE_SUITE(TestPrintSkeleton)

} // namespace tst_print_skeleton

#include "tst_print_skeleton.moc"
