#include "core/surface/check/verdict.h"
#include "tests/support/suite.h"

namespace tst_verdict {

using namespace ramure;

/// One word for a mesh, whoever asks.
class TestVerdict : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void brokenIsBrokenWhateverElseIsKnown()
    {
        SelfIntersections none;
        QVERIFY(verdictOn(MeshReport(), nullptr) == MeshVerdict::Broken);
        QVERIFY(verdictOn(MeshReport(), &none) == MeshVerdict::Broken);
        // As many closed pieces as roots, and OpenMesh is heard.
        QVERIFY(verdictOn(closed(), &none, 2) == MeshVerdict::Broken);
        MeshReport torus = closed();
        torus.eulerCharacteristic = 0;
        QVERIFY(verdictOn(torus, &none, 1) == MeshVerdict::Broken);
        QVERIFY(verdictOn(torus, &none) == MeshVerdict::Clean);
        MeshReport doubted = closed();
        doubted.openMeshChecked = true;
        QVERIFY(verdictOn(doubted, &none, 1) == MeshVerdict::Broken);
        doubted.openMeshAgrees = true;
        QVERIFY(verdictOn(doubted, &none, 1) == MeshVerdict::Clean);
    }
    void freedomFromCrossingsIsClaimedOnlyWhereTheyWereLookedFor()
    {
        SelfIntersections found;
        QVERIFY(verdictOn(closed(), nullptr, 1) == MeshVerdict::Closed);
        QVERIFY(verdictOn(closed(), &found, 1) == MeshVerdict::Clean);
        for (std::uint64_t& kind : found.counts) { // wherever they cross
            found.counts = {};
            kind = 1;
            QVERIFY(verdictOn(closed(), &found, 1) == MeshVerdict::Crossing);
        }
    }
    void theWorstIsTheLargest()
    {
        QVERIFY(MeshVerdict::Clean < MeshVerdict::Closed && MeshVerdict::Closed < MeshVerdict::Crossing &&
                MeshVerdict::Crossing < MeshVerdict::Broken);
        QCOMPARE(verdictName(MeshVerdict::Crossing), "crossing");
    }

private:
    static MeshReport closed()
    {
        MeshReport report;
        report.valid = true;
        report.components = 1;
        report.eulerCharacteristic = 2;
        return report;
    }
};

RAMURE_SUITE(TestVerdict)

} // namespace tst_verdict

#include "tst_verdict.moc"
