/// \file
/// The outline of a crown as a drawing: the curve on both sides of the trunk, with handles to drag.
#pragma once

#include <QPointF>
#include <QWidget>
#include <glm/vec2.hpp>
#include <vector>

namespace ramure {

/// Pairs as parseProfile() gives them. Mouse: drag a handle, double-click to add one, right-click for the
/// menu. Keys: page up and down choose a handle, arrows move it (Shift: further), Insert and Delete.
class ProfileCurve : public QWidget
{
    Q_OBJECT
public:
    explicit ProfileCurve(QWidget* parent);

    using Pairs = std::vector<glm::dvec2>;
    /// Empty: there is none to show, as where the selected trees differ.
    void setPairs(Pairs pairs);
    [[nodiscard]] const Pairs& pairs() const { return m_pairs; }
    /// -1: none.
    [[nodiscard]] int chosen() const { return m_chosen; }
    /// Where a handle is drawn.
    [[nodiscard]] QPointF handleAt(const glm::dvec2& pair) const;
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void gestureStarted();
    void pairsEdited();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF field() const;
    [[nodiscard]] glm::dvec2 pairAt(const QPointF& at) const;
    [[nodiscard]] int handleUnder(const QPointF& at) const;
    void choose(int handle);
    void moveTo(const glm::dvec2& pair);
    void add(const glm::dvec2& pair);
    void removeChosen();
    void take(Pairs pairs);

    Pairs m_pairs;
    int m_chosen = -1;
    bool m_drags = false;
};

} // namespace ramure
