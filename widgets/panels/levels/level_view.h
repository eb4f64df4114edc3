/// \file
/// A level of detail, or the whole tree, as it is seen from a distance: drawn in the background, turned with
/// the mouse or the arrow keys.
#pragma once

#include "core/session/job.h"
#include "widgets/panels/levels/level_scene.h"
#include <QImage>
#include <QWidget>
#include <memory>

namespace ramure {

class LevelView : public QWidget
{
    Q_OBJECT
public:
    explicit LevelView(QWidget* parent = nullptr);
    ~LevelView() override;

    /// \param levels null: nothing is shown. \param level nothing: the whole tree
    void setLevel(std::shared_ptr<const TreeLevels> levels, std::optional<std::size_t> level);
    void setShot(const LevelShot& shot);
    [[nodiscard]] const LevelShot& shot() const { return m_shot; }
    /// Null until the first one is drawn.
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    [[nodiscard]] bool isBusy() const { return m_job.isRunning(); }
    [[nodiscard]] QSize sizeHint() const override { return {180, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 100}; }

signals:
    /// By the mouse or the keys; the shot has it by now.
    void turned(double yawRad, double pitchRad);
    /// The wheel, + or -: times so far away.
    void moved(double factor);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Drawer;
    void draw();
    void turnTo(double yawRad, double pitchRad);
    void retranslate();

    std::shared_ptr<Drawer> m_drawer; ///< only the job's thread draws with it; null: nothing was drawn yet
    std::shared_ptr<const TreeLevels> m_levels;
    std::optional<std::size_t> m_level, m_drawn; ///< wished for; on the picture
    LevelShot m_shot;
    QPointF m_last; ///< of the mouse
    QImage m_picture;
    QString m_problem;
    Job m_job;
};

} // namespace ramure
