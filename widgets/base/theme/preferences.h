/// \file
/// The user's preferences, remembered between sessions. Widgets hear of changes through changed().
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
#include <QVariantMap>
#include <algorithm>
#include <optional>
#include <utility>

namespace ramure {

enum class ThemeChoice { System, Light, Dark };

class Preferences : public QObject
{
    Q_OBJECT
public:
    /// One preference: a key of the settings file, and its value while nothing is stored there.
    template <class T> class Value
    {
    public:
        /// \param isTold changed() tells of it
        Value(Preferences* all, const char* key, T usual = T(), bool isTold = true)
            : m_all(all)
            , m_key(QLatin1String(key))
            , m_usual(std::move(usual))
            , m_isTold(isTold)
        {
        }
        [[nodiscard]] T operator()() const
        {
            const QVariant stored = m_all->m_settings.value(m_key);
            return stored.isValid() ? stored.value<T>() : m_usual;
        }
        void set(const T& value)
        {
            if (!m_all->m_settings.contains(m_key) || (*this)() != value)
                m_all->store(m_key, QVariant::fromValue(value), m_isTold);
        }

    private:
        Preferences* m_all;
        QString m_key;
        T m_usual;
        bool m_isTold;
    };
    /// One of an enumeration, stored by its name.
    template <class Enum> class Choice
    {
    public:
        /// \param names in the order of the enumeration; the first is the default
        Choice(Preferences* all, const char* key, QStringList names)
            : m_stored(all, key)
            , m_names(std::move(names))
        {
        }
        [[nodiscard]] Enum operator()() const
        {
            return static_cast<Enum>(std::max<qsizetype>(m_names.indexOf(m_stored()), 0));
        }
        void set(Enum value) { m_stored.set(m_names[static_cast<int>(value)]); }

    private:
        Value<QString> m_stored;
        QStringList m_names;
    };

    static constexpr int maxRecentFiles = 10;
    static constexpr int maxRecentFinds = 12;
    static constexpr int defaultAutosaveMinutes = 1;
    static constexpr int maxAutosaveMinutes = 60;
    static constexpr int leastMotionMb = 64, mostMotionMb = 65'536, defaultMotionMb = 1024;

    explicit Preferences(QObject* parent = nullptr);
    ~Preferences() override; ///< writes the last changes to the disk

    Choice<AngleUnit> angleUnit{this, "units/angle", {"degrees", "radians"}};
    Choice<ThemeChoice> theme{this, "view/theme", {"system", "light", "dark"}};
    /// "en", "fr"; empty: that of the system.
    Value<QString> language{this, "view/language"};
    Choice<NavigationStyle> navigationStyle{this, "view/navigation", {"blender", "maya"}};
    Value<bool> groundVisible{this, "view/ground", true};
    /// How moments are shown.
    Choice<TimeDisplay> timeDisplay{this, "units/time", {"frames", "seconds", "timecode"}};
    /// Whether the welcome page comes up when the program starts without a file.
    Value<bool> welcomeAtStart{this, "view/welcomeAtStart", true};
    /// Minutes between two recovery files; 0: none are written. A part of a minute counts as a whole one.
    [[nodiscard]] int autosaveMinutes() const;
    void setAutosaveMinutes(int minutes);
    /// The same in milliseconds. The settings file may name a part of a minute ("0.05"), which no dialog
    /// offers: for slow disks to be tried out, and for tests.
    [[nodiscard]] int autosaveMs() const;
    /// Megabytes (2^20 bytes) of memory for computed motion, of all trees together.
    [[nodiscard]] int motionMemoryMb() const;
    void setMotionMemoryMb(int megabytes);
    /// All of the above as they were when the program was new. Files, window and shortcuts stay.
    void restoreDefaults();

    /// The keys that the user gave to actions, by the action's id; an empty sequence: no key.
    [[nodiscard]] QMap<QString, QKeySequence> shortcuts() const;
    /// Sets the keys of an action. Without a value it has its default again.
    void setShortcut(const QString& action, const std::optional<QKeySequence>& keys);
    void clearShortcuts();

    /// The latest first; absolute paths.
    Value<QStringList> recentFiles{this, "files/recent"};
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    /// The folder where the last file dialog ended, for the next one.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder) { m_folder.set(folder); }

    /// The axes and the unit of the last mesh that was exported.
    [[nodiscard]] FileSpace exportSpace() const;
    void setExportSpace(const FileSpace& space);
    /// Settings of the export dialog under names, and those of the last exports.
    Value<QVariantMap> exportSettings{this, "files/export", {}, false};
    void setExportSettings(const QVariantMap& settings) { exportSettings.set(settings); }

    /// Settings of the view's tools, see GizmoSettings::saved.
    Value<QVariantMap> toolSettings{this, "window/tools"};
    /// The quality of the picture in the view (ViewActions).
    Value<QVariantMap> viewLight{this, "view/light"};
    /// Recent finds of the palette, the latest first (paletteName).
    Value<QStringList> recentFinds{this, "window/recentFinds", {}, false};
    void addRecentFind(const QString& name);
    /// Whether the tour has begun once.
    Value<bool> tourSeen{this, "window/tourSeen", false, false};
    /// The favourites of the gallery, as namedTree takes them, in the order in which they were chosen.
    Value<QStringList> favouritePresets{this, "gallery/favourites"};
    Value<QStringList> foldedGroups{this, "properties/folded"};
    /// Columns of the scene panel that are shown besides the nodes' names. In a narrow panel names matter
    /// most; the rest is a right click on the header away.
    Value<QStringList> sceneColumns{this, "scene/columns", {"visible", "locked", "length", "children"}};
    Value<QByteArray> windowGeometry{this, "window/geometry", {}, false};
    Value<QByteArray> windowState{this, "window/state", {}, false};

signals:
    void changed();
    /// The settings cannot be written; emitted once until they can be written again. Meanwhile changes hold
    /// for this session.
    void failed(const ramure::Error& error);

private:
    void store(const QString& key, const QVariant& value, bool isTold = true);
    void write();

    Value<QString> m_folder{this, "files/folder"};
    Value<QString> m_exportSpace{this, "files/exportSpace"};
    Value<QVariantMap> m_shortcuts{this, "shortcuts"};
    QSettings m_settings;
    QTimer m_rest; ///< delay until changes are written
    bool m_isFailing = false;
};

} // namespace ramure
