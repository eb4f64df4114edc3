/// \file
/// The item views of the scene panel, the tree and the list of what a search found: a click on an eye or a
/// lock switches it and selects nothing, and the names are never squeezed away.
#pragma once

#include <QTreeView>

class QTimer;

namespace ramure {

class SceneTree : public QTreeView
{
    Q_OBJECT
public:
    explicit SceneTree(QWidget* parent = nullptr);

    /// The headings' sizes and the columns of names, eyes and locks; to be called once the model is set.
    void prepareColumns();
    /// While the selection changes by Ctrl with a click or a key: what is selected elsewhere is to stay.
    [[nodiscard]] bool isAdding() const { return m_adding; }
    /// A row that is pointed at elsewhere is tinted, until an invalid index is given.
    void setPointed(const QModelIndex& index);
    [[nodiscard]] QModelIndex pointedRow() const { return m_pointed; }
    /// What stands in the view while it has no row.
    void setEmptyText(const QString& text);

signals:
    /// The row under the mouse; invalid where there is none.
    void pointed(const QModelIndex& index);
    void stateClicked(const QModelIndex& index);
    /// A plain click beside the rows.
    void nothingClicked();
    /// Enter was pressed, or a branch double-clicked.
    void frameRequested();
    /// Rows hang over the view, or are about to be dropped: in their new place they stay where they are in
    /// the world, or with Shift keep their own values. Told again when that changes.
    void dragged(bool keepsWorld);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void drawRow(QPainter* painter, const QStyleOptionViewItem& options,
                 const QModelIndex& index) const override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    [[nodiscard]] QModelIndex stateAt(const QMouseEvent* event) const;
    void fitNames(bool mayShrink);
    void tellDragged(Qt::KeyboardModifiers modifiers, bool always);

    QTimer* m_fitTimer;
    QPersistentModelIndex m_pointed;
    QString m_emptyText;
    bool m_mayShrink = false;
    bool m_adding = false;
    bool m_keepsWorld = true; ///< as told last
};

} // namespace ramure
