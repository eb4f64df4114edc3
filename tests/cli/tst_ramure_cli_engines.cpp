#include "core/io/zip_file.h"
#include "tests/cli/cli_support.h"
#include "tests/support/cannot_run.h"
#include <QDir>
#include <QJsonArray>
#include <QRegularExpression>
#include <QStandardPaths>

namespace tst_ramure_cli_engines {

using namespace ramure::test;

/// `export --for`: a folder for Godot, Unity and Unreal. The engines cannot be run here: names, counts and
/// shaders can be judged.
class TestRamureCliEngines : public FolderSuite
{
    Q_OBJECT
private slots:
    void init() { begin(); }
    void whatIsRefused();
    void folders_data();
    void folders();
    void aSceneOfScripts();
    void levelsAreThoseAskedFor();
    void anArchiveIsTheFolder();
    void aFolderOfBeforeIsReplaced();
    void shadersCompile_data();
    void shadersCompile();

private:
    /// Small enough for a test: a tree of \p engine in the folder of that name.
    QString written(const QString& engine, const QString& name = QStringLiteral("My oak"),
                    const QStringList& more = {});
};

namespace {

QStringList arguments(const QString& engine, const QString& path, const QStringList& more = {})
{
    return QStringList{"export", "preset:TinyTree", "--for", engine, "--map-size", "64", "-o", path} + more;
}

QJsonObject glbJson(const QString& path)
{
    const QByteArray bytes = bytesOf(path);
    if (bytes.size() < 20 || !bytes.startsWith("glTF"))
        qFatal("%s is no GLB", qPrintable(path));
    return QJsonDocument::fromJson(bytes.mid(20, qFromLittleEndian<qint32>(bytes.constData() + 12))).object();
}

QStringList namesIn(const QJsonObject& json, const char* list)
{
    QStringList names;
    for (const QJsonValue& entry : json[QLatin1String(list)].toArray())
        names << entry[QLatin1String("name")].toString();
    return names;
}

qint64 trianglesIn(const QJsonObject& json)
{
    qint64 count = 0;
    for (const QJsonValue& mesh : json[QLatin1String("meshes")].toArray())
        for (const QJsonValue& primitive : mesh[QLatin1String("primitives")].toArray())
            count += json[QLatin1String("accessors")][primitive[QLatin1String("indices")].toInt()]
                         [QLatin1String("count")]
                             .toInteger() /
                     3;
    return count;
}

/// Has some mesh this attribute?
bool hasAttribute(const QJsonObject& json, const char* name)
{
    for (const QJsonValue& mesh : json[QLatin1String("meshes")].toArray())
        for (const QJsonValue& primitive : mesh[QLatin1String("primitives")].toArray())
            if (primitive[QLatin1String("attributes")].toObject().contains(QLatin1String(name)))
                return true;
    return false;
}

/// Whether a strict compiler takes a shader without a remark.
QByteArray compiled(const QString& path, const QByteArray& text, const QStringList& options)
{
    write(path, text);
    QProcess compiler;
    compiler.setProcessChannelMode(QProcess::MergedChannels);
    compiler.start(QStringLiteral("glslangValidator"), options + QStringList{path});
    const bool ended = compiler.waitForFinished(patienceMs());
    const QByteArray said = compiler.readAll();
    return ended && compiler.exitCode() == 0 && !said.contains("WARNING") ? QByteArray() : said + " ";
}

} // namespace

QString TestRamureCliEngines::written(const QString& engine, const QString& name, const QStringList& more)
{
    const QString folder = path(name);
    const CliRun run = runCli(arguments(engine, folder, more));
    if (run.code != 0)
        qFatal("%s", qPrintable(run.err));
    return folder;
}

void TestRamureCliEngines::whatIsRefused()
{
    const QString folder = path("oak");
    QVERIFY(isRefused(runCli(arguments("cryengine", folder)), "none, godot, unity, unreal expected"));
    QVERIFY(isRefused(runCli(arguments("", folder)), "expected"));
    for (const auto& [options, said] :
         {std::pair(QStringList{"--frames", "0:3"}, "--for"),
          std::pair(QStringList{"--wind-loop", "2"}, "--for"),
          std::pair(QStringList{"--model", "rough"}, "model"),
          std::pair(QStringList{"--leaves", "instances"}, "leaves"),
          std::pair(QStringList{"--no-texture"}, "no-texture"),
          std::pair(QStringList{"--variants"}, "variants"),
          std::pair(QStringList{"--print", "fdm", "--height", "100mm"}, "--print"),
          std::pair(QStringList{"--map-size", "0"}, "map-size"),
          std::pair(QStringList{"--budget", "9,8"}, "")})
        QVERIFY2(isRefused(runCli(arguments("godot", folder, options)), said), qPrintable(options.join(' ')));
    QVERIFY(isRefused(runCli({"export", "demo:Recipes", "--for", "unity", "-o", folder}), "one tree"));
    QVERIFY(isRefused(runCli({"export", "demo:Arm", "--for", "unity", "-o", folder}), "one tree"));
    QVERIFY(!QFile::exists(folder));
    write(path("file"), "as before");
    QVERIFY(isRefused(runCli(arguments("godot", path("file"))), "cannot be written"));
    QVERIFY(isRefused(runCli(arguments("godot", path("file/oak.zip"))), "cannot be written"));
    QVERIFY(isRefused(runCli(arguments("godot", path("none/oak.zip"))), "cannot be written"));
    QCOMPARE(bytesOf(path("file")), QByteArray("as before"));
    write(path("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QVERIFY(isRefused(runCli({"export", path("mesh.obj"), "--for", "godot", "-o", folder}), "need a tree"));
}

void TestRamureCliEngines::folders_data()
{
    QTest::addColumn<QStringList>("texts");
    QTest::addColumn<QString>("collision");
    QTest::addColumn<QString>("attribute");
    QTest::newRow("godot") << QStringList{"My_oak.tscn", "README.txt", "ramure_tree.gd",
                                          "ramure_wind.gdshader"}
                           << "branches_LOD0_\\d\\d-convcolonly"
                           << "COLOR_0";
    QTest::newRow("unity") << QStringList{"README.txt", "RamureTree.cs", "RamureTree.shader",
                                          "RamureWind.hlsl"}
                           << "COL_branches_LOD0_\\d\\d"
                           << "TEXCOORD_1";
    QTest::newRow("unreal") << QStringList{"My_oak_axes.exr", "My_oak_pivots.exr", "README.txt",
                                           "RamureWind.ush", "ramure_levels.py"}
                            << "UCX_branches_LOD0_\\d\\d"
                            << "TEXCOORD_1";
}

void TestRamureCliEngines::folders()
{
    QFETCH(QStringList, texts);
    QFETCH(QString, collision);
    QFETCH(QString, attribute);
    const QString folder = written(QTest::currentDataTag());
    QStringList names = QDir(folder).entryList(QDir::Files), expected = texts;
    for (int level = 0; level < 4; ++level)
        expected << QStringLiteral("My_oak_LOD%1.glb").arg(level);
    names.sort();
    expected.sort();
    QCOMPARE(names, expected);

    const QRegularExpression piece('^' + collision + '$');
    qint64 before = std::numeric_limits<qint64>::max(), pieces = 0;
    for (int level = 0; level < 4; ++level) {
        const QJsonObject json = glbJson(folder + QStringLiteral("/My_oak_LOD%1.glb").arg(level));
        const QStringList meshes = namesIn(json, "meshes");
        const auto count = meshes.filter(piece).size();
        QCOMPARE(count > 0, level == 0);
        pieces += count;
        const qint64 triangles = trianglesIn(json);
        QVERIFY2(triangles < before, qPrintable(QString::number(level)));
        before = triangles;
        const bool isBillboard = level == 3;
        QCOMPARE(meshes.filter(QRegularExpression("^billboard")).size() == 1, isBillboard);
        QCOMPARE(hasAttribute(json, qPrintable(attribute)), !isBillboard);
        QVERIFY(!json[QLatin1String("extensionsUsed")].toArray().contains("MSFT_lod"));
        for (const QString& name : meshes)
            QVERIFY2(name.contains("LOD"), qPrintable(name));
    }
    for (const QString& name : names)
        if (!name.endsWith(".glb") && !name.endsWith(".exr")) {
            const QString text = QString::fromUtf8(bytesOf(folder + '/' + name));
            QVERIFY2(!text.contains(QRegularExpression("@[A-Z_]+@")), qPrintable(name));
        }
    const QString readme = QString::fromUtf8(bytesOf(folder + "/README.txt"));
    QCOMPARE(readme.count('\n'), 11);
    QVERIFY(readme.contains("Not tried here") && readme.contains("My_oak_LOD3.glb"));
    QVERIFY(readme.contains(QRegularExpression(QStringLiteral("\\b%1\\b").arg(pieces))));
}

void TestRamureCliEngines::aSceneOfScripts()
{
    const QString folder = written("godot");
    const QString scene = QString::fromUtf8(bytesOf(folder + "/My_oak.tscn"));
    static const QRegularExpression resource(
        "\\[ext_resource type=\"\\w+\" path=\"([^\"]+)\" id=\"(\\w+)\"\\]");
    QStringList ids;
    for (auto it = resource.globalMatch(scene); it.hasNext();) {
        const QRegularExpressionMatch found = it.next();
        QVERIFY2(QFile::exists(folder + '/' + found.captured(1)), qPrintable(found.captured(1)));
        QVERIFY(scene.contains("ExtResource(\"" + found.captured(2) + "\")"));
        ids << found.captured(2);
    }
    QCOMPARE(ids.size(), 6);
    QVERIFY(scene.startsWith("[gd_scene load_steps=7 format=3]"));
    static const QRegularExpression list("PackedFloat32Array\\(([^)]*)\\)");
    double before = -1.0;
    const QStringList distances = list.match(scene).captured(1).split(", ");
    QCOMPARE(distances.size(), 4);
    for (const QString& distance : distances) {
        QVERIFY(distance.toDouble() > before);
        before = distance.toDouble();
    }
    QVERIFY(scene.contains("still_level = 3"));
    const QString script = QString::fromUtf8(bytesOf(written("unity") + "/RamureTree.cs"));
    static const QRegularExpression shares("shares = \\{ ([^}]*) \\}");
    QCOMPARE(shares.match(script).captured(1).split(", ").size(), 4);
    QVERIFY(shares.match(script).captured(1).startsWith("0.6f, 0.3f"));
    QVERIFY(bytesOf(written("unreal") + "/ramure_levels.py").contains("SIZES = [1, 0.6, 0.3"));
}

void TestRamureCliEngines::levelsAreThoseAskedFor()
{
    const QString folder = written("unreal", "two", {"--budget", "4000,1000", "--switch", "10"});
    QCOMPARE(QDir(folder).entryList({"*.glb"}, QDir::Files), (QStringList{"two_LOD0.glb", "two_LOD1.glb"}));
    QVERIFY(trianglesIn(glbJson(folder + "/two_LOD1.glb")) <= 1020);
    QVERIFY(bytesOf(folder + "/README.txt").contains("LOD1 from 10 m on"));
}

void TestRamureCliEngines::anArchiveIsTheFolder()
{
    const QString folder = written("unity", "oak");
    QCOMPARE(runCli(arguments("unity", path("oak.zip"))).code, 0);
    QVERIFY(!QFile::exists(path("oak.zip.parts")));
    const auto zip = ramure::ZipReader::open(path("oak.zip").toStdString());
    QVERIFY(zip);
    for (const QString& name : QDir(folder).entryList(QDir::Files)) {
        std::string bytes;
        QVERIFY2(zip->read("oak/" + name.toStdString(), 1U << 30U,
                           [&](std::string_view piece) {
                               bytes += piece;
                               return true;
                           }),
                 qPrintable(name));
        QVERIFY2(bytesOf(folder + '/' + name).toStdString() == bytes, qPrintable(name));
    }
    QDir(path(".")).mkdir("again");
    QCOMPARE(runCli(arguments("unity", path("again/oak.zip"))).code, 0);
    QVERIFY(bytesOf(path("again/oak.zip")) == bytesOf(path("oak.zip")));
}

void TestRamureCliEngines::aFolderOfBeforeIsReplaced()
{
    QDir(path(".")).mkdir("oak");
    write(path("oak/README.txt"), "old");
    write(path("oak/mine.txt"), "mine");
    written("godot", "oak/");
    QVERIFY(bytesOf(path("oak/README.txt")).startsWith("oak: a tree of Ramure"));
    QCOMPARE(bytesOf(path("oak/mine.txt")), QByteArray("mine"));
}

void TestRamureCliEngines::shadersCompile_data()
{
    QTest::addColumn<QString>("engine");
    QTest::addColumn<QString>("file");
    QTest::newRow("Godot") << "godot"
                           << "ramure_wind.gdshader";
    QTest::newRow("Unity") << "unity"
                           << "RamureWind.hlsl";
    QTest::newRow("Unreal") << "unreal"
                            << "RamureWind.ush";
}

/// Godot's language is that of GLSL with names of its own; the others' is HLSL.
void TestRamureCliEngines::shadersCompile()
{
    if (QStandardPaths::findExecutable(QStringLiteral("glslangValidator")).isEmpty())
        RAMURE_CANNOT_RUN("glslangValidator (Debian: glslang-tools) is missing");
    QFETCH(QString, engine);
    QFETCH(QString, file);
    const QByteArray text = bytesOf(written(engine) + '/' + file);
    const QStringList hlsl{"-V", "-D", "-S", "vert", "-e", "main", "-o", "/dev/null"};
    if (engine == QLatin1String("unity")) {
        const QByteArray call =
            "float4 main(float3 p : POSITION, float3 n : NORMAL, float4 c : COLOR, float2 uv : TEXCOORD1)"
            " : SV_Position { float3 to; RamureWind_float(p, n, c, uv, float4(1, 0, 0, 1), 2.0, to);"
            " return float4(to, 1); }\n";
        QCOMPARE(compiled(path("wind.vert"), text + call, hlsl), QByteArray());
    } else if (engine == QLatin1String("unreal")) {
        const QByteArray whole =
            "Texture2D Pivots, Axes;\nfloat3 custom(float2 UV1, float3 Place, float Time, float4 Wind)\n{\n" +
            text +
            "}\nfloat4 main(float3 p : POSITION, float2 uv : TEXCOORD1) : SV_Position"
            " { return float4(p + custom(uv, p, 2.0, float4(1, 0, 0, 1)), 1); }\n";
        QCOMPARE(compiled(path("wind.vert"), whole, hlsl), QByteArray());
    } else {
        QString glsl = QString::fromUtf8(text);
        static const QRegularExpression head("^(shader_type|render_mode).*$",
                                             QRegularExpression::MultilineOption),
            uniform("^uniform (\\w+ \\w+)[^;]*;", QRegularExpression::MultilineOption);
        glsl.replace(head, {}).replace(uniform, "uniform \\1;");
        const QByteArray whole =
            "#version 330 core\nvec3 VERTEX, NORMAL, ALBEDO, NORMAL_MAP; vec4 COLOR; vec2 UV;\n"
            "float TIME, ROUGHNESS, NORMAL_MAP_DEPTH;\n" +
            glsl.toUtf8() +
            "out vec4 seen;\nvoid main() { vertex(); fragment(); seen = vec4(VERTEX + ALBEDO, 1.0); }\n";
        QCOMPARE(compiled(path("wind.frag"), whole, {}), QByteArray());
    }
}

RAMURE_SUITE(TestRamureCliEngines)

} // namespace tst_ramure_cli_engines

#include "tst_ramure_cli_engines.moc"
