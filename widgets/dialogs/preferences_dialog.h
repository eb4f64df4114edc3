/// \file
/// The preferences: every change is applied and stored at once, so there is nothing to confirm.
#pragma once

#include "widgets/base/theme/preferences.h"
#include <QDialog>
#include <functional>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace ramure {

class PreferencesDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param preferences is not owned and must outlive the dialog.
    explicit PreferencesDialog(Preferences* preferences, QWidget* parent = nullptr);

private:
    void build();
    void connectFields();
    void follow(QWidget* field, const std::function<void()>& show);
    template <class Enum> void connectField(QComboBox* box, Preferences::Choice<Enum>& choice);

    Preferences* m_preferences;
    // In the order of the form, which is that of the Tab key.
    QComboBox* m_theme;
    QComboBox* m_language;
    QComboBox* m_units;
    QComboBox* m_times;
    QComboBox* m_navigation;
    QLabel* m_navigationHint;
    QSpinBox* m_autosave;
    QSpinBox* m_memory;
    QCheckBox* m_welcome;
};

} // namespace ramure
