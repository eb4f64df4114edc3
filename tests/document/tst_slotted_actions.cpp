// The export script on what Blender 4.4 and later have, actions with slots, by stand-ins in plain Python: no
// Debian has such a Blender yet.
#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"

#include <QProcess>
#include <QStandardPaths>

namespace tst_slotted_actions {

using namespace ramure;

class TestSlottedActions : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnAnyWarning(); }

    void theScriptReadsThem()
    {
        const QString python = QStandardPaths::findExecutable(QStringLiteral("python3"));
        if (python.isEmpty())
            RAMURE_CANNOT_RUN("no Python on this machine");
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(python, {QStringLiteral("-B"), QStringLiteral(RAMURE_TEST_DATA "/slotted_actions.py"),
                               QStringLiteral(RAMURE_SOURCE_DIR "/resources/blender/ramure_export.py")});
        QVERIFY(process.waitForFinished(60'000));
        const QByteArray said = process.readAll();
        QVERIFY2(process.exitCode() == 0 && said.contains("well"), said.constData());
    }
};

RAMURE_SUITE(TestSlottedActions)

} // namespace tst_slotted_actions

#include "tst_slotted_actions.moc"
