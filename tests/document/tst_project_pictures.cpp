#include "core/qt/document/project/project_file.h"
#include "core/scene/preset_scene.h"
#include "tests/support/suite.h"
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace tst_project_pictures {

using namespace ramure;

/// Paths of pictures: relative in files, absolute in the program.
class TestProjectPictures : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    static Project withPicture(const QString& picture)
    {
        Project project{presetScene("TinyTree").value(), {}};
        Scene& scene = project.scene;
        scene.find(scene.nodes().front().id)->params.barkPictures.colour =
            QFile::encodeName(picture).toStdString();
        return project;
    }
    static QString pictureOf(const Project& project)
    {
        return QFile::decodeName(project.scene.nodes().front().params.barkPictures.colour.c_str());
    }

private slots:
    void init() { test::failOnAnyWarning(); }

    void aProjectMovesWithItsPictures()
    {
        QVERIFY(QDir().mkpath(path("a/maps")) && QDir().mkpath(path("b")));
        QVERIFY(saveProjectFile(withPicture(path("a/maps/bark.png")), path("a/tree.ramure")));
        QFile file(path("a/tree.ramure"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"bark.colourPicture\": \"maps/bark.png\""));
        QVERIFY(file.copy(path("b/tree.ramure")));
        QCOMPARE(pictureOf(loadProjectFile(path("a/tree.ramure")).value()), path("a/maps/bark.png"));
        QCOMPARE(pictureOf(loadProjectFile(path("b/tree.ramure")).value()), path("b/maps/bark.png"));
    }
    void aMissingPictureKeepsItsPath()
    {
        QVERIFY(saveProjectFile(withPicture(path("gone/bark é.png")), path("tree.ramure")));
        const Project once = loadProjectFile(path("tree.ramure")).value();
        QCOMPARE(pictureOf(once), path("gone/bark é.png"));
        QVERIFY(saveProjectFile(once, path("again.ramure")));
        QCOMPARE(loadProjectFile(path("again.ramure")).value().scene, once.scene);
    }
    void relativePathsStartAtTheWorkingFolder()
    {
        QVERIFY(saveProjectFile(withPicture(QStringLiteral("here.png")), path("tree.ramure")));
        QCOMPARE(pictureOf(loadProjectFile(path("tree.ramure")).value()),
                 QDir::current().absoluteFilePath(QStringLiteral("here.png")));
    }
};

RAMURE_SUITE(TestProjectPictures)

} // namespace tst_project_pictures

#include "tst_project_pictures.moc"
