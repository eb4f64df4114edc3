#include "core/lod/mip_coverage.h"

#include "core/math/random.h"
#include "tests/support/suite.h"
#include <cmath>

namespace tst_mip_coverage {

using namespace ramure;

namespace {

/// Soft discs, as leaves are after two samples a pixel.
std::vector<float> discs(int size, int count, double radius, std::uint64_t seed)
{
    Random random(seed, RandomStream::Leaves);
    std::vector<float> alpha(std::size_t(size) * std::size_t(size), 0.0F);
    for (int k = 0; k < count; ++k) {
        const double x = random.unit() * size, y = random.unit() * size;
        for (int v = 0; v < size; ++v)
            for (int u = 0; u < size; ++u) {
                const double away = std::hypot(u + 0.5 - x, v + 0.5 - y);
                float& own = alpha[std::size_t(v) * std::size_t(size) + std::size_t(u)];
                own = std::max(own, float(std::clamp(radius - away + 0.5, 0.0, 1.0)));
            }
    }
    return alpha;
}

} // namespace

class TestMipCoverage : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    /// Of nothing, and of all, nothing is to be moved.
    void plainPicturesStay()
    {
        for (const float value : {0.0F, 1.0F}) {
            std::vector<float> alpha(64, value);
            keepCoverage(alpha, 8);
            for (const float a : alpha)
                QCOMPARE(a, value);
        }
        std::vector<float> one{0.7F};
        keepCoverage(one, 1);
        QCOMPARE(one.front(), 0.7F);
    }

    /// Within two hundredths of what is opaque in the whole, whatever the picture; nothing becomes opaque or
    /// stops being so.
    void sharesStay_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("radius");
        QTest::newRow("few small ones") << 60 << 1.5;
        QTest::newRow("many small ones") << 500 << 1.2;
        QTest::newRow("leaves") << 120 << 4.0;
        QTest::newRow("a dense crown") << 400 << 7.0;
    }
    void sharesStay()
    {
        QFETCH(int, count);
        QFETCH(double, radius);
        constexpr int size = 128;
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const std::vector<float> before = discs(size, count, radius, seed);
            std::vector<float> after = before;
            keepCoverage(after, size);
            for (float& a : after) // as a file has them
                a = std::round(255.0F * a) / 255.0F;
            for (std::size_t i = 0; i < before.size(); ++i)
                QCOMPARE(after[i] >= 0.5F, before[i] >= 0.5F);
            const std::vector<double> shares = opaqueShares(after, size, keptMips + 1);
            QCOMPARE(shares.size(), std::size_t(keptMips + 1));
            for (const double share : shares)
                QVERIFY2(std::abs(share - shares[0]) <= 0.02 * shares[0] + 1.0 / 64.0,
                         qPrintable(QString("%1 of %2").arg(share).arg(shares[0])));
        }
    }
};

RAMURE_SUITE(TestMipCoverage)

} // namespace tst_mip_coverage

#include "tst_mip_coverage.moc"
