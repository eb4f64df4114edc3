/// \file
/// Where the sun stands and what lies behind the trees. Applies at once.
#pragma once

#include <QDialog>

class QComboBox;
class QFormLayout;
class QPushButton;
class QSlider;
class QSpinBox;

namespace ramure {

class ViewSettings;

class LightDialog : public QDialog
{
    Q_OBJECT
public:
    /// \p settings are not owned and must outlive the dialog.
    explicit LightDialog(ViewSettings* settings, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void take();
    void apply();
    void retranslate();

    ViewSettings* m_settings;
    QFormLayout* m_form = nullptr;
    QComboBox* m_backdrop;
    QSlider* m_directionSlider;
    QSpinBox* m_direction;
    QSlider* m_heightSlider;
    QSpinBox* m_height;
    QPushButton* m_usual = nullptr;
    QPushButton* m_close = nullptr;
    bool m_taking = false;
};

} // namespace ramure
