#include "app/cli/virtual_display.h"
#include <QDeadlineTimer>
#include <csignal>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace ramure::cli {

namespace {

constexpr int startMs = 20'000;

} // namespace

VirtualDisplay::~VirtualDisplay()
{
    if (m_server.state() == QProcess::NotRunning)
        return;
    m_server.terminate();
    if (!m_server.waitForFinished(5000))
        m_server.kill();
    m_server.waitForFinished(5000);
}

Expected<void> VirtualDisplay::ensure()
{
    if (!qEnvironmentVariableIsEmpty("DISPLAY"))
        return {};
    m_server.setChildProcessModifier([] {
        // It would inherit that we block the signals that a thread of ours waits for, and never end.
        sigset_t none;
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
#ifdef __linux__
        ::prctl(PR_SET_PDEATHSIG, SIGTERM); // does not outlive us, however we end
#endif
    });
    m_server.setStandardErrorFile(QProcess::nullDevice());
    // The server chooses a free number and writes it to its standard output.
    m_server.start(QStringLiteral("Xvfb"),
                   {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                    QStringLiteral("0"), QStringLiteral("640x480x24"), QStringLiteral("-nolisten"),
                    QStringLiteral("tcp")});
    if (!m_server.waitForStarted(startMs))
        return fail(ErrorCode::Unknown, "there is no display, and Xvfb, which stands in for one, cannot be "
                                        "started (Debian package xvfb)");
    const QDeadlineTimer deadline(startMs);
    QByteArray number;
    while (!number.endsWith('\n')) {
        if (!m_server.waitForReadyRead(static_cast<int>(deadline.remainingTime())))
            return fail(ErrorCode::Unknown,
                        "Xvfb, which stands in for a display, has ended or does not answer");
        number += m_server.readAllStandardOutput();
    }
    qputenv("DISPLAY", ":" + number.trimmed());
    return {};
}

} // namespace ramure::cli
