/// \file
/// Asks for the kind and size of billboards: crossed cards or an atlas of views.
#pragma once

#include "widgets/view/render/passes/billboard_files.h"
#include <QDialog>
#include <QVariantMap>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace ramure {

class BillboardDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param hasSelection nodes are selected, so that they can be drawn alone \param kept settings() of the
    /// last time; missing ones get their defaults
    BillboardDialog(bool hasSelection, const QVariantMap& kept, QWidget* parent = nullptr);

    [[nodiscard]] BillboardWish wish() const;
    /// Several files go into a folder; else one GLB is written.
    [[nodiscard]] bool isFolder() const;
    [[nodiscard]] bool isSelectionOnly() const;
    [[nodiscard]] QVariantMap settings() const;

private:
    void build();
    void take(const QVariantMap& kept);
    void follow();
    void updateMessage();
    void setTexts();

    QFormLayout* m_form;
    QComboBox* m_kind;
    QSpinBox* m_cards;
    QCheckBox* m_lying;
    QSpinBox* m_views;
    QComboBox* m_size; ///< their data: pixels
    QComboBox* m_files;
    QCheckBox* m_selection;
    QLabel* m_summary;
    QLabel* m_problem; ///< why there is nothing to save
    QDialogButtonBox* m_buttons;
};

} // namespace ramure
