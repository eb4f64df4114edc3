/// \file
/// Asks for the size of a picture of the view, for its contents, and how finely it is drawn.
#pragma once

#include "widgets/view/render/camera_items.h"
#include <QDialog>
#include <QVariantMap>

class QCheckBox;
class QDialogButtonBox;

namespace ramure {

class LensForm;
class PictureForm;
struct ViewPicture;

class PictureDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param pixels size of the view \param view its camera, with the lens of the camera node that it
    /// follows \param kept settings() of the last time; missing ones get their defaults
    PictureDialog(QSize pixels, const NodeView& view, const QVariantMap& kept, QWidget* parent = nullptr);

    [[nodiscard]] PictureForm* form() const { return m_form; }
    [[nodiscard]] LensForm* lensForm() const { return m_lens; }
    [[nodiscard]] ViewPicture wish() const;
    [[nodiscard]] QVariantMap settings() const;

private:
    PictureForm* m_form;
    QCheckBox* m_grid;
    LensForm* m_lens;
};

} // namespace ramure
