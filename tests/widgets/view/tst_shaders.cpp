#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/renderer.h"
#include <QDir>
#include <QDirIterator>
#include <QProcess>
#include <QSet>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace tst_shaders {

using namespace ramure;

namespace {

/// What the reference compiler says of a program's stages, and whether it is content with them together.
struct Verdict
{
    bool good = false;
    QByteArray text;
};

Verdict judge(const ShaderTexts& texts)
{
    const QTemporaryDir folder;
    QStringList arguments{QStringLiteral("-l")};
    for (const auto& [name, text] : {std::pair<const char*, const QByteArray&>("program.vert", texts.vertex),
                                     {"program.geom", texts.geometry},
                                     {"program.frag", texts.fragment}}) {
        QFile file(folder.filePath(QLatin1String(name)));
        if (text.isEmpty() || !file.open(QIODevice::WriteOnly))
            continue;
        file.write(text);
        arguments << file.fileName();
    }
    QProcess validator;
    validator.setProcessChannelMode(QProcess::MergedChannels);
    validator.start(QStringLiteral("glslangValidator"), arguments);
    const bool ended = validator.waitForFinished();
    const QByteArray said = validator.readAll();
    return {ended && validator.exitStatus() == QProcess::NormalExit && validator.exitCode() == 0 &&
                !said.contains("WARNING"),
            said};
}

int componentsOf(const QString& declarations)
{
    static const QRegularExpression one(
        QStringLiteral("\\b(float|int|uint|[iu]?vec([234]))\\s+\\w+(\\[(\\d+)\\])?\\s*;"));
    int sum = 0;
    for (auto each = one.globalMatch(declarations); each.hasNext();) {
        const QRegularExpressionMatch found = each.next();
        sum += std::max(1, found.captured(2).toInt()) * std::max(1, found.captured(4).toInt());
    }
    return sum;
}

/// Numbers that a stage hands on per vertex, gl_Position among them.
int outputsOf(const QByteArray& stage)
{
    static const QRegularExpression out(
        QStringLiteral("\\bout\\s+(\\w+\\s*\\{([^}]*)\\}|\\w+\\s+\\w+(\\[\\d+\\])?\\s*;)"));
    int sum = 4;
    for (auto each = out.globalMatch(QString::fromUtf8(stage)); each.hasNext();) {
        const QRegularExpressionMatch found = each.next();
        sum += componentsOf(found.hasCaptured(2) ? found.captured(2) : found.captured(1));
    }
    return sum;
}

} // namespace

/// Stand-ins for the graphics cards that are not at hand: the shaders as a strict compiler reads them, and
/// the least that OpenGL 3.3 grants.
class TestShaders : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        if (QStandardPaths::findExecutable(QStringLiteral("glslangValidator")).isEmpty())
            RAMURE_CANNOT_RUN("glslangValidator (Debian: glslang-tools) is missing");
    }
    void init() { test::failOnAnyWarning(); }

    void brokenShadersAreSeen()
    {
        const QByteArray head = "#version 330 core\n",
                         vertex = head + "void main() { gl_Position = vec4(0.0); }";
        QVERIFY(judge({vertex, {}, head + "out vec4 c; void main() { c = vec4(1.0); }"}).good);
        for (const char* broken : {"out vec4 c; void main() { c = vec3(1.0); }", // llvmpipe refuses this, too
                                   "out vec4 c; void main() { c = texture2D(0, 1.0); }",
                                   "layout(binding = 0) uniform sampler2D s; void main() {}", // OpenGL 4.2
                                   "out vec4 c; void main() { c = fma(c, c, c); }"})          // OpenGL 4.0
            QVERIFY2(!judge({vertex, {}, head + broken}).good, broken);
        QCOMPARE(outputsOf("out vec3 a;\nflat out uint b[5];\nout S { vec4 c; float d; } s;\nin vec4 e;\n"
                           "void f(out vec4 g) {}"),
                 4 + 3 + 5 + 5);
    }

    void everyProgramIsValid_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<QByteArray>("defines");
        int index = 0;
        for (const auto& [program, sources] : RendererPrograms::table()) {
            QByteArray all = sources.defines;
            for (const char* define : switches::all)
                all += define;
            for (const QByteArray& defines : {QByteArray(sources.defines), all})
                QTest::addRow("%d %s %s", index, sources.fragment.back(), defines.simplified().constData())
                    << index << defines;
            ++index;
        }
    }
    void everyProgramIsValid()
    {
        QFETCH(const int, index);
        QFETCH(const QByteArray, defines);
        ShaderSources sources = RendererPrograms::table()[std::size_t(index)].second;
        sources.defines = defines.constData();
        const ShaderTexts texts = composed(sources);
        const Verdict verdict = judge(texts);
        QVERIFY2(verdict.good, verdict.text);
        // GL_MAX_VARYING_COMPONENTS, GL_MAX_GEOMETRY_OUTPUT_COMPONENTS and
        // GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS (of a triangle), GL_MAX_TEXTURE_IMAGE_UNITS
        QVERIFY(outputsOf(texts.vertex) <= 60);
        QVERIFY(outputsOf(texts.geometry) <= 128 && 3 * outputsOf(texts.geometry) <= 1024);
        for (const QByteArray& stage : {texts.vertex, texts.geometry, texts.fragment})
            QVERIFY(QString::fromUtf8(stage).count(
                        QRegularExpression(QStringLiteral("uniform \\w*sampler"))) <= 16);
    }
    void everyFileIsPartOfAProgram()
    {
        QSet<QString> listed;
        for (const auto& [program, sources] : RendererPrograms::table()) {
            (void)composed(sources); // links the resources in
            for (const auto& names : {sources.vertex, sources.fragment})
                for (const char* name : names)
                    listed << QLatin1String(name);
            if (sources.geometry)
                listed << QLatin1String(sources.geometry);
        }
        const QStringList files = QDir(QStringLiteral(":/shaders")).entryList();
        QCOMPARE(listed, QSet<QString>(files.begin(), files.end()));
    }
    /// A core profile that looks forward refuses wide lines. They are drawn as quads here.
    void noWideLines()
    {
        int sources = 0;
        for (QDirIterator each(QStringLiteral(RAMURE_SOURCE_DIR "/widgets"), {QStringLiteral("*.cpp")},
                               QDir::Files, QDirIterator::Subdirectories);
             each.hasNext(); ++sources) {
            QFile file(each.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(!file.readAll().contains("glLineWidth"), qPrintable(file.fileName()));
        }
        QVERIFY(sources > 100);
    }
    void texturesFitSmallCards()
    {
        QCOMPARE(GpuCache::textureRows(1'000'000, 1024), std::size_t(0));
        QCOMPARE(GpuCache::textureRows(2048 * 4096 + 1, 4096), std::size_t(0));
        QCOMPARE(GpuCache::textureRows(2048 * 4096, 4096), std::size_t(4096));
        QCOMPARE(GpuCache::textureRows(2049, 4096), std::size_t(2));
        QCOMPARE(GpuCache::textureRows(0, 4096), std::size_t(1));
        QVERIFY(ShadowMap::size <= 4096);
    }
};

RAMURE_SUITE(TestShaders)

} // namespace tst_shaders

#include "tst_shaders.moc"
