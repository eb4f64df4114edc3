/// \file
/// Asks what stands for trees far away: crossed cards or an atlas of views, and how large.
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
    /// \param hasSelection nodes are selected: they can be drawn alone \param kept settings() of the last
    /// time; what is missing there is as usual
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
