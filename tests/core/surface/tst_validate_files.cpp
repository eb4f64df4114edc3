#include "core/io/mesh_file.h"
#include "core/surface/proof/validate.h"
#include "tests/support/suite.h"
#include <QDir>

namespace tst_validate_files {

using namespace ramure;

/// One file per kind of defect, each with a comment that says what is wrong with it; counted by hand.
class TestValidateFiles : public QObject
{
    Q_OBJECT

    struct Expected
    {
        const char* file;
        std::vector<std::pair<DefectKind, Index>> counts;
        Index vertices, faces, components;
        int euler;
        double volume;
        bool openMesh; ///< its structure knows connections, not positions
    };
    std::vector<Expected> m_files = {
        {"clean.obj", {}, 8, 12, 1, 2, 1.0, true},
        {"boundary_edge.obj", {{DefectKind::BoundaryEdge, 3}}, 8, 11, 1, 1, 11.0 / 12.0, false},
        {"non_manifold_edge.obj", {{DefectKind::NonManifoldEdge, 1}}, 14, 24, 1, 3, 2.0, false},
        {"non_manifold_vertex.obj", {{DefectKind::NonManifoldVertex, 1}}, 9, 12, 1, 3, 4.0 / 3.0, false},
        {"inconsistent_edge.obj", {{DefectKind::InconsistentEdge, 3}}, 8, 12, 1, 2, 5.0 / 6.0, false},
        {"duplicate_vertex.obj", {{DefectKind::DuplicateVertex, 1}}, 12, 16, 2, 4, 7.0 / 6.0, true},
        {"duplicate_face.ply",
         {{DefectKind::DuplicateFace, 1}, {DefectKind::NonManifoldEdge, 3}},
         8,
         13,
         1,
         3,
         13.0 / 12.0,
         false},
        {"degenerate_face.obj", {{DefectKind::DegenerateFace, 1}}, 9, 14, 1, 2, 1.0, true},
        {"isolated_vertex.ply", {{DefectKind::IsolatedVertex, 1}}, 9, 12, 1, 2, 1.0, false},
    };

private slots:
    void init() { test::failOnAnyWarning(); }

    void everyFileIsExpected()
    {
        const QDir folder(QStringLiteral(RAMURE_TEST_DATA "/defects"));
        QCOMPARE(folder.entryList(QDir::Files).size(), static_cast<qsizetype>(m_files.size()));
        for (int kind = 0; kind < defectKindCount; ++kind)
            QVERIFY(std::any_of(m_files.begin(), m_files.end(), [&](const Expected& file) {
                return !file.counts.empty() && file.counts.front().first == DefectKind(kind);
            }));
    }
    void everyDefectIsFound()
    {
        for (const Expected& expected : m_files) {
            const auto mesh = readMeshFile(std::string(RAMURE_TEST_DATA "/defects/") + expected.file);
            QVERIFY2(mesh, test::why(mesh));
            const TriangleMesh joined = mesh->joined();
            auto report = validateMesh(joined);
            QVERIFY2(report, test::why(report));
            for (int kind = 0; kind < defectKindCount; ++kind) {
                Index count = 0;
                for (const auto& [which, number] : expected.counts)
                    count = which == DefectKind(kind) ? number : count;
                QVERIFY2(
                    report->count(DefectKind(kind)) == count,
                    qPrintable(QStringLiteral("%1, kind %2").arg(QLatin1String(expected.file)).arg(kind)));
            }
            QVERIFY2(report->valid == expected.counts.empty(), expected.file);
            QCOMPARE(report->vertices, expected.vertices);
            QCOMPARE(report->faces, expected.faces);
            QCOMPARE(report->components, expected.components);
            QCOMPARE(report->eulerCharacteristic, expected.euler);
            QVERIFY2(std::abs(report->volume - expected.volume) < 1e-12, expected.file);
            QVERIFY(confirmWithOpenMesh(joined, *report));
            QVERIFY(report->openMeshChecked);
            QVERIFY2(report->openMeshAgrees == expected.openMesh, expected.file);
        }
    }
};

RAMURE_SUITE(TestValidateFiles)

} // namespace tst_validate_files

#include "tst_validate_files.moc"
