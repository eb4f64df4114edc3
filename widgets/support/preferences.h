/// \file
/// What the user prefers, remembered between sessions. Widgets hear of changes through changed().
#pragma once

#include "widgets/numbers/number_format.h"
#include <QObject>
#include <QSettings>
#include <QStringList>

namespace ramure {

enum class ThemeChoice { System, Light, Dark };

class Preferences : public QObject
{
    Q_OBJECT
public:
    static constexpr int maxRecentFiles = 10;

    explicit Preferences(QObject* parent = nullptr);

    [[nodiscard]] AngleUnit angleUnit() const;
    void setAngleUnit(AngleUnit unit);
    [[nodiscard]] ThemeChoice theme() const;
    void setTheme(ThemeChoice theme);
    /// "en", "fr"; empty: that of the system.
    [[nodiscard]] QString language() const;
    void setLanguage(const QString& language);

    /// The latest first; absolute paths.
    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    void clearRecentFiles();
    /// The folder where the last file dialog ended, for the next one.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);

    [[nodiscard]] QStringList foldedGroups() const;
    void setFoldedGroups(const QStringList& groups);

    [[nodiscard]] QByteArray windowGeometry() const;
    [[nodiscard]] QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

signals:
    void changed();

private:
    void store(const QString& key, const QVariant& value);

    QSettings m_settings;
};

} // namespace ramure
