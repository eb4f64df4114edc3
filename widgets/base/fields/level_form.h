/// \file
/// Levels of detail of an export: how many, how many triangles each may have, and when it is shown.
#pragma once

#include "core/lod/level_options.h"
#include <QVariantMap>
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace ramure {

class LevelForm : public QWidget
{
    Q_OBJECT
public:
    explicit LevelForm(QWidget* parent = nullptr);

    /// Returns the options as written; checkLevels() may refuse them. Nothing if one level without a budget
    /// is asked for, which is the tree as it is.
    [[nodiscard]] LevelOptions options() const;
    void setOptions(const LevelOptions& options);
    /// Makes the form fit a panel: the hints in its empty fields are shorter.
    void setNarrow();
    /// A text without numbers is no budget. Errors: Invalid, with the expected form; those of readSwitches
    /// and of checkLevels.
    [[nodiscard]] Expected<void> check() const;

    /// Convert to files of settings and back. Entries that are no numbers are left out.
    static QVariantMap settingsOf(const LevelOptions& options);
    static LevelOptions optionsIn(const QVariantMap& settings);

signals:
    void changed();

private:
    void takeCount();

    QSpinBox* m_count;
    QLabel *m_label, *m_fromLabel;
    QLineEdit *m_budgets, *m_from;
    QCheckBox *m_cards, *m_billboard;
};

} // namespace ramure
