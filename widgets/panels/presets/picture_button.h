/// \file
/// The picture of a preset with its name below it: a button that can be dragged into the view.
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace ramure {

class PictureButton : public QAbstractButton
{
    Q_OBJECT
public:
    /// \param preset whose picture is among the resources, twice as large as it is shown
    /// \param width of the picture, logical pixels
    PictureButton(const QString& preset, int width, QWidget* parent);

    [[nodiscard]] const QString& preset() const { return m_preset; }
    static constexpr int usualWidth = 176, smallWidth = 128;

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString m_preset;
    QPixmap m_picture;
    QSize m_size; ///< of the picture as it is shown
    QPoint m_pressed;
};

/// Of what is dragged: the name of a preset in Latin-1.
inline constexpr const char* presetMimeType = "application/x-ramure-preset";

} // namespace ramure
