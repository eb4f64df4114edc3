/// \file
/// The picture of a preset with its name below it: a button that can be dragged into the view. In its corner
/// there may be a star, which a click sets and takes away.
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace ramure {

class PictureButton : public QAbstractButton
{
    Q_OBJECT
public:
    /// \param preset whose picture is among the resources, twice as large as it is shown; empty: there is
    /// none, and nothing can be dragged \param width of the picture, logical pixels
    PictureButton(const QString& preset, int width, QWidget* parent);

    [[nodiscard]] const QString& preset() const { return m_preset; }
    /// \param picture null: there is none yet
    void setPicture(const QPixmap& picture);
    [[nodiscard]] const QPixmap& picture() const { return m_picture; }
    [[nodiscard]] bool hasPicture() const { return !m_picture.isNull(); }
    [[nodiscard]] QSize pictureSize() const { return m_size; } ///< logical pixels
    /// Gives the picture a star: always visible if \p on, else under the mouse only.
    void setStar(bool on);
    [[nodiscard]] QRect starPlace() const;
    static constexpr int usualWidth = 176, smallWidth = 108;
    static constexpr int textGap = 5; ///< between the picture and its name
    static constexpr qreal cornerRadius = 7.0;

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void starClicked();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString m_preset;
    QPixmap m_picture;
    QSize m_size; ///< size of the picture as it is shown
    QPoint m_pressed;
    bool m_hasStar = false, m_isStarred = false;
};

/// \param corner of the picture, the upper right one
QRect pictureStarPlace(const QPoint& corner);
/// On a disc, so that it is seen before a sky as well as before leaves.
void paintPictureStar(QPainter& painter, const QRect& place, bool starred);

/// MIME type of a dragged preset; the data are a name for namedTree in UTF-8.
inline constexpr const char* presetMimeType = "application/x-ramure-preset";

} // namespace ramure
