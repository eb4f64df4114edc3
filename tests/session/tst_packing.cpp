#include "core/qt/session/export/packing.h"

#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_file.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace tst_packing {

using namespace ramure;

class TestPacking : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    void write(const char* name, const QByteArray& bytes) const
    {
        QVERIFY(QDir().mkpath(QFileInfo(path(name)).path()));
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    static QByteArray bytesOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
    }
    static std::string worn(const Document& document, NodeId node, const char* key)
    {
        return std::get<std::string>(findParam(key)->get(document.scene().find(node)->params));
    }
    /// Two trees and a box, project in the folder "project".
    void open(Document& document, const QString& bark, const QString& leaf, const QString& box) const
    {
        std::vector<Node> nodes(3);
        for (NodeId id = 1; id <= 3; ++id) {
            nodes[id - 1].id = id;
            nodes[id - 1].name = "Node " + std::to_string(id);
            nodes[id - 1].kind = id == 3 ? NodeKind::Primitive : NodeKind::Tree;
            nodes[id - 1].params.barkPictures.colour = QFile::encodeName(bark).toStdString();
        }
        nodes[1].params.leafPictures.opacity = QFile::encodeName(leaf).toStdString();
        nodes[2].params.barkPictures.colour.clear();
        nodes[2].params.surfacePictures.colour = QFile::encodeName(box).toStdString();
        document.reset(*Scene::fromNodes(std::move(nodes)), path("project/oak.ramure"));
    }

private slots:
    void init()
    {
        test::failOnAnyWarning();
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir().mkpath(path("project")));
    }

    void aSceneWithoutAFileIsRefused()
    {
        Document document;
        const auto packed = edit::packPictures(document);
        QVERIFY(!packed);
        QVERIFY(packed.error().message().find("save it first") != std::string::npos);
    }
    void aMissingPictureIsNamedAndNothingChanges()
    {
        write("elsewhere/bark.png", "bark");
        Document document;
        open(document, path("elsewhere/bark.png"), path("elsewhere/gone.png"), {});
        const Scene before = document.scene();
        const auto packed = edit::packPictures(document);
        QVERIFY(!packed);
        QCOMPARE(QString::fromStdString(packed.error().file), path("elsewhere/gone.png"));
        QVERIFY(document.scene() == before);
        QCOMPARE(document.undoStack()->count(), 0);
    }
    void lockedNodesAreNamed()
    {
        write("elsewhere/bark.png", "bark");
        Document document;
        open(document, path("elsewhere/bark.png"), {}, {});
        QVERIFY(edit::setNodeLocked(document, {2}, true));
        const auto packed = edit::packPictures(document);
        QVERIFY(!packed);
        QVERIFY(packed.error().message().find("Node 2") != std::string::npos);
        QVERIFY(!QDir(packedFolder(document.filePath())).exists());
    }
    void everyPictureComesAlongOnce()
    {
        write("elsewhere/bark.png", "bark");
        write("other/bark.png", "another bark");
        write("project/own.png", "own");
        Document document;
        open(document, path("elsewhere/bark.png"), path("project/own.png"), path("other/bark.png"));
        const Scene before = document.scene();
        const auto packed = edit::packPictures(document);
        QVERIFY2(packed, test::why(packed));
        QCOMPARE(*packed, std::size_t(2));
        QCOMPARE(document.undoStack()->count(), 1);
        const QDir folder(packedFolder(document.filePath()));
        QCOMPARE(folder.dirName(), QStringLiteral("oak pictures"));
        QCOMPARE(folder.entryList(QDir::Files), (QStringList{"bark-2.png", "bark.png"}));
        QCOMPARE(bytesOf(QFile::decodeName(worn(document, 1, "bark.colourPicture").c_str())),
                 QByteArray("bark"));
        QCOMPARE(worn(document, 1, "bark.colourPicture"), worn(document, 2, "bark.colourPicture"));
        QCOMPARE(bytesOf(QFile::decodeName(worn(document, 3, "surface.colourPicture").c_str())),
                 QByteArray("another bark"));
        QCOMPARE(QString::fromStdString(worn(document, 2, "foliage.leafOpacityPicture")),
                 path("project/own.png"));

        // Again there is nothing to do; after undo the copies that lie there are taken.
        QCOMPARE(edit::packPictures(document).value_or(9), std::size_t(0));
        document.undo();
        QVERIFY(document.scene() == before);
        QCOMPARE(edit::packPictures(document).value_or(0), std::size_t(2));
        QCOMPARE(folder.entryList(QDir::Files).size(), 2);

        // The folder can be moved: the project names them relative to itself.
        QVERIFY(saveProjectFile(document.project(), document.filePath()));
        QVERIFY(QDir().rename(path("project"), path("moved")));
        const auto read = loadProjectFile(path("moved/oak.ramure"));
        QVERIFY2(read, test::why(read));
        const std::string bark = read->scene.find(1)->params.barkPictures.colour;
        QCOMPARE(bytesOf(QFile::decodeName(bark.c_str())), QByteArray("bark"));
    }
};

RAMURE_SUITE(TestPacking)

} // namespace tst_packing

#include "tst_packing.moc"
