/// \file
/// Red, green and blue as a swatch that opens the colour dialog, and as #rrggbb to type.
#pragma once

#include "widgets/panels/properties/param_editor.h"
#include <QColor>

class QAbstractButton;
class QColorDialog;
class QLineEdit;

namespace ramure {

class ColorEditor : public ParamEditor
{
    Q_OBJECT
public:
    ColorEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;

    /// The open dialog, or null.
    [[nodiscard]] QColorDialog* dialog() const { return m_dialog; }

private:
    void takeText();
    void openDialog();

    QAbstractButton* m_swatch = nullptr;
    QLineEdit* m_text = nullptr;
    QColorDialog* m_dialog = nullptr;
    std::optional<ParamValue> m_value; ///< nothing where the nodes differ
};

/// The colour on screen of red, green and blue from 0 to 1, and back.
QColor screenColor(const glm::dvec3& value);
glm::dvec3 colorValue(const QColor& color);

} // namespace ramure
