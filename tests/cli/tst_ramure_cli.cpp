#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/params/param_relevance.h"
#include "core/params/recipe.h"
#include "tests/cli/cli_support.h"
#include <QElapsedTimer>
#include <QJsonArray>
#include <random>

namespace tst_ramure_cli {

using namespace ramure;
using test::isRefused;
using test::runCli;

/// Usage, list, info: what every script relies on.
class TestRamureCli : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    static QStringList words(const char* text) { return QString::fromUtf8(text).split(QLatin1Char(' ')); }

private slots:
    void init() { test::failOnAnyWarning(); }

    void badUsage_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* arguments, const char* part) {
            QTest::newRow(arguments) << words(arguments) << QString::fromUtf8(part);
        };
        QTest::newRow("nothing") << QStringList() << "missing command";
        row("grow",
            "unknown command \"grow\": list, info, import, recipe, scatter, edit, export, levels, age, "
            "validate, signs, "
            "simulate, ik, "
            "render, billboard, "
            "textures, batch, job, sheet expected");
        row("--nonsense", "unknown command");
        row("info", "missing INPUT");
        row("info preset:SmallTree preset:FanTree", "unexpected argument \"preset:FanTree\"");
        row("info preset:SmallTree --frobnicate", "Unknown option 'frobnicate'");
        row("info preset:SmallTree -x", "Unknown option 'x'");
        row("info preset:SmallTree --set", "Missing value after '--set'");
        row("info preset:SmallTree --set turtle.alpha", "KEY=VALUE expected");
        row("info preset:SmallTree --set turtle.beta=1", "unknown parameter \"turtle.beta\"");
        row("info preset:Oak", "Oak");
        row("info preset:", "SmallTree");
        row("info tree.dae", "\"tree.dae\" is no input: preset:NAME, demo:NAME or a file .ramure, .obj, "
                             ".ply, .glb, .usda, .usdz, .stl, .3mf, .png, .exr expected");
        row("info SmallTree", "is no input");
        row("info none.ramure", "none.ramure");
        row("info none.obj", "No such file or directory");
        row("info none.ply", "No such file or directory");
        row("list", "missing presets|params");
        row("list trees", "cannot list \"trees\"");
        row("list presets --markdown", "--markdown is for params");
        row("export preset:SmallTree", "missing -o FILE");
        row("export preset:SmallTree -o", "Missing value");
        row("export preset:SmallTree -o tree.dae",
            "unknown file ending \".dae\": meshes are written as .obj, .ply");
        row("export preset:SmallTree -o tree", "unknown file ending \"\"");
        row("export preset:SmallTree -o t.obj --texture --model rough", "--texture needs --model mesh");
        row("export preset:SmallTree -o t.obj --texture --no-texture", "exclude each other");
        row("export preset:SmallTree -o t.obj --up x", "--up: unknown axis \"x\": y or z expected");
        row("export preset:SmallTree -o t.obj --unit parsec", "--unit: unknown unit \"parsec\"");
        row("export preset:SmallTree -o t.obj --scale 0", "--scale: the scale must be from");
        row("export preset:SmallTree -o t.obj --scale two", "--scale: \"two\" is not a number");
        row("export preset:SmallTree -o t.stl --print wood --height 180mm", "fdm, resin, powder expected");
        row("export preset:SmallTree -o t.stl --print fdm", "--print needs --height");
        row("export preset:SmallTree -o t.stl --height 180mm", "--height needs --print");
        row("export preset:SmallTree -o t.stl --print fdm --height 0mm",
            "--height: \"0mm\": a length above 0");
        row("export preset:SmallTree -o t.stl --print fdm --height=-18cm", "--height: \"-18cm\": a length");
        row("export preset:SmallTree -o t.stl --print fdm --height tall", "--height: \"tall\" is no length");
        row("export preset:SmallTree -o t.stl --print fdm --height 3m", "a print of 3000 mm");
        row("export preset:SmallTree -o t.stl --print fdm --height 18cm --thinnest 4cm",
            "too thick for a print");
        row("export preset:SmallTree -o t.stl --print fdm --height 18cm --foot toes", "disc, flat expected");
        row("export preset:SmallTree -o t.stl --print fdm --height 18cm --scale 2", "exclude each other");
        row("export preset:SmallTree -o t.obj --part roots", "branches, leaves, fruit, all expected");
        row("export preset:SmallTree -o t.obj --model fine", "mesh, rough, skeleton expected");
        row("validate", "missing INPUT");
        row("render preset:SmallTree", "one -o FILE.png expected");
        row("render preset:SmallTree -o a.jpg", "pictures are written as .png");
        row("render preset:SmallTree -o a.png --mode x-ray",
            "skeleton, simplified, rough, sections, mesh, checker, stretch expected");
        for (const char* size : {"1280", "x", "12x12", "0x100", "-20x100", "8193x100", "100x8193",
                                 "100x100x100", "axb", "99999999999x100", ""})
            QTest::newRow((QByteArray("size ") + size).constData())
                << QStringList{"render", "preset:SmallTree", "-o", "a.png", "--size", QString::fromUtf8(size)}
                << "WIDTHxHEIGHT expected, each 16 to 8192 pixels";
    }
    void badUsage()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, part);
        QVERIFY(isRefused(runCli(arguments), part));
    }
    void validateTellsOfTheBudget()
    {
        const auto budget = [](const char* target) {
            return runCli({"validate", "preset:TinyTree", "--json", "--set",
                           QStringLiteral("mesh.targetTriangles=") + QLatin1String(target)})
                .json()
                .value("budget")
                .toObject();
        };
        QVERIFY(!runCli({"validate", "preset:TinyTree", "--json"}).json().contains("budget"));
        QCOMPARE(budget("5000").value("fit").toString(), QString("within"));
        QCOMPARE(budget("5000").value("note").toString(), QString());
        QCOMPARE(budget("500").value("fit").toString(), QString("smallest"));
        QCOMPARE(budget("500").value("targetTriangles").toInt(), 500);
        QVERIFY(budget("500").value("note").toString().contains("smallest mesh"));
        const auto text = runCli({"validate", "preset:TinyTree", "--set", "mesh.targetTriangles=500"});
        QCOMPARE(text.code, 0);
        QVERIFY(text.out.contains("500 triangles wanted: So many branches"));
        QVERIFY(runCli({"validate", "preset:TinyTree", "--set", "mesh.targetTriangles=5000"})
                    .out.contains("5000 triangles wanted: kept within 5 %"));
    }
    void badValues_data()
    {
        QTest::addColumn<QString>("setting");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* setting, const char* part) {
            QTest::newRow(setting) << QString::fromUtf8(setting) << QString::fromUtf8(part);
        };
        row("turtle.alpha=nan", "turtle.alpha");
        row("turtle.alpha=inf", "turtle.alpha");
        row("turtle.alpha=-1", "turtle.alpha");
        row("turtle.alpha=0", "turtle.alpha");
        row("turtle.alpha=1e30", "turtle.alpha");
        row("turtle.alpha=long", "turtle.alpha");
        row("turtle.alpha=", "turtle.alpha");
        row("grammar.iterations=-1", "grammar.iterations");
        row("grammar.iterations=2.5", "grammar.iterations");
        row("grammar.iterations=99999999999999999999", "grammar.iterations");
        row("grammar.stochastic=perhaps", "grammar.stochastic");
        row("tree.scale=1,2", "tree.scale");
        row("tree.scale=1,2,nan", "tree.scale");
        row("sections.radialDivisions=2", "sections.radialDivisions");
        row("season.day=400", "season.day");
        row("season.day=-1", "season.day");
        row("season.day=nan", "season.day");
        row("season.day=May", "season.day");
        row("season.climate=tropical", "season.climate");
        row("grammar.axiom=B]A", "grammar.axiom");
        row("grammar.axiom=", "grammar.axiom");
        row("grammar.rules=A > B", "grammar.rules");
        row("grammar.rules=A -> -1: B | 2: C", "grammar.rules");
        row("grammar.rules=A -> B\\nA -> C", "grammar.rules");
    }
    void badValues()
    {
        QFETCH(QString, setting);
        QFETCH(QString, part);
        QVERIFY(isRefused(runCli({"info", "preset:SmallTree", "--set", setting}), part));
    }
    void unbalancedBracketsAtTheirColumn()
    {
        QVERIFY(isRefused(runCli({"info", "preset:SmallTree", "--set", "grammar.axiom=BB]A"}),
                          ":3: grammar.axiom"));
        QVERIFY(isRefused(runCli({"info", "preset:SmallTree", "--set", "grammar.axiom=B[BA"}),
                          ":2: grammar.axiom"));
        QVERIFY(isRefused(runCli({"info", "preset:SmallTree", "--set", "grammar.rules=B -> B\\nA -> [AB]]"}),
                          "2:10: grammar.rules"));
    }
    void rulesThatExplodeStopAtOnce()
    {
        QElapsedTimer timer;
        timer.start();
        const test::CliRun run = runCli({"info", "preset:SmallTree", "--set", "grammar.axiom=A", "--set",
                                         "grammar.rules=A -> AAAAAAAA", "--set", "grammar.iterations=30"});
        QVERIFY(isRefused(run, "64000000"));
        qInfo("refused after %lld ms", timer.elapsed());
    }
    void longTextsBecomeOneLine()
    {
        QVERIFY(isRefused(runCli({"info", "preset:a\nb"}), "a b"));
        QVERIFY(isRefused(runCli({"info", "x\ny.dae"}), "x y.dae"));
    }

    void helpAndVersionEverywhere()
    {
        const test::CliRun program = runCli({"--help"});
        QCOMPARE(program.code, 0);
        QVERIFY(program.err.isEmpty());
        QCOMPARE(runCli({"-h"}).out, program.out);
        QCOMPARE(runCli({"--version"}).out,
                 QStringLiteral("ramure-cli %1\n").arg(QLatin1String(RAMURE_VERSION)));
        for (const char* command : {"list", "info", "edit", "export", "validate", "simulate", "ik", "render",
                                    "batch", "job", "sheet"}) {
            QVERIFY(program.out.contains(QLatin1String(command)));
            const test::CliRun help = runCli({QLatin1String(command), "--help"});
            QCOMPARE(help.code, 0);
            QVERIFY(help.err.isEmpty());
            QVERIFY(help.out.startsWith(QStringLiteral("Usage: ramure-cli %1 ").arg(QLatin1String(command))));
            for (const QString& line : help.out.split(QLatin1Char('\n')))
                QVERIFY2(line.size() <= 100, qPrintable(line));
            QCOMPARE(runCli({QLatin1String(command), "--version"}).out, runCli({"--version"}).out);
            // Also where the rest makes no sense.
            QCOMPARE(runCli({QLatin1String(command), "--nonsense", "--help"}).out, help.out);
        }
    }
    void everyFormatIsToldOf()
    {
        const QString manual = runCli({"--manual"}).out, program = runCli({"--help"}).out;
        // Options may write other files beside.
        const QString exported = runCli({"export", "--help"}).out.section(QStringLiteral("Options:"), 0, 0);
        const QString info = runCli({"info", "--help"}).out;
        const QString imported = runCli({"import", "--help"}).out;
        // Those of `batch` are the reader's.
        for (const char* place : {"{read}", "{import}", "{write}", "{formats}"})
            QVERIFY(!(manual + program + runCli({"export", "--help"}).out + info + imported)
                         .contains(QLatin1String(place)));
        for (const FileFormat* format : fileFormats()) {
            const QString ending = QLatin1Char('.') + QLatin1String(format->ending);
            QVERIFY(manual.contains(ending));
            QCOMPARE(exported.contains(ending), isFor(*format, FormatUse::Write));
            QVERIFY(!isFor(*format, FormatUse::Read) || (program.contains(ending) && info.contains(ending)));
            QVERIFY(!isFor(*format, FormatUse::Read) || imported.contains(ending));
        }
    }
    void fullStandardOutput()
    {
        QProcess process;
        process.setStandardOutputFile(QStringLiteral("/dev/full"));
        process.start(QStringLiteral(RAMURE_CLI), {"info", "preset:TinyTree"});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 5);
        QVERIFY(process.readAllStandardError().contains("No space left on device"));
    }

    void presetsAreListed()
    {
        const test::CliRun run = runCli({"list", "presets", "--json"});
        QCOMPARE(run.code, 0);
        QStringList names;
        for (const QJsonValue entry : QJsonDocument::fromJson(run.out.toUtf8()).array()) {
            names << entry["name"].toString();
            QVERIFY(!entry["description"].toString().isEmpty());
            QVERIFY(!entry["group"].toString().isEmpty());
            const bool isSpecies = entry["group"] == "Broadleaved trees" || entry["group"] == "Conifers";
            QVERIFY(!isSpecies || !entry["latin"].toString().isEmpty());
            // A form is a species at one age.
            const bool grows = entry["steps"].toArray() == QJsonArray{"growth"} && entry["group"] != "Forms";
            QCOMPARE(entry["seeds"].toObject().size(), entry["latin"].toString().isEmpty() ? 0 : 6);
            QCOMPARE(entry["ages"].toObject().keys(),
                     grows ? QStringList({"mature", "old", "young"}) : QStringList());
            QCOMPARE(entry["ours"].toObject().isEmpty(), entry["latin"].toString().isEmpty());
            if (entry["name"] == "SilverBirch1995") {
                QCOMPARE(entry["published"]["height"].toDouble(), 19.0);
                QVERIFY(std::abs(entry["ours"]["crownWidth"].toDouble() - 10.7) < 1.0);
                QVERIFY(entry["source"].toString().contains("RDS-2016-0005"));
            }
            if (entry["name"] == "SilverBirch") {
                QVERIFY(entry["ours"]["leafReach"].toDouble() > entry["ours"]["leafLength"].toDouble());
                QVERIFY(entry["ours"]["leafAreaIndex"].toDouble() > 2.0);
                QCOMPARE(entry["publishedLeaves"]["leafLength"].toArray().size(), 2);
            }
            QCOMPARE(entry["source"].isString(), entry["published"].isObject());
        }
        QCOMPARE(names.mid(0, 4), (QStringList{"SmallTree", "FanTree", "TinyTree", "Fern2D"}));
        for (const char* species : {"HondaTree", "AonoKuniiTree", "TernaryTree", "QuakingAspen",
                                    "BlackTupelo", "WeepingWillow1995", "CaliforniaBlackOak"})
            QVERIFY2(names.contains(QLatin1String(species)), species);
        QCOMPARE(runCli({"list", "presets"}).out.count(QLatin1Char('\n')), names.size());
    }
    void paramsAreListed()
    {
        const QStringList expected = {"generator.kind",
                                      "weberPenn.shape",
                                      "weberPenn.ratioPower",
                                      "weberPenn.level1.downAngle",
                                      "weberPenn.level3.branches",
                                      "grammar.axiom",
                                      "grammar.rules",
                                      "grammar.iterations",
                                      "grammar.stochastic",
                                      "grammar.seed",
                                      "turtle.theta",
                                      "turtle.alpha",
                                      "turtle.decay",
                                      "simplify.enabled",
                                      "simplify.rotationThreshold",
                                      "sections.lengthDivisions",
                                      "sections.radialDivisions",
                                      "foliage.leavesCutoff",
                                      "foliage.leavesDensity",
                                      "foliage.applesProbability",
                                      "foliage.seed",
                                      "tree.translation",
                                      "tree.rotation",
                                      "tree.scale"};
        const QJsonArray rows =
            QJsonDocument::fromJson(runCli({"list", "params", "--json"}).out.toUtf8()).array();
        QStringList keys;
        for (const QJsonValue entry : rows)
            keys << entry["key"].toString();
        for (const QString& key : expected)
            QVERIFY2(keys.contains(key), qPrintable(key));
        QCOMPARE(runCli({"list", "params"}).out.count(QLatin1Char('\n')), keys.size());
        const QString page = runCli({"list", "params", "--markdown"}).out;
        for (const QString& key : keys)
            QVERIFY2(page.contains("`" + key + "`"), qPrintable(key));
        QCOMPARE(test::bytesOf(QStringLiteral(RAMURE_SOURCE_DIR "/resources/handbook/parameters.md")),
                 page.toUtf8());
    }
    /// What is listed as the default of a parameter sets it to just that.
    void listedDefaultsAreAccepted()
    {
        // The table's defaults are the faithful tree; the preset is dressed.
        const QString before =
            runCli({"info", "preset:SmallTree", "--json", "--set", "foliage.leaf=faithful", "--set",
                    "foliage.leafSize=1", "--set", "foliage.fruit=faithful", "--set", "bark.family=plain"})
                .out;
        const QJsonArray rows =
            QJsonDocument::fromJson(runCli({"list", "params", "--json"}).out.toUtf8()).array();
        QStringList arguments{"info", "preset:SmallTree", "--json"};
        for (const QJsonValue row : rows) {
            const ParamDef& def = *findParam(row["key"].toString().toStdString());
            if (isOfSteps(def) && relevanceOf(def) && !isRelevant(NodeParams(), def))
                continue; // of a source that this recipe does not begin with
            if (!hasParam(NodeKind::Tree, def) && isOfSteps(def))
                continue; // of a step that it has not
            const QJsonValue value = row["default"];
            QString text = value.isBool()     ? QString(value.toBool() ? "true" : "false")
                           : value.isDouble() ? QString::number(value.toDouble(), 'g', 17)
                                              : value.toString();
            if (value.isString())
                text.replace("\\", "\\\\").replace("\n", "\\n");
            if (value.isArray())
                text = QStringLiteral("%1,%2,%3")
                           .arg(value[0].toDouble())
                           .arg(value[1].toDouble())
                           .arg(value[2].toDouble());
            arguments << "--set" << row["key"].toString() + "=" + text;
        }
        const test::CliRun run = runCli(arguments);
        QVERIFY2(run.code == 0, qPrintable(run.err));
        QCOMPARE(run.out, before);
    }

    void infoReproducesTheReference()
    {
        QFile file(QStringLiteral(RAMURE_TEST_DATA "/skeletons.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList columns = QString::fromUtf8(file.readLine().trimmed()).split(QLatin1Char(','));
        int rows = 0;
        while (!file.atEnd()) {
            const QStringList cells = QString::fromUtf8(file.readLine().trimmed()).split(QLatin1Char(','));
            if (cells.size() != columns.size())
                continue;
            QMap<QString, QString> row;
            for (qsizetype i = 0; i < columns.size(); ++i)
                row[columns[i]] = cells[i];
            checkRow(row);
            if (QTest::currentTestFailed())
                return;
            ++rows;
        }
        QVERIFY(rows >= 30);
    }
    void infoKeysAreThoseOfTheReference()
    {
        const test::CliRun run = runCli({"info", "preset:TinyTree", "--json"});
        const QStringList shared = {"branches",  "max",    "maxChildren", "min",        "sumA1",
                                    "sumRadius", "sumTip", "terminals",   "totalLength"};
        QCOMPARE(run.keys(),
                 (QStringList{"branches",  "edits",  "leafArea", "leafAreaIndex", "leafLength",
                              "leafReach", "leaves", "max",      "maxChildren",   "measures",
                              "min",       "nodes",  "shed",     "simplified",    "sumA1",
                              "sumRadius", "sumTip", "symbols",  "terminals",     "totalLength"}));
        QCOMPARE(run.json()["simplified"].toObject().keys(), shared);
    }
    void axesAreListedFromTheGround()
    {
        QVERIFY(!runCli({"info", "preset:TinyTree", "--json"}).json().contains("axes"));
        const QJsonObject run = runCli({"info", "preset:TinyTree", "--json", "--axes"}).json();
        QCOMPARE(run["edits"].toObject(), (QJsonObject{{"matched", 0}, {"placed", 0}, {"unplaced", 0}}));
        QMap<QString, QJsonObject> seen;
        double length = 0.0;
        for (const QJsonValue& value : run["axes"].toArray()) {
            const QJsonObject axis = value.toObject();
            QCOMPARE(axis["id"].toString().size(), 16);
            QVERIFY(!seen.contains(axis["id"].toString()));
            QCOMPARE(axis["parent"].isNull(), axis["order"].toInt() == 0);
            if (!axis["parent"].isNull()) {
                const QJsonObject parent = seen.value(axis["parent"].toString());
                QCOMPARE(axis["order"].toInt(), parent["order"].toInt(-7) + 1);
                QVERIFY(axis["s"].toDouble() <= parent["length"].toDouble() + 1e-9);
                QVERIFY(axis["radius"].toDouble() <= parent["radius"].toDouble() + 1e-9);
            }
            QVERIFY(axis["downAngle"].toDouble() >= 0.0 && axis["downAngle"].toDouble() < 3.15);
            length += axis["length"].toDouble();
            seen[axis["id"].toString()] = axis;
        }
        QVERIFY(seen.size() > 50);
        QVERIFY(std::abs(length - run["totalLength"].toDouble()) <
                1e-6 * length); // each branch is on one axis
    }
    void presetsAreDeterministicUnlessAsked()
    {
        const QStringList command = {"info", "preset:SmallTree", "--json"};
        QCOMPARE(runCli(command).out, runCli(command).out);
        QCOMPARE(runCli(command + QStringList{"--set", "grammar.seed=7"}).out, runCli(command).out);
        const QStringList stochastic = command + QStringList{"--set", "grammar.stochastic=true"};
        QCOMPARE(runCli(stochastic).out, runCli(stochastic).out);
        QVERIFY(runCli(stochastic).out != runCli(command).out);
        QVERIFY(runCli(stochastic + QStringList{"--set", "grammar.seed=7"}).out != runCli(stochastic).out);
    }
    void badProjectFiles()
    {
        std::mt19937 random(4);
        const QString file = path("tree.ramure");
        test::write(file, "");
        QVERIFY(isRefused(runCli({"info", file}), "tree.ramure"));
        QByteArray noise(500, '\0');
        for (char& c : noise)
            c = static_cast<char>(random());
        test::write(file, noise);
        QVERIFY(isRefused(runCli({"info", file}), "tree.ramure"));
        const QByteArray good =
            R"({"format": "ramure", "nodes": [{"id": 1, "kind": "tree", "name": "Oak"}], "version": 1})";
        test::write(file, good);
        QCOMPARE(runCli({"info", file}).code, 0);
        for (const qsizetype length : {qsizetype(1), good.size() / 2, good.size() - 1}) {
            test::write(file, good.left(length));
            QVERIFY(isRefused(runCli({"info", file}), "tree.ramure"));
        }
        test::write(file, QByteArray(good).replace("\"version\": 1", "\"version\": 99"));
        QVERIFY(isRefused(runCli({"validate", file}), "newer"));
        test::write(file, QByteArray(good).replace("\"tree\"", "7"));
        QVERIFY(isRefused(runCli({"info", file}), "nodes[0].kind"));
        // Only a newer version knows this kind of node: it stays, and grows nothing.
        test::write(file, QByteArray(good).replace("tree\"", "teapot\""));
        QVERIFY(isRefused(runCli({"info", file}), "the project holds no tree"));
        test::write(file, R"({"format": "ramure", "nodes": [], "version": 1})");
        QVERIFY(isRefused(runCli({"info", file}), "the project holds no tree"));
        QVERIFY(isRefused(runCli({"info", m_folder.path() + "/none.ramure"}), "none.ramure"));
    }
    void infoOfSeveralTrees()
    {
        const QString file = path("two.ramure");
        test::write(file, R"({"format": "ramure", "version": 1, "nodes": [
            {"id": 1, "kind": "group", "name": "Grove", "params": {"tree.translation": [10, 0, 0]}},
            {"id": 2, "kind": "tree", "name": "Oak", "parent": 1, "params": {"grammar.iterations": 2}},
            {"id": 3, "kind": "tree", "name": "Elm", "params": {"grammar.iterations": 1}}]})");
        const test::CliRun run = runCli({"info", file, "--json"});
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const QJsonObject all = run.json();
        QCOMPARE(all["branches"].toInt(), 60);
        QCOMPARE(all["symbols"].toInt(), 248);
        QCOMPARE(all["trees"][0]["name"].toString(), QString("Oak"));
        QCOMPARE(all["trees"][1]["simplified"]["branches"].toInt(), 13);
        QVERIFY(std::abs(all["max"][0].toDouble() - 10.28952) < 1e-4);
        QVERIFY(std::abs(all["min"][0].toDouble() - -0.42536) < 1e-4);
        QVERIFY(runCli({"info", file}).out.contains("2 trees"));
        // --set reaches all of them; an error names the tree.
        QCOMPARE(runCli({"info", file, "--json", "--set", "grammar.iterations=0"}).json()["branches"].toInt(),
                 12);
        QVERIFY(isRefused(runCli({"info", file, "--set", "grammar.axiom=]"}), "Oak: grammar.axiom"));
    }

private:
    static void checkRow(const QMap<QString, QString>& row)
    {
        QStringList arguments{"info", "preset:" + row["preset"], "--json"};
        if (row["preset"] != "TinyTree") // a fixed string: nothing to iterate
            arguments << "--set"
                      << "grammar.iterations=" + row["iterations"];
        const test::CliRun run = runCli(arguments);
        QVERIFY2(run.code == 0, qPrintable(run.err));
        const QJsonObject info = run.json();
        const QJsonObject simplified = info["simplified"].toObject();
        const auto isNear = [&](const QJsonValue& value, const char* column) {
            return std::abs(value.toDouble() - row[QLatin1String(column)].toDouble()) <= 1e-4;
        };
        for (const char* key : {"symbols", "branches", "terminals", "maxChildren"})
            QCOMPARE(QString::number(info[QLatin1String(key)].toInt()), row[QLatin1String(key)]);
        QCOMPARE(QString::number(simplified["branches"].toInt()), row["simplifiedBranches"]);
        QCOMPARE(QString::number(simplified["terminals"].toInt()), row["simplifiedTerminals"]);
        QCOMPARE(QString::number(simplified["maxChildren"].toInt()), row["simplifiedMaxChildren"]);
        QVERIFY(isNear(info["totalLength"], "totalLength") && isNear(info["sumA1"], "sumA1"));
        QVERIFY(isNear(simplified["totalLength"], "simplifiedTotalLength"));
        QVERIFY(isNear(simplified["sumA1"], "simplifiedSumA1"));
        QVERIFY(isNear(info["min"][0], "minX") && isNear(info["min"][1], "minY") &&
                isNear(info["min"][2], "minZ"));
        QVERIFY(isNear(info["max"][0], "maxX") && isNear(info["max"][1], "maxY") &&
                isNear(info["max"][2], "maxZ"));
    }
};

RAMURE_SUITE(TestRamureCli)

} // namespace tst_ramure_cli

#include "tst_ramure_cli.moc"
