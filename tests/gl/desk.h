/// \file
/// The real program as a user has it: its own process on a real X server with a window manager (openbox),
/// driven by real keys and a real mouse (xdotool). What it does is seen from outside: titles of windows,
/// pictures of the screen, the clipboard, files.
#pragma once

#include "tests/support/suite.h"
#include "tests/support/waits.h"
#include <QFile>
#include <QGuiApplication>
#include <QPixmap>
#include <QProcess>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QThread>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

namespace ramure::test {

constexpr int deskPatienceMs = 60'000; ///< on a busy machine; a good run waits for nothing that long

/// Looks again and again until \p holds, with the events of this program handled in between.
inline bool eventually(const std::function<bool()>& holds, int milliseconds = deskPatienceMs)
{
    return QTest::qWaitFor(holds, milliseconds);
}

/// What xdotool prints, without the last line end; nothing where it failed.
inline QString xdo(const QStringList& arguments)
{
    QProcess tool;
    tool.start(QStringLiteral("xdotool"), arguments);
    if (!tool.waitForFinished(deskPatienceMs) || tool.exitCode() != 0)
        return {};
    return QString::fromUtf8(tool.readAllStandardOutput()).trimmed();
}

/// What the editor is to find in its home at the start: English, no welcome page, no tour. Only the owner may
/// look.
inline void prepareHome(const QTemporaryDir& home, std::optional<double> autosaveMinutes = {})
{
    QFile::setPermissions(home.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QSettings settings(home.filePath(QStringLiteral("Ramure/ramure.conf")), QSettings::IniFormat);
    settings.setValue(QStringLiteral("view/language"), QStringLiteral("en"));
    settings.setValue(QStringLiteral("view/welcomeAtStart"), false);
    settings.setValue(QStringLiteral("window/tourSeen"), true);
    if (autosaveMinutes)
        settings.setValue(QStringLiteral("files/autosaveMinutes"), *autosaveMinutes);
    settings.sync();
}

/// The window manager, while this object lives.
class Desk
{
public:
    Desk()
    {
        m_manager.setStandardErrorFile(QProcess::nullDevice());
        m_manager.start(QStringLiteral("openbox"), {QStringLiteral("--sm-disable")});
        m_manager.waitForStarted();
    }
    ~Desk()
    {
        m_manager.terminate();
        if (!m_manager.waitForFinished(5000))
            m_manager.kill();
        m_manager.waitForFinished();
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    /// The program that is missing on this machine; empty: none.
    static QString missing()
    {
        for (const char* tool : {"openbox", "xdotool"})
            if (QStandardPaths::findExecutable(QLatin1String(tool)).isEmpty())
                return QLatin1String(tool);
        return {};
    }

private:
    QProcess m_manager;
};

/// A running editor with settings and recovery files of its own.
class Editor
{
public:
    /// \param home is where settings, caches and recovery files lie.
    explicit Editor(const QString& home)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name :
             {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"})
            environment.insert(QLatin1String(name), home);
        m_program.setProcessEnvironment(environment);
        m_program.setProcessChannelMode(QProcess::ForwardedChannels);
    }
    ~Editor() { kill(); }
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    void start(const QStringList& arguments = {})
    {
        m_program.start(QStringLiteral(RAMURE_EDITOR), arguments);
        m_program.waitForStarted();
    }
    [[nodiscard]] bool isRunning() const { return m_program.state() != QProcess::NotRunning; }
    /// As `kill -9` does.
    void kill()
    {
        if (isRunning())
            m_program.kill();
        m_program.waitForFinished();
    }
    /// By its key; true where it ended well.
    bool quit()
    {
        return keysUntil({QStringLiteral("ctrl+q")}, [this] { return !isRunning(); }) &&
               m_program.exitStatus() == QProcess::NormalExit && m_program.exitCode() == 0;
    }

    /// The visible window with such a title, empty where there is none.
    [[nodiscard]] QString window(const QString& titlePattern) const
    {
        if (!isRunning())
            return {};
        const QString found =
            xdo({QStringLiteral("search"), QStringLiteral("--all"), QStringLiteral("--onlyvisible"),
                 QStringLiteral("--pid"), QString::number(m_program.processId()), QStringLiteral("--name"),
                 titlePattern});
        return found.section(u'\n', 0, 0);
    }
    /// With its open menus.
    [[nodiscard]] qsizetype windowCount() const
    {
        const QString found =
            xdo({QStringLiteral("search"), QStringLiteral("--all"), QStringLiteral("--onlyvisible"),
                 QStringLiteral("--pid"), QString::number(m_program.processId())});
        return found.isEmpty() ? 0 : found.count(u'\n') + 1;
    }
    /// Waits until such a window is there and has the keyboard.
    bool waitForWindow(const QString& titlePattern)
    {
        return eventually([&] {
            const QString found = window(titlePattern);
            return !found.isEmpty() && xdo({QStringLiteral("getactivewindow")}) == found;
        });
    }
    bool waitUntilGone(const QString& titlePattern)
    {
        return eventually([&] { return window(titlePattern).isEmpty(); });
    }
    /// Keys by their names, such as "ctrl+s", to the window that has the keyboard.
    static void keys(const QStringList& names)
    {
        xdo(QStringList{QStringLiteral("key"), QStringLiteral("--delay"), QStringLiteral("20")} + names);
    }
    /// A window that has just opened may lose a key before it has the focus, which no hand is quick enough
    /// for: presses the keys once more each time nothing has come of it for a while.
    static bool keysUntil(const QStringList& names, const std::function<bool()>& done)
    {
        constexpr int tries = 20;
        constexpr int aWhileMs = 3000;
        for (int i = 0; i < tries; ++i) {
            keys(names);
            if (eventually(done, aWhileMs))
                return true;
            giveKeyboardBack();
        }
        return false;
    }
    /// On a busy machine a window can be the active one and yet hear nothing, when it was shown and left in
    /// the same moment. Another window that comes and goes, as a click elsewhere and back does, sets that
    /// right.
    static void giveKeyboardBack()
    {
        const QString active = xdo({QStringLiteral("getactivewindow")});
        QWidget other;
        other.resize(40, 40);
        other.show();
        other.activateWindow();
        (void)QTest::qWaitForWindowActive(&other);
        other.close();
        xdo({QStringLiteral("windowactivate"), active});
        eventually([&] { return xdo({QStringLiteral("getactivewindow")}) == active; }, 5000);
    }
    static void type(const QString& text)
    {
        xdo({QStringLiteral("type"), QStringLiteral("--delay"), QStringLiteral("8"), text});
    }
    /// Where the inside of a window stands on the screen.
    [[nodiscard]] QRect place(const QString& titlePattern) const
    {
        const QString text =
            xdo({QStringLiteral("getwindowgeometry"), QStringLiteral("--shell"), window(titlePattern)});
        const auto number = [&text](const QString& name) {
            return text.section(name + u'=', 1).section(u'\n', 0, 0).toInt();
        };
        return {number(QStringLiteral("X")), number(QStringLiteral("Y")), number(QStringLiteral("WIDTH")),
                number(QStringLiteral("HEIGHT"))};
    }
    static void moveMouse(const QPoint& onScreen)
    {
        xdo({QStringLiteral("mousemove"), QStringLiteral("--sync"), QString::number(onScreen.x()),
             QString::number(onScreen.y())});
    }
    static void click(const QPoint& onScreen)
    {
        moveMouse(onScreen);
        xdo({QStringLiteral("click"), QStringLiteral("1")});
    }

private:
    QProcess m_program;
};

/// What the screen shows.
inline QImage screenPicture(const QRect& part = {})
{
    const QImage all = QGuiApplication::primaryScreen()->grabWindow(0).toImage();
    return part.isEmpty() ? all : all.copy(part);
}

/// Panels and dialogs once they have stopped changing, for less long than a text cursor stays.
inline QImage stillPicture(const QRect& part)
{
    return whenStill(300, [&part] { return screenPicture(part); });
}

/// The view once it has stopped changing. It draws once more, better and slower, when nothing has moved for a
/// while, and on a busy machine a draft stays until the whole tree is there.
inline QImage stillView(const QRect& part)
{
    return whenStill(1500, [&part] { return screenPicture(part); });
}

} // namespace ramure::test
