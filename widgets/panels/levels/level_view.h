/// \file
/// A level of detail, or the whole tree, as it is seen from a distance: drawn in the background, turned with
/// the mouse or the arrow keys.
#pragma once

#include "widgets/panels/levels/level_scene.h"
#include "widgets/view/drawn_picture.h"
#include <memory>

namespace ramure {

class LevelView : public DrawnPicture
{
    Q_OBJECT
public:
    explicit LevelView(QWidget* parent = nullptr);

    /// \param levels null: nothing is shown. \param level nothing: the whole tree
    void setLevel(std::shared_ptr<const TreeLevels> levels, std::optional<std::size_t> level);
    void setShot(const LevelShot& shot);
    [[nodiscard]] const LevelShot& shot() const { return m_shot; }
    [[nodiscard]] bool isBusy() const { return isDrawing(); }
    [[nodiscard]] QSize sizeHint() const override { return {180, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 100}; }

signals:
    /// By the mouse or the keys; the shot has it by now.
    void turned(double yawRad, double pitchRad);
    /// The wheel, + or -: times so far away.
    void moved(double factor);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Drawn;
    void redraw() override;
    [[nodiscard]] QString waitText() const override;
    void turnTo(double yawRad, double pitchRad);

    std::shared_ptr<Drawn> m_kept; ///< only the thread that draws looks at it
    std::shared_ptr<const TreeLevels> m_levels;
    std::optional<std::size_t> m_level, m_drawn; ///< wished for; on the picture
    LevelShot m_shot;
};

} // namespace ramure
