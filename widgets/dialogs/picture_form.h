/// \file
/// How exported pictures look: size in pixels, with or without the world behind the trees.
#pragma once

#include <QSize>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace ramure {

class PictureForm : public QWidget
{
    Q_OBJECT
public:
    explicit PictureForm(QWidget* parent = nullptr);

    /// Adds the view's size to the common ones, so that its ratio can be kept.
    void setViewSize(QSize pixels);
    [[nodiscard]] bool isLikeView() const; ///< the picture is as large as the view
    void setMayBeTransparent(bool may);
    void setPictureSize(QSize pixels);
    [[nodiscard]] QSize pictureSize() const;
    [[nodiscard]] bool isTransparent() const;
    void setTransparent(bool transparent);

signals:
    void changed();

private:
    void keepRatio(QSpinBox* edited);

    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_sizes;
    QCheckBox* m_locked; ///< to the ratio of the view
    QSize m_viewSize;
    QCheckBox* m_transparent;
};

} // namespace ramure
