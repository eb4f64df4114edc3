// The judge of ./dev peers on meshes whose faults are known. It is Python with NumPy, and knows nothing of
// Ramure.
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <cmath>

namespace tst_peers_judge {

using namespace ramure;

class TestPeersJudge : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    struct Answer
    {
        int code = -1;
        QByteArray said;
        QJsonObject found;
    };

    Answer judge(const QByteArray& obj, const QString& name = QStringLiteral("mesh.obj"))
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(obj) != obj.size())
            return {};
        file.close();
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral("/usr/bin/python3"),
                      {QStringLiteral("-B"), QStringLiteral(RAMURE_SOURCE_DIR "/tests/peers/judge.py"),
                       file.fileName()});
        if (!process.waitForFinished(60'000))
            return {};
        const QByteArray said = process.readAll();
        return {process.exitCode(), said, QJsonDocument::fromJson(said).object()};
    }

    /// Eight corners from here on, as wide as this; \p askew: not on the diagonals of another's squares.
    static QByteArray corners(double at = 0, double width = 1, double askew = 0)
    {
        QByteArray text;
        for (int k = 0; k < 8; ++k) {
            text += 'v';
            for (int axis = 0; axis < 3; ++axis)
                text += ' ' + QByteArray::number(at + askew * axis + width * (k >> axis & 1));
            text += '\n';
        }
        return text;
    }
    /// Six squares that look outwards, of the eight corners from this one on.
    static QByteArray faces(int first = 1)
    {
        static constexpr int squares[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        QByteArray text;
        for (const auto& square : squares) {
            text += 'f';
            for (const int corner : square)
                text += ' ' + QByteArray::number(first + corner);
            text += '\n';
        }
        return text;
    }
    static QByteArray cube() { return corners() + faces(); }

    /// All faults of a sound cube are 0; those that are named have these numbers.
    void verifyFaults(const QByteArray& obj, const QMap<QString, int>& expected)
    {
        const Answer answer = judge(obj);
        QVERIFY2(answer.code == 0, answer.said.constData());
        for (const char* fault : {"boundaryEdges", "crowdedEdges", "turnedEdges", "bowTies",
                                  "piecesInsideOut", "extraVertices", "facesTwice", "flatFaces"})
            QVERIFY2(answer.found.value(QLatin1String(fault)).toInt(-1) ==
                         expected.value(QLatin1String(fault)),
                     (fault + QByteArray(": ") + answer.said).constData());
        QCOMPARE(answer.found.value(QStringLiteral("pieces")).toInt(),
                 expected.value(QStringLiteral("pieces"), 1));
    }

private slots:
    void initTestCase()
    {
        QProcess process;
        process.start(QStringLiteral("/usr/bin/python3"),
                      {QStringLiteral("-c"), QStringLiteral("import numpy")});
        if (!process.waitForFinished(60'000) || process.exitCode() != 0)
            RAMURE_CANNOT_RUN("no NumPy for /usr/bin/python3 on this machine (python3-numpy)");
    }
    void init() { test::failOnAnyWarning(); }

    void whatIsNoMeshIsAnError()
    {
        QVERIFY(judge("no mesh", QStringLiteral("mesh.ply")).code != 0);
        QVERIFY(judge("v 0 0 0\nf 1 2 3\n").code != 0);
    }

    void soundCube()
    {
        verifyFaults(cube(), {});
        const QJsonObject found = judge(cube()).found;
        QCOMPARE(found.value(QStringLiteral("triangles")).toInt(), 12);
        QCOMPARE(found.value(QStringLiteral("crossing")).toDouble(-1), 0.0);
        QVERIFY(qAbs(found.value(QStringLiteral("volume")).toDouble() - 1) < 1e-12);
    }

    void cornersInOnePlaceAreOne()
    {
        // Each square has corners of its own, as at the seams of textures.
        QByteArray obj = cube().left(corners().size());
        for (int k = 0; k < 5; ++k)
            obj += corners();
        for (int k = 0; k < 6; ++k)
            obj += faces(1 + 8 * k).split('\n').at(k) + '\n';
        verifyFaults(obj, {{QStringLiteral("extraVertices"), 16}});
    }

    void faults()
    {
        const QByteArray squares = faces();
        const QByteArray first = squares.left(squares.indexOf('\n') + 1);
        verifyFaults(corners() + squares.mid(first.size()), {{QStringLiteral("boundaryEdges"), 4}});
        verifyFaults(cube() + corners(3) + faces(9), {{QStringLiteral("pieces"), 2}});
        // Two cubes that have a corner in common: the triangles around it are two fans.
        verifyFaults(cube() + corners(1) + faces(9),
                     {{QStringLiteral("bowTies"), 1}, {QStringLiteral("extraVertices"), 1}});
        verifyFaults(cube() + first,
                     {{QStringLiteral("facesTwice"), 2}, {QStringLiteral("crowdedEdges"), 5}});
        verifyFaults(cube() + "f 1 2 2\n", {{QStringLiteral("flatFaces"), 1}});
        verifyFaults(corners() + squares.mid(first.size()) + "f 1 2 4 3\n",
                     {{QStringLiteral("turnedEdges"), 4}});
        QByteArray inwards = corners();
        for (const QByteArray& line : squares.trimmed().split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            inwards += "f " + words[4] + ' ' + words[3] + ' ' + words[2] + ' ' + words[1] + '\n';
        }
        verifyFaults(inwards, {{QStringLiteral("piecesInsideOut"), 1}});
    }

    void crossings()
    {
        const QJsonObject found = judge(cube() + corners(0.3, 0.9, 0.07) + faces(9)).found;
        // Three squares of each go through three of the other.
        const double crossing = found.value(QStringLiteral("crossing")).toDouble();
        QVERIFY2(crossing > 300 && crossing <= 600, QByteArray::number(crossing).constData());
        QCOMPARE(judge(cube() + corners(0.25, 0.5) + faces(9))
                     .found.value(QStringLiteral("crossing"))
                     .toDouble(-1),
                 0.0);
    }

    void texture()
    {
        const QByteArray even =
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nvn 0 0 1\nvn 0 0 -1\n";
        const QJsonObject found = judge(even + "f 1/1/1 2/2/1 3/3/1 4/4/2\n").found;
        QVERIFY(qAbs(found.value(QStringLiteral("textureSpread")).toDouble() - 1) < 1e-12);
        QVERIFY(qAbs(found.value(QStringLiteral("texturePerMetre")).toDouble() - 2) < 1e-12);
        QVERIFY(qAbs(found.value(QStringLiteral("normalsAway")).toDouble() - 1.0 / 6) < 1e-12);
        QVERIFY(!judge(cube()).found.contains(QStringLiteral("textureSpread")));
    }

    /// Two leaves of 1 m by 2 m, one of which is there twice, over a trunk of a cube; flowers do not count.
    void foliage()
    {
        const QByteArray leaf = "v %1 5 0\nv %2 5 0\nv %2 5 2\nv %1 5 2\n";
        const auto at = [&](int place) {
            return QByteArray(leaf)
                .replace("%1", QByteArray::number(place))
                .replace("%2", QByteArray::number(place + 1));
        };
        const QJsonObject found = judge(cube() + "o leaves\n" + at(0) + at(3) +
                                        "f 9 10 11 12\nf 13 14 15 16\nf 15 14 13 16\no flowers\nf 1 2 3\n")
                                      .found;
        QCOMPARE(found.value(QStringLiteral("triangles")).toInt(), 12);
        QCOMPARE(found.value(QStringLiteral("leaves")).toInt(), 2);
        QVERIFY(qAbs(found.value(QStringLiteral("leafReach")).toDouble() - std::sqrt(5.0)) < 1e-6);
        QVERIFY(qAbs(found.value(QStringLiteral("leafArea")).toDouble() - 4) < 1e-6);
        QVERIFY(qAbs(found.value(QStringLiteral("leafAreaIndex")).toDouble() - 0.5) < 1e-6);
    }
};

RAMURE_SUITE(TestPeersJudge)

} // namespace tst_peers_judge

#include "tst_peers_judge.moc"
