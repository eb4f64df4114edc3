/// \file
/// What the column of names and the sheet of keys share: where rows lie.
#pragma once

#include "widgets/panels/animation/key_model.h"
#include <QScrollBar>
#include <QWidget>
#include <optional>

namespace ramure {

/// Rows of equal height under a strip, scrolled together by one scroll bar.
class KeyRowsView : public QWidget
{
    Q_OBJECT
public:
    KeyRowsView(KeyModel* model, QScrollBar* scroll, QWidget* parent);

    /// Height of the strip above the rows; in the sheet it holds the bar that scales the selection.
    static constexpr int strip = 14;
    [[nodiscard]] int rowHeight() const;
    [[nodiscard]] double rowTop(std::size_t row) const;
    /// Nothing above and below the rows.
    [[nodiscard]] std::optional<std::size_t> rowAt(double y) const;
    /// Rows at least partly in sight: first and one behind the last.
    [[nodiscard]] std::pair<std::size_t, std::size_t> rowsInSight() const;
    void scrollTo(std::size_t row);
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void wheelEvent(QWheelEvent* event) override;
    /// Background of rows and the line between strip and rows.
    void paintRows(QPainter& painter) const;

    KeyModel* m_model;
    QScrollBar* m_scroll;
};

/// The column of names: click selects a row's keys (Shift adds), the triangle folds a node, the eye hides a
/// curve.
class KeyRowList : public KeyRowsView
{
    Q_OBJECT
public:
    using KeyRowsView::KeyRowsView;
    /// Eyes are of use where curves are shown.
    void setEyes(bool shown);
    [[nodiscard]] QString textOf(const KeyRow& row) const;
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void rowClicked(std::size_t row);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRect eyeOf(std::size_t row) const;
    void paintRow(QPainter& painter, std::size_t index) const;

    bool m_eyes = false;
};

} // namespace ramure
