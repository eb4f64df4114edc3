/// \file
/// Settings of a page of the export dialog that are kept: under names, and those of its last export.
#pragma once

#include "widgets/dialogs/export/export_uses.h"
#include <QVariantMap>
#include <QWidget>
#include <functional>

class QComboBox;
class QPushButton;

namespace ramure {

class Preferences;

class KeptForm : public QWidget
{
    Q_OBJECT
public:
    /// \param settings those of the page on show \param preferences must outlive the form
    KeptForm(Preferences* preferences, std::function<QVariantMap()> settings, QWidget* parent = nullptr);

    /// Offers the settings of this page.
    void setUse(ExportUse use);
    /// What is kept of a page: its last export, and the settings that it had when it was left.
    [[nodiscard]] QVariantMap lastExport() const { return kept(lastKey, m_use); }
    [[nodiscard]] QVariantMap leftPage() const { return kept(pageKey, m_use); }
    void storeExport(const QVariantMap& settings) { store(lastKey, m_use, settings); }
    void storePage(ExportUse use, const QVariantMap& settings) { store(pageKey, use, settings); }

signals:
    /// The settings of that name are wanted.
    void chosen(const QVariantMap& settings);
    void told(const QString& text);

private:
    static inline const QString lastKey = QStringLiteral("last"), namedKey = QStringLiteral("named"),
                                pageKey = QStringLiteral("page");

    [[nodiscard]] QVariantMap kept(const QString& group, ExportUse use) const;
    void store(const QString& group, ExportUse use, const QVariantMap& settings);
    void fill();
    void update();
    void take(int row);
    void keep();
    void forget();

    Preferences* m_preferences;
    std::function<QVariantMap()> m_settings;
    ExportUse m_use = ExportUse::Blender;
    QComboBox* m_names;
    QPushButton* m_keep;
    QPushButton* m_forget;
};

} // namespace ramure
