#include "core/math/random.h"
#include "core/math/stage_hash.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/project_file.h"
#include "tests/cli/cli_support.h"
#include "tests/support/cannot_run.h"

#include <QCoreApplication>
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace ramure;
using test::runCli;

namespace {

/// The environment of a processor without fused operations and wide vectors, as far as the C library goes:
/// it chooses its sines by what the processor has. (Our own functions with several versions choose for
/// themselves; their versions are compared where they are tested.)
QProcessEnvironment plainProcessor()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("GLIBC_TUNABLES"), QStringLiteral("glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"));
    return environment;
}

constexpr const char* probeOption = "--sines-of-the-library";

/// What the suite's own program prints when called so: it tells whether plainProcessor() works.
int printSines()
{
    StageHash hash(0);
    for (int i = 0; i < 100'000; ++i)
        hash.add(std::sin(0.001 * i)).add(std::exp(-0.0001 * i)).add(std::atan2(0.001 * i, 1.7));
    std::printf("%s\n", std::to_string(hash.value()).c_str());
    return 0;
}

constexpr int treeCount = 100, simulationCount = 20;

/// Of the four presets in turn, each with parameters of its own.
Node tree(int number)
{
    Random random(std::uint64_t(number), RandomStream::Test);
    const Preset& preset = courseworkPresets()[std::size_t(number) % courseworkPresets().size()];
    Node node;
    node.id = NodeId(number) + 1;
    node.kind = NodeKind::Tree;
    node.name = "tree" + std::to_string(number);
    node.params = preset.params;
    if (number == 0) { // one that did differ, once
        node.params.turtle.theta = 0.5151;
        return node;
    }
    NodeParams& params = node.params;
    params.grammar.iterations = std::min<std::int64_t>(params.grammar.iterations, 3);
    params.grammar.stochastic = number % 8 < 4;
    params.grammar.seed = number;
    params.turtle.theta = random.range(0.1, 0.9);
    params.turtle.decay = random.range(0.7, 0.95);
    params.variation.angle = random.range(0.0, 0.5);
    params.sections.lengthDivisions = 2 + random.below(3);
    params.sections.radialDivisions = 3 + random.below(6);
    params.foliage.leavesDensity = random.below(3);
    params.foliage.seed = number;
    for (int axis = 0; axis < 3; ++axis)
        params.tree.rotation[axis] = random.range(-std::numbers::pi, std::numbers::pi);
    PhysicsParams& physics = params.physics;
    physics.mode = number % 2 == 0 ? PhysicsMode::Robust : PhysicsMode::Faithful;
    physics.windDirection = random.range(-std::numbers::pi, std::numbers::pi);
    physics.windStrength = random.range(0.5, 1.5);
    physics.seed = number;
    return node;
}

/// Empty where both are the same; else the first line that differs and the object that it belongs to.
QByteArray difference(const QByteArray& a, const QByteArray& b)
{
    if (a == b)
        return {};
    const qsizetype at = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
    const auto lineOf = [](const QByteArray& text, qsizetype from) {
        return text.mid(from, text.indexOf('\n', from) - from);
    };
    const qsizetype line = a.lastIndexOf('\n', at - 1) + 1;
    return lineOf(a, a.lastIndexOf("\no ", at) + 1) + ": \"" + lineOf(a, line) + "\" and \"" +
           lineOf(b, line) + "\"";
}

} // namespace

/// The same seed gives the same bytes on every processor: the program runs as on this one and as on one
/// without fused operations.
class TestSameBytes : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }
    void initTestCase();
    void trees();
    void simulations_data();
    void simulations();
    void arms();

private:
    QTemporaryDir m_folder;
    QString m_grove = m_folder.filePath(QStringLiteral("grove.ramure"));
};

void TestSameBytes::initTestCase()
{
    const auto sines = [](const QProcessEnvironment& environment) {
        return test::runProgram(QCoreApplication::applicationFilePath(), {QLatin1String(probeOption)},
                                environment)
            .out;
    };
    const QString here = sines(QProcessEnvironment::systemEnvironment());
    QVERIFY(!here.isEmpty());
    if (sines(plainProcessor()) == here)
        RAMURE_CANNOT_RUN("this processor and C library have only one kind of sine");

    std::vector<Node> nodes;
    for (int number = 0; number < treeCount; ++number)
        nodes.push_back(tree(number));
    for (const NodeKind kind : {NodeKind::Terrain, NodeKind::Primitive, NodeKind::Arm}) {
        Node node;
        node.id = NodeId(nodes.size()) + 1;
        node.kind = kind;
        node.name = "node" + std::to_string(node.id);
        nodes.push_back(node);
    }
    const auto scene = Scene::fromNodes(std::move(nodes));
    QVERIFY2(scene, test::why(scene));
    const auto saved = saveProjectFile({*scene, {}}, m_grove);
    QVERIFY2(saved, test::why(saved));
}

void TestSameBytes::trees()
{
    const QString here = m_folder.filePath(QStringLiteral("a.obj")),
                  there = m_folder.filePath(QStringLiteral("b.obj"));
    QCOMPARE(runCli({"export", m_grove, "-o", here}).code, 0);
    QCOMPARE(runCli({"export", m_grove, "-o", there}, plainProcessor()).code, 0);
    const QByteArray bytes = test::bytesOf(here);
    QVERIFY(bytes.count("\no branches_") == treeCount);
    // Each names its own file of materials.
    const QByteArray other = test::bytesOf(there).replace("b.mtl", "a.mtl"),
                     differs = difference(bytes, other);
    QVERIFY2(differs.isEmpty(), differs);
}

void TestSameBytes::simulations_data()
{
    QTest::addColumn<QString>("tree");
    for (int number = 0; number < simulationCount; ++number) {
        const std::string name = tree(number + 1).name;
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
}

void TestSameBytes::simulations()
{
    QFETCH(QString, tree);
    const QString file = m_folder.filePath(QStringLiteral("steps.csv"));
    const QStringList command{"simulate", m_grove, "--tree", tree, "--steps", "300", "--csv", file};
    QCOMPARE(runCli(command).code, 0);
    const QByteArray here = test::bytesOf(file);
    QVERIFY(here.count('\n') == 302);
    QCOMPARE(runCli(command, plainProcessor()).code, 0);
    const QByteArray differs = difference(here, test::bytesOf(file));
    QVERIFY2(differs.isEmpty(), differs);
}

void TestSameBytes::arms()
{
    for (const char* solver : {"transpose", "dls"}) {
        const QStringList command{"ik",   m_grove,   "--target", "0.4,0.9,0.3", "--solver",
                                  solver, "--steps", "500",      "--json"};
        const test::CliRun here = runCli(command);
        QVERIFY(here.json()["steps"].toInt() > 0);
        QCOMPARE(runCli(command, plainProcessor()).out, here.out);
    }
}

int main(int argc, char** argv)
{
    if (argc == 2 && QByteArrayView(argv[1]) == probeOption)
        return printSines();
    QCoreApplication application(argc, argv);
    TestSameBytes suite;
    return QTest::qExec(&suite, argc, argv);
}
#include "tst_same_bytes.moc"
