#include "tests/support/failing_disk.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/picture_file.h"
#include <QTemporaryDir>

namespace tst_picture_file {

using namespace ramure;

namespace {

QImage picture(int version)
{
    QImage image(40, 30, QImage::Format_RGB32);
    image.fill(version == 0 ? Qt::red : Qt::green);
    return image;
}

} // namespace

class TestPictureFile : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void whatIsNoPictureIsRefused()
    {
        QTemporaryDir folder;
        const auto path = [&folder](const char* name) {
            return folder.filePath(QLatin1String(name)).toStdString();
        };
        for (const char* name : {"tree", "tree.", "tree.nothing", ".png/tree"}) {
            const auto saved = savePicture(picture(0), path(name));
            QVERIFY(!saved);
            QCOMPARE(saved.error().code, ErrorCode::Unknown);
            QCOMPARE(saved.error().file, path(name));
        }
        QCOMPARE(savePicture(QImage(), path("x.png")).error().code, ErrorCode::Unknown);
        QCOMPARE(savePicture(picture(0), path("none/x.png")).error().code, ErrorCode::Io);
        QVERIFY(test::filesIn(folder.path()).isEmpty());
    }
    void endingsChooseTheFormat()
    {
        QTemporaryDir folder;
        for (const char* name : {"a.png", "a.JPG", "a.b.bmp"}) {
            const QString path = folder.filePath(QLatin1String(name));
            const auto saved = savePicture(picture(0), path.toStdString());
            QVERIFY2(saved, test::why(saved));
            QCOMPARE(QImage(path).size(), QSize(40, 30));
        }
        QCOMPARE(QImage(folder.filePath(QStringLiteral("a.png"))), picture(0));
    }
    void oldPicturesSurviveEveryError()
    {
        test::checkNothingLost([](const QString& folder, int version) {
            return savePicture(picture(version), folder.toStdString() + "/a.png");
        });
    }
};

RAMURE_SUITE(TestPictureFile)

} // namespace tst_picture_file

#include "tst_picture_file.moc"
