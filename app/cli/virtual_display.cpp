#include "app/cli/virtual_display.h"
#include <QDeadlineTimer>
#include <csignal>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xcb/xcb.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace ramure::cli {

namespace {

constexpr int startMs = 20'000;
constexpr int answerMs = 5'000; ///< a server on another machine may not be there at all

/// Asked by another process: a connection that nobody answers could not be given up.
bool displayAnswers()
{
    int told[2];
    if (qEnvironmentVariableIsEmpty("DISPLAY") || ::pipe(told) != 0)
        return false;
    const pid_t asker = ::fork();
    if (asker == 0) {
        const char isThere = xcb_connection_has_error(xcb_connect(nullptr, nullptr)) == 0 ? 1 : 0;
        ::_exit(::write(told[1], &isThere, 1) == 1 ? 0 : 1);
    }
    ::close(told[1]);
    pollfd waited{told[0], POLLIN, 0};
    char isThere = 0;
    if (asker < 0 || ::poll(&waited, 1, answerMs) != 1 || ::read(told[0], &isThere, 1) != 1)
        isThere = 0;
    ::close(told[0]);
    if (asker > 0) {
        ::kill(asker, SIGKILL);
        ::waitpid(asker, nullptr, 0);
    }
    return isThere != 0;
}

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
    if (displayAnswers())
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
    // The server chooses a free number and writes it to its standard output. Without -noreset it begins anew
    // whenever its last client leaves, and drops those that come in the meantime.
    m_server.start(QStringLiteral("Xvfb"),
                   {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                    QStringLiteral("0"), QStringLiteral("640x480x24"), QStringLiteral("-nolisten"),
                    QStringLiteral("tcp"), QStringLiteral("-noreset")});
    if (!m_server.waitForStarted(startMs))
        return fail(ErrorCode::Unknown,
                    "there is no display%1, and Xvfb, which stands in for one, cannot be started (Debian "
                    "package xvfb)",
                    {qEnvironmentVariableIsEmpty("DISPLAY")
                         ? std::string()
                         : " that answers at DISPLAY=" + qgetenv("DISPLAY").toStdString()});
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
