/// \file
/// Asks for the size of a picture of the view, and for its contents.
#pragma once

#include <QDialog>
#include <QVariantMap>

class QCheckBox;
class QDialogButtonBox;

namespace ramure {

class PictureForm;
struct ViewPicture;

class PictureDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param view pixels \param kept settings() of the last time; missing ones get their defaults
    PictureDialog(QSize view, const QVariantMap& kept, QWidget* parent = nullptr);

    [[nodiscard]] PictureForm* form() const { return m_form; }
    [[nodiscard]] ViewPicture wish() const;
    [[nodiscard]] QVariantMap settings() const;

private:
    PictureForm* m_form;
    QCheckBox* m_grid;
};

} // namespace ramure
