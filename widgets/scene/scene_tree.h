/// \file
/// The item view of the scene panel: a click on an eye or a lock switches it and selects nothing.
#pragma once

#include <QTreeView>

namespace ramure {

class SceneTree : public QTreeView
{
    Q_OBJECT
public:
    explicit SceneTree(QWidget* parent = nullptr);

signals:
    void stateClicked(const QModelIndex& index);

public slots:
    /// Gives the names the room that is left, or as much as the deepest visible one needs.
    void fitNames();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] QModelIndex stateAt(const QMouseEvent* event) const;
};

} // namespace ramure
