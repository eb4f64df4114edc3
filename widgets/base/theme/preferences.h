/// \file
/// What the user prefers, remembered between sessions. Widgets hear of changes through changed().
#pragma once

#include "core/base/error.h"
#include "core/io/file_space.h"
#include "widgets/base/texts/number_format.h"
#include "widgets/base/texts/time_text.h"
#include "widgets/base/theme/navigation_style.h"
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <QSettings>
#include <QStringList>
#include <QTimer>
#include <optional>

namespace ramure {

enum class ThemeChoice { System, Light, Dark };

class Preferences : public QObject
{
    Q_OBJECT
public:
    static constexpr int maxRecentFiles = 10;
    static constexpr int maxRecentFinds = 12;
    static constexpr int defaultAutosaveMinutes = 1;
    static constexpr int maxAutosaveMinutes = 60;
    static constexpr int leastMotionMb = 64, mostMotionMb = 65'536, defaultMotionMb = 1024;

    explicit Preferences(QObject* parent = nullptr);
    ~Preferences() override; ///< what was set last is on the disk

    [[nodiscard]] AngleUnit angleUnit() const;
    void setAngleUnit(AngleUnit unit);
    [[nodiscard]] ThemeChoice theme() const;
    void setTheme(ThemeChoice theme);
    /// "en", "fr"; empty: that of the system.
    [[nodiscard]] QString language() const;
    void setLanguage(const QString& language);
    [[nodiscard]] NavigationStyle navigationStyle() const;
    void setNavigationStyle(NavigationStyle style);
    [[nodiscard]] bool groundVisible() const;
    void setGroundVisible(bool on);
    /// Minutes between two recovery files; 0: none are written. A part of a minute counts as a whole one.
    [[nodiscard]] int autosaveMinutes() const;
    void setAutosaveMinutes(int minutes);
    /// The same in milliseconds. The settings file may name a part of a minute ("0.05"), which no dialog
    /// offers: for slow disks to be tried out, and for tests.
    [[nodiscard]] int autosaveMs() const;
    /// How moments are shown.
    [[nodiscard]] TimeDisplay timeDisplay() const;
    void setTimeDisplay(TimeDisplay display);
    /// Megabytes (2^20 bytes) of memory for computed motion, of all trees together.
    [[nodiscard]] int motionMemoryMb() const;
    void setMotionMemoryMb(int megabytes);
    /// Whether the welcome page comes up when the program starts without a file.
    [[nodiscard]] bool welcomeAtStart() const;
    void setWelcomeAtStart(bool on);
    /// All of the above as they were when the program was new. Files, window and shortcuts stay.
    void restoreDefaults();

    /// The keys that the user gave to actions, by the action's id; an empty sequence: no key.
    [[nodiscard]] QMap<QString, QKeySequence> shortcuts() const;
    /// Without a value the action has its default again.
    void setShortcut(const QString& action, const std::optional<QKeySequence>& keys);
    void clearShortcuts();

    /// The latest first; absolute paths.
    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    void clearRecentFiles();
    /// The folder where the last file dialog ended, for the next one.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);

    /// The axes and the unit of the last mesh that was exported.
    [[nodiscard]] FileSpace exportSpace() const;
    void setExportSpace(const FileSpace& space);

    /// What the export dialog keeps: settings under names, and those of the last exports.
    [[nodiscard]] QVariantMap exportSettings() const;
    void setExportSettings(const QVariantMap& settings);

    /// What the tools of the view remember, see GizmoSettings::saved.
    [[nodiscard]] QVariantMap toolSettings() const;
    void setToolSettings(const QVariantMap& settings);

    /// What is remembered of the picture in the view: its quality (ViewActions).
    [[nodiscard]] QVariantMap viewLight() const;
    void setViewLight(const QVariantMap& light);

    /// What the palette found and was asked to do, the latest first (paletteName).
    [[nodiscard]] QStringList recentFinds() const;
    void addRecentFind(const QString& name);
    /// Whether the tour has begun once.
    [[nodiscard]] bool tourSeen() const;
    void setTourSeen();

    /// Of the gallery, as namedTree takes them, in the order in which they became that.
    [[nodiscard]] QStringList favouritePresets() const;
    void setFavouritePresets(const QStringList& presets);

    [[nodiscard]] QStringList foldedGroups() const;
    void setFoldedGroups(const QStringList& groups);

    /// Names of the columns of the scene panel that are shown besides the nodes' names; nothing: never
    /// chosen.
    [[nodiscard]] std::optional<QStringList> sceneColumns() const;
    void setSceneColumns(const QStringList& columns);

    [[nodiscard]] QByteArray windowGeometry() const;
    [[nodiscard]] QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

signals:
    void changed();
    /// They cannot be written; once until they can be again. Meanwhile what was set holds for this session.
    void failed(const ramure::Error& error);

private:
    void store(const QString& key, const QVariant& value);
    void set(const QString& key, const QVariant& value); ///< what nobody needs to hear of
    void write();

    QSettings m_settings;
    QTimer m_rest; ///< until what was set is written
    bool m_isFailing = false;
};

} // namespace ramure
