#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/widgets/base/fixture.h"
#include "widgets/actions/import_actions.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>

namespace ramure {

extern const FileFormat objFormat, plyFormat, plyTextFormat, animationFormat;

static Expected<ReadMesh> readNothing(const std::string&, const Progress&)
{
    return fail(ErrorCode::Io, "nothing");
}

static Expected<BlenderImport> importNothing(const std::string&, const ImportOptions&, const Progress&)
{
    return fail(ErrorCode::Io, "nothing");
}

static Expected<void> writeCount(const std::string& path, const ExportScene& scene, const WriteOptions&,
                                 const Progress&)
{
    QFile file(QFile::decodeName(path.c_str()));
    if (!file.open(QIODevice::WriteOnly))
        return fail(ErrorCode::Io, "no file");
    file.write(QByteArray::number(int(scene.meshes.size())));
    return {};
}

static FileRates noRates(bool, double)
{
    return {};
}

static const FileFormat fake = {.id = "fake",
                                .ending = "fake",
                                .name = "Fake files",
                                .choice = "Fake",
                                .holds = holdsObjects,
                                .read = &readNothing,
                                .import = &importNothing,
                                .write = &writeCount,
                                .rates = &noRates};

/// In the place of the program's own table: a row more.
std::span<const FileFormat* const> fileFormats()
{
    static constexpr const FileFormat* table[] = {&objFormat, &plyFormat, &plyTextFormat, &animationFormat,
                                                  &fake};
    return table;
}

} // namespace ramure

using namespace ramure;

namespace {

/// Keeps the filter that it is asked with.
class FilterChooser : public test::FakeChooser
{
public:
    QString saveFile(const QString&, const QString&, const QString& wanted, const QString& ending) override
    {
        filter = wanted;
        suffix = ending;
        return {};
    }

    QString filter, suffix;
};

} // namespace

/// One row more in the table of formats: the dialogs have it, with nothing else told of it.
class TestExportFormats : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        test::failOnWidgetWarning();
        test::openNodes(m_document, {test::treeNode(1, "T")});
        QVERIFY(m_recompute.waitForFull(test::patience(20'000)));
    }

    void everyRowIsOffered()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        QStringList ids;
        const auto* list = dialog.findChild<QComboBox*>(QStringLiteral("exportFormat"));
        for (int row = 0; row < list->count(); ++row) {
            QVERIFY(!list->itemText(row).isEmpty());
            ids += list->itemData(row).toString();
        }
        QCOMPARE(ids, (QStringList{"obj", "ply", "ply-text", "fake"}));
        for (const FileFormat* format : fileFormats()) {
            if (!isFor(*format, FormatUse::Write))
                continue;
            dialog.setFormat(QString::fromLatin1(format->id));
            QVERIFY(dialog.path().endsWith(u'.' + QString::fromLatin1(format->ending)));
        }
    }
    void whatAFormatHoldsIsWhatIsAsked()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setFormat(QStringLiteral("fake"));
        QVERIFY(!dialog.findChild<QCheckBox*>(QStringLiteral("exportTexture"))->isEnabled());
        QVERIFY(dialog.findChild<QComboBox*>(QStringLiteral("exportUp"))->isHidden());
        QVERIFY(!dialog.options().texture);
        QCOMPARE(dialog.options().parts, std::uint8_t(exportAll));
        dialog.setFormat(QStringLiteral("ply"));
        QVERIFY(!dialog.findChild<QComboBox*>(QStringLiteral("exportUp"))->isHidden());
        QVERIFY(dialog.options().texture);
        QCOMPARE(dialog.options().parts, std::uint8_t(exportBranches));
    }
    void itIsBrowsedForAndWritten()
    {
        ExportDialog dialog(&m_document, &m_recompute, &m_preferences, &m_chooser);
        dialog.setFormat(QStringLiteral("fake"));
        for (QPushButton* button : dialog.findChildren<QPushButton*>())
            if (button->text() == QStringLiteral("Browse…"))
                button->click();
        QCOMPARE(m_chooser.filter, QStringLiteral("Fake files (*.fake)"));
        QCOMPARE(m_chooser.suffix, QStringLiteral("fake"));
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        QTemporaryDir folder;
        dialog.setPath(folder.filePath(QStringLiteral("tree.fake")));
        dialog.startExport();
        QTRY_COMPARE(exported.count(), 1);
        QFile file(folder.filePath(QStringLiteral("tree.fake")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("1"));
    }
    void itIsOpenedDroppedAndImported()
    {
        QVERIFY(ImportActions::canImport(QStringLiteral("tree.Fake")));
        QVERIFY(!ImportActions::canImport(QStringLiteral("tree.unknown")));
        QVERIFY(ImportActions::fileFilter().contains(QStringLiteral("*.obj *.ply *.animation *.fake")));
    }

private:
    test::OwnSettings m_settings;
    Preferences m_preferences;
    Document m_document;
    Recompute m_recompute{&m_document};
    FilterChooser m_chooser;
};

QTEST_MAIN(TestExportFormats)
#include "tst_export_formats.moc"
