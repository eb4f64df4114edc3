/// \file
/// Chooses the position of the sun and the background of the trees. Applies at once.
#pragma once

#include "widgets/view/render/light/sun_position.h"
#include <QDialog>

class QComboBox;
class QDateTimeEdit;
class QDoubleSpinBox;
class QFormLayout;
class QGroupBox;
class QLabel;
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

signals:
    void pictureWanted(); ///< another sky picture is to be chosen

private:
    void build();
    void buildPicture(QFormLayout* form);
    void buildMoment();
    void buildButtons();
    void take();
    void apply();
    /// Returns the sun's position for the moment and the place of the fields.
    [[nodiscard]] SunPosition momentsSun() const;
    void tellMoment();
    void takeMoment();

    ViewSettings* m_settings;
    QComboBox* m_backdrop;
    QLabel* m_picture;
    QPushButton* m_choosePicture;
    QSlider* m_turnSlider;
    QSpinBox* m_turn;
    QSlider* m_directionSlider;
    QSpinBox* m_direction;
    QSlider* m_heightSlider;
    QSpinBox* m_height;
    QSlider* m_hazeSlider;
    QDoubleSpinBox* m_haze;
    QSlider* m_exposureSlider;
    QDoubleSpinBox* m_exposure;
    QSlider* m_whiteSlider;
    QSpinBox* m_white;
    QGroupBox* m_moment;
    QDateTimeEdit* m_time;
    QDoubleSpinBox* m_latitude;
    QDoubleSpinBox* m_longitude;
    QLabel* m_momentText;
    QPushButton* m_takeMoment = nullptr;
    QPushButton* m_usual = nullptr;
    bool m_taking = false;
};

} // namespace ramure
