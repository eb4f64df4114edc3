/// \file
/// The palette: a field and a list over the window. Typed words find every command, parameter and place of
/// the handbook, and Return runs or opens it.
#pragma once

#include "widgets/dialogs/palette/palette_item.h"
#include <QFrame>
#include <vector>

class QLabel;
class QLineEdit;
class QListView;

namespace ramure {

class PaletteModel;

class Palette : public QFrame
{
    Q_OBJECT
public:
    explicit Palette(QWidget* parent);

    /// Opens it at the top of the parent's window, with nothing typed. \p recent: paletteName of recent
    /// choices, the latest first.
    void open(std::vector<PaletteItem> items, const QStringList& recent);

signals:
    /// Emitted after the palette has closed. Disabled items are never chosen.
    void chosen(const ramure::PaletteItem& item);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void place();
    void showFound();
    void chooseCurrent();

    PaletteModel* m_model;
    QLineEdit* m_field;
    QListView* m_list;
    QLabel* m_none;
};

} // namespace ramure
