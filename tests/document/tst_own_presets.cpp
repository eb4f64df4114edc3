#include "core/qt/document/project/own_presets.h"

#include "core/params/param_def.h"
#include "core/scene/preset_scene.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace tst_own_presets {

using namespace ramure;

/// Trees that were kept.
class TestOwnPresets : public QObject
{
    Q_OBJECT

    static void write(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void namesThatNoFileCanHave_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"", " ", "a/b", "..", ".hidden", "a\\b", "a:b", "what?", "a*", "\"a\"",
                                 "<a>", "a|b", " a", "a\n"})
            QTest::newRow(name) << QString::fromLatin1(name);
        QTest::newRow("long") << QString(OwnPresets::longestName + 1, u'a');
    }
    void namesThatNoFileCanHave()
    {
        QFETCH(const QString, name);
        QTemporaryDir folder;
        const OwnPresets presets(folder.path() + "/presets");
        QVERIFY(presets.save("Oak", *presetTree("EnglishOak1995")));
        for (const auto& done : {presets.save(name, *presetTree("TinyTree")), presets.rename("Oak", name)}) {
            QVERIFY(!done);
            QCOMPARE(done.error().code, ErrorCode::Invalid);
        }
        QCOMPARE(presets.names(), QStringList{"Oak"});
        QCOMPARE(QDir(folder.path()).entryList(QDir::NoDotAndDotDot | QDir::AllEntries),
                 QStringList{"presets"});
    }
    void filesThatAreNoTrees()
    {
        QTemporaryDir folder;
        const OwnPresets presets(folder.path());
        write(folder.path() + "/cut.ramure", "{\"format\": \"ramure\", \"no");
        write(folder.path() + "/empty.ramure", "{\"format\": \"ramure\", \"version\": 3}");
        write(folder.path() + "/notes.txt", "no preset");
        QCOMPARE(presets.names(), (QStringList{"cut", "empty"}));
        for (const char* name : {"cut", "empty", "missing"}) {
            const auto tree = presets.load(name);
            QVERIFY(!tree);
            QVERIFY2(tree.error().message().find(name) != std::string::npos, tree.error().message().c_str());
        }
    }
    void nothingIsOverwritten()
    {
        QTemporaryDir folder;
        const OwnPresets presets(folder.path());
        QVERIFY(presets.save("Oak", *presetTree("EnglishOak1995")));
        QVERIFY(presets.save("Birch", *presetTree("SilverBirch1995")));
        QVERIFY(!presets.save("Oak", *presetTree("TinyTree")));
        QVERIFY(!presets.rename("Birch", "Oak"));
        QVERIFY(presets.load("Oak")->params == presetTree("EnglishOak1995")->params);
        QCOMPARE(presets.freeName("Oak"), QStringLiteral("Oak 2"));
        QCOMPARE(presets.freeName("Elm"), QStringLiteral("Elm"));
    }
    void foldersThatTakeNothing()
    {
        QTemporaryDir folder;
        write(folder.path() + "/file", "");
        const auto saved =
            OwnPresets(folder.path() + "/file/presets").save("Oak", *presetTree("EnglishOak1995"));
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, ErrorCode::Io);
        QVERIFY(OwnPresets(folder.path() + "/none").names().isEmpty());
    }
    /// Whatever a tree is, but for where it stands.
    void aKeptTreeIsTheSame()
    {
        QTemporaryDir folder;
        const OwnPresets presets(folder.path());
        Node tree = *presetTree("SilverBirch1995");
        tree.id = 7;
        tree.locked = true;
        tree.params.grammar.seed = 42;
        tree.params.tree.translation = {3.0, 0.0, 1.0};
        QVERIFY(presets.save("Éric’s birch 10", tree));
        const auto kept = presets.load("Éric’s birch 10");
        QVERIFY(kept);
        tree.params.tree = {};
        QVERIFY(kept->params == tree.params);
        QVERIFY(!kept->locked && kept->id == noNode);
        QCOMPARE(QString::fromStdString(kept->name), QStringLiteral("Éric’s birch 10"));
        QVERIFY(presets.save("Éric’s birch 9", tree));
        QCOMPARE(presets.names().first(), QStringLiteral("Éric’s birch 9")); // as people count
    }
    void picturesGoWithTheirTrees()
    {
        QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("data")));
        qputenv("XDG_DATA_HOME", folder.filePath("data").toUtf8()); // of the trash
        const OwnPresets presets(folder.filePath("presets"));
        QVERIFY(presets.save("Oak", *presetTree("EnglishOak1995")));
        write(presets.pictureFile("Oak"), "picture");
        QVERIFY(presets.rename("Oak", "Elm"));
        QVERIFY(QFile::exists(presets.pictureFile("Elm")) && !QFile::exists(presets.pictureFile("Oak")));
        QVERIFY(!presets.rename("Oak", "Ash"));
        QVERIFY(presets.remove("Elm"));
        QVERIFY(presets.names().isEmpty() && !QFile::exists(presets.pictureFile("Elm")));
        QVERIFY(!presets.remove("Elm"));
    }
    void treesAreNamedByWhereTheyAre()
    {
        QTemporaryDir folder;
        qputenv("XDG_DATA_HOME", folder.path().toUtf8());
        QVERIFY(namedTree("TinyTree")->params == presetTree("TinyTree")->params);
        QVERIFY(!namedTree("own:Oak") && !namedTree("NoSuchTree"));
        QVERIFY(OwnPresets().save("Oak", *presetTree("EnglishOak1995")));
        QVERIFY(namedTree("own:Oak")->params == presetTree("EnglishOak1995")->params);
    }
};

RAMURE_SUITE(TestOwnPresets)

} // namespace tst_own_presets

#include "tst_own_presets.moc"
