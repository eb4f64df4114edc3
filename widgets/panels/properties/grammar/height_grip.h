/// \file
/// The lower edge of an editor, to be dragged.
#pragma once

#include <QWidget>
#include <optional>

namespace ramure {

class GrammarEdit;

class HeightGrip : public QWidget
{
    Q_OBJECT
public:
    /// Dragging the grip gives \p edit more or fewer lines, a double click the usual number. The editor is
    /// not owned and must outlive the grip.
    HeightGrip(GrammarEdit* edit, QWidget* parent);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    GrammarEdit* m_edit;
    std::optional<double> m_pressedAt; ///< y on the screen
    int m_linesThen = 0;
};

} // namespace ramure
