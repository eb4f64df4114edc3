/// \file
/// The leaves of one tree, large, beside the properties that shape them: follows every change of the numbers.
#pragma once

#include "core/qt/document/document.h"
#include <QDialog>

class QLabel;

namespace ramure {

class LeafView;

/// Not modal.
class LeafDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the dialog.
    LeafDialog(Document* document, QWidget* parent);

    /// The tree whose leaves are shown; where it is gone, or no tree, the last ones stay.
    void setTree(NodeId tree);
    [[nodiscard]] LeafView* view() const { return m_view; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void refresh();

    Document* m_document;
    NodeId m_tree = noNode;
    LeafView* m_view;
};

} // namespace ramure
