/// \file
/// How finely a picture is drawn, and what of it is sharp: samples of each pixel, and depth of field.
#pragma once

#include "widgets/view/render/camera_items.h"
#include <QVariantMap>
#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QPushButton;
class QSpinBox;

namespace ramure {

class LensForm : public QWidget
{
    Q_OBJECT
public:
    /// \param view the camera of the picture; where its lens is open, the form begins with it
    /// \param kept settings() of the last time; missing ones get their defaults
    LensForm(const NodeView& view, const QVariantMap& kept, QWidget* parent = nullptr);

    [[nodiscard]] int samples() const; ///< of each pixel
    /// Returns a lens that is closed where everything is to be sharp.
    [[nodiscard]] Lens lens() const;
    void setFocus(double metres); ///< from the camera
    [[nodiscard]] QVariantMap settings() const;

signals:
    /// The focus is to be shown by a click in the view.
    void pickWanted();

private:
    void build();
    void enable();

    Camera m_camera;
    QSpinBox* m_samples;
    QCheckBox* m_hasLens;
    QDoubleSpinBox* m_fStop;
    QDoubleSpinBox* m_focus;
    QPushButton* m_pick;
};

} // namespace ramure
