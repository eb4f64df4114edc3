/// \file
/// The preferences: every change is applied and stored at once, so there is nothing to confirm.
#pragma once

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace ramure {

class Preferences;

class PreferencesDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param preferences is not owned and must outlive the dialog.
    explicit PreferencesDialog(Preferences* preferences, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void connectFields();
    void take();
    void retranslate();

    Preferences* m_preferences;
    bool m_taking = false; ///< the fields follow the preferences and must not answer
    // In the order of the form, which is that of the Tab key.
    QLabel* m_themeLabel;
    QComboBox* m_theme;
    QLabel* m_languageLabel;
    QComboBox* m_language;
    QLabel* m_unitsLabel;
    QComboBox* m_units;
    QLabel* m_timesLabel;
    QComboBox* m_times;
    QLabel* m_navigationLabel;
    QComboBox* m_navigation;
    QLabel* m_navigationHint;
    QLabel* m_autosaveLabel;
    QSpinBox* m_autosave;
    QLabel* m_autosaveHint;
    QLabel* m_memoryLabel;
    QSpinBox* m_memory;
    QLabel* m_memoryHint;
    QCheckBox* m_welcome;
    QPushButton* m_defaults;
    QPushButton* m_close;
};

} // namespace ramure
