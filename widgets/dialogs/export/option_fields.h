/// \file
/// The fields of the export dialog for the options of the table: a box to tick, a list to choose from, or a
/// number.
#pragma once

#include "core/qt/session/export/export_option.h"
#include <QVariantMap>
#include <QWidget>
#include <vector>

namespace ramure {

class OptionFields : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Makes the field of the option with this key. A box to tick shows its own label.
    QWidget* make(const char* key, QWidget* parent);
    [[nodiscard]] bool has(const ExportOption& option) const;
    /// \pre it was made
    template <class T> [[nodiscard]] T* of(const char* key) const { return qobject_cast<T*>(find(key)); }
    void setTexts();
    void setEnabled(bool enabled);
    /// Shows the fields that the page offers and hides the others.
    void show(const ExportPage& page);
    /// Returns what the fields say. Options that the page does not offer have their defaults. \param page
    /// null: all are offered
    [[nodiscard]] ExportOptions options(const ExportPage* page = nullptr) const;
    /// Fills the fields of the options with this flag.
    void set(const ExportOptions& options, OptionFlag flag);
    /// Writes values into a file of settings and takes them from there. A value that is missing there, or is
    /// no item, leaves its field as it is.
    void store(QVariantMap& kept) const;
    void take(const QVariantMap& kept);

signals:
    void changed(const ramure::ExportOption& option);

private:
    struct Field
    {
        const ExportOption* option;
        QWidget* widget; ///< a QCheckBox, a NumberField, or a QComboBox whose data are numbers
    };
    [[nodiscard]] QWidget* find(const char* key) const;
    void connectChange(const ExportOption& option, QWidget* widget);

    std::vector<Field> m_fields;
};

/// Returns the row of the table with this key. \pre There is one.
const ExportOption& optionOfKey(std::string_view key);

} // namespace ramure
