#include "tests/widgets/base/fixture.h"
#include "tests/widgets/base/input.h"
#include "widgets/panels/properties/picture_editor.h"
#include <QFileDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

namespace tst_picture_editor {

using namespace ramure;

class TestPictureEditor : public QObject
{
    Q_OBJECT
    test::OwnSettings m_settings;
    QTemporaryDir m_folder;
    std::unique_ptr<PictureEditor> m_editor;
    std::vector<std::string> m_edits;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    void show(const QString& picture)
    {
        const ParamValue value(QFile::encodeName(picture).toStdString());
        m_editor->showValues({&value, 1});
    }
    bool drop(const QList<QUrl>& urls) { return test::dropFiles(m_editor.get(), urls); }

private slots:
    void init()
    {
        test::failOnWidgetWarning();
        m_editor = std::make_unique<PictureEditor>(*findParam("bark.colourPicture"), nullptr);
        m_edits.clear();
        connect(m_editor.get(), &ParamEditor::valueEdited, this,
                [this](const ParamValue& value) { m_edits.push_back(std::get<std::string>(value)); });
        m_editor->show();
    }
    void cleanup() { m_editor.reset(); }

    void otherFilesAreNotTaken()
    {
        QVERIFY(!drop({}));
        QVERIFY(!drop({QUrl::fromLocalFile(path("tree.ramure"))}));
        QVERIFY(!drop({QUrl(QStringLiteral("https://example.org/bark.png"))}));
        QVERIFY(!drop({QUrl::fromLocalFile(path("a.png")), QUrl::fromLocalFile(path("b.png"))}));
        QVERIFY(m_edits.empty());
    }
    void whatCannotBeReadIsTold()
    {
        QSignalSpy refused(m_editor.get(), &ParamEditor::refused);
        show(path("gone.png"));
        QTRY_VERIFY(!refused.isEmpty() && !refused.last().at(0).toString().isEmpty());
        QVERIFY(m_editor->thumbnail().isNull());
        QCOMPARE(m_editor->findChild<QLineEdit*>()->text(), path("gone.png")); // it keeps its path
        show(QString());
        QVERIFY(refused.last().at(0).toString().isEmpty());
    }
    void aPictureIsDroppedAndSeen()
    {
        QImage red(80, 40, QImage::Format_RGB32);
        red.fill(Qt::red);
        QVERIFY(red.save(path("red.png")));
        QVERIFY(drop({QUrl::fromLocalFile(path("red.png"))}));
        QCOMPARE(m_edits, std::vector{QFile::encodeName(path("red.png")).toStdString()});
        show(path("red.png"));
        QTRY_VERIFY(!m_editor->thumbnail().isNull());
        QCOMPARE(m_editor->thumbnail().pixelColor(3, 3), QColor(Qt::red));
        QVERIFY(m_editor->thumbnail().width() <= 80);
        show(QString());
        QVERIFY(m_editor->thumbnail().isNull());
    }
    void itIsTypedOrChosen()
    {
        auto* field = m_editor->findChild<QLineEdit*>();
        field->setFocus();
        QTest::keyClicks(field, "/maps/bark.jpg");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_edits, std::vector<std::string>{"/maps/bark.jpg"});
        m_editor->button()->setFocus();
        QTest::keyClick(m_editor->button(), Qt::Key_Space);
        QPointer<QFileDialog> dialog = m_editor->window()->findChild<QFileDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        dialog->reject();
        QTRY_VERIFY(!dialog);
        QCOMPARE(m_edits.size(), std::size_t(1));
    }
    void differentPicturesShowNone()
    {
        const ParamValue values[] = {std::string("/a.png"), std::string("/b.png")};
        m_editor->showValues(values);
        QVERIFY(m_editor->findChild<QLineEdit*>()->text().isEmpty());
        QCOMPARE(m_editor->findChild<QLineEdit*>()->placeholderText(), QStringLiteral("—"));
    }
};

RAMURE_SUITE(TestPictureEditor)

} // namespace tst_picture_editor

#include "tst_picture_editor.moc"
